#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt/robot/Nav2Servers.h"
#include "sim2d/nav/nav2/docking/DockingServer.h"
#include "sim2d/nav/nav2/docking/FollowingServer.h"

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

}  // namespace bt
