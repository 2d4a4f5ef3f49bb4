#include "bt/human/HumanContext.h"
#include "bt/human/Ports.h"

namespace bt {

namespace {

NodeStatus setFrozen(LeafContext& leaf, bool frozen) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  if (!human) {
    return NodeStatus::Failure;
  }
  context.control(*human).frozen = frozen;
  return NodeStatus::Success;
}

NodeStatus stopMovement(LeafContext& leaf) {
  return setFrozen(leaf, true);
}
NodeStatus resumeMovement(LeafContext& leaf) {
  return setFrozen(leaf, false);
}

struct Memory {
  std::int64_t startStep;
  int human;
  bool wasFrozen;
  double duration;  // [s]
};

NodeStatus start(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const double duration = leaf.require<double>(1);
  if (!human) {
    return NodeStatus::Failure;
  }
  bool& frozen = context.control(*human).frozen;
  leaf.memory<Memory>() = {leaf.step(), *human, frozen && !context.isOriginal(11), duration};
  frozen = true;
  return NodeStatus::Running;
}

NodeStatus run(LeafContext& leaf) {
  const Memory& memory = leaf.memory<Memory>();
  if (!leaf.hasElapsed(memory.startStep, memory.duration)) {
    return NodeStatus::Running;
  }
  humanOf(leaf).control(memory.human).frozen = memory.wasFrozen;
  return NodeStatus::Success;
}

void halt(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  if (!context.isOriginal(11)) {
    const Memory& memory = leaf.memory<Memory>();
    context.control(memory.human).frozen = memory.wasFrozen;
  }
}

}  // namespace

void addStopActions(NodeLibrary& to) {
  to.addAction(humanNode("StopMovement", "Walking",
                         "The person stops walking to goals until resumed; reactions still move.",
                         {port::agent()}),
               stopMovement);
  to.addAction(
      humanNode("ResumeMovement", "Walking", "Ends what StopMovement began.", {port::agent()}),
      resumeMovement);
  to.addStateful<Memory>(
      humanNode(
          "StopAndWaitTimerAction", "Timing", "Stands still for some time.",
          {port::agent(), port::duration("wait_duration", "Time to stand.").byDefault("5.0")}),
      {start, run, halt});
}

}  // namespace bt
