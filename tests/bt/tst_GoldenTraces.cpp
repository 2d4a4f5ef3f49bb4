#include "tests/bt/TraceRows.h"
#include "tests/bt/TreeProbe.h"

using traces::row;

namespace {

void rowsOfNodes() {
  row("goal block",
      "<Fallback><Sequence><RunOnce><S name='g1'/></RunOnce><Inverter><RunOnce><S name='g2'/>"
      "</RunOnce></Inverter></Sequence><S name='A'/></Fallback>",
      "g1 g2 A -> SUCCESS|A -> SUCCESS|A -> SUCCESS");
  row("goal block alone",
      "<Sequence><RunOnce><S name='g1'/></RunOnce><Inverter><RunOnce><S name='g2'/>"
      "</RunOnce></Inverter></Sequence>",
      "g1 g2 -> FAILURE|-> SKIPPED|-> SKIPPED|-> SKIPPED");
  row("sequence", "<Sequence><S name='a'/><S name='b'/><S name='c'/></Sequence>",
      "a b c -> SUCCESS|a b c -> SUCCESS");
  row("memory, three successes",
      "<SequenceWithMemory><S name='a'/><S name='b'/><S name='c'/></SequenceWithMemory>",
      "a -> RUNNING|b -> RUNNING|c -> SUCCESS|a -> RUNNING");
  row("memory, one failure",
      "<SequenceWithMemory><S name='a'/><F/><S name='c'/></SequenceWithMemory>",
      "a -> RUNNING|F -> FAILURE|F -> FAILURE|F -> FAILURE");
  row("retry 3", "<RetryUntilSuccessful num_attempts='3'><F/></RetryUntilSuccessful>",
      "F -> RUNNING|F -> RUNNING|F -> FAILURE|F -> RUNNING");
  row("retry for ever", "<RetryUntilSuccessful num_attempts='-1'><F/></RetryUntilSuccessful>",
      "F -> RUNNING|F -> RUNNING|F -> RUNNING|F -> RUNNING|F -> RUNNING");
  row("retry of a stateful leaf",
      "<RetryUntilSuccessful num_attempts='2'><St result='FAILURE'/></RetryUntilSuccessful>",
      "start -> RUNNING|run1 start -> RUNNING|run1 -> FAILURE|start -> RUNNING");
  row("repeat 3", "<Repeat num_cycles='3'><S/></Repeat>",
      "S -> RUNNING|S -> RUNNING|S -> SUCCESS|S -> RUNNING");
  row("keep running", "<KeepRunningUntilFailure><S/></KeepRunningUntilFailure>",
      "S -> RUNNING|S -> RUNNING|S -> RUNNING|S -> RUNNING");
  row("fallback", "<Fallback><F/><St runs='2'/></Fallback>",
      "F start -> RUNNING|run1 -> RUNNING|run2 -> SUCCESS|F start -> RUNNING");
  row("reactive fallback", "<ReactiveFallback><F/><St runs='2'/></ReactiveFallback>",
      "F start -> RUNNING|F run1 -> RUNNING|F run2 -> SUCCESS");
}

void rowsOfTimeAndTemplates() {
  row("time delay", "<TD><S/></TD>", "-> FAILURE|-> FAILURE|-> FAILURE|S -> SUCCESS|S -> SUCCESS");
  row("time delay of 1 s", "<TD delay='1.0'><S/></TD>",
      "-> FAILURE|-> FAILURE|-> FAILURE|-> FAILURE|-> FAILURE|-> FAILURE|-> FAILURE|"
      "-> FAILURE|-> FAILURE|-> FAILURE|S -> SUCCESS");
  row("time delay in memory, two rounds",
      "<SequenceWithMemory><S name='a'/><TD><St/></TD><S name='z'/></SequenceWithMemory>",
      "a -> RUNNING|-> FAILURE|-> FAILURE|-> FAILURE|start -> RUNNING|run1 z -> SUCCESS|"
      "a -> RUNNING|start -> RUNNING|run1 z -> SUCCESS");
  row("run once, failure", "<RunOnce><F/></RunOnce>", "F -> FAILURE|-> SKIPPED|-> SKIPPED");
  row("run once, remembered", "<RunOnce then_skip='false'><F/></RunOnce>",
      "F -> FAILURE|-> FAILURE|-> FAILURE");
  row("template, robot never visible",
      "<Fallback><Sequence><RunOnce><F name='Vis'/></RunOnce><RunOnce><St runs='2'/></RunOnce>"
      "</Sequence><S name='nav'/></Fallback>",
      "Vis nav -> SUCCESS|start -> RUNNING|run1 -> RUNNING|run2 -> SUCCESS|nav -> SUCCESS|"
      "nav -> SUCCESS");
  row("corrected, visible",
      "<Fallback><Sequence><S name='Vis'/><RunOnce then_skip='false'><ForceFailure><St runs='2'/>"
      "</ForceFailure></RunOnce></Sequence><S name='nav'/></Fallback>",
      "Vis start -> RUNNING|run1 -> RUNNING|run2 nav -> SUCCESS|Vis nav -> SUCCESS|"
      "Vis nav -> SUCCESS");
  row("corrected, not visible",
      "<Fallback><Sequence><F name='Vis'/><RunOnce then_skip='false'><ForceFailure><St runs='2'/>"
      "</ForceFailure></RunOnce></Sequence><S name='nav'/></Fallback>",
      "Vis nav -> SUCCESS|Vis nav -> SUCCESS");
  row("parallel", "<Parallel success_count='1' failure_count='-1'><St/><S/></Parallel>",
      "start S halt -> SUCCESS|start S halt -> SUCCESS");
  row("if-then-else, stateful condition",  // ours: no stale FAILURE, the condition starts again
      "<IfThenElse><St result='FAILURE'/><S/></IfThenElse>",
      "start -> RUNNING|run1 -> FAILURE|start -> RUNNING|run1 -> FAILURE");
  row("one skipped, one success",
      "<Fallback><Sequence><S name='v'/><RunOnce><S name='r'/></RunOnce></Sequence>"
      "<S name='nav'/></Fallback>",
      "v r -> SUCCESS|v -> SUCCESS|v -> SUCCESS");
}

void noteRow(const char* name, const std::string& xml, const char* notes) {
  QTest::newRow(name) << QString::fromStdString(xml) << QString::fromUtf8(notes);
}

std::string withSubTree(const char* call, const char* below) {
  return std::string("<root BTCPP_format='4' main_tree_to_execute='M'><BehaviorTree ID='M'>") +
         call + "</BehaviorTree><BehaviorTree ID='Sub'>" + below + "</BehaviorTree></root>";
}

/// "tree.there-stale:1 tree.there-clock:0"
QString notesOn(const std::string& xml) {
  const base::Result<bt::TreeFile> file = bt::readTreeText(probe::fileOf(xml), "t.xml");
  const base::Result<bt::TreeTable> table = bt::resolveIncludes(*file);
  QStringList codes;
  for (const base::Diagnostic& note : bt::differencesFromBtCpp(*table, probe::library())) {
    codes << QString::fromStdString(std::string(note.code)) + QLatin1Char(':') +
                 QString::number(note.line);
  }
  return codes.join(QLatin1Char(' '));
}

}  // namespace

/// Traces recorded with BehaviorTree.CPP 4.10, one tick per step.
class GoldenTracesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tick_tree_givesTheRecordedTrace_data() {
    traces::columns();
    rowsOfNodes();
    rowsOfTimeAndTemplates();
  }

  void tick_tree_givesTheRecordedTrace() { traces::checkRow(); }
  // Notes of `check` on a tree that BehaviorTree.CPP 4.10 runs differently: each row of the table
  // in bt/engine/README.md that a file can show.

  void notes_tree_areThoseOfTheTable_data() {
    QTest::addColumn<QString>("xml");
    QTest::addColumn<QString>("notes");
    noteRow("if, a stateful condition", "<IfThenElse><St/><S/></IfThenElse>", "tree.there-stale:1");
    noteRow("if, a condition with a pre-condition", "<IfThenElse><F _skipIf='0'/><S/></IfThenElse>",
            "tree.there-stale:1");
    noteRow("if, a stateful node in the condition",
            "<IfThenElse>\n<Inverter><St/></Inverter><S/></IfThenElse>", "tree.there-stale:1");
    noteRow("if, a plain condition", "<IfThenElse><Inverter><F/></Inverter><S/></IfThenElse>", "");
    noteRow("if, three children", "<IfThenElse><St/><S/><S/></IfThenElse>", "");
    noteRow("while, two children", "<WhileDoElse><St/><S/></WhileDoElse>", "");
    noteRow("times, once for a file",
            "<Sequence><Sleep msec='5'/><Delay delay_msec='5'><S/></Delay></Sequence>",
            "tree.there-clock:0");
    noteRow("constant of a SubTree for a real",
            withSubTree("<SubTree ID='Sub' x='7'/>", "<ReadDouble value='{x}'/>"),
            "tree.there-refused:1");
    noteRow("constant of a SubTree, written as a real",
            withSubTree("<SubTree ID='Sub' x='7.0'/>", "<ReadDouble value='{x}'/>"), "");
    noteRow("constant of a SubTree, whole",
            withSubTree("<SubTree ID='Sub' x='7'/>", "<ReadInt value='{x}'/>"), "");
    noteRow(
        "text to an entry of a script",
        "<Sequence><Script code='k := 1'/>\n<SetBlackboard value='5' output_key='k'/></Sequence>",
        "tree.there-emptied:2");
    noteRow("text to an entry of a typed port",
            "<Sequence><Script code='k := 1'/><SetBlackboard value='5' output_key='k'/>"
            "<ReadInt value='{k}'/></Sequence>",
            "");
    noteRow("text to an entry of its own", "<SetBlackboard value='5' output_key='k'/>", "");
    noteRow(
        "removed, and given to a SubTree",
        withSubTree("<Sequence><SubTree ID='Sub' x='{a}'/>\n<UnsetBlackboard key='a'/></Sequence>",
                    "<Script code='x := 1'/>"),
        "tree.there-kept:2");
    noteRow("removed, and given to nothing", "<UnsetBlackboard key='a'/>", "");
    noteRow("a queue is copied",
            "<Sequence><LoopInt queue='{q}' value='{v}'><S/></LoopInt>\n"
            "<SetBlackboard value='{q}' output_key='m'/></Sequence>",
            "tree.there-shared:2");
  }

  void notes_tree_areThoseOfTheTable() {
    QFETCH(QString, xml);
    QFETCH(QString, notes);
    QCOMPARE(notesOn(xml.toStdString()), notes);
  }

  /// They are for users who export a tree, not for users who run it.
  void notes_areNoPartOfOtherCompilations() {
    const auto program = probe::compiled("<IfThenElse><St/><S/></IfThenElse>");
    QVERIFY(program);
    QVERIFY(program.diagnostics().empty());
  }
};

QTEST_APPLESS_MAIN(GoldenTracesTest)
#include "tst_GoldenTraces.moc"
