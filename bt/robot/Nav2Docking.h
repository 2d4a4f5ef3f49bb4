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

/// docking_server and following_server beside the other servers. Their commands go to the wheels
/// past velocity smoother and collision monitor, as in nav2_bringup. For the drive to a staging
/// pose they ask planner and controller server, whose paths are planned anew every second.
class Nav2Servers::Docking {
 public:
  static constexpr std::array<RobotAction, 3> kActions = {
      RobotAction::DockRobot, RobotAction::UndockRobot, RobotAction::FollowObject};
  static bool isOne(RobotAction action);

  /// `servers` outlives this.
  explicit Docking(Nav2Servers& servers);

  void begin(RobotAction action, const RobotRequest& request);
  void cancel(RobotAction action);
  /// After planner and controller: the command for the wheels; nothing: none of its own. Outcomes
  /// of actions that ended are put into the servers' results.
  std::optional<sim2d::BodyTwist> drive();
  /// "docked dock1" …, since the last call.
  std::vector<std::string> takeEvents() { return std::exchange(events_, {}); }

 private:
  /// The drive to the staging pose.
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
  sim2d::nav2::DockView view() const;

  Nav2Servers& servers_;
  sim2d::nav2::DockingServer docking_;
  sim2d::nav2::FollowingServer following_;
  std::optional<RobotAction> running_;
  std::optional<sim2d::BodyTwist> held_;  // the last command
  std::optional<sim2d::nav2::Pose2> stagingPose_;
  Staging staging_;
  FollowedObject object_;
  std::optional<int> track_;  // that is followed
  std::vector<std::string> events_;
};

}  // namespace bt
