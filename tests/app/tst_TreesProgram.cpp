#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

#include "tests/app/RunFiles.h"

using outside::Finished;

/// `hunavsim trees` from outside.
class TreesProgramTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void play_tree_givesTheRecordedTrace_data();
  void play_tree_givesTheRecordedTrace();
  void play_compatQ20_delayIsNotArmedAgain();
  void play_text_isATable();
  void play_idInScript_countsForEachLeaf();
  void play_unknownName_isAWarning();
  void play_badScript_saysWhere_data();
  void play_badScript_saysWhere();
  void play_badTree_isBadInput();
  void play_faultyTree_keepsTheTicksAndFails();
  void play_probabilityChoice_dependsOnTheSeed();
  void words_wrong_exitWith64_data();
  void words_wrong_exitWith64();
  void make_shippedScenario_treesPassTheCheck_data();
  void make_shippedScenario_treesPassTheCheck();
  void make_again_saysWhatBecameOfEachFile();
  void make_withoutFolder_printsAll();
  void make_intoAFile_isAnError();
  void make_baseNameWithFolder_isAnError();
  void make_hunav2_hasTheGoalsOfTheShippedTrees_data();
  void make_hunav2_hasTheGoalsOfTheShippedTrees();
  void make_hunav2_bodyIsTheFilledTemplate_data();
  void make_hunav2_bodyIsTheFilledTemplate();
};

namespace {

QString utf8(const char* text) {
  return QString::fromUtf8(text);
}

void writeText(const QString& path, const QByteArray& text) {
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  QCOMPARE(file.write(text), qint64(text.size()));
}

/// Leaves of people's trees under short names: S succeeds, the others do what the script says.
QByteArray leaf(const QByteArray& name) {
  return "<RegularNav name='" + name + "' agent_id='{id}' time_step='{dt}'/>";
}

QByteArray fileOf(QByteArray body) {
  static const QRegularExpression letter(QStringLiteral("<([a-zA-Z][a-zA-Z0-9]?|Vis|nav)/>"));
  QString text = QString::fromUtf8(body);
  text.replace(letter, QString::fromUtf8(leaf("\\1")));
  return "<root BTCPP_format='4'><BehaviorTree ID='T'>" + text.toUtf8() +
         "</BehaviorTree></root>\n";
}

struct Play {
  QTemporaryDir folder;
  Finished run(const QByteArray& body, const QByteArray& script, const QStringList& more) {
    const QString tree = folder.filePath(QStringLiteral("t.xml"));
    const QString statuses = folder.filePath(QStringLiteral("s.yaml"));
    writeText(tree, fileOf(body));
    writeText(statuses, script);
    return outside::runProgram(QStringList{QStringLiteral("trees"), QStringLiteral("--play"), tree,
                                           QStringLiteral("--script"), statuses,
                                           QStringLiteral("--dt"), QStringLiteral("0.1")} +
                               more);
  }
};

/// "a:SUCCESS b:RUNNING -> RUNNING" per tick, of --json.
QStringList traceOf(const Finished& finished) {
  QStringList ticks;
  for (const QJsonValue& value : QJsonDocument::fromJson(finished.out.toUtf8()).array()) {
    const QJsonObject tick = value.toObject();
    QString line;
    for (const QJsonValue& called : tick[QStringLiteral("leaves")].toArray()) {
      const QJsonObject object = called.toObject();
      line += object[QStringLiteral("name")].toString() + QLatin1Char(':') +
              object[QStringLiteral("status")].toString().left(1) + QLatin1Char(' ');
    }
    ticks << line + QStringLiteral("-> ") + tick[QStringLiteral("root")].toString();
  }
  return ticks;
}

void row(const char* name, const char* body, const char* script, const char* ticks) {
  QTest::newRow(name) << QByteArray(body) << QByteArray(script)
                      << utf8(ticks).split(QLatin1Char('|'));
}

QString interopFolder() {
  const QByteArray given = qgetenv("HUNAV_INTEROP_DIR");
  return (given.isEmpty() ? utf8(SOURCE_DIR "/../shared/interop") : QString::fromLocal8Bit(given)) +
         QStringLiteral("/hunavsim2/");
}

/// Goal ids of the SetGoal nodes of a tree file, in order, by a reader of the tests' own.
QStringList goalsIn(const QString& path) {
  QXmlStreamReader xml(outside::bytesOf(path));
  QStringList goals;
  bool isModel = false;
  while (!xml.atEnd()) {
    xml.readNext();
    if (xml.name() == QLatin1String("TreeNodesModel")) {
      isModel = xml.isStartElement();
    }
    const QString id = xml.attributes().value(QStringLiteral("ID")).toString();
    const bool isSetGoal = xml.name() == QLatin1String("SetGoal") || id == QLatin1String("SetGoal");
    if (xml.isStartElement() && !isModel && isSetGoal) {
      goals << xml.attributes().value(QStringLiteral("goal_id")).toString();
    }
  }
  return xml.hasError() ? QStringList{xml.errorString()} : goals;
}

QStringList makeWords(const QString& scenario, const QString& folder, const char* style) {
  return {QStringLiteral("trees"),   scenario,   QStringLiteral("-o"), folder,
          QStringLiteral("--style"), utf8(style)};
}

}  // namespace

/// Traces recorded with BehaviorTree.CPP 4.10, one tick per step.
void TreesProgramTest::play_tree_givesTheRecordedTrace_data() {
  QTest::addColumn<QByteArray>("body");
  QTest::addColumn<QByteArray>("script");
  QTest::addColumn<QStringList>("expected");
  row("goal block",
      "<Fallback><Sequence><RunOnce><g1/></RunOnce><Inverter><RunOnce><g2/></RunOnce></Inverter>"
      "</Sequence><A/></Fallback>",
      "", "g1:S g2:S A:S -> SUCCESS|A:S -> SUCCESS|A:S -> SUCCESS");
  row("memory, three successes", "<SequenceWithMemory><a/><b/><c/></SequenceWithMemory>", "",
      "a:S -> RUNNING|b:S -> RUNNING|c:S -> SUCCESS|a:S -> RUNNING");
  row("memory, one failure", "<SequenceWithMemory><a/><F/><c/></SequenceWithMemory>", "F: FAILURE",
      "a:S -> RUNNING|F:F -> FAILURE|F:F -> FAILURE|F:F -> FAILURE");
  row("retry 3", "<RetryUntilSuccessful num_attempts='3'><F/></RetryUntilSuccessful>",
      "F: [FAILURE]", "F:F -> RUNNING|F:F -> RUNNING|F:F -> FAILURE|F:F -> RUNNING");
  row("retry of a stateful leaf",
      "<RetryUntilSuccessful num_attempts='2'><St/></RetryUntilSuccessful>",
      "St: [RUNNING, FAILURE, RUNNING, FAILURE, RUNNING]",
      "St:R -> RUNNING|St:F St:R -> RUNNING|St:F -> FAILURE|St:R -> RUNNING");
  row("repeat 3", "<Repeat num_cycles='3'><S/></Repeat>", "",
      "S:S -> RUNNING|S:S -> RUNNING|S:S -> SUCCESS|S:S -> RUNNING");
  row("fallback", "<Fallback><F/><St/></Fallback>",
      "F: [FAILURE]\nSt: [RUNNING, RUNNING, SUCCESS, RUNNING]",
      "F:F St:R -> RUNNING|St:R -> RUNNING|St:S -> SUCCESS|F:F St:R -> RUNNING");
  row("reactive fallback", "<ReactiveFallback><F/><St/></ReactiveFallback>",
      "F: [FAILURE]\nSt: [RUNNING, RUNNING, SUCCESS]",
      "F:F St:R -> RUNNING|F:F St:R -> RUNNING|F:F St:S -> SUCCESS");
  row("delay in memory, two rounds",  // ours: the second round waits again
      "<SequenceWithMemory><a/><TimeDelay delay='0.3'><St/></TimeDelay><z/></SequenceWithMemory>",
      "St: [RUNNING, SUCCESS, RUNNING, SUCCESS]",
      "a:S -> RUNNING|-> FAILURE|-> FAILURE|-> FAILURE|St:R -> RUNNING|St:S z:S -> SUCCESS|"
      "a:S -> RUNNING|-> FAILURE|-> FAILURE|-> FAILURE|St:R -> RUNNING|St:S z:S -> SUCCESS");
  row("run once, failure", "<RunOnce><F/></RunOnce>", "F: [FAILURE]",
      "F:F -> FAILURE|-> SKIPPED|-> SKIPPED");
  row("run once, remembered", "<RunOnce then_skip='false'><F/></RunOnce>", "F: [FAILURE]",
      "F:F -> FAILURE|-> FAILURE|-> FAILURE");
  row("template, robot never visible",
      "<Fallback><Sequence><RunOnce><Vis/></RunOnce><RunOnce><St/></RunOnce></Sequence><nav/>"
      "</Fallback>",
      "Vis: [FAILURE]\nSt: [RUNNING, RUNNING, SUCCESS]",
      "Vis:F nav:S -> SUCCESS|St:R -> RUNNING|St:R -> RUNNING|St:S -> SUCCESS|nav:S -> SUCCESS|"
      "nav:S -> SUCCESS");
  row("corrected, visible",
      "<Fallback><Sequence><Vis/><RunOnce then_skip='false'><ForceFailure><St/></ForceFailure>"
      "</RunOnce></Sequence><nav/></Fallback>",
      "St: [RUNNING, RUNNING, SUCCESS]",
      "Vis:S St:R -> RUNNING|St:R -> RUNNING|St:S nav:S -> SUCCESS|Vis:S nav:S -> SUCCESS");
  row("corrected, not visible",
      "<Fallback><Sequence><Vis/><RunOnce then_skip='false'><ForceFailure><St/></ForceFailure>"
      "</RunOnce></Sequence><nav/></Fallback>",
      "Vis: [FAILURE]", "Vis:F nav:S -> SUCCESS|Vis:F nav:S -> SUCCESS");
  row("parallel", "<Parallel success_count='1' failure_count='-1'><St/><S/></Parallel>",
      "St: [RUNNING]", "St:R S:S St:H -> SUCCESS|St:R S:S St:H -> SUCCESS");
  row("one skipped, one success",
      "<Fallback><Sequence><v/><RunOnce><r/></RunOnce></Sequence><nav/></Fallback>", "",
      "v:S r:S -> SUCCESS|v:S -> SUCCESS|v:S -> SUCCESS");
}

void TreesProgramTest::play_tree_givesTheRecordedTrace() {
  QFETCH(QByteArray, body);
  QFETCH(QByteArray, script);
  QFETCH(QStringList, expected);
  Play play;
  const Finished found = play.run(
      body, script,
      {QStringLiteral("--json"), QStringLiteral("--ticks"), QString::number(expected.size())});
  QVERIFY2(found.exitCode == 0, qPrintable(found.err));
  QCOMPARE(traceOf(found), expected);
  QVERIFY2(found.err.isEmpty(), qPrintable(found.err));
}

void TreesProgramTest::play_compatQ20_delayIsNotArmedAgain() {
  Play play;
  const Finished found =
      play.run("<TimeDelay delay='0.3'><S/></TimeDelay>", "",
               {QStringLiteral("--json"), QStringLiteral("--ticks"), QStringLiteral("5"),
                QStringLiteral("--compat"), QStringLiteral("Q-20")});
  QCOMPARE(traceOf(found), utf8("-> FAILURE|-> FAILURE|-> FAILURE|S:S -> SUCCESS|S:S -> SUCCESS")
                               .split(QLatin1Char('|')));
}

void TreesProgramTest::play_text_isATable() {
  Play play;
  const Finished found =
      play.run("<Sequence><a/><RunOnce><St/></RunOnce></Sequence>", "St: [RUNNING, FAILURE]",
               {QStringLiteral("--ticks"), QStringLiteral("3")});
  QCOMPARE(found.out, utf8("tick  root     leaves\n"
                           "1     RUNNING  a SUCCESS, St RUNNING\n"
                           "2     FAILURE  St FAILURE\n"
                           "3     SUCCESS  a SUCCESS\n"));
  const Finished without = outside::runProgram({QStringLiteral("trees"), QStringLiteral("--play"),
                                                play.folder.filePath(QStringLiteral("t.xml"))});
  QCOMPARE(without.out.count(QLatin1Char('\n')), 11);  // ten ticks, all leaves succeed
  QVERIFY(without.out.contains(utf8("\n10    SUCCESS  a SUCCESS\n")));
}

void TreesProgramTest::play_idInScript_countsForEachLeaf() {
  Play play;
  const Finished found =
      play.run("<Fallback><a/><b/><UpdateGoal agent_id='{id}'/></Fallback>",
               "RegularNav: [FAILURE, FAILURE, SUCCESS]\nb: FAILURE\n",
               {QStringLiteral("--json"), QStringLiteral("--ticks"), QStringLiteral("3")});
  QCOMPARE(traceOf(found), utf8("a:F b:F UpdateGoal:S -> SUCCESS|a:F b:F UpdateGoal:S -> SUCCESS|"
                                "a:S -> SUCCESS")
                               .split(QLatin1Char('|')));
}

void TreesProgramTest::play_unknownName_isAWarning() {
  Play play;
  const Finished found = play.run("<Sequence><Vis/></Sequence>", "Viz: [FAILURE]\n", {});
  QCOMPARE(found.exitCode, 0);
  QVERIFY2(found.err.contains(utf8("s.yaml:1:1: warning: ")) &&
               found.err.contains(utf8("did you mean 'Vis'?")),
           qPrintable(found.err));
}

void TreesProgramTest::play_badScript_saysWhere_data() {
  QTest::addColumn<QByteArray>("script");
  QTest::addColumn<QByteArray>("place");
  QTest::newRow("no status") << QByteArray("a: [SUCCESS,\n    FAILED]\n") << QByteArray(":2:5:");
  QTest::newRow("skipped") << QByteArray("a: SKIPPED\n") << QByteArray(":1:4:");
  QTest::newRow("empty list") << QByteArray("\na: []\n") << QByteArray(":2:4:");
  QTest::newRow("nothing") << QByteArray("a:\n") << QByteArray(":1:1:");
  QTest::newRow("map") << QByteArray("a: {b: SUCCESS}\n") << QByteArray(":1:4:");
  QTest::newRow("list") << QByteArray("- SUCCESS\n") << QByteArray(":1:1:");
  QTest::newRow("twice") << QByteArray("a: SUCCESS\nb: FAILURE\na: FAILURE\n")
                         << QByteArray(":3:1:");
  QTest::newRow("cut") << QByteArray("a: [SUCCESS, ") << QByteArray(":");
  QTest::newRow("binary") << QByteArray("\xff\xfe\x00z", 4) << QByteArray(":1:");
}

void TreesProgramTest::play_badScript_saysWhere() {
  QFETCH(QByteArray, script);
  QFETCH(QByteArray, place);
  Play play;
  const Finished found = play.run("<Sequence><a/><b/></Sequence>", script, {});
  QCOMPARE(found.exitCode, 2);
  QVERIFY(found.out.isEmpty());
  const QString start = utf8("s.yaml") + utf8(place.constData());
  QVERIFY2(found.err.contains(start) && found.err.contains(utf8("error: ")), qPrintable(found.err));
}

void TreesProgramTest::play_badTree_isBadInput() {
  Play play;
  QCOMPARE(play.run("<Sequence><NoSuchNode/></Sequence>", "", {}).exitCode, 2);
  QCOMPARE(play.run("<Sequence/>", "", {}).exitCode, 2);
  const Finished missing = outside::runProgram(
      {QStringLiteral("trees"), QStringLiteral("--play"), QStringLiteral("/nowhere/t.xml")});
  QCOMPARE(missing.exitCode, 2);
  QVERIFY2(missing.err.startsWith(utf8("/nowhere/t.xml: error: ")), qPrintable(missing.err));
}

void TreesProgramTest::play_faultyTree_keepsTheTicksAndFails() {
  Play play;
  const Finished found = play.run(
      "<SequenceWithMemory><a/>\n<Script code='x := y + 1'/></SequenceWithMemory>", "", {});
  QCOMPARE(found.exitCode, 1);
  QVERIFY2(found.out.contains(utf8("1     RUNNING  a SUCCESS\n")), qPrintable(found.out));
  QVERIFY2(found.err.contains(utf8("t.xml:2: error: SequenceWithMemory/Script: ")),
           qPrintable(found.err));
}

void TreesProgramTest::play_probabilityChoice_dependsOnTheSeed() {
  Play play;
  const auto drawn = [&play](const char* seed) {
    return traceOf(play.run("<ProbabilityChoice weights='1;1'><a/><b/></ProbabilityChoice>", "",
                            {QStringLiteral("--json"), QStringLiteral("--ticks"),
                             QStringLiteral("40"), QStringLiteral("--seed"), utf8(seed)}));
  };
  const QStringList first = drawn("1");
  QCOMPARE(first.size(), 40);
  QVERIFY(first.contains(utf8("a:S -> SUCCESS")) && first.contains(utf8("b:S -> SUCCESS")));
  QCOMPARE(drawn("1"), first);
  QVERIFY(drawn("2") != first);
}

void TreesProgramTest::words_wrong_exitWith64_data() {
  QTest::addColumn<QString>("words");
  QTest::newRow("nothing") << utf8("trees");
  QTest::newRow("both") << utf8("trees a.yaml --play b.xml");
  QTest::newRow("style of nothing") << utf8("trees a.yaml --style mine");
  QTest::newRow("folder for a play") << utf8("trees --play b.xml -o out");
  QTest::newRow("script without play") << utf8("trees a.yaml --script s.yaml");
  QTest::newRow("no ticks") << utf8("trees --play b.xml --ticks 0");
  QTest::newRow("half ticks") << utf8("trees --play b.xml --ticks 1.5");
  QTest::newRow("no step") << utf8("trees --play b.xml --dt 0");
  QTest::newRow("nan step") << utf8("trees --play b.xml --dt nan");
  QTest::newRow("seed below 0") << utf8("trees --play b.xml --seed -1");
  QTest::newRow("quirk") << utf8("trees --play b.xml --compat Q-99");
}

void TreesProgramTest::words_wrong_exitWith64() {
  QFETCH(QString, words);
  const Finished found = outside::runProgram(words.split(QLatin1Char(' ')));
  QCOMPARE(found.exitCode, 64);
  QVERIFY(found.out.isEmpty());
  QVERIFY(!found.err.isEmpty());
}

void TreesProgramTest::make_shippedScenario_treesPassTheCheck_data() {
  QTest::addColumn<QByteArray>("style");
  QTest::newRow("corrected") << QByteArray("corrected");
  QTest::newRow("hunav2") << QByteArray("hunav2");
}

void TreesProgramTest::make_shippedScenario_treesPassTheCheck() {
  QFETCH(QByteArray, style);
  QTemporaryDir folder;
  const QString scenario = utf8(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
  const QString out = folder.filePath(QStringLiteral("a/b"));
  const Finished made = outside::runProgram(makeWords(scenario, out, style.constData()));
  QVERIFY2(made.exitCode == 0, qPrintable(made.err));
  QStringList files;
  for (const QFileInfo& info : QDir(out).entryInfoList(QDir::Files)) {
    QVERIFY2(made.out.contains(utf8("written   ") + info.filePath() + QLatin1Char('\n')),
             qPrintable(made.out));
    files << info.filePath();
  }
  QVERIFY(files.size() >= 3);
  QVERIFY(QFile::exists(out + utf8("/BTRegularNav.xml")));
  QVERIFY(QFile::exists(out + utf8("/corner_cafe_agents__agent_1_bt.xml")));
  const Finished alone = outside::runProgram(QStringList{QStringLiteral("check")} + files);
  QVERIFY2(alone.exitCode == 0 && alone.err.isEmpty(), qPrintable(alone.err));
  const Finished together =
      outside::runProgram({QStringLiteral("check"), scenario, QStringLiteral("--trees"), out});
  QVERIFY2(together.exitCode == 0, qPrintable(together.err));
}

void TreesProgramTest::make_again_saysWhatBecameOfEachFile() {
  QTemporaryDir folder;
  const QString scenario = utf8(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
  QStringList words = makeWords(scenario, folder.path(), "corrected");
  QCOMPARE(outside::runProgram(words).exitCode, 0);
  const QString edited = folder.filePath(QStringLiteral("corner_cafe_agents__agent_1_bt.xml"));
  const QByteArray original = outside::bytesOf(edited);
  QVERIFY(!original.isEmpty());
  writeText(edited, "<root/>");
  writeText(folder.filePath(QStringLiteral("mine.xml")), "mine");
  const Finished text = outside::runProgram(words);
  QVERIFY(text.out.contains(utf8("replaced  ") + edited));
  QCOMPARE(text.out.count(utf8("replaced")), 1);
  QVERIFY(text.out.contains(utf8("unchanged ")) && !text.out.contains(utf8("written")));
  QCOMPARE(outside::bytesOf(edited), original);
  QCOMPARE(outside::bytesOf(folder.filePath(QStringLiteral("mine.xml"))), QByteArray("mine"));
  words << QStringLiteral("--json");
  const Finished json = outside::runProgram(words);
  for (const QJsonValue& file : QJsonDocument::fromJson(json.out.toUtf8()).array()) {
    QCOMPARE(file.toObject()[QStringLiteral("state")].toString(), utf8("unchanged"));
  }
}

void TreesProgramTest::make_withoutFolder_printsAll() {
  QTemporaryDir folder;
  const QString scenario = utf8(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
  QCOMPARE(outside::runProgram(makeWords(scenario, folder.path(), "corrected")).exitCode, 0);
  const Finished text = outside::runProgram({QStringLiteral("trees"), scenario});
  const Finished json =
      outside::runProgram({QStringLiteral("trees"), scenario, QStringLiteral("--json")});
  const QJsonArray all = QJsonDocument::fromJson(json.out.toUtf8()).array();
  QCOMPARE(all.size(), QDir(folder.path()).entryList(QDir::Files).size());
  for (const QJsonValue& value : all) {
    const QString name = value.toObject()[QStringLiteral("file")].toString();
    const QString content = QString::fromUtf8(outside::bytesOf(folder.filePath(name)));
    QCOMPARE(value.toObject()[QStringLiteral("text")].toString(), content);
    QVERIFY(text.out.contains(utf8("==> ") + name + utf8(" <==\n") + content));
  }
}

void TreesProgramTest::make_intoAFile_isAnError() {
  QTemporaryDir folder;
  const QString inTheWay = folder.filePath(QStringLiteral("file"));
  writeText(inTheWay, "x");
  const Finished found = outside::runProgram(makeWords(
      utf8(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml"), inTheWay, "corrected"));
  QCOMPARE(found.exitCode, 2);
  QVERIFY2(found.err.contains(utf8("error: ")), qPrintable(found.err));
  QCOMPARE(outside::bytesOf(inTheWay), QByteArray("x"));
}

void TreesProgramTest::make_baseNameWithFolder_isAnError() {
  QTemporaryDir folder;
  QByteArray text = outside::bytesOf(utf8(TEST_DATA_DIR "/scenario/canonical.yaml"));
  const int at = text.indexOf("yaml_base_name:");
  QVERIFY(at > 0);
  text.replace(at, text.indexOf('\n', at) - at, "yaml_base_name: ../outside");
  const QString scenario = folder.filePath(QStringLiteral("s.yaml"));
  writeText(scenario, text);
  const QString out = folder.filePath(QStringLiteral("out"));
  const Finished found = outside::runProgram(makeWords(scenario, out, "corrected"));
  QCOMPARE(found.exitCode, 2);
  QVERIFY(!QFile::exists(out));
  QVERIFY(QDir(folder.path()).entryList({QStringLiteral("outside*")}).isEmpty());
}

void TreesProgramTest::make_hunav2_hasTheGoalsOfTheShippedTrees_data() {
  QTest::addColumn<QString>("place");
  QTest::addColumn<QString>("base");
  QTest::newRow("isaac") << utf8("isaac") << utf8("warehouse_agents");
  for (const char* name : {"agents_cafe", "agents_house", "agents_warehouse"}) {
    QTest::newRow(name) << utf8("gazebo_classic") << utf8(name);
  }
  QTest::newRow("fortress") << utf8("gazebo_fortress") << utf8("cafe_agents");
}

void TreesProgramTest::make_hunav2_hasTheGoalsOfTheShippedTrees() {
  QFETCH(QString, place);
  QFETCH(QString, base);
  const QString root = interopFolder() + place;
  if (!QFile::exists(root)) {
    QSKIP("the interoperability files are not here");
  }
  QTemporaryDir folder;
  const Finished made = outside::runProgram(
      makeWords(root + utf8("/scenarios/") + base + utf8(".yaml"), folder.path(), "hunav2"));
  QVERIFY2(made.exitCode == 0, qPrintable(made.err));
  int compared = 0;
  for (const QString& name : QDir(folder.path()).entryList({base + utf8("__agent_*_bt.xml")})) {
    const QString shipped = root + utf8("/behavior_trees/") + name;
    if (QFile::exists(shipped)) {
      QCOMPARE(goalsIn(folder.filePath(name)), goalsIn(shipped));
      ++compared;
    }
  }
  QVERIFY(compared > 0);
}

/// People of canonical.yaml with the values that belong into the placeholders.
void TreesProgramTest::make_hunav2_bodyIsTheFilledTemplate_data() {
  QTest::addColumn<int>("agent");
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("goals");
  QTest::addColumn<QString>("values");
  QTest::newRow("regular") << 1 << utf8("BTRegularNav.xml") << utf8("1 2 3") << QString();
  QTest::newRow("impassive") << 2 << utf8("BTRegularNav.xml") << utf8("3 1") << QString();
  QTest::newRow("surprised") << 3 << utf8("BTSurprisedNav.xml") << utf8("2 1")
                             << utf8("dist=4 duration=30 once=true");
  QTest::newRow("scared") << 4 << utf8("BTScaredNav.xml") << utf8("1 3")
                          << utf8("dist=4 duration=40 maxvel=1.5 safe_distance=5");
  QTest::newRow("curious") << 5 << utf8("BTCuriousNav.xml") << utf8("2")
                           << utf8("dist=10 duration=40 maxvel=1.5 stopdist=1.5");
  QTest::newRow("threatening") << 6 << utf8("BTThreateningNav.xml") << utf8("3")
                               << utf8("dist=4 duration=40 frontdist=1.4");
}

namespace {

/// Tags with their attributes in the order of the file, from the first tree on; comments and blanks
/// do not count.
QStringList tagsOf(const QString& text) {
  QStringList tags;
  const QString body = QStringLiteral("<root>") + text.mid(text.indexOf(utf8("<BehaviorTree")));
  QXmlStreamReader xml(body);
  while (!xml.atEnd()) {
    xml.readNext();
    if (xml.isStartElement()) {
      QString tag = xml.name().toString();
      for (const QXmlStreamAttribute& attribute : xml.attributes()) {
        tag += QLatin1Char(' ') + attribute.name() + QLatin1Char('=') + attribute.value();
      }
      tags << tag;
    } else if (xml.isEndElement()) {
      tags << QLatin1Char('/') + xml.name().toString();
    }
  }
  return xml.hasError() ? QStringList{xml.errorString()} : tags;
}

QString filledTemplate(QString text, const QString& goals, const QString& values) {
  QString block = QStringLiteral("<Sequence name='SetGoals'>");
  const QStringList ids = goals.split(QLatin1Char(' '));
  for (int i = 0; i < ids.size(); ++i) {
    const QString goal =
        QStringLiteral("<RunOnce><SetGoal agent_id='{id}' goal_id='%1'/></RunOnce>").arg(ids[i]);
    const bool isLast = i + 1 == ids.size();
    block += isLast ? QStringLiteral("<Inverter>%1</Inverter>").arg(goal) : goal;
  }
  text.replace(utf8("{GOAL_SEQUENCE}"), block + QStringLiteral("</Sequence>"));
  for (const QString& pair : values.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
    const QStringList both = pair.split(QLatin1Char('='));
    text.replace(QLatin1Char('{') + both[0] + QLatin1Char('}'), both[1]);
  }
  return text;
}

}  // namespace

void TreesProgramTest::make_hunav2_bodyIsTheFilledTemplate() {
  QFETCH(int, agent);
  QFETCH(QString, file);
  QFETCH(QString, goals);
  QFETCH(QString, values);
  const QString path = interopFolder() + utf8("hunav_sim_v2/behavior_trees/") + file;
  if (!QFile::exists(path)) {
    QSKIP("the interoperability files are not here");
  }
  QTemporaryDir folder;
  QByteArray scenario = outside::bytesOf(utf8(TEST_DATA_DIR "/scenario/canonical.yaml"));
  scenario.replace("simulator: Gazebo Classic", "simulator: Webots");  // the panel's own layout
  QFile copy(folder.filePath(utf8("canonical.yaml")));
  QVERIFY(copy.open(QIODevice::WriteOnly) && copy.write(scenario) == scenario.size());
  copy.close();
  const Finished made = outside::runProgram(makeWords(copy.fileName(), folder.path(), "hunav2"));
  QVERIFY2(made.exitCode == 0, qPrintable(made.err));
  const QString ours = QString::fromUtf8(
      outside::bytesOf(folder.filePath(utf8("canonical__agent_%1_bt.xml").arg(agent))));
  const QString theirs = filledTemplate(QString::fromUtf8(outside::bytesOf(path)), goals, values);
  const QStringList tags = tagsOf(ours);
  QVERIFY(tags.size() > 10);
  QCOMPARE(tags, tagsOf(theirs));
}

QTEST_GUILESS_MAIN(TreesProgramTest)
#include "tst_TreesProgram.moc"
