#include "tests/bt/TreeProbe.h"

/// Control nodes that a host adds.
class CustomControlsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tick_second_runsThatChildAlone();
  void tick_running_keepsMemoryAndChild();
  void tick_skippedOrDone_resetsChildren();
  void halt_whileRunning_haltsChildrenThenTells();
  void halt_overSynchronousLeaves_startsAgain();
  void tick_faultOfAChild_stopsTheTree();
  void tick_idle_isAFault();
  void tick_asChildOfReactiveNodes_followsTheRules();
  void load_withoutChildren_isAnError();
  void load_moreChildrenThanTheManifestAllows_isAnError();
  void conditions_ofAControl_count();
};

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
  result.addControl<PickMemory>(
      probe::manifest("Pick", {probe::port("child", bt::PortType::Int, "0")}),
      {pick, [](bt::ParentContext& node) { probe::note(node, "halted", NodeStatus::Idle); }});
  result.addControl<TurnMemory>(probe::manifest("Turns"), {turns, [](bt::ParentContext& node) {
                                                             node.memory<TurnMemory>().next = 0;
                                                             probe::note(node, "halted",
                                                                         NodeStatus::Idle);
                                                           }});
  bt::NodeManifest two = probe::manifest("Both");
  two.minChildren = 2;
  two.maxChildren = 2;
  result.addControl(two, {both, nullptr});
  return result;
}

struct Playing {
  explicit Playing(const char* xml) {
    const base::Result<bt::TreeFile> file = bt::readTreeText(probe::fileOf(xml), "t.xml");
    const auto program = bt::compile(*file, library());
    problems = probe::textOf(program.diagnostics());
    if (program) {
      state = std::make_unique<bt::TreeState>(*program);
    }
  }
  std::string trace() {
    log.calls.clear();
    const NodeStatus status = state->tickOnce({++step, 0.1, &log});
    std::string text;
    for (const std::string& call : log.calls) {
      text += call + " ";
    }
    return text + "-> " + base::nodeStatusName(status);
  }

  probe::Log log;
  std::string problems;
  std::unique_ptr<bt::TreeState> state;
  std::int64_t step = 0;
};

void compareTrace(Playing& tree, const char* expected) {
  const std::string trace = tree.trace();
  QVERIFY2(trace == expected, trace.c_str());
}

}  // namespace

void CustomControlsTest::tick_second_runsThatChildAlone() {
  Playing tree("<Pick child='1'><S name='a'/><Sequence><S name='b'/><F/></Sequence><S/></Pick>");
  QVERIFY2(tree.state, tree.problems.c_str());
  compareTrace(tree, "pick1 b F -> FAILURE");
  compareTrace(tree, "pick2 b F -> FAILURE");
}

void CustomControlsTest::tick_running_keepsMemoryAndChild() {
  Playing tree("<Pick child='1'><S/><St runs='2'/></Pick>");
  compareTrace(tree, "pick1 start -> RUNNING");
  compareTrace(tree, "pick2 run1 -> RUNNING");
  compareTrace(tree, "pick3 run2 -> SUCCESS");
  compareTrace(tree, "pick4 start -> RUNNING");
}

void CustomControlsTest::tick_skippedOrDone_resetsChildren() {
  Playing tree("<Sequence><Both><St/><S _skipIf='true'/></Both></Sequence>");
  compareTrace(tree, "start halt -> SKIPPED");
  compareTrace(tree, "start halt -> SKIPPED");
  Playing done("<Both><St runs='5'/><S/></Both>");
  compareTrace(done, "start S halt -> SUCCESS");
  QVERIFY(done.state->events().back().kind == bt::LeafEvent::Kind::Halted);
}

void CustomControlsTest::halt_whileRunning_haltsChildrenThenTells() {
  Playing tree("<Pick><St/></Pick>");
  compareTrace(tree, "pick1 start -> RUNNING");
  tree.log.calls.clear();
  tree.state->halt({1, 0.1, &tree.log});
  QVERIFY((tree.log.calls == std::vector<std::string>{"halt", "halted"}));
  tree.log.calls.clear();
  tree.state->halt({1, 0.1, &tree.log});
  QVERIFY(tree.log.calls.empty());
}

void CustomControlsTest::halt_overSynchronousLeaves_startsAgain() {
  Playing tree("<Turns><S name='a'/><F name='b'/></Turns>");
  compareTrace(tree, "a -> RUNNING");
  tree.log.calls.clear();
  tree.state->halt({1, 0.1, &tree.log});
  QVERIFY((tree.log.calls == std::vector<std::string>{"halted"}));
  compareTrace(tree, "a -> RUNNING");
  compareTrace(tree, "b -> FAILURE");
  compareTrace(tree, "a -> RUNNING");
}

void CustomControlsTest::tick_faultOfAChild_stopsTheTree() {
  Playing tree("<Fallback><Pick><ReadInt value='{nothing}'/></Pick><S/></Fallback>");
  compareTrace(tree, "pick1 0 halted -> IDLE");
  QVERIFY(tree.state->fault() != nullptr);
}

void CustomControlsTest::tick_idle_isAFault() {
  Playing tree("<Pick child='3'><S/></Pick>");
  compareTrace(tree, "pick1 halted -> IDLE");
  QVERIFY(tree.state->fault() != nullptr);
  QVERIFY(tree.state->fault()->message.find("IDLE") != std::string::npos);
}

void CustomControlsTest::tick_asChildOfReactiveNodes_followsTheRules() {
  Playing tree(
      "<ReactiveFallback><Inverter><RunOnce then_skip='false'><S name='v'/></RunOnce></Inverter>"
      "<Pick><St runs='1'/></Pick></ReactiveFallback>");
  compareTrace(tree, "v pick1 start -> RUNNING");
  compareTrace(tree, "pick2 run1 -> SUCCESS");
}

void CustomControlsTest::load_withoutChildren_isAnError() {
  const Playing tree("<Sequence><Pick/></Sequence>");
  QVERIFY(!tree.state);
  QVERIFY2(tree.problems.find("t.xml:1: error: ") != std::string::npos, tree.problems.c_str());
}

void CustomControlsTest::load_moreChildrenThanTheManifestAllows_isAnError() {
  QVERIFY(!Playing("<Both><S/></Both>").state);
  QVERIFY(!Playing("<Both><S/><S/><S/></Both>").state);
  QVERIFY(Playing("<Both><S/><S/></Both>").state);
  QVERIFY(Playing("<Control ID='Both'><S/><S/></Control>").state);
}

void CustomControlsTest::conditions_ofAControl_count() {
  Playing tree("<Sequence><Pick _skipIf='id == 0' _onSuccess='id := 0'><S/></Pick></Sequence>");
  QVERIFY2(tree.state, tree.problems.c_str());
  tree.state->set(tree.state->program().hostSlot(0), 3);
  compareTrace(tree, "pick1 S -> SUCCESS");
  compareTrace(tree, "-> SKIPPED");
}

QTEST_APPLESS_MAIN(CustomControlsTest)
#include "tst_CustomControls.moc"
