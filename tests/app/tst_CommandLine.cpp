#include <QImage>
#include <QJsonArray>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

namespace {

QString demo() {
  return text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
}

}  // namespace

/// What all commands do alike, and the window started with words of the command line.
class CommandLineTest : public QObject, protected InFolder {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    writeText(path("walk.csv"), "time,id,x,y\n0,1,0,0\n1,1,1,0\n2,1,2,0\n");
    writeText(path("few.yaml"), "hunavsim_experiment: 1\nscenarios: [" + demo().toUtf8() +
                                    "]\nseeds: 1\nduration: 0.1\n");
  }

  /// A folder cannot be the standard output: nothing is made, not even a folder of this name.
  void dash_isNoFolder_data() {
    QTest::addColumn<QStringList>("words");
    const auto row = [](const char* command, const QStringList& more) {
      QTest::newRow(command) << (QStringList{text(command)} + more + list("-o -"));
    };
    row("run", {demo(), text("--duration"), text("0.1")});
    row("batch", {path("few.yaml")});
    row("evaluate", {path("walk.csv")});
    row("convert", {demo(), text("--target"), text("isaac")});
    row("trees", {demo()});
    row("validate", {text("rimea-1"), text("--seeds"), text("1")});
  }
  void dash_isNoFolder() {
    QFETCH(QStringList, words);
    const QString where = path("dash");
    QVERIFY(QDir().mkpath(where));
    QCOMPARE(unexpected(runProgram(words, where), 64, "a folder is required"), QString());
    QVERIFY(QDir(where).isEmpty());
  }

  /// What somebody else put there is replaced only by who says so.
  void output_fileOfOthers_staysUnlessForced_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QString>("name");
    const auto row = [](const char* command, const QStringList& more, const char* name) {
      QTest::newRow(command) << QStringList{text(command)} + more << text(name);
    };
    row("run", {demo(), text("--duration"), text("0.1")}, "metrics.json");
    row("batch", {path("few.yaml")}, "results.csv");
    row("evaluate", {path("walk.csv")}, "metrics.json");
    row("trees", {demo()}, "corner_cafe_agents__agent_1_bt.xml");
    row("validate", {text("rimea-1"), text("--model"), text("sfm"), text("--seeds"), text("1")},
        "validation.csv");
  }
  void output_fileOfOthers_staysUnlessForced() {
    QFETCH(QStringList, words);
    QFETCH(QString, name);
    const QTemporaryDir folder;
    const QString file = folder.filePath(name);
    writeText(file, "mine");
    words += {text("-o"), folder.path()};
    QCOMPARE(unexpected(runProgram(words), 2, name), QString());
    QCOMPARE(bytesOf(file), QByteArray("mine"));
    QCOMPARE(failureOf(words + list("--force")), QString());
    QVERIFY(bytesOf(file) != QByteArray("mine"));
    writeText(folder.filePath(text("own.txt")), "beside");
    const Finished again = runProgram(words);  // its own files are no others'
    QVERIFY2(again.exitCode == 0, qPrintable(again.err));
  }

  void json_badInput_isListedOnStandardOutput_data() {
    QTest::addColumn<QStringList>("words");
    writeText(path("bad.yaml"), "hunav_loader:\n  ros__parameters:\n    agents: [a, \n");
    writeText(path("bad.csv"), "time,id,x,y\n0,1,nan,0\n");
    const auto row = [](const char* command, const QStringList& more) {
      QTest::newRow(command) << (QStringList{text(command)} + more);
    };
    row("check", {path("bad.yaml")});
    row("run", {path("bad.yaml")});
    row("batch", {path("bad.yaml"), text("-o"), path("out")});
    row("evaluate", {path("bad.csv"), text("-o"), path("out")});
    row("convert", {path("bad.yaml"), text("--target"), text("isaac"), text("-o"), path("out")});
    row("trees", {path("bad.yaml")});
  }
  void json_badInput_isListedOnStandardOutput() {
    QFETCH(QStringList, words);
    const Finished finished = runProgram(words + list("--json"));
    QCOMPARE(finished.exitCode, 2);
    const QJsonArray all = QJsonDocument::fromJson(finished.out.toUtf8()).array();
    QVERIFY2(!all.isEmpty(), qPrintable(finished.out));
    const QJsonObject first = all[0].toObject();
    QCOMPARE(first[text("severity")].toString(), text("error"));
    QVERIFY(first[text("file")].toString().contains(text("bad.")));
    QVERIFY(first[text("line")].toInt() > 0);
    QVERIFY(!first[text("message")].toString().isEmpty());
  }

  /// A command line that cannot be followed is an error as well.
  void json_wrongWords_areListedOnStandardOutput_data() {
    QTest::addColumn<QStringList>("words");
    QTest::newRow("value") << list("run % --seed x", {demo()});
    QTest::newRow("missing") << list("run");
    QTest::newRow("unknown option") << list("bench --foo");
    QTest::newRow("name") << list("list keyz");
    QTest::newRow("command") << list("chekc %", {demo()});
    QTest::newRow("format and json") << list("list nodes --format xml");
    QTest::newRow("trees of nothing") << list("trees");
    QTest::newRow("time between ticks") << list("trees --play % --dt nan", {demo()});
    QTest::newRow("realism test") << list("validate nope");
  }
  void json_wrongWords_areListedOnStandardOutput() {
    QFETCH(QStringList, words);
    const Finished finished = runProgram(words + list("--json"));
    QCOMPARE(finished.exitCode, 64);
    const QJsonArray all = QJsonDocument::fromJson(finished.out.toUtf8()).array();
    QCOMPARE(all.size(), 1);
    QCOMPARE(all[0].toObject()[text("severity")].toString(), text("error"));
    QVERIFY(!all[0].toObject()[text("message")].toString().isEmpty());
  }

  void fullStandardOutput_everyCommand_isAnError_data() {
    QTest::addColumn<QStringList>("words");
    const auto row = [](const char* command, const QStringList& more) {
      QTest::newRow(command) << (QStringList{text(command)} + more);
    };
    row("--version", {});
    row("batch", {path("few.yaml"), text("-o"), path("full/batch")});
    row("evaluate", {path("walk.csv"), text("-o"), path("full/walk")});
    row("convert", {demo(), text("--target"), text("isaac"), text("-o"), path("full/isaac")});
    row("validate", {text("rimea-1"), text("--model"), text("sfm"), text("--seeds"), text("1")});
  }
  void fullStandardOutput_everyCommand_isAnError() {
    QFETCH(QStringList, words);
    QProcess program;
    program.setStandardOutputFile(text("/dev/full"));
    program.start(text(HUNAVSIM_PROGRAM), words);
    QVERIFY(program.waitForFinished(55000));
    const QString said = QString::fromUtf8(program.readAllStandardError());
    QCOMPARE(program.exitCode(), 2);
    QVERIFY2(said.contains(text("cannot write to standard output")), qPrintable(said));
  }

  void mistypedWords_nameTheNearest_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("says");
    QTest::newRow("command") << list("evalute % x", {path("walk.csv")}) << 64
                             << text("unknown command 'evalute' (did you mean 'evaluate'?)");
    QTest::newRow("list") << list("list modles") << 64 << text("(did you mean 'models'?)");
    QTest::newRow("option") << list("run corner_cafe_agents --sed 3") << 64
                            << text("unknown option '--sed' (did you mean '--seed'?)");
    QTest::newRow("option with its value")
        << list("bench --thread=2") << 64
        << text("unknown option '--thread' (did you mean '--threads'?)");
    QTest::newRow("planner") << list("run corner_cafe_agents --planner pursiut") << 64
                             << text("(did you mean 'pursuit'? known: ");
    QTest::newRow("metric") << list("run corner_cafe_agents --metrics path_lenght") << 64
                            << text("(did you mean 'path_length'?)");
    QTest::newRow("scenario of a command")
        << list("run corner_cafe_agent") << 2
        << text("no shipped scenario of this name (did you mean 'corner_cafe_agents'?)");
    QTest::newRow("scenario of the window")
        << list("corner_cafe_agent") << 2
        << text("no command or shipped scenario of this name (did you mean 'corner_cafe_agents'?)");
  }
  void mistypedWords_nameTheNearest() {
    QFETCH(QStringList, words);
    QFETCH(QString, says);
    const Finished finished = runProgram(words);
    QTEST(finished.exitCode, "code");
    QVERIFY2(finished.err.contains(says), qPrintable(finished.err));
  }

  /// On a terminal, which `script` is, unless NO_COLOR is set.
  void errors_onATerminal_haveColors_data() {
    QTest::addColumn<bool>("isPlain");
    QTest::newRow("terminal") << false;
    QTest::newRow("NO_COLOR") << true;
  }
  void errors_onATerminal_haveColors() {
    QFETCH(bool, isPlain);
    QProcess terminal;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(text("NO_COLOR"));
    environment.insert(text("TERM"), text("xterm"));
    if (isPlain) {
      environment.insert(text("NO_COLOR"), text("1"));
    }
    terminal.setProcessEnvironment(environment);
    terminal.start(text("script"), {text("-qec"), text(HUNAVSIM_PROGRAM " check nowhere/a.yaml"),
                                    text("/dev/null")});
    if (!terminal.waitForStarted()) {
      QSKIP("the program 'script' is not here");
    }
    QVERIFY(terminal.waitForFinished(30000));
    const QByteArray said = terminal.readAllStandardOutput();
    QVERIFY2(said.contains("error:"), said.constData());
    QCOMPARE(said.contains("\033[1;31merror:\033[0m"), !isPlain);
    QCOMPARE(said.contains('\033'), !isPlain);
  }

  void window_standardInput_isRefused() {
    QCOMPARE(unexpected(runProgram("- -q"), 64, "cannot read standard input"), QString());
  }

  void window_dock_beforeOrBehindTheScenario_showsItAndOpensTheFile_data() {
    QTest::addColumn<QStringList>("words");
    const QString demo = text("corner_cafe_agents");
    const auto dock = text("--dock");
    const auto issues = text("issues");
    QTest::newRow("behind") << QStringList{demo, dock, issues};
    QTest::newRow("before") << QStringList{dock, issues, demo};
    QTest::newRow("two before") << QStringList{dock, issues, text("events"), demo};
    QTest::newRow("with a sign") << QStringList{dock + text("=issues"), demo};
  }
  void window_dock_beforeOrBehindTheScenario_showsItAndOpensTheFile() {
    QFETCH(QStringList, words);
    const QTemporaryDir folder;
    const QString file = folder.filePath(text("a.png"));
    words << text("--at") << text("0") << text("--theme") << text("light") << text("--screenshot")
          << file;
    QCOMPARE(failureOf(words), QString());
    const QImage picture(file);
    QCOMPARE(picture.size(), QSize(1280, 800));
    // Properties stood at the right edge, and the start page is white there: now it is the canvas.
    QCOMPARE(picture.pixelColor(1270, 300), QColor(0xEC, 0xEE, 0xF0));
  }

  void window_imageAsPicture_isRefusedAtOnce() {
    const QTemporaryDir folder;
    const QString picture = folder.filePath(text("a.png"));
    const QString image = folder.filePath(text("plan.pgm"));  // no map YAML names it
    QVERIFY(QFile::copy(text(SOURCE_DIR "/maps/reactions/reactions.pgm"), image));
    QCOMPARE(unexpected(runProgram("% --at 0 --screenshot %", {image, picture}), 2,
                        "plan.pgm: error: an image has no scale"),
             QString());
    QVERIFY(!QFile::exists(picture));
  }

  /// A file manager opens files, not folders.
  void window_headerOfARun_opensTheRun() {
    const QTemporaryDir folder;
    const QString run = folder.filePath(text("run"));
    QCOMPARE(failureOf("run reaction_regular_agents --duration 2 -o % -q", {run}), QString());
    QCOMPARE(
        failureOf("% --at 1 --theme light --screenshot %", {run, folder.filePath(text("a.png"))}),
        QString());
    QCOMPARE(failureOf("% --at 1 --theme light --screenshot %",
                       {run + text("/trace.json"), folder.filePath(text("b.png"))}),
             QString());
    const QByteArray picture = bytesOf(folder.filePath(text("a.png")));
    QVERIFY(!picture.isEmpty() && picture == bytesOf(folder.filePath(text("b.png"))));
  }

  void window_tooManyWords_areToldInOrder() {
    QCOMPARE(unexpected(runProgram("% a b",
                                   {text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml")}),
                        64, "unexpected arguments: a b"),
             QString());
  }

  void window_dock_unknown_isRefused() {
    QCOMPARE(
        unexpected(runProgram("corner_cafe_agents --dock nothing --at 0 --screenshot /tmp/x.png"),
                   64, "nothing"),
        QString());
  }
};

QTEST_GUILESS_MAIN(CommandLineTest)
#include "tst_CommandLine.moc"
