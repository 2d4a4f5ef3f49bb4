#include "bt/human/Leaves.h"
#include "bt/human/Ports.h"
#include "sim2d/base/Rng.h"

/// Decorators and conditions about time and chance that the original does not have.
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

struct Choice {
  bool isTaken;  // the child runs
};

NodeStatus tickChance(DecoratorContext& leaf) {
  bool& isTaken = leaf.memory<Choice>().isTaken;
  if (!isTaken) {
    const HumanContext& context = humanOf(leaf);
    const base::AgentRng random(context.view().seed(), context.idOf(context.self()),
                                static_cast<std::uint64_t>(context.view().step()));
    const double draw =
        random.uniform01(base::Draw::NodeChance, static_cast<std::uint32_t>(leaf.node()));
    if (draw >= leaf.require<double>(0)) {
      return NodeStatus::Failure;
    }
    isTaken = true;
  }
  const NodeStatus status = leaf.tickChild();
  isTaken = !isDone(status);
  return status;
}

void haltChance(DecoratorContext& leaf) {
  leaf.memory<Choice>().isTaken = false;
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
  to.addDecorator<Choice>(
      ownNode("ProbabilityChoice", "Timing",
              "Draws once when it is reached: runs its child to the end, or fails.",
              {Port("probability", PortType::Double, "", "Chance of running the child.")
                   .byDefault("0.5")
                   .range(0.0, 1.0)},
              NodeKind::Decorator),
      {tickChance, haltChance});
  to.addCondition(ownNode("IsTimeBetween", "Timing", "The simulated time lies in [from, until).",
                          {port::duration("from", "Begin.").byDefault("0.0"),
                           port::duration("until", "End.").required().suggest("60.0")},
                          NodeKind::Condition),
                  isTimeBetween);
}

}  // namespace bt
