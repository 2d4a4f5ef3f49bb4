#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "sim2d/nav/nav2/servers/Behaviors.h"

namespace sim2d::nav2 {

/// Runs one behaviour at a time at `cycle_frequency` (nav2_behaviors::TimedBehavior): its cycles
/// are at the first steps not before start + n / frequency. Thread: one at a time.
class BehaviorServer {
 public:
  BehaviorServer(const BehaviorParameters& parameters, const DriveParameters& backUp,
                 const DriveParameters& driveOnHeading)
      : parameters_(parameters), backUp_(backUp), driveOnHeading_(driveOnHeading) {}

  // Each ends what runs.
  void spin(const Spin::Goal& goal, double time, const Pose2& pose);
  void backUp(const DriveStraight::Goal& goal, double time, const Pose2& pose);
  void driveOnHeading(const DriveStraight::Goal& goal, double time, const Pose2& pose);
  void wait(double duration, double time);
  void assistedTeleop(double timeAllowance, double time);
  /// A cancelled behaviour stops the robot: the caller commands zero.
  void cancel() { behavior_.reset(); }
  bool isRunning() const { return behavior_.has_value(); }

  /// Each step: what a cycle gave, if one was due; nothing while none runs or is due, then the last
  /// command holds. `wish`: of the teleoperator.
  std::optional<BehaviorStep> update(const BehaviorInput& input, const BodyTwist& wish = {});
  /// Of the behaviour that ran last.
  std::uint16_t code() const { return code_; }

 private:
  using Behavior = std::variant<Spin, DriveStraight, Wait, AssistedTeleop>;
  void start(const Behavior& behavior, BehaviorKind kind, double time);

  BehaviorParameters parameters_;
  DriveParameters backUp_, driveOnHeading_;
  std::optional<Behavior> behavior_;
  BehaviorKind kind_ = BehaviorKind::Spin;
  double start_ = 0.0;  // [s]
  std::int64_t lastCycle_ = -1;
  std::uint16_t code_ = 0;
};

}  // namespace sim2d::nav2
