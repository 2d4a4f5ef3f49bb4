#include "bt/human/HumanContext.h"

namespace bt {

namespace {

template <bool frozen>
void setFrozen(HumanContext& context, AgentIndex human) {
  context.control(human).frozen = frozen;
}

struct Memory {
  std::int64_t startStep;
  int human;
  bool wasFrozen;
  double duration;  // [s]
};

NodeStatus start(LeafContext& leaf, AgentIndex human, double duration) {
  HumanContext& context = humanOf(leaf);
  bool& frozen = context.control(human).frozen;
  const bool wasFrozen = frozen && !context.hasQuirk(11);
  frozen = true;
  return begin(leaf, Memory{leaf.step(), human, wasFrozen, duration});
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
  if (!context.hasQuirk(11)) {
    const Memory& memory = leaf.memory<Memory>();
    context.control(memory.human).frozen = memory.wasFrozen;
  }
}

constexpr const char* kNodes = R"(
Action StopMovement|Walking|The person stops walking to goals until ResumeMovement; reactions still move the person.
agent_id
Action ResumeMovement|Walking|Ends the effect of StopMovement.
agent_id
Action StopAndWaitTimerAction|Timing|Stands still for some time.
agent_id
wait_duration duration default 5.0|Duration.
)";

}  // namespace

void addStopActions(NodeLibrary& to) {
  const NodeCatalogue nodes = humanManifests(kNodes);
  to.addAction(*nodes.find("StopMovement"), withPorts<setFrozen<true>, 0>);
  to.addAction(*nodes.find("ResumeMovement"), withPorts<setFrozen<false>, 0>);
  to.addStateful<Memory>(*nodes.find("StopAndWaitTimerAction"),
                         {withPorts<start, 0, 1>, run, halt});
}

}  // namespace bt
