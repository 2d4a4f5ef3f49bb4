#include "bt/human/Goals.h"
#include "bt/human/Leaves.h"
#include "bt/human/Motions.h"
#include "bt/human/Ports.h"

namespace bt {

namespace {

constexpr double kRadius = 0.1;  // of the goal that takes the place of the others [m]

struct Memory {
  int human;
  int goalId;
  double x, y;
  double reach;  // [m]
};

sim2d::GoalItem goalOf(const Memory& memory) {
  return {memory.goalId, base::Vec2(memory.x, memory.y), kRadius};
}

NodeStatus start(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const std::optional<sim2d::GoalItem> place = context.place(leaf, 1);
  const double tolerance = leaf.require<double>(5);
  if (!human || !place) {
    return NodeStatus::Failure;
  }
  Memory& memory = leaf.memory<Memory>();
  const double asked = context.isOriginal(12) ? kRadius : tolerance;
  memory = {*human, place->id, place->position.x(), place->position.y(), asked + kGoalTolerance};
  context.notes(leaf).saved = {savePerson(context, *human)};
  context.control(*human).goals = {goalOf(memory)};
  return NodeStatus::Running;
}

void restore(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  for (const SavedPerson& saved : context.notes(leaf).saved) {
    restoreGoals(context, saved);
  }
  context.dropNotes(leaf);
}

NodeStatus run(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const Memory& memory = leaf.memory<Memory>();
  if (!context.view().isPresent(memory.human)) {
    restore(leaf);
    return NodeStatus::Failure;
  }
  const sim2d::GoalItem goal = goalOf(memory);
  const base::Vec2 position = context.view().pose(memory.human).position;
  if ((goal.position - position).norm() <= memory.reach) {
    restore(leaf);
    return NodeStatus::Success;
  }
  context.move(memory.human, walkTo(context, memory.human, goal));
  return NodeStatus::Running;
}

}  // namespace

void addGoTo(NodeLibrary& to) {
  to.addStateful<Memory>(
      humanNode("GoTo", "Walking",
                "Walks to a global goal; the person's other goals wait meanwhile.",
                {port::agent(), port::goal("Id of the global goal."), port::oldX(), port::oldY(),
                 port::timeStep(),
                 port::length("tolerance", "Reached within this plus 0.1 m.").byDefault("0.1"),
                 port::unused("temporary", PortType::Bool),
                 port::unused("stop_duration", PortType::Double, "s")}),
      {start, run, restore});
}

}  // namespace bt
