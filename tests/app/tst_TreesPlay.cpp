#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

/// `hunavsim trees --play` from outside.
class TreesPlayTest : public QObject {
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
  void play_navigatorTree_ticksItsLeaves();
};

namespace {

/// Leaves of people's trees under short names: S succeeds, the others do what the script says.
QByteArray leaf(const QByteArray& name) {
  return "<RegularNav name='" + name + "' agent_id='{id}' time_step='{dt}'/>";
}

QByteArray fileOf(const QByteArray& body) {
  static const QRegularExpression letter(QStringLiteral("<([a-zA-Z][a-zA-Z0-9]?|Vis|nav)/>"));
  QString text = QString::fromUtf8(body);
  text.replace(letter, QString::fromUtf8(leaf("\\1")));
  return "<root BTCPP_format='4'><BehaviorTree ID='T'>" + text.toUtf8() +
         "</BehaviorTree></root>\n";
}

struct Play {
  QTemporaryDir folder;
  Finished run(const QByteArray& body, const QByteArray& script, const QStringList& more) {
    const QString tree = folder.filePath(text("t.xml"));
    const QString statuses = folder.filePath(text("s.yaml"));
    writeText(tree, fileOf(body));
    writeText(statuses, script);
    return runProgram(list("trees --play % --script % --dt 0.1", {tree, statuses}) + more);
  }
};

/// "a:SUCCESS b:RUNNING -> RUNNING" per tick, of --json.
QStringList traceOf(const Finished& finished) {
  QStringList ticks;
  for (const auto& value : QJsonDocument::fromJson(finished.out.toUtf8()).array()) {
    const QJsonObject tick = value.toObject();
    QString line;
    for (const auto& called : tick[text("leaves")].toArray()) {
      const QJsonObject object = called.toObject();
      line += object[text("name")].toString() + QLatin1Char(':') +
              object[text("status")].toString().left(1) + QLatin1Char(' ');
    }
    ticks << line + text("-> ") + tick[text("root")].toString();
  }
  return ticks;
}

void row(const char* name, const char* body, const char* script, const char* ticks) {
  QTest::newRow(name) << QByteArray(body) << QByteArray(script)
                      << text(ticks).split(QLatin1Char('|'));
}

}  // namespace

/// Traces recorded with BehaviorTree.CPP 4.10, one tick per step.
void TreesPlayTest::play_tree_givesTheRecordedTrace_data() {
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

void TreesPlayTest::play_tree_givesTheRecordedTrace() {
  QFETCH(QByteArray, body);
  QFETCH(QByteArray, script);
  QFETCH(QStringList, expected);
  Play play;
  const Finished found =
      play.run(body, script, {text("--json"), text("--ticks"), QString::number(expected.size())});
  QVERIFY2(found.exitCode == 0, qPrintable(found.err));
  QCOMPARE(traceOf(found), expected);
  QVERIFY2(found.err.isEmpty(), qPrintable(found.err));
}

void TreesPlayTest::play_compatQ20_delayIsNotArmedAgain() {
  Play play;
  const Finished found =
      play.run("<TimeDelay delay='0.3'><S/></TimeDelay>", "",
               {text("--json"), text("--ticks"), text("5"), text("--compat"), text("Q-20")});
  QCOMPARE(traceOf(found), text("-> FAILURE|-> FAILURE|-> FAILURE|S:S -> SUCCESS|S:S -> SUCCESS")
                               .split(QLatin1Char('|')));
}

void TreesPlayTest::play_text_isATable() {
  Play play;
  const Finished found = play.run("<Sequence><a/><RunOnce><St/></RunOnce></Sequence>",
                                  "St: [RUNNING, FAILURE]", {text("--ticks"), text("3")});
  QCOMPARE(found.out, text("tick  root     leaves\n"
                           "1     RUNNING  a SUCCESS, St RUNNING\n"
                           "2     FAILURE  St FAILURE\n"
                           "3     SUCCESS  a SUCCESS\n"));
  const Finished without = runProgram("trees --play %", {play.folder.filePath(text("t.xml"))});
  QCOMPARE(without.out.count(QLatin1Char('\n')), 11);  // ten ticks, all leaves succeed
  QVERIFY(without.out.contains(text("\n10    SUCCESS  a SUCCESS\n")));
}

void TreesPlayTest::play_idInScript_countsForEachLeaf() {
  Play play;
  const Finished found = play.run("<Fallback><a/><b/><UpdateGoal agent_id='{id}'/></Fallback>",
                                  "RegularNav: [FAILURE, FAILURE, SUCCESS]\nb: FAILURE\n",
                                  {text("--json"), text("--ticks"), text("3")});
  QCOMPARE(traceOf(found), text("a:F b:F UpdateGoal:S -> SUCCESS|a:F b:F UpdateGoal:S -> SUCCESS|"
                                "a:S -> SUCCESS")
                               .split(QLatin1Char('|')));
}

void TreesPlayTest::play_unknownName_isAWarning() {
  Play play;
  const Finished found = play.run("<Sequence><Vis/></Sequence>", "Viz: [FAILURE]\n", {});
  QCOMPARE(unexpected(found, 0, text("s.yaml:1:1: warning: ")), QString());
  QVERIFY2(found.err.contains(text("did you mean 'Vis'?")), qPrintable(found.err));
}

void TreesPlayTest::play_badScript_saysWhere_data() {
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

void TreesPlayTest::play_badScript_saysWhere() {
  QFETCH(QByteArray, script);
  QFETCH(QByteArray, place);
  Play play;
  const Finished found = play.run("<Sequence><a/><b/></Sequence>", script, {});
  QCOMPARE(found.exitCode, 2);
  QVERIFY(found.out.isEmpty());
  const QString start = text("s.yaml") + text(place.constData());
  QVERIFY2(found.err.contains(start) && found.err.contains(text("error: ")), qPrintable(found.err));
}

void TreesPlayTest::play_badTree_isBadInput() {
  Play play;
  QCOMPARE(play.run("<Sequence><NoSuchNode/></Sequence>", "", {}).exitCode, 2);
  QCOMPARE(play.run("<Sequence/>", "", {}).exitCode, 2);
  const Finished missing = runProgram("trees --play /nowhere/t.xml");
  QCOMPARE(missing.exitCode, 2);
  QVERIFY2(missing.err.startsWith(text("/nowhere/t.xml: error: ")), qPrintable(missing.err));
}

void TreesPlayTest::play_faultyTree_keepsTheTicksAndFails() {
  Play play;
  const Finished found = play.run(
      "<SequenceWithMemory><a/>\n<Script code='x := y + 1'/></SequenceWithMemory>", "", {});
  QCOMPARE(found.exitCode, 1);
  QVERIFY2(found.out.contains(text("1     RUNNING  a SUCCESS\n")), qPrintable(found.out));
  QVERIFY2(found.err.contains(text("t.xml:2: error: SequenceWithMemory/Script: ")),
           qPrintable(found.err));
}

void TreesPlayTest::play_probabilityChoice_dependsOnTheSeed() {
  Play play;
  const auto drawn = [&play](const char* seed) {
    return traceOf(
        play.run("<ProbabilityChoice weights='1;1'><a/><b/></ProbabilityChoice>", "",
                 {text("--json"), text("--ticks"), text("40"), text("--seed"), text(seed)}));
  };
  const QStringList first = drawn("1");
  QCOMPARE(first.size(), 40);
  QVERIFY(first.contains(text("a:S -> SUCCESS")) && first.contains(text("b:S -> SUCCESS")));
  QCOMPARE(drawn("1"), first);
  QVERIFY(drawn("2") != first);
}

/// A robot's tree: the planner answers twice, the controller never ends, and is halted by a wish to
/// plan anew (a rate of 1 Hz, ticks of 0.1 s: in the first and the eleventh).
void TreesPlayTest::play_navigatorTree_ticksItsLeaves() {
  QTemporaryDir folder;
  const QString tree = folder.filePath(text("nav.xml"));
  const QString script = folder.filePath(text("s.yaml"));
  writeText(tree,
            "<root BTCPP_format='4' main_tree_to_execute='T'><BehaviorTree ID='T'>"
            "<PipelineSequence><RateController hz='1.0'>"
            "<ComputePathToPose goal='{goal}' path='{path}' planner_id='GridBased'/>"
            "</RateController><FollowPath path='{path}' controller_id='FollowPath'/>"
            "</PipelineSequence></BehaviorTree></root>\n");
  writeText(script, "FollowPath: [RUNNING]\n");
  const Finished found =
      runProgram("trees --play % --script % --dt 0.1 --ticks 12 --json", {tree, script});
  QVERIFY2(found.exitCode == 0, qPrintable(found.err));
  QVERIFY2(!found.err.contains(text("unknown")), qPrintable(found.err));
  const int plans = found.out.count(text("\"id\": \"ComputePathToPose\""));
  const int follows = found.out.count(text("\"id\": \"FollowPath\""));
  QVERIFY2(plans == 2, qPrintable(found.out));
  QVERIFY2(follows == 12, qPrintable(found.out));
}

QTEST_GUILESS_MAIN(TreesPlayTest)
#include "tst_TreesPlay.moc"
