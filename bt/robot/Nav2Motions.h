#pragma once

#include <array>
#include <optional>

#include "bt/robot/Nav2Servers.h"
#include "sim2d/nav/nav2/servers/BehaviorServer.h"
#include "sim2d/nav/nav2/servers/CollisionMonitor.h"
#include "sim2d/nav/nav2/servers/VelocitySmoother.h"

namespace bt {

/// What stands between controllers and wheels: behaviours, which drive instead of a controller,
/// the velocity smoother, the collision monitor if the file has one. In Humble behaviours bypass
/// the smoother.
class Nav2Servers::Motions {
 public:
  static constexpr std::array<RobotAction, 5> kActions = {
      RobotAction::Spin, RobotAction::BackUp, RobotAction::DriveOnHeading, RobotAction::Wait,
      RobotAction::AssistedTeleop};
  static bool isOne(RobotAction action);

  /// What is looked at in a step.
  struct Step {
    const sim2d::Observation& observation;  // in the frame of the local costmap, with the scan
                                            // that has arrived
    const sim2d::Observation& inOdom;       // the same in the frame odom, of the collision monitor
    const sim2d::nav2::LayeredCostmap& local;
    double time = 0.0;  // [s]
  };

  Motions(const sim2d::nav2::Nav2Parameters& parameters, const sim2d::nav2::Polygon& footprint);

  /// False: the file lists no such behaviour.
  bool begin(RobotAction action, const RobotRequest& request, const Step& step);
  void cancel(RobotAction action);
  /// Service toggle of the collision monitor: off, it passes commands on as they are.
  void monitorCollisions(bool isOn) { isMonitored_ = isOn; }
  bool isRunning(RobotAction action) const { return running_ == action; }
  /// What came of the behaviour that began last, once it has ended.
  std::optional<RobotOutcome> takeOutcome(RobotAction action);
  /// `command`: what a controller published in this step, if it did; the command for the wheels.
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
  bool ignoresCollisions_ = false;       // what runs
  std::optional<RobotOutcome> outcome_;  // of the action that `ended_` names
  RobotAction ended_ = RobotAction::Wait;
  bool stops_ = false;                      // a behaviour was cancelled
  std::optional<sim2d::BodyTwist> direct_;  // of a behaviour that bypasses the smoother
  sim2d::BodyTwist teleop_;  // the last command of a person while AssistedTeleop runs
  sim2d::BodyTwist sent_;    // by the smoother, holds
};

}  // namespace bt
