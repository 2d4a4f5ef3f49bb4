#include "bt/human/Goals.h"
#include "bt/human/Leaves.h"
#include "bt/human/Ports.h"

namespace bt {

namespace {

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

void addGoalConditions(NodeLibrary& to) {
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
