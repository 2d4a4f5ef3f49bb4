#include "bt/human/Leaves.h"
#include "bt/human/Ports.h"

/// A decorator and a condition about time that the original does not have.
namespace bt {

namespace {

bool isDone(NodeStatus status) {
  return status == NodeStatus::Success || status == NodeStatus::Failure;
}

struct Rest {
  std::int64_t startStep;
  bool isResting;
};

NodeStatus tickCooldown(DecoratorContext& leaf) {
  Rest& rest = leaf.memory<Rest>();
  if (rest.isResting && !leaf.hasElapsed(rest.startStep, leaf.require<double>(0))) {
    return NodeStatus::Failure;
  }
  rest.isResting = false;
  const NodeStatus status = leaf.tickChild();
  if (isDone(status)) {
    rest = {leaf.step(), true};
  }
  return status;
}

NodeStatus isTimeBetween(LeafContext& leaf) {
  const double now = humanOf(leaf).view().time() + kTimeTolerance;
  return successIf(now >= leaf.require<double>(0) && now < leaf.require<double>(1));
}

}  // namespace

void addTiming(NodeLibrary& to) {
  to.addDecorator<Rest>(
      ownNode("Cooldown", "Timing",
              "Runs its child; once that is done the node fails until the time has passed.",
              {port::duration("duration", "Pause after each run of the child.").byDefault("10.0")},
              NodeKind::Decorator),
      {tickCooldown, nullptr});
  to.addCondition(ownNode("IsTimeBetween", "Timing", "The simulated time lies in [from, until).",
                          {port::duration("from", "Begin.").byDefault("0.0"),
                           port::duration("until", "End.").required().suggest("60.0")},
                          NodeKind::Condition),
                  isTimeBetween);
}

}  // namespace bt
