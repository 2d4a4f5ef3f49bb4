#include "sim2d/nav/nav2/servers/BehaviorServer.h"

#include <type_traits>

#include "sim2d/nav/SensedWorld.h"

namespace sim2d::nav2 {

void BehaviorServer::start(const Behavior& behavior, BehaviorKind kind, double time) {
  behavior_.emplace(behavior);
  kind_ = kind;
  start_ = time;
  lastCycle_ = -1;
  code_ = 0;
}

void BehaviorServer::spin(const Spin::Goal& goal, double time, const Pose2& pose) {
  start(Spin(parameters_, goal, time, pose), BehaviorKind::Spin, time);
}

void BehaviorServer::backUp(const DriveStraight::Goal& goal, double time, const Pose2& pose) {
  start(DriveStraight(parameters_, backUp_, DriveStraight::backUp(goal), time, pose),
        BehaviorKind::BackUp, time);
}

void BehaviorServer::driveOnHeading(const DriveStraight::Goal& goal, double time,
                                    const Pose2& pose) {
  start(DriveStraight(parameters_, driveOnHeading_, goal, time, pose), BehaviorKind::DriveOnHeading,
        time);
}

void BehaviorServer::wait(double duration, double time) {
  start(Wait(duration, time), BehaviorKind::Wait, time);
}

void BehaviorServer::assistedTeleop(double timeAllowance, double time) {
  start(AssistedTeleop(parameters_, timeAllowance, time), BehaviorKind::AssistedTeleop, time);
}

std::optional<BehaviorStep> BehaviorServer::update(const BehaviorInput& input,
                                                   const BodyTwist& wish) {
  if (!behavior_) {
    return std::nullopt;
  }
  const std::int64_t cycle = eventAt(input.time - start_, parameters_.cycleFrequency);
  if (cycle <= lastCycle_) {
    return std::nullopt;
  }
  lastCycle_ = cycle;
  const BehaviorStep step = std::visit(
      [&input, &wish](auto& behavior) {
        if constexpr (std::is_same_v<std::decay_t<decltype(behavior)>, AssistedTeleop>) {
          return behavior.cycle(input, wish);
        } else {
          return behavior.cycle(input);
        }
      },
      *behavior_);
  if (step.status != BehaviorStatus::Running) {
    behavior_.reset();
    code_ = behaviorCode(kind_, step.error);
  }
  return step;
}

}  // namespace sim2d::nav2
