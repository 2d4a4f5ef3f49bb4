#include "bt/human/Goals.h"
#include "bt/human/Motions.h"

/// Nodes about a person's goals and about walking to them.
namespace bt {

using sim2d::GoalItem;

namespace {

constexpr double kRadius = 0.1;  // of the goal that temporarily replaces the others [m]

struct Memory {
  int human;
  int goalId;
  double x, y;
  double reach;  // [m]
};

GoalItem goalOf(const Memory& memory) {
  return {memory.goalId, base::Vec2(memory.x, memory.y), kRadius};
}

NodeStatus start(LeafContext& leaf, AgentIndex human, const GoalItem& place, double tolerance) {
  HumanContext& context = humanOf(leaf);
  const double asked = context.hasQuirk(12) ? kRadius : tolerance;
  const Memory memory = {human, place.id, place.position.x(), place.position.y(),
                         asked + kGoalTolerance};
  context.groupNodeState(leaf).saved = {saveAgent(context, human)};
  context.control(human).goals = {goalOf(memory)};
  return begin(leaf, memory);
}

NodeStatus run(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const Memory& memory = leaf.memory<Memory>();
  if (!context.view().isPresent(memory.human)) {
    restoreAllGoals(leaf);
    return NodeStatus::Failure;
  }
  const GoalItem goal = goalOf(memory);
  const base::Vec2 position = context.view().pose(memory.human).position;
  if ((goal.position - position).norm() <= memory.reach) {
    restoreAllGoals(leaf);
    return NodeStatus::Success;
  }
  context.move(memory.human, walkTo(context, memory.human, goal));
  return NodeStatus::Running;
}

void regularNav(HumanContext& context, AgentIndex human) {
  context.move(human, regularWalk(context, human));
}

bool isAtPosition(HumanContext& context, AgentIndex human, const GoalItem& place,
                  double tolerance) {
  return (context.view().pose(human).position - place.position).norm() <= tolerance;
}

constexpr const char* kNodes = R"(
Action GoTo|Walking|Walks to a global goal; the person's other goals are suspended.
agent_id goal_id target_x target_y time_step
tolerance length default 0.1|The goal is reached within this distance plus 0.1 m.
temporary bool|Accepted for existing files; has no effect.
stop_duration seconds|Accepted for existing files; has no effect.
Action UpdateGoal|Goals|Removes the current goal from the list; with cyclic goals it is appended at the end. Fails without goals.
agent_id
Action SetGoal|Goals|Appends a global goal to the person's list; goals set in the first tick replace those of the scenario.
agent_id goal_id target_x target_y
Action RegularNav|Walking|One time step towards the current goal; without a goal the person comes to rest.
agent_id time_step
Condition IsGoalReached|Goals|The person is within the radius of the current goal, plus 0.1 m; never without a goal.
agent_id
Condition IsAtPosition|Goals|The person is at a global goal.
agent_id int needed suggest {id}|Id of any person.
goal_id target_x target_y
tolerance length default 0.1|Maximum distance to the goal.
)";

}  // namespace

void addGoalNodes(NodeLibrary& to) {
  const NodeCatalogue nodes = humanManifests(kNodes);
  to.addStateful<Memory>(*nodes.find("GoTo"), {withPorts<start, 0, 1, 5>, run, restoreAllGoals});
  to.addAction(*nodes.find("UpdateGoal"), withPorts<advanceGoal, 0>);
  to.addAction(*nodes.find("SetGoal"), withPorts<addGoal, 0, 1>);
  to.addAction(*nodes.find("RegularNav"), withPorts<regularNav, 0>);
  to.addCondition(*nodes.find("IsGoalReached"), withPorts<isGoalReached, 0>);
  to.addCondition(*nodes.find("IsAtPosition"), withPorts<isAtPosition, 0, 1, 4>);
}

}  // namespace bt
