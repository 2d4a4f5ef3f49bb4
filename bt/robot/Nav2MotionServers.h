#pragma once

#include <array>
#include <optional>

#include "bt/robot/Nav2Servers.h"
#include "sim2d/nav/nav2/servers/Behaviors.h"
#include "sim2d/nav/nav2/servers/CollisionMonitor.h"
#include "sim2d/nav/nav2/servers/VelocitySmoother.h"

namespace bt {

/// The servers between controllers and wheels: behaviours, which drive instead of a controller, the
/// velocity smoother and, if configured, the collision monitor. In Humble behaviours bypass the
/// smoother.
class Nav2Servers::MotionServers {
 public:
  static constexpr std::array<RobotAction, 5> kActions = {
      RobotAction::Spin, RobotAction::BackUp, RobotAction::DriveOnHeading, RobotAction::Wait,
      RobotAction::AssistedTeleop};
  static bool handles(RobotAction action);

  /// Input of one step.
  struct Step {
    const sim2d::Observation& observation;  // in the local costmap's frame, with the
                                            // delayed scan
    const sim2d::Observation& inOdom;       // the same in odom, for the collision monitor
    const sim2d::nav2::LayeredCostmap& local;
    double time = 0.0;  // [s]
  };

  MotionServers(const sim2d::nav2::Nav2Parameters& parameters,
                const sim2d::nav2::Polygon& footprint);

  /// Returns false if the file lists no such behaviour.
  bool begin(RobotAction action, const RobotRequest& request, const Step& step);
  void cancel(RobotAction action);
  /// Service toggle of the collision monitor. If off, it passes commands unchanged.
  void enableCollisionMonitor(bool isOn) { isMonitored_ = isOn; }
  bool isRunning(RobotAction action) const { return running_ == action; }
  /// The outcome of the last behaviour, once it has ended.
  std::optional<RobotOutcome> takeOutcome(RobotAction action);
  /// `command`: the controller's command in this step, if any. Returns the command for the wheels.
  sim2d::BodyTwist drive(const Step& step, std::optional<sim2d::BodyTwist> command);

 private:
  void runBehavior(const Step& step, std::optional<sim2d::BodyTwist>& command);

  sim2d::nav2::Distro distro_;
  std::array<bool, kActions.size()> isThere_ = {};
  sim2d::nav2::BehaviorServer behaviors_;
  sim2d::nav2::VelocitySmoother smoother_;
  std::optional<sim2d::nav2::CollisionMonitor> monitor_;
  bool isMonitored_ = true;
  std::optional<RobotAction> running_;
  bool ignoresCollisions_ = false;       // of the running behaviour
  std::optional<RobotOutcome> outcome_;  // of the action in `ended_`
  RobotAction ended_ = RobotAction::Wait;
  bool stops_ = false;                      // a behaviour was cancelled
  std::optional<sim2d::BodyTwist> direct_;  // command that bypasses the smoother
  sim2d::BodyTwist teleop_;                 // last manual command during AssistedTeleop
  sim2d::BodyTwist sent_;                   // last output of the smoother
};

}  // namespace bt
