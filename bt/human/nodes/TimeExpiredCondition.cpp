#include "bt/human/Leaves.h"
#include "bt/human/Ports.h"

namespace bt {

namespace {

struct Memory {
  double elapsed;  // [s] over the ticks in which the node was reached
};

NodeStatus isExpired(LeafContext& leaf) {
  double& elapsed = leaf.memory<Memory>().elapsed;
  const double limit = leaf.require<double>(0);
  elapsed += leaf.require<double>(1);
  if (elapsed < limit - kTimeTolerance) {
    return NodeStatus::Failure;
  }
  if (!leaf.require<bool>(2)) {
    elapsed = 0.0;
  }
  return NodeStatus::Success;
}

}  // namespace

void addTimeExpiredCondition(NodeLibrary& to) {
  to.addCondition<Memory>(
      humanNode(
          "TimeExpiredCondition", "Timing",
          "Adds `ts` each time it is asked and holds when the sum has come to `seconds`; then "
          "it starts anew, or with only_once holds from then on.",
          {port::duration("seconds", "Length of the timer.").byDefault("1.0"),
           port::duration("ts", "Added per tick; usually {dt}.").byDefault("0.01").suggest("{dt}"),
           Port("only_once", PortType::Bool, "", "Stay expired.").byDefault("false")},
          NodeKind::Condition),
      isExpired);
}

}  // namespace bt
