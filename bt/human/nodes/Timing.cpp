#include "bt/human/HumanContext.h"
#include "bt/human/Ports.h"

/// Decorators and conditions about time; the original does not have Cooldown and IsTimeBetween.
namespace bt {

namespace {

bool isDone(NodeStatus status) {
  return status == NodeStatus::Success || status == NodeStatus::Failure;
}

struct Delay {
  std::int64_t startStep;
  bool isArmed;
};

NodeStatus tickDelay(DecoratorContext& leaf) {
  Delay& memory = leaf.memory<Delay>();
  if (!memory.isArmed) {
    memory = {leaf.step(), true};
    return NodeStatus::Failure;
  }
  if (!leaf.hasElapsed(memory.startStep, leaf.require<double>(0))) {
    return NodeStatus::Failure;
  }
  const NodeStatus status = leaf.tickChild();
  if (isDone(status) && !humanOf(leaf).isOriginal(20)) {
    memory.isArmed = false;
  }
  return status;
}

void disarm(DecoratorContext& leaf) {
  leaf.memory<Delay>().isArmed = false;
}

struct Timer {
  double elapsed;  // [s] over the ticks in which the node was reached
};

NodeStatus isExpired(LeafContext& leaf) {
  double& elapsed = leaf.memory<Timer>().elapsed;
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
  to.addDecorator<Delay>(
      humanNode("TimeDelay", "Timing",
                "Fails until the delay is over, then runs its child; the next round waits again.",
                {port::duration("delay", "Time before the child is run.").byDefault("1.0")},
                NodeKind::Decorator),
      {tickDelay, disarm});
  to.addCondition<Timer>(
      humanNode(
          "TimeExpiredCondition", "Timing",
          "Adds `ts` each time it is asked and holds when the sum has come to `seconds`; then "
          "it starts anew, or with only_once holds from then on.",
          {port::duration("seconds", "Length of the timer.").byDefault("1.0"),
           port::duration("ts", "Added per tick; usually {dt}.").byDefault("0.01").suggest("{dt}"),
           PortSpec("only_once", PortType::Bool, "", "Stay expired.").byDefault("false")},
          NodeKind::Condition),
      isExpired);
  to.addDecorator<Rest>(
      ownNode("Cooldown", "Timing",
              "Runs its child; once that is done the node fails until the time has passed.",
              {port::duration("duration", "Pause after each run of the child.").byDefault("10.0")},
              NodeKind::Decorator),
      {tickCooldown, nullptr});
  to.addCondition(ownNode("IsTimeBetween", "Timing", "The simulated time lies in [from, until).",
                          {port::duration("from", "Begin.").byDefault("0.0"),
                           port::duration("until", "End.").needed().suggest("60.0")},
                          NodeKind::Condition),
                  isTimeBetween);
}

}  // namespace bt
