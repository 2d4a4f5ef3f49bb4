#include "bt/human/Leaves.h"
#include "bt/human/Perception.h"
#include "bt/human/Ports.h"

namespace bt {

namespace {

NodeStatus isClose(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const double threshold = leaf.require<double>(1);
  return successIf(human && robotDistance(context.view(), *human) < threshold);
}

NodeStatus isFacing(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  return successIf(human && isRobotFacing(context.view(), *human));
}

}  // namespace

void addRobotConditions(NodeLibrary& to) {
  to.addCondition(
      humanNode(
          "IsRobotClose", "Perception", "The robot is nearer than the threshold.",
          {port::agent(), port::length("threshold", "Nearer than this is close.").byDefault("1.0")},
          NodeKind::Condition),
      isClose);
  to.addCondition(humanNode("IsRobotFacingAgent", "Perception",
                            "The robot's front points at the person, within 0.3 rad.",
                            {port::agent()}, NodeKind::Condition),
                  isFacing);
}

}  // namespace bt
