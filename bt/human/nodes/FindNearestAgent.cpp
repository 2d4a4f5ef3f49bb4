#include "bt/human/Leaves.h"
#include "bt/human/Perception.h"
#include "bt/human/Ports.h"

namespace bt {

namespace {

NodeStatus findNearest(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const int nearest = human ? nearestPerson(context.view(), *human) : -1;
  if (nearest < 0) {
    return NodeStatus::Failure;
  }
  leaf.set(1, context.idOf(nearest));
  return NodeStatus::Success;
}

}  // namespace

void addFindNearestAgent(NodeLibrary& to) {
  to.addAction(humanNode("FindNearestAgent", "People",
                         "Writes the id of the nearest other person; fails when there is nobody.",
                         {port::agent(), Port("target_agent_id", PortType::Int, "",
                                              "Takes the id of the nearest person.")
                                             .output()
                                             .suggest("{target_agent_id}")}),
               findNearest);
}

}  // namespace bt
