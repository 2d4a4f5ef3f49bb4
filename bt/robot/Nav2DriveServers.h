#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt/robot/Nav2Servers.h"
#include "sim2d/nav/nav2/docking/DockingServer.h"
#include "sim2d/nav/nav2/docking/FollowingServer.h"
#include "sim2d/nav/nav2/servers/Behaviors.h"
#include "sim2d/nav/nav2/servers/CollisionMonitor.h"
#include "sim2d/nav/nav2/servers/VelocitySmoother.h"

namespace bt {

/// docking_server and following_server. Their commands bypass the velocity smoother and the
/// collision monitor, as in nav2_bringup. For the drive to a staging pose they use the planner and
/// controller servers and replan every second.
class Nav2Servers::Docking {
 public:
  static constexpr std::array<RobotAction, 3> kActions = {
      RobotAction::DockRobot, RobotAction::UndockRobot, RobotAction::FollowObject};
  static bool handles(RobotAction action);

  /// `servers` must outlive this object.
  explicit Docking(Nav2Servers& servers);

  void begin(RobotAction action, const RobotRequest& request);
  void cancel(RobotAction action);
  /// Call after planner and controller. Returns the command for the wheels; empty: none. Outcomes
  /// of finished actions are stored in the servers' results.
  std::optional<sim2d::BodyTwist> drive();
  /// Events since the last call: "docked dock1" …
  std::vector<std::string> takeEvents() { return std::exchange(events_, {}); }

 private:
  /// State of the drive to the staging pose.
  struct Staging {
    bool isOn = false, isPlanning = false, isFollowing = false;
    double plannedAt = 0.0;  // [s]
    int failures = 0;
    PathId goal = 0;
  };

  void driveDocking();
  void driveFollowing();
  sim2d::nav2::StagingDrive stage(const sim2d::nav2::Pose2& pose);
  void planStaging();
  void endStaging();
  RobotOutcome& end(sim2d::nav2::ServerStatus status, int errorCode, const std::string& text);
  std::optional<sim2d::nav2::Pose2> object();
  const sim2d::TrackedBody* tracked() const;
  sim2d::nav2::DockControllerInput view() const;

  Nav2Servers& servers_;
  sim2d::nav2::DockingServer docking_;
  sim2d::nav2::FollowingServer following_;
  std::optional<RobotAction> running_;
  std::optional<sim2d::BodyTwist> held_;  // last command
  std::optional<sim2d::nav2::Pose2> stagingPose_;
  Staging staging_;
  FollowedObject object_;
  std::optional<int> track_;  // id of the followed body
  std::vector<std::string> events_;
};

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
