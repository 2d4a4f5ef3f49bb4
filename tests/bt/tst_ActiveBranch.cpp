#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <QtTest>

#include "bt/human/ActiveBranch.h"
#include "bt/human/TreeLoader.h"

using base::NodeStatus;

namespace {

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

class ActiveBranchTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
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

QTEST_APPLESS_MAIN(ActiveBranchTest)
#include "tst_ActiveBranch.moc"
