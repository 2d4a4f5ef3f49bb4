#include "bt/human/Motions.h"

/// Nodes about a person's goals and groups, and about walking to goals.
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

struct GroupWalk {
  std::int64_t startStep;
  int main;
  double duration;  // [s]
};

NodeStatus startGroup(LeafContext& leaf, const Members& members, double duration) {
  HumanContext& context = humanOf(leaf);
  const int main = members.front();
  GroupNodeState& groupNodeState = context.groupNodeState(leaf);
  groupNodeState.saved.clear();
  for (const int member : members) {
    groupNodeState.saved.push_back(saveAgent(context, member));
    setGroup(context, member, context.idOf(main));
    if (member != main) {
      context.control(member).goals = context.control(main).goals;
    }
  }
  context.setActive(main);
  return begin(leaf, GroupWalk{leaf.step(), main, duration});
}

void disband(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const int main = leaf.memory<GroupWalk>().main;
  for (const SavedAgent& saved : context.groupNodeState(leaf).saved) {
    if (!isStillThere(context, saved)) {
      continue;
    }
    setGroup(context, saved.human, context.hasQuirk(17) ? -1 : saved.group);
    if (saved.human != main) {
      restoreGoals(context, saved);
    }
  }
  context.dropGroupNodeState(leaf);
}

NodeStatus walkInGroup(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const GroupWalk& memory = leaf.memory<GroupWalk>();
  if (!context.view().isPresent(memory.main)) {
    disband(leaf);
    return NodeStatus::Failure;
  }
  sim2d::Intent intent = regularWalk(context, memory.main);
  intent.active = true;
  context.move(memory.main, intent, MotionOwner::Group);
  if (isGoalReached(context, memory.main)) {
    advanceGoal(context, memory.main);
  }
  const NodeStatus status = successAfter(leaf, memory.startStep, memory.duration);
  if (status == NodeStatus::Success) {
    disband(leaf);
  }
  return status;
}

constexpr const char* kNodes = R"(
Action GoTo|Walking|Walks to a global goal; the person's other goals are suspended.
agent_id goal_id target_x target_y time_step
tolerance length default 0.1|The goal is reached within this distance plus 0.1 m.
temporary bool|Accepted for existing files; has no effect.
stop_duration seconds|Accepted for existing files; has no effect.
Action UpdateGoal goals|Goals|Removes the current goal from the list; with cyclic goals it is appended at the end. Fails without goals.
agent_id
Action SetGoal goals|Goals|Appends a global goal to the person's list; goals set in the first tick replace those of the scenario.
agent_id goal_id target_x target_y
Action RegularNav goals|Walking|One time step towards the current goal; without a goal the person comes to rest.
agent_id time_step
Condition IsGoalReached|Goals|The person is within the radius of the current goal, plus 0.1 m; never without a goal.
agent_id
Condition IsAtPosition|Goals|The person is at a global goal.
agent_id int needed suggest {id}|Id of any person.
goal_id target_x target_y
tolerance length default 0.1|Maximum distance to the goal.
Action SetGroupId|Groups|Puts the person into a group.
agent_id int needed suggest {id}|Id of the person.
group_id int needed suggest 5|Number of the group; -1: no group.
Action SetGroupWalk goals|Groups|Forms a group with the goals of the main person, whom this node controls; the others follow their own trees. Groups and goals are restored at the end.
main_agent_id int needed suggest {id}|Id of the person who leads.
non_main_agent_ids time_step duration
)";

}  // namespace

void addGoalsAndGroups(NodeLibrary& to) {
  to.add(
      humanManifests(kNodes),
      {{"GoTo", stateful<Memory>({withPorts<start, 0, 1, 5>, run, restoreAllGoals})},
       {"UpdateGoal", synchronous(withPorts<advanceGoal, 0>)},
       {"SetGoal", synchronous(withPorts<addGoal, 0, 1>)},
       {"RegularNav", synchronous(withPorts<regularNav, 0>)},
       {"IsGoalReached", synchronous(withPorts<isGoalReached, 0>)},
       {"IsAtPosition", synchronous(withPorts<isAtPosition, 0, 1, 4>)},
       {"SetGroupId", synchronous(withPorts<setGroup, 0, 1>)},
       {"SetGroupWalk", stateful<GroupWalk>({withPorts<startGroup, 1, 3>, walkInGroup, disband})}});
}

}  // namespace bt
