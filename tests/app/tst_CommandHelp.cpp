#include <QJsonArray>
#include <QStandardPaths>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

namespace {

Finished runShell(const QString& program, const QStringList& words) {
  QProcess process;
  process.start(program, words);
  return finishedOf(process);
}

bool isInstalled(const char* program) {
  return !QStandardPaths::findExecutable(text(program)).isEmpty();
}

}  // namespace

/// The help of all commands, and the files that are written from the same table: the manual page
/// and completions, as the programs that read them see them.
class CommandHelpTest : public QObject, protected InFolder {
  Q_OBJECT

 private:
  QJsonArray commands_;

  QString written(const char* format) {
    QString file = path(format);
    const Finished page = runProgram("list commands --format %", {text(format)});
    writeText(file, page.exitCode == 0 ? page.out.toUtf8() : QByteArray());
    return file;
  }

  /// What bash offers for the last word.
  QStringList completed(const QString& file, const QStringList& words) {
    const QString script = text(
        "source \"$1\"; shift; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _hunavsim; "
        "printf '%s\\n' \"${COMPREPLY[@]}\"");
    const Finished shell =
        runShell(text("bash"), QStringList{text("--norc"), text("-c"), script, text("bash"), file} +
                                   (QStringList{text(HUNAVSIM_PROGRAM)} + words));
    return shell.out.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  }

 private Q_SLOTS:
  void initTestCase() {
    const Finished listed = runProgram("list commands --json");
    QVERIFY2(listed.exitCode == 0, qPrintable(listed.err));
    commands_ = QJsonDocument::fromJson(listed.out.toUtf8()).array();
    QVERIFY(commands_.size() >= 15);
  }

  void everyCommand_hasUsageOptionsExamplesAndExitCodes() {
    for (const QJsonValue& value : std::as_const(commands_)) {
      const QString name = value[text("name")].toString();
      const bool isWindow = name == text("hunavsim");
      const Finished help = runProgram(isWindow ? list("--help") : QStringList{name, text("-h")});
      QCOMPARE(help.exitCode, 0);
      QVERIFY2(help.out.contains(text("Usage: ") + value[text("usage")].toString()),
               qPrintable(name));
      QVERIFY2(help.out.contains(text("\n  64 ")), qPrintable(name));
      QVERIFY2(!value[text("examples")].toArray().isEmpty(), qPrintable(name));
      const QJsonArray options = value[text("options")].toArray();
      for (const QJsonValue& option : options) {
        QVERIFY2(help.out.contains(option[text("names")][0].toString()), qPrintable(name));
        QVERIFY2(!option[text("description")].toString().isEmpty(), qPrintable(name));
      }
      const QJsonArray examples = value[text("examples")].toArray();
      for (const QJsonValue& example : examples) {
        QVERIFY2(help.out.contains(text("\n  ") + example[text("line")].toString() + text("\n")),
                 qPrintable(name));
      }
    }
  }

  /// 80 columns, unless a heading alone is wider.
  void everyHelp_fitsATerminal() {
    for (const QJsonValue& value : std::as_const(commands_)) {
      const QString name = value[text("name")].toString();
      const bool isWindow = name == text("hunavsim");
      const Finished help =
          runProgram(isWindow ? list("--help") : QStringList{name, text("--help")});
      for (const QString& line : help.out.split(QLatin1Char('\n'))) {
        const bool isText = line.startsWith(text("                          "));
        QVERIFY2(!isText || line.size() <= 80, qPrintable(line));
      }
    }
  }

  void options_ofRun_areInGroupsWithTheCommonOnesFirst() {
    const QString help = runProgram("run --help").out;
    int last = 0;
    for (const char* part :
         {"\nArguments:\n", "\nScenario:\n", "--map FILE|none", "\nRun:\n", "--seed N",
          "--duration SECONDS", "--stop-on-collision none|people|any", "\nRobot:\n", "--robot TYPE",
          "--planner NAME", "\nOutput:\n", "-o, --output DIR", "-q, --quiet",
          "\nLive view and ROS 2:\n", "\nAdvanced:\n", "--exact", "-h, --help", "\nExamples:\n",
          "\nExit codes:\n"}) {
      const int place = help.indexOf(text(part));
      QVERIFY2(place > last, part);
      last = place;
    }
  }

  void help_ofTheProgram_listsAllCommands() {
    const QString help = runProgram("--help").out;
    for (const QJsonValue& value : std::as_const(commands_)) {
      const QString name = value[text("name")].toString();
      QVERIFY2(name == text("hunavsim") || help.contains(text("\n  ") + name + text(" ")),
               qPrintable(name));
    }
    QVERIFY(help.indexOf(text("\n  run ")) < help.indexOf(text("--map")));
  }

  void manualPage_isReadWithoutAWarning() {
    if (!isInstalled("groff")) {
      QSKIP("groff is not installed");
    }
    const Finished page = runShell(text("groff"), list("-man -Tutf8 -ww %", {written("man")}));
    QCOMPARE(page.exitCode, 0);
    QCOMPARE(page.err, QString());
    for (const QJsonValue& value : std::as_const(commands_)) {
      QVERIFY(page.out.contains(value[text("name")].toString()));
    }
  }

  void bash_completes_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QStringList>("offered");
    QTest::newRow("command") << list("ev") << list("evaluate");
    QTest::newRow("option") << list("run --plan") << list("--planner");
    QTest::newRow("planner") << list("run --planner social_m") << list("social_mppi");
    QTest::newRow("choice") << list("run x --stop-on-collision pe") << list("people");
    QTest::newRow("scenario") << list("run corner_c") << list("corner_cafe_agents");
    QTest::newRow("scenario of the window") << list("two_w") << list("two_workers_agents");
    QTest::newRow("scenario to check") << list("check corner_c") << list("corner_cafe_agents");
    QTest::newRow("list") << list("list plan") << list("planners");
    QTest::newRow("target") << list("convert x --target web") << list("webots");
  }
  void bash_completes() {
    QFETCH(QStringList, words);
    QFETCH(QStringList, offered);
    QCOMPARE(completed(written("bash"), words), offered);
  }

  void bash_completesFilesAndFolders() {
    writeText(path("place/map.yaml"), "");
    const QString file = written("bash");
    QCOMPARE(completed(file, {text("run"), text("--map"), path("place/m")}),
             QStringList(path("place/map.yaml")));
    QCOMPARE(completed(file, {text("run"), text("-o"), path("pla")}), QStringList(path("place")));
  }

  void otherShells_readTheirCompletions() {
    int shells = 0;
    for (const char* shell : {"zsh", "fish"}) {
      const QString file = written(shell);
      QVERIFY(bytesOf(file).contains("social_mppi") && bytesOf(file).contains("list scenarios"));
      if (isInstalled(shell)) {
        const Finished read = runShell(text(shell), {text("-n"), file});
        QVERIFY2(read.exitCode == 0 && read.err.isEmpty(), qPrintable(read.err));
        ++shells;
      }
    }
    if (shells == 0) {
      QSKIP("neither zsh nor fish is installed");
    }
  }

  void formats_ofCommands_areRefusedElsewhere() {
    QCOMPARE(runProgram("list nodes --format bash").exitCode, 64);
    QCOMPARE(runProgram("list scenarios --format zsh").exitCode, 64);
  }
};

QTEST_GUILESS_MAIN(CommandHelpTest)
#include "tst_CommandHelp.moc"
