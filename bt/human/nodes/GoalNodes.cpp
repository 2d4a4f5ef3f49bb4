#include "bt/human/Goals.h"
#include "bt/human/HumanContext.h"
#include "bt/human/Motions.h"
#include "bt/human/Ports.h"

/// Nodes about the goals of a person, and walking to them.
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

NodeStatus updateGoal(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  return successIf(human && advanceGoal(context, *human));
}

NodeStatus setGoal(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const std::optional<sim2d::GoalItem> place = context.place(leaf, 1);
  if (!human || !place) {
    return NodeStatus::Failure;
  }
  addGoal(context, *human, *place);
  return NodeStatus::Success;
}

NodeStatus regularNav(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  if (!human) {
    return NodeStatus::Failure;
  }
  context.move(*human, regularWalk(context, *human));
  return NodeStatus::Success;
}

NodeStatus isReached(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  return successIf(human && isGoalReached(context, *human));
}

NodeStatus isAtPosition(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const std::optional<sim2d::GoalItem> place = context.place(leaf, 1);
  const double tolerance = leaf.require<double>(4);
  return successIf(human && place &&
                   (context.view().pose(*human).position - place->position).norm() <= tolerance);
}

}  // namespace

void addGoalNodes(NodeLibrary& to) {
  to.addStateful<Memory>(
      humanNode("GoTo", "Walking",
                "Walks to a global goal; the person's other goals wait meanwhile.",
                {port::agent(), port::goal("Id of the global goal."), port::oldX(), port::oldY(),
                 port::timeStep(),
                 port::length("tolerance", "Reached within this plus 0.1 m.").byDefault("0.1"),
                 port::unused("temporary", PortType::Bool),
                 port::unused("stop_duration", PortType::Double, "s")}),
      {start, run, restore});
  to.addAction(humanNode("UpdateGoal", "Goals",
                         "Takes the current goal off the list; cyclic people get it back at the "
                         "end. Fails without goals.",
                         {port::agent()}),
               updateGoal);
  to.addAction(
      humanNode("SetGoal", "Goals",
                "Puts a global goal at the end of the person's list; those set in the "
                "first tick replace the goals of the scenario.",
                {port::agent(), port::goal("Id of the global goal."), port::oldX(), port::oldY()}),
      setGoal);
  to.addAction(humanNode("RegularNav", "Walking",
                         "One step towards the current goal; without one the person comes to rest.",
                         {port::agent(), port::timeStep()}),
               regularNav);
  to.addCondition(humanNode("IsGoalReached", "Goals",
                            "The person is within the radius of the current goal, plus 0.1 m; "
                            "never without a goal.",
                            {port::agent()}, NodeKind::Condition),
                  isReached);
  to.addCondition(
      humanNode("IsAtPosition", "Goals", "The person stands at a global goal.",
                {port::person("agent_id", "Id of the person; may be any."),
                 port::goal("Id of the global goal."), port::oldX(), port::oldY(),
                 port::length("tolerance", "At most so far from the goal.").byDefault("0.1")},
                NodeKind::Condition),
      isAtPosition);
}

}  // namespace bt
