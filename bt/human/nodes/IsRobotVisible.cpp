#include "bt/human/Leaves.h"
#include "bt/human/Perception.h"
#include "bt/human/Ports.h"

namespace bt {

namespace {

NodeStatus isVisible(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const double distance = leaf.require<double>(1);
  return successIf(human && isRobotVisible(context.view(), *human, distance));
}

}  // namespace

void addIsRobotVisible(NodeLibrary& to) {
  to.addCondition(
      humanNode(
          "IsRobotVisible", "Perception",
          "The robot is near enough, not behind the back (100 degrees to each side) and no "
          "wall hides it.",
          {port::agent(),
           port::length("distance", "The robot is seen up to here.").required().suggest("5.0")},
          NodeKind::Condition),
      isVisible);
}

}  // namespace bt
