#include "bt/human/Leaves.h"
#include "bt/human/Ports.h"

namespace bt {

namespace {

struct Memory {
  std::int64_t startStep;
  bool isArmed;
};

NodeStatus tick(DecoratorContext& leaf) {
  Memory& memory = leaf.memory<Memory>();
  if (!memory.isArmed) {
    memory = {leaf.step(), true};
    return NodeStatus::Failure;
  }
  if (!leaf.hasElapsed(memory.startStep, leaf.require<double>(0))) {
    return NodeStatus::Failure;
  }
  const NodeStatus status = leaf.tickChild();
  const bool isDone = status == NodeStatus::Success || status == NodeStatus::Failure;
  if (isDone && !humanOf(leaf).isOriginal(20)) {
    memory.isArmed = false;
  }
  return status;
}

void halt(DecoratorContext& leaf) {
  leaf.memory<Memory>().isArmed = false;
}

}  // namespace

void addTimeDelay(NodeLibrary& to) {
  to.addDecorator<Memory>(
      humanNode("TimeDelay", "Timing",
                "Fails until the delay is over, then runs its child; the next round waits again.",
                {port::duration("delay", "Time before the child is run.").byDefault("1.0")},
                NodeKind::Decorator),
      {tick, halt});
}

}  // namespace bt
