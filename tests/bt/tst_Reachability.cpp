#include <QtTest/QtTest>

#include "bt/robot/RobotNodes.h"
#include "tests/bt/TreeProbe.h"

namespace {

/// Names of the nodes that are never executed.
QString unreachableIn(const char* xml, const bt::NodeLibrary& library) {
  const auto program = probe::compiled(xml, library);
  if (!program) {
    return QString::fromStdString(probe::textOf(program.diagnostics()));
  }
  QStringList names;
  for (int node = 0; node < (*program)->nodeCount(); ++node) {
    if ((*(*program)->unreachable())[static_cast<std::size_t>(node)]) {
      names << QString::fromStdString((*program)->label(node));
    }
  }
  return names.join(QLatin1Char(' '));
}

}  // namespace

/// Nodes that the structure of a tree excludes.
class ReachabilityTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void unreachable_people_isWhatTheStructureExcludes_data() {
    QTest::addColumn<QString>("xml");
    QTest::addColumn<QString>("names");
    const auto row = [](const char* name, const char* xml, const char* names) {
      QTest::newRow(name) << QString::fromLatin1(xml) << QString::fromLatin1(names);
    };
    row("any leaf may have any result",
        "<Sequence><S name='a'/><Fallback><F name='b'/><S name='c'/></Fallback></Sequence>", "");
    row("after AlwaysFailure in a Sequence",
        "<Sequence><S name='a'/><AlwaysFailure/><S name='b'/><Sequence name='c'><S name='d'/>"
        "</Sequence></Sequence>",
        "b c d");
    row("after AlwaysSuccess in a Fallback",
        "<ReactiveFallback><AlwaysSuccess/><S name='a'/></ReactiveFallback>", "a");
    row("Inverter", "<Sequence><Inverter><AlwaysSuccess/></Inverter><S name='a'/></Sequence>", "a");
    row("ForceSuccess",
        "<Fallback><ForceSuccess><S name='a'/></ForceSuccess><S name='b'/></Fallback>", "b");
    row("ForceFailure of a leaf that may be running",
        "<Sequence><ForceFailure><St name='a'/></ForceFailure><S name='b'/></Sequence>", "b");
    row("results of a chain",
        "<Sequence><Fallback><AlwaysFailure name='x'/><AlwaysFailure name='y'/></Fallback>"
        "<S name='a'/></Sequence>",
        "a");
    row("one child of a chain may succeed",
        "<Sequence><Fallback><AlwaysFailure/><S name='a'/></Fallback><S name='b'/></Sequence>", "");
    row("the child that would fail is never executed",
        "<Fallback><Sequence><Fallback><AlwaysSuccess/><AlwaysFailure name='a'/></Fallback>"
        "</Sequence><S name='b'/></Fallback>",
        "a b");
    row("a condition may change the result",
        "<Sequence><AlwaysFailure _skipIf='id == 1'/><S name='a'/></Sequence>", "");
    row("branches of IfThenElse",
        "<IfThenElse><AlwaysSuccess/><S name='then'/><S name='else'/></IfThenElse>", "else");
    row("branches of WhileDoElse",
        "<WhileDoElse><AlwaysFailure/><S name='do'/><S name='else'/></WhileDoElse>", "do");
    row("Parallel starts all",
        "<Parallel success_count='1' failure_count='1'><AlwaysFailure/><S name='a'/></Parallel>",
        "");
    row("in a SubTree",
        "<root BTCPP_format='4' main_tree_to_execute='M'><BehaviorTree ID='M'><Sequence>"
        "<SubTree ID='Sub'/><S name='a'/></Sequence></BehaviorTree><BehaviorTree ID='Sub'>"
        "<Sequence><AlwaysFailure/><S name='b'/></Sequence></BehaviorTree></root>",
        "b a");
  }
  void unreachable_people_isWhatTheStructureExcludes() {
    QFETCH(QString, xml);
    QFETCH(QString, names);
    QCOMPARE(unreachableIn(qPrintable(xml), probe::library()), names);
  }

  void unreachable_navigator_knowsRecoveries() {
    const bt::NodeLibrary library = bt::robotNodes();
    const auto names = [&](const char* xml) { return unreachableIn(xml, library); };
    QCOMPARE(names("<RecoveryNode number_of_retries='1'><Wait name='a'/><Wait name='b'/>"
                   "</RecoveryNode>"),
             QString());
    QCOMPARE(names("<RecoveryNode number_of_retries='1'><ForceSuccess><Wait name='a'/>"
                   "</ForceSuccess><Wait name='b'/></RecoveryNode>"),
             QStringLiteral("b"));
    QCOMPARE(names("<PipelineSequence><AlwaysFailure/><Wait name='a'/></PipelineSequence>"),
             QStringLiteral("a"));
    QCOMPARE(names("<RoundRobin><AlwaysFailure/><Wait name='a'/></RoundRobin>"), QString());
  }
};

QTEST_APPLESS_MAIN(ReachabilityTest)
#include "tst_Reachability.moc"
