#include <algorithm>
#include <limits>

#include <QElapsedTimer>
#include <QtTest>

#include "tests/bench/PlainEngine.h"
#include "tests/bt/TreeProbe.h"

/// Time of one tick of a tree of 20 reactive nodes, all of which are ticked and whose leaves read
/// their ports from the blackboard, ours beside an engine of the usual kind, and of making one
/// tree. Both call the same leaves.
class TreeTickBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void tick_trees_data();
  void tick_trees();
  void create_trees();

 private:
  std::shared_ptr<const bt::Program> program_;
};

namespace {

using base::NodeStatus;

constexpr int kBranches = 6;  // of three nodes, beside the root and a last leaf: 20
constexpr int kRounds = 7;    // the best one counts
constexpr long kTicksPerRound = 100000;

struct Counter {
  long reads = 0;
};

NodeStatus isNear(Counter& counter, int id, double distance) {
  counter.reads += id;
  return distance > 0.0 ? NodeStatus::Success : NodeStatus::Failure;
}

NodeStatus walk(Counter& counter, int id, double step) {
  counter.reads += id;
  return step > 0.0 ? NodeStatus::Failure : NodeStatus::Running;
}

bt::NodeManifest manifest(const char* id, const char* second) {
  return probe::manifest(
      id, {probe::port("id", bt::PortType::Int), probe::port(second, bt::PortType::Double)});
}

bt::NodeLibrary library() {
  bt::NodeLibrary result;
  result.add(manifest("Near", "distance"), bt::synchronous([](bt::LeafContext& leaf) {
               return isNear(leaf.host<Counter>(), leaf.require<int>(0), leaf.require<double>(1));
             }));
  result.add(manifest("Walk", "step"), bt::synchronous([](bt::LeafContext& leaf) {
               return walk(leaf.host<Counter>(), leaf.require<int>(0), leaf.require<double>(1));
             }));
  return result;
}

std::string treeText() {
  std::string xml = "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\"><ReactiveFallback>";
  for (int i = 0; i < kBranches; ++i) {
    xml +=
        "<ReactiveSequence><Near id='{id}' distance='{dt}'/><Walk id='{id}' step='{dt}'/>"
        "</ReactiveSequence>";
  }
  return xml + "<Walk id='{id}' step='{dt}'/></ReactiveFallback></BehaviorTree></root>";
}

class PlainNear : public plain::Node {
 public:
  PlainNear(plain::Ports ports, std::shared_ptr<plain::Blackboard> blackboard, Counter& counter)
      : Node("Near", std::move(ports), std::move(blackboard)), counter_(counter) {}

 protected:
  NodeStatus tick() override {
    return isNear(counter_, input<int>("id"), input<double>("distance"));
  }

 private:
  Counter& counter_;
};

class PlainWalk : public plain::Node {
 public:
  PlainWalk(plain::Ports ports, std::shared_ptr<plain::Blackboard> blackboard, Counter& counter)
      : Node("Walk", std::move(ports), std::move(blackboard)), counter_(counter) {}

 protected:
  NodeStatus tick() override { return walk(counter_, input<int>("id"), input<double>("step")); }

 private:
  Counter& counter_;
};

/// The same tree in the plain engine.
struct PlainTree {
  explicit PlainTree(Counter& counter) : blackboard(std::make_shared<plain::Blackboard>()) {
    auto top = std::make_unique<plain::ReactiveFallback>("top", plain::Ports(), blackboard);
    const plain::Ports walkPorts = {{"id", "{id}"}, {"step", "{dt}"}};
    for (int i = 0; i < kBranches; ++i) {
      auto branch = std::make_unique<plain::ReactiveSequence>("branch", plain::Ports(), blackboard);
      branch->add(std::make_unique<PlainNear>(plain::Ports{{"id", "{id}"}, {"distance", "{dt}"}},
                                              blackboard, counter));
      branch->add(std::make_unique<PlainWalk>(walkPorts, blackboard, counter));
      top->add(std::move(branch));
    }
    top->add(std::make_unique<PlainWalk>(walkPorts, blackboard, counter));
    root = std::move(top);
    blackboard->set("id", 7);
    blackboard->set("dt", 0.1);
  }
  std::shared_ptr<plain::Blackboard> blackboard;
  std::unique_ptr<plain::Node> root;
};

/// Best time of one call of `tickAll` per tree [ns].
template <class TickAll>
double timeOf(std::size_t trees, const TickAll& tickAll) {
  const long steps = std::max(1L, kTicksPerRound / static_cast<long>(trees));
  double best = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kRounds; ++round) {
    QElapsedTimer clock;
    clock.start();
    for (long step = 0; step < steps; ++step) {
      tickAll();
    }
    const auto ticks = static_cast<double>(steps) * static_cast<double>(trees);
    best = std::min(best, static_cast<double>(clock.nsecsElapsed()) / ticks);
  }
  return best;
}

/// dt is written before every tick, as in a simulation.
double timeOfOurs(const std::shared_ptr<const bt::Program>& program, std::size_t count,
                  Counter& counter) {
  std::vector<bt::TreeState> trees;
  for (std::size_t i = 0; i < count; ++i) {
    trees.emplace_back(program);
  }
  const int id = program->hostSlot(0);
  const int dt = program->hostSlot(1);
  for (bt::TreeState& tree : trees) {
    tree.set(id, 7);
  }
  std::int64_t step = 0;
  return timeOf(count, [&] {
    ++step;
    for (bt::TreeState& tree : trees) {
      tree.set(dt, 0.1);
      tree.tickOnce({step, 0.1, &counter});
    }
  });
}

double timeOfPlain(std::size_t count, Counter& counter) {
  std::vector<std::unique_ptr<PlainTree>> trees;
  for (std::size_t i = 0; i < count; ++i) {
    trees.push_back(std::make_unique<PlainTree>(counter));
  }
  return timeOf(count, [&] {
    for (const std::unique_ptr<PlainTree>& tree : trees) {
      tree->blackboard->set("dt", 0.1);
      tree->root->execute();
    }
  });
}

}  // namespace

void TreeTickBench::initTestCase() {
  const base::Result<bt::TreeFile> file = bt::readTreeText(treeText());
  QVERIFY(file);
  const auto program = bt::compile(*file, library());
  QVERIFY(program);
  program_ = *program;
  QCOMPARE(program_->nodeCount(), 20);
}

void TreeTickBench::tick_trees_data() {
  QTest::addColumn<int>("count");
  QTest::newRow("1") << 1;
  QTest::newRow("1000") << 1000;
  QTest::newRow("10000") << 10000;
}

void TreeTickBench::tick_trees() {
  QFETCH(int, count);
  Counter own;
  Counter other;
  const double ours = timeOfOurs(program_, static_cast<std::size_t>(count), own);
  const double plain = timeOfPlain(static_cast<std::size_t>(count), other);
  QCOMPARE(own.reads, other.reads);  // both did the same work
  qInfo("%5d trees of 20 nodes: %7.1f ns per tick, plain engine %8.1f ns, ratio %.1f", count, ours,
        plain, plain / ours);
  QTest::setBenchmarkResult(ours, QTest::WalltimeNanoseconds);
}

void TreeTickBench::create_trees() {
  constexpr std::size_t kCount = 1000;
  Counter counter;
  const double ours = timeOf(kCount, [this] {
    std::vector<bt::TreeState> trees;
    trees.reserve(kCount);
    for (std::size_t i = 0; i < kCount; ++i) {
      trees.emplace_back(program_);
    }
  });
  const double plain = timeOf(kCount, [&counter] {
    std::vector<std::unique_ptr<PlainTree>> trees;
    for (std::size_t i = 0; i < kCount; ++i) {
      trees.push_back(std::make_unique<PlainTree>(counter));
    }
  });
  qInfo("a new tree: %.0f ns, plain engine %.0f ns, ratio %.1f", ours, plain, plain / ours);
  QTest::setBenchmarkResult(ours, QTest::WalltimeNanoseconds);
}

QTEST_APPLESS_MAIN(TreeTickBench)
#include "bench_TreeTick.moc"
