#include "bt/human/Goals.h"
#include "bt/human/Motions.h"

/// Nodes about the goals of a person, and walking to them.
namespace bt {

using sim2d::GoalItem;

namespace {

constexpr double kRadius = 0.1;  // of the goal that takes the place of the others [m]

struct Memory {
  int human;
  int goalId;
  double x, y;
  double reach;  // [m]
};

GoalItem goalOf(const Memory& memory) {
  return {memory.goalId, base::Vec2(memory.x, memory.y), kRadius};
}

NodeStatus start(LeafContext& leaf, Person human, const GoalItem& place, double tolerance) {
  HumanContext& context = humanOf(leaf);
  const double asked = context.isOriginal(12) ? kRadius : tolerance;
  const Memory memory = {human, place.id, place.position.x(), place.position.y(),
                         asked + kGoalTolerance};
  context.notes(leaf).saved = {savePerson(context, human)};
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

void regularNav(HumanContext& context, Person human) {
  context.move(human, regularWalk(context, human));
}

bool isAtPosition(HumanContext& context, Person human, const GoalItem& place, double tolerance) {
  return (context.view().pose(human).position - place.position).norm() <= tolerance;
}

constexpr const char* kNodes = R"(
Action GoTo|Walking|Walks to a global goal; the person's other goals wait meanwhile.
agent_id goal_id target_x target_y time_step
tolerance length default 0.1|Reached within this plus 0.1 m.
temporary bool|Accepted for existing files; has no effect.
stop_duration seconds|Accepted for existing files; has no effect.
Action UpdateGoal|Goals|Takes the current goal off the list; cyclic people get it back at the end. Fails without goals.
agent_id
Action SetGoal|Goals|Puts a global goal at the end of the person's list; those set in the first tick replace the goals of the scenario.
agent_id goal_id target_x target_y
Action RegularNav|Walking|One step towards the current goal; without one the person comes to rest.
agent_id time_step
Condition IsGoalReached|Goals|The person is within the radius of the current goal, plus 0.1 m; never without a goal.
agent_id
Condition IsAtPosition|Goals|The person stands at a global goal.
agent_id int needed suggest {id}|Id of the person; may be any.
goal_id target_x target_y
tolerance length default 0.1|At most so far from the goal.
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
