#pragma once

#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"
#include "sim2d/nav/nav2/docking/DockingParameters.h"

/// The controller of docking_server and following_server (opennav_docking::Controller).
namespace sim2d::nav2 {

/// What it looks at: poses in the map, the costmap in a frame of its own.
struct DockView {
  Pose2 pose;                         // of the robot
  BodyTwist motion;                   // of the odometry
  const Costmap& costmap;             // the local one
  const CostmapFootprint& footprint;  // robot frame
  Pose2 costmapFrame{};               // in the map: odom, when that is the costmap's frame
};

class DockController {
 public:
  DockController(const DockControllerParameters& parameters, Distro distro)
      : parameters_(parameters), law_(lawOf(parameters)), distro_(distro) {}

  /// The graceful control law towards a target.
  BodyTwist command(const DockView& view, const Pose2& target, bool isBackward) const;
  /// Whether the way that the law would drive is free for the footprint's edges: simulated in steps
  /// of `simulation_time_step` until the target is 1 cm near or `projection_time` is over. Poses
  /// within `dock_collision_threshold` of the dock (docking) or of the start (undocking) are not
  /// tested. True without `use_collision_detection`.
  bool isFree(const DockView& view, const Pose2& target, bool isDocking, bool isBackward) const;
  /// A turn on the spot by `angle` [rad] in `dt` [s]: no faster than it can still stop in time,
  /// w = sqrt(2 a |angle|).
  BodyTwist rotation(double angle, double turnRate, double dt) const;

 private:
  DockControllerParameters parameters_;
  GracefulParameters law_;
  Distro distro_;
};

}  // namespace sim2d::nav2
