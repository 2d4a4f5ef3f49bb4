#include "bt/human/HumanContext.h"

/// Stops, decorators and conditions about time; Cooldown and IsTimeBetween do not exist in
/// HuNavSim.
namespace bt {

namespace {

template <bool frozen>
void setFrozen(HumanContext& context, AgentIndex human) {
  context.control(human).frozen = frozen;
}

struct Stop {
  std::int64_t startStep;
  int human;
  bool wasFrozen;
  double duration;  // [s]
};

NodeStatus startStop(LeafContext& leaf, AgentIndex human, double duration) {
  HumanContext& context = humanOf(leaf);
  bool& frozen = context.control(human).frozen;
  const bool wasFrozen = frozen && !context.hasQuirk(11);
  frozen = true;
  return begin(leaf, Stop{leaf.step(), human, wasFrozen, duration});
}

NodeStatus runStop(LeafContext& leaf) {
  const Stop& memory = leaf.memory<Stop>();
  if (!leaf.hasElapsed(memory.startStep, memory.duration)) {
    return NodeStatus::Running;
  }
  humanOf(leaf).control(memory.human).frozen = memory.wasFrozen;
  return NodeStatus::Success;
}

void haltStop(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  if (!context.hasQuirk(11)) {
    const Stop& memory = leaf.memory<Stop>();
    context.control(memory.human).frozen = memory.wasFrozen;
  }
}

struct Pause {
  std::int64_t startStep;
  bool isOn;
};

NodeStatus tickDelay(ParentContext& leaf) {
  Pause& pause = leaf.memory<Pause>();
  if (!pause.isOn) {
    pause = {leaf.step(), true};
    return NodeStatus::Failure;
  }
  if (!leaf.hasElapsed(pause.startStep, leaf.require<double>(0))) {
    return NodeStatus::Failure;
  }
  const NodeStatus status = leaf.tickChild();
  if (isDone(status) && !humanOf(leaf).hasQuirk(20)) {
    pause.isOn = false;
  }
  return status;
}

void resetPause(ParentContext& leaf) {
  leaf.memory<Pause>().isOn = false;
}

NodeStatus isExpired(LeafContext& leaf) {
  double& elapsed = leaf.memory<double>();  // [s] sum over the ticks of this node
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

NodeStatus tickCooldown(ParentContext& leaf) {
  Pause& pause = leaf.memory<Pause>();
  if (pause.isOn && !leaf.hasElapsed(pause.startStep, leaf.require<double>(0))) {
    return NodeStatus::Failure;
  }
  pause.isOn = false;
  const NodeStatus status = leaf.tickChild();
  if (isDone(status)) {
    pause = {leaf.step(), true};
  }
  return status;
}

NodeStatus isTimeBetween(LeafContext& leaf) {
  const double now = humanOf(leaf).view().time() + kTimeTolerance;
  return successIf(now >= leaf.require<double>(0) && now < leaf.require<double>(1));
}

constexpr const char* kNodes = R"(
Action StopMovement|Walking|The person stops walking to goals until ResumeMovement; reactions still move the person.
agent_id
Action ResumeMovement|Walking|Ends the effect of StopMovement.
agent_id
Action StopAndWaitTimerAction|Timing|Stands still for some time.
agent_id
wait_duration duration default 5.0|Duration.
Decorator TimeDelay|Timing|Fails until the delay is over, then runs the child; the delay restarts after each run of the child.
delay duration default 1.0|Time before the child is run.
Condition TimeExpiredCondition|Timing|Adds `ts` in each tick and succeeds when the sum has reached `seconds`; then it restarts, or with only_once succeeds from then on.
seconds duration default 1.0|Length of the timer.
ts duration default 0.01 suggest {dt}|Added per tick; usually {dt}.
only_once bool default false|The timer stays expired.
Decorator Cooldown own|Timing|Runs the child; after its completion the node fails until the time has passed.
duration duration default 10.0|Pause after each run of the child.
Condition IsTimeBetween own|Timing|The simulated time lies in [from, until).
from duration default 0.0|Start of the interval.
until duration needed suggest 60.0|End of the interval.
)";

}  // namespace

void addTiming(NodeLibrary& to) {
  to.add(humanManifests(kNodes), {{"StopMovement", synchronous(withPorts<setFrozen<true>, 0>)},
                                  {"ResumeMovement", synchronous(withPorts<setFrozen<false>, 0>)},
                                  {"StopAndWaitTimerAction",
                                   stateful<Stop>({withPorts<startStop, 0, 1>, runStop, haltStop})},
                                  {"TimeDelay", decorator<Pause>({tickDelay, resetPause})},
                                  {"TimeExpiredCondition", synchronous<double>(isExpired)},
                                  {"Cooldown", decorator<Pause>({tickCooldown})},
                                  {"IsTimeBetween", synchronous(isTimeBetween)}});
}

}  // namespace bt
