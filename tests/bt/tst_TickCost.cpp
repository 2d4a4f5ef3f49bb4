#include "tests/AllocationCount.h"
#include "tests/bt/TreeProbe.h"

namespace {

using base::NodeStatus;

struct Counter {
  long reads = 0;
};

bt::NodeLibrary library() {
  bt::NodeLibrary result;
  result.add(probe::manifest("Near", {probe::port("id", bt::PortType::Int),
                                      probe::port("distance", bt::PortType::Double)}),
             bt::synchronous([](bt::LeafContext& leaf) {
               leaf.host<Counter>().reads += leaf.require<int>(0);
               return leaf.require<double>(1) < 0.0 ? NodeStatus::Success : NodeStatus::Failure;
             }));
  bt::StatefulFunctions walk;
  walk.onStart = [](bt::LeafContext& leaf) {
    leaf.host<Counter>().reads += leaf.require<int>(0);
    return NodeStatus::Running;
  };
  walk.onRunning = walk.onStart;
  result.add(probe::manifest("Walk", {probe::port("id", bt::PortType::Int),
                                      probe::port("step", bt::PortType::Double)}),
             bt::stateful(walk));
  return result;
}

/// 20 nodes, all ticked in every step.
std::string reactiveTree() {
  std::string xml = "<ReactiveFallback>";
  for (int i = 0; i < 6; ++i) {
    xml +=
        "<ReactiveSequence><Near id='{id}' distance='{dt}'/><Walk id='{id}' step='{dt}'/>"
        "</ReactiveSequence>";
  }
  return xml + "<Walk id='{id}' step='{dt}'/></ReactiveFallback>";
}

std::shared_ptr<const bt::Program> program(const std::string& xml) {
  const base::Result<bt::TreeFile> file = bt::readTreeText(probe::fileOf(xml));
  const auto result = bt::compile(*file, library());
  if (!result) {
    qFatal("%s", probe::textOf(result.diagnostics()).c_str());
  }
  return *result;
}

void tickAll(std::vector<bt::TreeState>& trees, std::int64_t step, Counter& counter) {
  const int id = trees.front().program().hostSlot(0);
  const int dt = trees.front().program().hostSlot(1);
  for (bt::TreeState& tree : trees) {
    tree.set(id, 7);
    tree.set(dt, 0.1);
    tree.tickOnce({step, 0.1, &counter});
  }
}

}  // namespace

/// A tick allocates nothing. What it costs tells bench_TreeTick.
class TickCostTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tick_twentyNodes_allocatesNothing_data() {
    QTest::addColumn<QString>("xml");
    QTest::newRow("reactive") << QString::fromStdString(reactiveTree());
    QTest::newRow("scripts") << QStringLiteral(
        "<Sequence><Script code='n := 1; m := n + id'/><Walk id='{id}' step='{dt}' _while='n == "
        "1'/>"
        "</Sequence>");
    QTest::newRow("restarted leaf") << QStringLiteral(
        "<Sequence><SetBlackboard value='{id}' output_key='a'/><Timeout msec='100'>"
        "<Walk id='{a}' step='{dt}'/></Timeout></Sequence>");
    QTest::newRow("switch, parallel, loop") << QStringLiteral(
        "<Parallel success_count='3'><Switch2 variable='{n}' case_1='1' case_2='2'><AlwaysSuccess/>"
        "<AlwaysSuccess/><AlwaysFailure/></Switch2><LoopInt queue='1;2;3' value='{v}'>"
        "<AlwaysSuccess/></LoopInt><Repeat num_cycles='5'><AlwaysSuccess/></Repeat></Parallel>");
  }

  void tick_twentyNodes_allocatesNothing() {
    QFETCH(QString, xml);
    std::vector<bt::TreeState> trees;
    trees.emplace_back(program(xml.toStdString()));
    Counter counter;
    const long before = allocations;
    for (int step = 1; step <= 100; ++step) {
      tickAll(trees, step, counter);
    }
    const long after = allocations;
    QCOMPARE(after - before, 0L);
    QVERIFY(!trees[0].fault());
  }
};

QTEST_APPLESS_MAIN(TickCostTest)
#include "tst_TickCost.moc"
