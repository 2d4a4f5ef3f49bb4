#include <random>

#include "tests/bt/TreeProbe.h"

/// Nodes that are always done within the tick are run on a short way. A condition that changes
/// nothing, `_skipIf="false"`, sends the same tree down the long way: both must tell the same.
class InstantNodesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void flags_ofPlainAndConditionedTrees_differ();
  void tick_randomTrees_sameAsTheLongWay();
  void tick_leafThatIsNotDone_isAFaultAtThatLeaf();
  void tick_leafWithoutInput_stopsBeforeTheNextLeaf();
};

namespace {

using base::NodeStatus;

struct Answers {
  std::uint64_t bits = 0;  // question n is answered with yes when bit n is set
  std::vector<int> asked;
};

bt::NodeLibrary library() {
  bt::NodeLibrary result;
  result.addCondition(probe::manifest("Ask", {probe::port("n", bt::PortType::Int)}),
                      [](bt::LeafContext& leaf) {
                        const int n = leaf.require<int>(0);
                        leaf.host<Answers>().asked.push_back(n);
                        return (leaf.host<Answers>().bits >> n & 1U) != 0 ? NodeStatus::Success
                                                                          : NodeStatus::Failure;
                      });
  result.addAction(probe::manifest("Endless"),
                   [](bt::LeafContext&) { return NodeStatus::Running; });
  return result;
}

/// A random tree of at most `depth` levels; `extra` is written into every node.
class RandomTree {
 public:
  RandomTree(unsigned seed, const char* extra) : random_(seed), extra_(extra) {}

  std::string text(int depth) {
    static const char* const kControls[] = {"Sequence", "Fallback", "ReactiveSequence",
                                            "ReactiveFallback"};
    static const char* const kDecorators[] = {"Inverter", "ForceSuccess", "ForceFailure"};
    const std::size_t kind = depth == 0 ? 9 : random_() % 10;
    if (kind >= 7) {
      return "<Ask n='" + std::to_string(next_++ % 64) + "'" + extra_ + "/>";
    }
    const std::string name = kind < 4 ? kControls[kind] : kDecorators[kind - 4];
    const std::size_t children = kind < 4 ? 1 + random_() % 4 : 1;
    std::string body;
    for (std::size_t i = 0; i < children; ++i) {
      body += text(depth - 1);
    }
    return "<" + name + extra_ + ">" + body + "</" + name + ">";
  }

 private:
  std::mt19937 random_;
  std::string extra_;
  int next_ = 0;
};

std::shared_ptr<const bt::Program> compiled(const std::string& xml) {
  const auto file = bt::readTreeText(probe::fileOf(xml));
  const auto program = bt::compile(*file, library());
  if (!program) {
    qFatal("%s", probe::textOf(program.diagnostics()).c_str());
  }
  return *program;
}

}  // namespace

void InstantNodesTest::flags_ofPlainAndConditionedTrees_differ() {
  const auto shortWay =
      compiled("<Sequence><Ask n='0'/><Inverter><Ask n='1'/></Inverter></Sequence>");
  for (int node = 0; node < shortWay->nodeCount(); ++node) {
    QVERIFY(shortWay->node(node).isInstant);
  }
  const auto mixed = compiled(
      "<Sequence><Ask n='0' _skipIf='false'/><Inverter><Ask n='1'/></Inverter></Sequence>");
  QVERIFY(!mixed->node(0).isInstant);
  QVERIFY(!mixed->node(1).isInstant);
  QVERIFY(mixed->node(2).isInstant);
}

void InstantNodesTest::tick_randomTrees_sameAsTheLongWay() {
  std::mt19937_64 answers(5);
  for (unsigned seed = 0; seed < 300; ++seed) {
    const auto shortWay = compiled(RandomTree(seed, "").text(4));
    const auto longWay = compiled(RandomTree(seed, " _skipIf='false'").text(4));
    QVERIFY(shortWay->node(0).isInstant && !longWay->node(0).isInstant);
    bt::TreeState ours(shortWay);
    bt::TreeState other(longWay);
    for (int step = 1; step <= 20; ++step) {
      Answers first;
      first.bits = answers();
      Answers second = first;
      const NodeStatus root = ours.tickOnce({step, 0.1, &first});
      QCOMPARE(root, other.tickOnce({step, 0.1, &second}));
      QCOMPARE(first.asked, second.asked);
      QVERIFY(ours.statuses() == other.statuses());
    }
  }
}

void InstantNodesTest::tick_leafThatIsNotDone_isAFaultAtThatLeaf() {
  bt::TreeState tree(compiled(
      "<Fallback><Inverter><Ask n='0'/></Inverter><Sequence><Endless/><Ask n='1'/></Sequence>"
      "</Fallback>"));
  Answers answers;
  answers.bits = 1;
  QCOMPARE(tree.tickOnce({1, 0.1, &answers}), NodeStatus::Idle);
  QVERIFY(tree.fault());
  QCOMPARE(tree.fault()->path, std::string("Fallback/Sequence/Endless"));
  QCOMPARE(tree.fault()->message, std::string("the node returned RUNNING"));
  QCOMPARE(answers.asked, std::vector<int>{0});
  for (const NodeStatus status : tree.statuses()) {
    QCOMPARE(status, NodeStatus::Idle);
  }
}

void InstantNodesTest::tick_leafWithoutInput_stopsBeforeTheNextLeaf() {
  bt::TreeState tree(
      compiled("<Sequence><ForceSuccess><Ask/></ForceSuccess><Ask n='1'/></Sequence>"));
  Answers answers;
  answers.bits = 3;
  QCOMPARE(tree.tickOnce({1, 0.1, &answers}), NodeStatus::Idle);
  QVERIFY(tree.fault());
  QCOMPARE(tree.fault()->path, std::string("Sequence/ForceSuccess/Ask"));
  QCOMPARE(answers.asked, std::vector<int>{0});  // the leaf itself, with nothing read
  QCOMPARE(tree.tickOnce({2, 0.1, &answers}), NodeStatus::Idle);
  QCOMPARE(answers.asked, std::vector<int>{0});
}

QTEST_APPLESS_MAIN(InstantNodesTest)
#include "tst_InstantNodes.moc"
