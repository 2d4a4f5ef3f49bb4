#include "bt/human/Leaves.h"
#include "bt/human/Perception.h"
#include "bt/human/Ports.h"

namespace bt {

namespace {

NodeStatus isVisible(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> observer = context.person(leaf, 0);
  const std::optional<int> target = context.person(leaf, 1);
  const double distance = leaf.require<double>(2);
  const double halfView = leaf.require<double>(3);
  return successIf(observer && target &&
                   isPersonVisible(context.view(), *observer, *target, distance, halfView));
}

NodeStatus isClose(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> observer = context.person(leaf, 0);
  const std::optional<int> target = context.person(leaf, 1);
  const double threshold = leaf.require<double>(2);
  return successIf(observer && target &&
                   personDistance(context.view(), *observer, *target) < threshold);
}

}  // namespace

void addAgentConditions(NodeLibrary& to) {
  to.addCondition(
      humanNode("IsAgentVisible", "Perception",
                "Another person is near enough, within the field of view, and no wall hides them.",
                {port::person("observer_id", "Id of the person who looks."),
                 port::person("agent_id", "Id of the person looked for.", "2"),
                 port::length("distance", "People are seen up to here.").byDefault("5.0"),
                 port::angle("field_of_view",
                             "Half of the field of view: the angle to each side, pi = all around.")
                     .byDefault("1.7407963267948966")
                     .range(0.0, 2.0 * base::kPi)},
                NodeKind::Condition),
      isVisible);
  to.addCondition(
      humanNode("IsAgentClose", "Perception", "Another person is nearer than the threshold.",
                {port::person("observer_id", "Id of the first person."),
                 port::person("target_agent_id", "Id of the other person.", "2"),
                 port::length("threshold", "Nearer than this is close.").byDefault("1.0")},
                NodeKind::Condition),
      isClose);
}

}  // namespace bt
