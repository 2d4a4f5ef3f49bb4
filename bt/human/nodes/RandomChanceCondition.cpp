#include "bt/human/Leaves.h"
#include "bt/human/Ports.h"
#include "sim2d/base/Rng.h"

namespace bt {

namespace {

NodeStatus isLucky(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const sim2d::WorldView& view = context.view();
  const base::AgentRng random(view.seed(), context.idOf(context.self()),
                              static_cast<std::uint64_t>(view.step()));
  const double draw =
      random.uniform01(base::Draw::NodeChance, static_cast<std::uint32_t>(leaf.node()));
  return successIf(draw < leaf.require<double>(0));
}

}  // namespace

void addRandomChanceCondition(NodeLibrary& to) {
  to.addCondition(
      humanNode("RandomChanceCondition", "Timing",
                "Holds with the given probability; drawn anew in every tick that reaches it, so "
                "over n ticks the chance is 1 - (1 - p)^n.",
                {Port("probability", PortType::Double, "", "Chance per tick.")
                     .byDefault("0.3")
                     .range(0.0, 1.0),
                 port::unused("agent_id", PortType::Int)},
                NodeKind::Condition),
      isLucky);
}

}  // namespace bt
