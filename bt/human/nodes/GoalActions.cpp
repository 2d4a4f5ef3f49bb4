#include "bt/human/Goals.h"
#include "bt/human/Leaves.h"
#include "bt/human/Motions.h"
#include "bt/human/Ports.h"

namespace bt {

namespace {

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

}  // namespace

void addGoalActions(NodeLibrary& to) {
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
}

}  // namespace bt
