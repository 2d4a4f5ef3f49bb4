#include <random>

#include "tests/bt/TraceRows.h"
#include "tests/bt/TreeProbe.h"

using traces::row;

namespace {

using base::NodeStatus;

struct PickMemory {
  int ticks;
};

/// Pick: runs the child with the number of its port; IDLE for a number that there is not.
NodeStatus pick(bt::ParentContext& node) {
  ++node.memory<PickMemory>().ticks;
  const int child = node.require<int>(0);
  probe::note(node, "pick" + std::to_string(node.memory<PickMemory>().ticks), NodeStatus::Idle);
  return child < node.childCount() ? node.tickChild(child) : NodeStatus::Idle;
}

/// Both: ticks all children, halts the first; returns what the last one did.
NodeStatus both(bt::ParentContext& node) {
  NodeStatus status = NodeStatus::Idle;
  for (int child = 0; child < node.childCount(); ++child) {
    status = node.tickChild(child);
  }
  node.resetChild(0);
  return status;
}

struct TurnMemory {
  int next;
};

/// Turns: one child per tick, RUNNING before the last; begins anew when halted.
NodeStatus turns(bt::ParentContext& node) {
  int& next = node.memory<TurnMemory>().next;
  const NodeStatus status = node.tickChild(next);
  ++next;
  if (next < node.childCount()) {
    return NodeStatus::Running;
  }
  next = 0;
  return status;
}

bt::NodeLibrary library() {
  bt::NodeLibrary result = probe::library();
  result.add(probe::manifest("Pick", {probe::port("child", bt::PortType::Int, "0")}),
             bt::control<PickMemory>({pick, [](bt::ParentContext& node) {
                                        probe::note(node, "halted", NodeStatus::Idle);
                                      }}));
  result.add(probe::manifest("Turns"),
             bt::control<TurnMemory>({turns, [](bt::ParentContext& node) {
                                        node.memory<TurnMemory>().next = 0;
                                        probe::note(node, "halted", NodeStatus::Idle);
                                      }}));
  bt::NodeManifest two = probe::manifest("Both");
  two.minChildren = 2;
  two.maxChildren = 2;
  result.add(two, bt::control({both, nullptr}));
  return result;
}

struct Playing : probe::Run {
  explicit Playing(const char* xml) : Run(xml, library()) {}
};

void compareTrace(Playing& tree, const char* expected) {
  const std::string trace = tree.trace();
  QVERIFY2(trace == expected, trace.c_str());
}

struct Answers {
  std::uint64_t bits = 0;  // question n is answered with yes when bit n is set
  std::vector<int> asked;
};

bt::NodeLibrary answeringLibrary() {
  bt::NodeLibrary result;
  result.add(probe::manifest("Ask", {probe::port("n", bt::PortType::Int)}),
             bt::synchronous([](bt::LeafContext& leaf) {
               const int n = leaf.require<int>(0);
               leaf.host<Answers>().asked.push_back(n);
               return (leaf.host<Answers>().bits >> n & 1U) != 0 ? NodeStatus::Success
                                                                 : NodeStatus::Failure;
             }));
  result.add(probe::manifest("Endless"),
             bt::synchronous([](bt::LeafContext&) { return NodeStatus::Running; }));
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
  const auto program = bt::compile(*file, answeringLibrary());
  if (!program) {
    qFatal("%s", probe::textOf(program.diagnostics()).c_str());
  }
  return *program;
}

void rowsOfRepetition() {
  row("inverter", "<Inverter><St result='FAILURE'/></Inverter>",
      "start -> RUNNING|run1 -> SUCCESS|start -> RUNNING");
  row("force success", "<ForceSuccess><F/></ForceSuccess>", "F -> SUCCESS");
  row("force failure", "<ForceFailure><St/></ForceFailure>", "start -> RUNNING|run1 -> FAILURE");
  row("force, skipped", "<ForceSuccess><AlwaysSuccess _skipIf='1'/></ForceSuccess>", "-> SKIPPED");
  row("repeat 0", "<Repeat num_cycles='0'><S/></Repeat>", "-> SUCCESS");
  row("repeat, failure", "<Repeat num_cycles='3'><F/></Repeat>", "F -> FAILURE");
  row("repeat a stateful child", "<Repeat num_cycles='2'><St/></Repeat>",
      "start -> RUNNING|run1 start -> RUNNING|run1 -> SUCCESS|start -> RUNNING");
  row("repeat for ever", "<Repeat num_cycles='-1'><S/></Repeat>", "S -> RUNNING|S -> RUNNING");
  row("repeat, skipped", "<Repeat num_cycles='2'><RunOnce><S/></RunOnce></Repeat>",
      "S -> RUNNING|-> SKIPPED|-> SKIPPED");
  row("repeat, no port", "<Repeat><S/></Repeat>", "!'num_cycles' is missing");
  row("repeat forgets when halted",
      "<ReactiveFallback><TD delay='0.1'><F name='t'/></TD><Repeat num_cycles='2'><S/></Repeat>"
      "</ReactiveFallback>",
      "S -> RUNNING|t S -> SUCCESS|t S -> RUNNING");
  row("retry 0", "<RetryUntilSuccessful num_attempts='0'><S/></RetryUntilSuccessful>",
      "-> FAILURE");
  row("retry, success", "<RetryUntilSuccessful num_attempts='5'><S/></RetryUntilSuccessful>",
      "S -> SUCCESS");
  row("retry, skipped",
      "<RetryUntilSuccessful num_attempts='5'><AlwaysSuccess _skipIf='1'/></RetryUntilSuccessful>",
      "-> SKIPPED");
  row("keep running, failure",
      "<KeepRunningUntilFailure><St result='FAILURE'/>"
      "</KeepRunningUntilFailure>",
      "start -> RUNNING|run1 -> FAILURE|start -> RUNNING");
  row("keep running, skipped",
      "<KeepRunningUntilFailure><AlwaysSuccess _skipIf='1'/></KeepRunningUntilFailure>",
      "-> RUNNING|-> RUNNING");
}

void rowsOfDelays() {
  row("delay", "<Delay delay_msec='200'><S/></Delay>",
      "-> RUNNING|-> RUNNING|S -> SUCCESS|-> RUNNING|-> RUNNING|S -> SUCCESS");
  row("delay of a stateful child", "<Delay delay_msec='100'><St/></Delay>",
      "-> RUNNING|start -> RUNNING|run1 -> SUCCESS|-> RUNNING");
  row("delay 0", "<Delay delay_msec='0'><S/></Delay>", "S -> SUCCESS");
  row("delay, halted while it waits",
      "<ReactiveFallback><TD delay='0.1'><S name='t'/></TD><Delay delay_msec='200'><S/></Delay>"
      "</ReactiveFallback>",
      "-> RUNNING|t -> SUCCESS|t -> SUCCESS");
  row("timeout", "<Timeout msec='200'><St runs='9'/></Timeout>",
      "start -> RUNNING|run1 -> RUNNING|halt -> FAILURE|start -> RUNNING");
  row("timeout, soon enough", "<Timeout msec='300'><St runs='2'/></Timeout>",
      "start -> RUNNING|run1 -> RUNNING|run2 -> SUCCESS|start -> RUNNING");
  row("timeout 0", "<Timeout msec='0'><St runs='2'/></Timeout>",
      "start -> RUNNING|run1 -> RUNNING|run2 -> SUCCESS");
  row("run once, halted before it was done",
      "<ReactiveFallback><TD delay='0.1'><F name='t'/></TD><RunOnce><St runs='2'/></RunOnce>"
      "<S name='e'/></ReactiveFallback>",
      "start -> RUNNING|t run1 -> RUNNING|t run2 -> SUCCESS|t e -> SUCCESS");
  row("run once, interrupted",
      "<ReactiveSequence><Repeat num_cycles='1'><Script code='n += "
      "1'/></Repeat></ReactiveSequence>",
      "!does not exist");
  row("precondition, true", "<Precondition if='1 == 1'><St/></Precondition>",
      "start -> RUNNING|run1 -> SUCCESS|start -> RUNNING");
  row("precondition, false", "<Precondition if='1 == 2'><S/></Precondition>", "-> FAILURE");
  row("precondition, else", "<Precondition if='1 == 2' else='SKIPPED'><S/></Precondition>",
      "-> SKIPPED");
  row("precondition is not asked again",
      "<Sequence><Script code='n := 1' _onSuccess='n := 1'/><Precondition if='n == 1'>"
      "<Sequence><Script code='n := 2'/><St/></Sequence></Precondition></Sequence>",
      "start -> RUNNING|run1 -> SUCCESS|start -> RUNNING");
}

void rowsOfEntries() {
  row("loop over a constant", "<LoopInt queue='4;5' value='{v}'><ReadInt value='{v}'/></LoopInt>",
      "4 -> RUNNING|5 -> RUNNING|-> SUCCESS|4 -> RUNNING|5 -> RUNNING|-> SUCCESS");
  row("loop, halted",
      "<Timeout msec='200'><LoopInt queue='4;5;6' value='{v}'><Sequence><ReadInt value='{v}'/>"
      "<St runs='2'/></Sequence></LoopInt></Timeout>",
      "4 start -> RUNNING|run1 -> RUNNING|halt -> FAILURE|4 start -> RUNNING");
  row("loop over an entry, from which the elements are taken",
      "<Sequence><RunOnce><Script code=\"q := '1;2'\"/></RunOnce>"
      "<LoopInt queue='{q}' value='{v}'><ReadInt value='{v}'/></LoopInt></Sequence>",
      "1 -> RUNNING|2 -> RUNNING|-> SUCCESS|-> SUCCESS");
  row("loop over an entry that is written again",
      "<Sequence><Script code=\"q := '1;2'\"/>"
      "<LoopInt queue='{q}' value='{v}'><ReadInt value='{v}'/></LoopInt></Sequence>",
      "1 -> RUNNING|2 -> RUNNING|-> SUCCESS|1 -> RUNNING");
  row("loop over an entry that SetBlackboard fills",
      "<Sequence><SetBlackboard value='1;2;' output_key='q'/>"
      "<LoopInt queue='{q}' value='{v}'><ReadInt value='{v}'/></LoopInt></Sequence>",
      "1 -> RUNNING|2 -> RUNNING|-> SUCCESS|1 -> RUNNING");
  row("loop over an entry that was never written",
      "<LoopDouble queue='{q}' value='{v}'><S/></LoopDouble>", "!has no value");
  row("loop over a text in an entry of any type",
      "<Sequence><ForceSuccess><SetBlackboard value='{q}' output_key='m'/></ForceSuccess>"
      "<Script code=\"q := '1;2'\"/><LoopInt queue='{q}' value='{v}'><S/></LoopInt></Sequence>",
      "!is not a queue of this type");
  row("loop over an entry",
      "<Sequence><RunOnce><Script code=\"q := '1.5;2'\"/></RunOnce>"
      "<LoopDouble queue='{q}' value='{v}' if_empty='FAILURE'><ReadDouble "
      "value='{v}'/></LoopDouble>"
      "</Sequence>",
      "1.5 -> RUNNING|2 -> RUNNING|-> FAILURE");
  row("loop, text, child fails",
      "<LoopString queue='a;b' value='{v}'><Sequence><ReadText value='{v}'/><F/></Sequence>"
      "</LoopString>",
      "a F -> FAILURE|a F -> FAILURE");
  row("loop, stateful child", "<LoopBool queue='1;0' value='{v}'><St/></LoopBool>",
      "start -> RUNNING|run1 -> RUNNING|start -> RUNNING|run1 -> RUNNING|-> SUCCESS|start -> "
      "RUNNING");
  row("precondition, child is skipped",
      "<Sequence><Precondition if='1 == 1'><S _skipIf='1 == 1'/></Precondition></Sequence>",
      "-> SKIPPED|-> SKIPPED");
  row("run once, port without a value",
      "<Sequence><RunOnce then_skip='{unset}'><S name='a'/></RunOnce><S name='b'/></Sequence>",
      "a b -> SUCCESS|b -> SUCCESS");
  row("skip unless updated",
      "<Sequence><RunOnce><SetBlackboard value='1' output_key='k'/></RunOnce>"
      "<SkipUnlessUpdated entry='{k}'><S/></SkipUnlessUpdated></Sequence>",
      "S -> SUCCESS|-> SKIPPED|-> SKIPPED");
  row("skip unless updated, never written",
      "<SkipUnlessUpdated entry='{k}'><S/></SkipUnlessUpdated>", "S -> SUCCESS|-> SKIPPED");
  row("skip unless updated, no such entry", "<SkipUnlessUpdated entry='k'><S/></SkipUnlessUpdated>",
      "-> SKIPPED|-> SKIPPED");
  row("wait for an update",
      "<Parallel success_count='1' failure_count='-1'><WaitValueUpdate entry='{k}'><St/>"
      "</WaitValueUpdate><Inverter><TD delay='0.1'><SetBlackboard value='1' output_key='k'/></TD>"
      "</Inverter></Parallel>",
      "start halt -> SUCCESS");
  row("custom decorator forgets when halted",
      "<Timeout msec='300'><TD delay='0.1'><St runs='9'/></TD></Timeout>",
      "-> FAILURE|start -> RUNNING|run1 -> RUNNING|run2 -> RUNNING|halt -> FAILURE|-> FAILURE");
}

}  // namespace

/// Control nodes that a host adds.
class CustomControlsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tick_second_runsThatChildAlone() {
    Playing tree("<Pick child='1'><S name='a'/><Sequence><S name='b'/><F/></Sequence><S/></Pick>");
    QVERIFY2(tree.state, tree.problems.c_str());
    compareTrace(tree, "pick1 b F -> FAILURE");
    compareTrace(tree, "pick2 b F -> FAILURE");
  }

  void tick_running_keepsMemoryAndChild() {
    Playing tree("<Pick child='1'><S/><St runs='2'/></Pick>");
    compareTrace(tree, "pick1 start -> RUNNING");
    compareTrace(tree, "pick2 run1 -> RUNNING");
    compareTrace(tree, "pick3 run2 -> SUCCESS");
    compareTrace(tree, "pick4 start -> RUNNING");
  }

  void tick_skippedOrDone_resetsChildren() {
    Playing tree("<Sequence><Both><St/><S _skipIf='true'/></Both></Sequence>");
    compareTrace(tree, "start halt -> SKIPPED");
    compareTrace(tree, "start halt -> SKIPPED");
    Playing done("<Both><St runs='5'/><S/></Both>");
    compareTrace(done, "start S halt -> SUCCESS");
    QVERIFY(done.state->events().back().kind == bt::LeafEvent::Kind::Halted);
  }

  void halt_whileRunning_haltsChildrenThenTells() {
    Playing tree("<Pick><St/></Pick>");
    compareTrace(tree, "pick1 start -> RUNNING");
    tree.log.calls.clear();
    tree.state->halt({1, 0.1, &tree.log});
    QVERIFY((tree.log.calls == std::vector<std::string>{"halt", "halted"}));
    tree.log.calls.clear();
    tree.state->halt({1, 0.1, &tree.log});
    QVERIFY(tree.log.calls.empty());
  }

  void halt_overSynchronousLeaves_startsAgain() {
    Playing tree("<Turns><S name='a'/><F name='b'/></Turns>");
    compareTrace(tree, "a -> RUNNING");
    tree.log.calls.clear();
    tree.state->halt({1, 0.1, &tree.log});
    QVERIFY((tree.log.calls == std::vector<std::string>{"halted"}));
    compareTrace(tree, "a -> RUNNING");
    compareTrace(tree, "b -> FAILURE");
    compareTrace(tree, "a -> RUNNING");
  }

  void tick_faultOfAChild_stopsTheTree() {
    Playing tree("<Fallback><Pick><ReadInt value='{nothing}'/></Pick><S/></Fallback>");
    compareTrace(tree, "pick1 0 halted -> IDLE");
    QVERIFY(tree.state->fault() != nullptr);
  }

  void tick_idle_isAFault() {
    Playing tree("<Pick child='3'><S/></Pick>");
    compareTrace(tree, "pick1 halted -> IDLE");
    QVERIFY(tree.state->fault() != nullptr);
    QVERIFY(tree.state->fault()->message.find("IDLE") != std::string::npos);
  }

  void tick_asChildOfReactiveNodes_followsTheRules() {
    Playing tree(
        "<ReactiveFallback><Inverter><RunOnce then_skip='false'><S name='v'/></RunOnce></Inverter>"
        "<Pick><St runs='1'/></Pick></ReactiveFallback>");
    compareTrace(tree, "v pick1 start -> RUNNING");
    compareTrace(tree, "pick2 run1 -> SUCCESS");
  }

  void load_withoutChildren_isAnError() {
    const Playing tree("<Sequence><Pick/></Sequence>");
    QVERIFY(!tree.state);
    QVERIFY2(tree.problems.find("t.xml:1: error: ") != std::string::npos, tree.problems.c_str());
  }

  void load_moreChildrenThanTheManifestAllows_isAnError() {
    QVERIFY(!Playing("<Both><S/></Both>").state);
    QVERIFY(!Playing("<Both><S/><S/><S/></Both>").state);
    QVERIFY(Playing("<Both><S/><S/></Both>").state);
    QVERIFY(Playing("<Control ID='Both'><S/><S/></Control>").state);
  }

  void conditions_ofAControl_count() {
    Playing tree("<Sequence><Pick _skipIf='id == 0' _onSuccess='id := 0'><S/></Pick></Sequence>");
    QVERIFY2(tree.state, tree.problems.c_str());
    tree.state->set(tree.state->program().hostSlot(0), 3);
    compareTrace(tree, "pick1 S -> SUCCESS");
    compareTrace(tree, "-> SKIPPED");
  }

  // Nodes that are always done within the tick are run on a short way. A condition that changes
  // nothing, `_skipIf="false"`, sends the same tree down the long way: both must tell the same.

  void flags_ofPlainAndConditionedTrees_differ() {
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

  void tick_randomTrees_sameAsTheLongWay() {
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

  void tick_leafThatIsNotDone_isAFaultAtThatLeaf() {
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

  void tick_leafWithoutInput_stopsBeforeTheNextLeaf() {
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

  // Decorators: what is called and returned in each step.

  void tick_decorator_givesTrace_data() {
    traces::columns();
    rowsOfRepetition();
    rowsOfDelays();
    rowsOfEntries();
  }

  void tick_decorator_givesTrace() { traces::checkRow(); }
};

QTEST_APPLESS_MAIN(CustomControlsTest)
#include "tst_CustomControls.moc"
