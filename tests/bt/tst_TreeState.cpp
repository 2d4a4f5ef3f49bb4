#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <QtTest>

#include "bt/human/ActiveBranch.h"
#include "bt/human/TreeLoader.h"
#include "tests/bt/TreeProbe.h"

using base::NodeStatus;

namespace {

/// "path=STATUS …" of the nodes that changed.
QString changed(const probe::Run& run) {
  QStringList parts;
  for (std::size_t node = 0; node < run.before.size(); ++node) {
    const NodeStatus status = run.state->statuses()[node];
    if (status != run.before[node]) {
      parts << QString::fromStdString(run.state->program().path(static_cast<int>(node))) +
                   QLatin1Char('=') + QString::fromUtf8(base::nodeStatusName(status));
    }
  }
  return parts.join(QLatin1Char(' '));
}

std::vector<bt::LeafEvent::Kind> kinds(const probe::Run& run) {
  std::vector<bt::LeafEvent::Kind> result;
  for (const bt::LeafEvent& event : run.state->events()) {
    result.push_back(event.kind);
  }
  return result;
}

using Kinds = std::vector<bt::LeafEvent::Kind>;

constexpr NodeStatus kRuns = NodeStatus::Running;
constexpr NodeStatus kHeld = NodeStatus::Success;
constexpr NodeStatus kFailed = NodeStatus::Failure;
constexpr NodeStatus kIdle = NodeStatus::Idle;

sim2d::TreeStatuses tree(const std::vector<std::pair<std::string, NodeStatus>>& nodes) {
  sim2d::TreeStatuses all;
  std::vector<std::string> paths;
  for (const auto& [path, status] : nodes) {
    paths.push_back(path);
    all.statuses.push_back(status);
  }
  all.paths = std::make_shared<const std::vector<std::string>>(std::move(paths));
  return all;
}

}  // namespace

/// What a recorder and an editor see of a running tree.
class TreeStateTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void paths_equalSiblings_areNumbered() {
    probe::Run run(
        "<root BTCPP_format='4' main_tree_to_execute='M'><BehaviorTree ID='M'>"
        "<Fallback name='MainFallback'><Sequence name='SetGoals'><RunOnce><S "
        "name='SetGoal'/></RunOnce>"
        "<RunOnce><S name='SetGoal'/></RunOnce><Inverter><S/></Inverter></Sequence>"
        "<SubTree ID='Nav'/></Fallback></BehaviorTree>"
        "<BehaviorTree ID='Nav'><Sequence name='go'><S/></Sequence></BehaviorTree></root>");
    const std::vector<std::string> expected = {"MainFallback",
                                               "MainFallback/SetGoals",
                                               "MainFallback/SetGoals/RunOnce[1]",
                                               "MainFallback/SetGoals/RunOnce[1]/SetGoal",
                                               "MainFallback/SetGoals/RunOnce[2]",
                                               "MainFallback/SetGoals/RunOnce[2]/SetGoal",
                                               "MainFallback/SetGoals/Inverter",
                                               "MainFallback/SetGoals/Inverter/S",
                                               "MainFallback/Nav",
                                               "MainFallback/Nav/go",
                                               "MainFallback/Nav/go/S"};
    QVERIFY(*run.state->program().paths() == expected);
    QVERIFY(run.state->program().treeOf(9) == "Nav");
    QVERIFY(run.state->program().manifest(8).id == "SubTree");
  }

  void statuses_tick_areWhatWasReturned() {
    probe::Run run("<Fallback><RunOnce><F/></RunOnce><Inverter><S/></Inverter><St/></Fallback>");
    run.tick();
    run.tick();
    run.tick();
    const std::vector<NodeStatus> third = {NodeStatus::Running, NodeStatus::Skipped,
                                           NodeStatus::Idle,    NodeStatus::Failure,
                                           NodeStatus::Success, NodeStatus::Running};
    const bt::StatusList statuses = run.state->statuses();
    QVERIFY(std::equal(third.begin(), third.end(), statuses.begin(), statuses.end()));
  }

  void changes_onlyDifferences_areListed() {
    probe::Run run("<Fallback><RunOnce><F/></RunOnce><St runs='2'/></Fallback>");
    run.tick();
    QCOMPARE(changed(run), QStringLiteral("Fallback=RUNNING Fallback/RunOnce=FAILURE "
                                          "Fallback/RunOnce/F=FAILURE Fallback/St=RUNNING"));
    run.tick();  // goes on at St
    QCOMPARE(changed(run), QStringLiteral("Fallback/RunOnce=IDLE Fallback/RunOnce/F=IDLE"));
    run.tick();
    QCOMPARE(changed(run), QStringLiteral("Fallback=SUCCESS Fallback/St=SUCCESS"));
    run.tick();
    QCOMPARE(changed(run), QStringLiteral("Fallback=RUNNING Fallback/RunOnce=SKIPPED "
                                          "Fallback/St=RUNNING"));
  }

  void events_statefulLeaf_startsAndEnds() {
    using Kind = bt::LeafEvent::Kind;
    probe::Run run("<Sequence><S/><St/><St result='FAILURE'/><Sleep msec='100'/></Sequence>");
    run.tick();
    QVERIFY(kinds(run) == Kinds({Kind::Started}));
    QCOMPARE(run.state->events()[0].node, 2);
    run.tick();
    QVERIFY(kinds(run) == Kinds({Kind::Succeeded, Kind::Started}));
    run.tick();
    QVERIFY(kinds(run) == Kinds({Kind::Failed}));
  }

  void events_haltedLeaf_isSaid() {
    using Kind = bt::LeafEvent::Kind;
    probe::Run run("<Timeout msec='100'><St runs='9'/></Timeout>");
    run.tick();
    run.tick();
    QVERIFY(kinds(run) == Kinds({Kind::Halted}));
    run.tick();
    run.halt();
    QVERIFY(kinds(run) == Kinds({Kind::Started, Kind::Halted}));
  }

  void halt_runningTree_isRestarted() {
    probe::Run run("<Sequence><S name='a'/><St runs='9'/></Sequence>");
    run.tick();
    run.halt();
    QVERIFY(run.log.calls == std::vector<std::string>{"halt"});
    QCOMPARE(run.trace(), std::string("a start -> RUNNING"));
    run.halt();
    run.halt();
    QVERIFY(run.log.calls.empty());  // what is not RUNNING is not halted
  }

  void reset_runOnce_runsAgain() {
    probe::Run run("<Sequence><RunOnce><S name='a'/></RunOnce><Script code='k := 1'/></Sequence>");
    QCOMPARE(run.trace(), std::string("a -> SUCCESS"));
    QCOMPARE(run.trace(), std::string("-> SUCCESS"));
    QCOMPARE(run.entry("k"), std::string("1"));
    run.state->reset();
    QCOMPARE(run.entry("k"), std::string());
    QCOMPARE(run.trace(), std::string("a -> SUCCESS"));
  }

  void states_ofOneProgram_areIndependent() {
    const auto program = probe::compiled("<Sequence><RunOnce><S name='a'/></RunOnce></Sequence>");
    QVERIFY(program);
    bt::TreeState first(*program);
    bt::TreeState second(*program);
    probe::Log log;
    QCOMPARE(first.tickOnce({1, 0.1, &log}), NodeStatus::Success);
    QCOMPARE(first.tickOnce({2, 0.1, &log}), NodeStatus::Skipped);
    QCOMPARE(second.tickOnce({2, 0.1, &log}), NodeStatus::Success);
  }

  void context_ports_tellWhereTheirValueIsFrom() {
    bt::NodeLibrary library;
    bt::PortSpec text = probe::port("text", bt::PortType::String);
    text.direction = bt::PortDirection::Output;
    library.add(probe::manifest("Tell", {text}), bt::synchronous([](bt::LeafContext& leaf) {
                  return leaf.set(0, std::string_view("x")) ? NodeStatus::Success
                                                            : NodeStatus::Failure;
                }));
    library.add(probe::manifest("Ask", {probe::port("given", bt::PortType::Int),
                                        probe::port("byDefault", bt::PortType::Double, "1.5"),
                                        probe::port("missing", bt::PortType::Int),
                                        probe::port("wrong", bt::PortType::Int),
                                        probe::port("ids", bt::PortType::Any)}),
                bt::synchronous([](bt::LeafContext& leaf) {
                  const bool states = leaf.state(0) == bt::PortState::Given &&
                                      leaf.state(1) == bt::PortState::Default &&
                                      leaf.state(2) == bt::PortState::Missing &&
                                      leaf.state(3) == bt::PortState::WrongType;
                  const bool values = leaf.get<int>(0) == 3 && leaf.get<double>(1) == 1.5 &&
                                      !leaf.get<int>(2) && !leaf.get<int>(3) &&
                                      leaf.getOr<int>(2, 8) == 8 && leaf.text(4) == "7";
                  return states && values ? NodeStatus::Success : NodeStatus::Failure;
                }));
    const auto program = probe::compiled(
        "<Sequence><Tell text='{w}'/><Script code='n := 7'/>"
        "<Ask given='3' wrong='{w}' ids='{n}'/></Sequence>",
        library);
    QVERIFY2(program, probe::textOf(program.diagnostics()).c_str());
    bt::TreeState state(*program);
    QCOMPARE(state.tickOnce({1, 0.1, nullptr}), NodeStatus::Success);
  }

  void context_memory_survivesRestart() {
    bt::NodeLibrary library;
    struct Count {
      int value;
    };
    library.add(probe::manifest("ThirdTime"), bt::synchronous<Count>([](bt::LeafContext& leaf) {
                  return ++leaf.memory<Count>().value >= 3 ? NodeStatus::Success
                                                           : NodeStatus::Failure;
                }));
    const auto program = probe::compiled("<ThirdTime/>", library);
    QVERIFY(program);
    bt::TreeState state(*program);
    QCOMPARE(state.tickOnce({1, 0.1, nullptr}), NodeStatus::Failure);
    QCOMPARE(state.tickOnce({2, 0.1, nullptr}), NodeStatus::Failure);
    QCOMPARE(state.tickOnce({3, 0.1, nullptr}), NodeStatus::Success);
    state.reset();
    QCOMPARE(state.tickOnce({4, 0.1, nullptr}), NodeStatus::Failure);
  }

  void library_withLeaves_replacesAddedOnes() {
    bt::StatefulFunctions scripted;
    scripted.onStart = [](bt::LeafContext& leaf) {
      return probe::note(leaf, leaf.label() + "?", NodeStatus::Success);
    };
    scripted.onRunning = scripted.onStart;
    const bt::NodeLibrary library = probe::library().withLeafFunctions(scripted);
    const auto program =
        probe::compiled("<Sequence><F/><St name='x'/><AlwaysSuccess/></Sequence>", library);
    QVERIFY(program);
    bt::TreeState state(*program);
    probe::Log log;
    QCOMPARE(state.tickOnce({1, 0.1, &log}), NodeStatus::Success);
    QVERIFY((log.calls == std::vector<std::string>{"F?", "x?"}));
  }

  /// A condition of WhileDoElse is asked anew although its last result still stands.
  void library_withLeaves_callsConditionsInEveryTick() {
    bt::StatefulFunctions scripted;
    scripted.onStart = [](bt::LeafContext& leaf) {
      const NodeStatus status = leaf.label() == "St" ? NodeStatus::Running : NodeStatus::Success;
      return probe::note(leaf, leaf.label(), status);
    };
    scripted.onRunning = scripted.onStart;
    const bt::NodeLibrary library = probe::library().withLeafFunctions(scripted);
    const auto program = probe::compiled("<WhileDoElse><S/><St/></WhileDoElse>", library);
    QVERIFY(program);
    bt::TreeState state(*program);
    probe::Log log;
    QCOMPARE(state.tickOnce({1, 0.1, &log}), NodeStatus::Running);
    QCOMPARE(state.tickOnce({2, 0.1, &log}), NodeStatus::Running);
    QVERIFY((log.calls == std::vector<std::string>{"S", "St", "S", "St"}));
  }

  void branch_ofACuriousPerson_saysWhy() {
    const bt::ActiveBranch branch =
        bt::activeBranchOf(tree({{"Fallback", kRuns},
                                 {"Fallback/Curious", kRuns},
                                 {"Fallback/Curious/IsRobotVisible", kHeld},
                                 {"Fallback/Curious/ApproachRobot", kRuns},
                                 {"Fallback/RegularNav", kIdle}}));
    QCOMPARE(branch.words(), std::string("approaches the robot, because the robot is in sight"));
  }

  void branch_conditionThatFailed_isNoReason() {
    const bt::ActiveBranch branch =
        bt::activeBranchOf(tree({{"Fallback", kRuns},
                                 {"Fallback/Scared", kFailed},
                                 {"Fallback/Scared/IsCrowded", kHeld},  // of another branch
                                 {"Fallback/Scared/IsRobotVisible", kFailed},
                                 {"Fallback/IsRobotClose", kFailed},
                                 {"Fallback/Nav[2]", kRuns},
                                 {"Fallback/Nav[2]/RegularNav", kRuns}}));
    QCOMPARE(branch.words(), std::string("walks to the goal"));
  }

  void branch_twoConditions_areBothTold() {
    const bt::ActiveBranch branch =
        bt::activeBranchOf(tree({{"Sequence", kRuns},
                                 {"Sequence/IsCrowded", kHeld},
                                 {"Sequence/Sequence", kRuns},
                                 {"Sequence/Sequence/IsAgentClose[1]", kHeld},
                                 {"Sequence/Sequence/Own Words", kRuns}}));
    QCOMPARE(branch.words(), std::string("Own Words, because it is crowded and a person is close"));
  }

  void branch_nothingRuns_isEmpty() {
    QVERIFY(bt::activeBranchOf({}).words().empty());
    QVERIFY(bt::activeBranchOf(
                tree({{"Root", kHeld}, {"Root/SetBlackboard", kHeld}, {"Root/IsCrowded", kHeld}}))
                .words()
                .empty());
    QVERIFY(bt::activeBranchOf(tree({})).words().empty());
  }

  /// RegularNav is done within each step.
  void branch_actionOfOneStep_isTold() {
    const bt::ActiveBranch branch = bt::activeBranchOf(tree({{"Root", kHeld},
                                                             {"Root/IsAgentClose", kHeld},
                                                             {"Root/RegularNav", kHeld},
                                                             {"Root/SetBlackboard", kHeld}}));
    QCOMPARE(branch.words(), std::string("walks to the goal, because a person is close"));
  }

  /// In the one step between two goals, too, somebody does something.
  void branch_atAGoal_turnsToTheNext() {
    const bt::ActiveBranch branch = bt::activeBranchOf(tree({{"Fallback", kHeld},
                                                             {"Fallback/Nav", kFailed},
                                                             {"Fallback/Nav/IsGoalReached", kHeld},
                                                             {"Fallback/Nav/RegularNav", kIdle},
                                                             {"Fallback/UpdateGoal", kHeld}}));
    QCOMPARE(branch.words(), std::string("turns to the next goal"));
  }

  void words_ofOtherNodes_areTheirNames() {
    QCOMPARE(bt::nodeDescription("DrinkCoffee"), std::string("drink coffee"));
    QCOMPARE(bt::nodeDescription("drink_coffee"), std::string("drink coffee"));
    QCOMPARE(bt::nodeDescription("Drink Coffee"), std::string("Drink Coffee"));
    QCOMPARE(bt::nodeDescription(""), std::string());
  }

  /// A node that runs for a while has words, not its name.
  void words_ofOurNodes_areSentences() {
    QCOMPARE(bt::nodeDescription("RegularNav"), std::string("walks to the goal"));
    const bt::NodeLibrary library = bt::humanNodes();
    for (const char* node : {"ApproachAgent", "BlockAgent", "FleeFrom", "GoTo", "WanderInArea",
                             "WaitInQueue", "YieldToRobot", "PassOnSide", "UseObject",
                             "GoToNearestExit", "ConversationFormation", "WaitForAgent"}) {
      QVERIFY(library.functions(node) != nullptr);
      std::string name = bt::nodeDescription(node);
      QVERIFY2(name.find(' ') != std::string::npos && name.find("agent") == std::string::npos,
               name.c_str());
    }
  }
};

QTEST_APPLESS_MAIN(TreeStateTest)
#include "tst_TreeState.moc"
