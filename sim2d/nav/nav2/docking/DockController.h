#pragma once

#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"
#include "sim2d/nav/nav2/docking/DockingParameters.h"

/// The controller of docking_server and following_server (opennav_docking::Controller).
namespace sim2d::nav2 {

/// Inputs of the controller: poses in the map, the costmap in its own frame.
struct DockControllerInput {
  Pose2 pose;                         // robot pose
  BodyTwist motion;                   // odometry
  const Costmap& costmap;             // local costmap
  const CostmapFootprint& footprint;  // robot frame
  Pose2 costmapFrame{};               // in the map: odom, if that is the costmap's frame
};

class DockController {
 public:
  DockController(const DockControllerParameters& parameters, Distro distro)
      : parameters_(parameters), law_(lawOf(parameters)), distro_(distro) {}

  /// The graceful control law towards a target.
  BodyTwist command(const DockControllerInput& view, const Pose2& target, bool isBackward) const;
  /// Whether the footprint's edges are free along the motion towards the target: simulated in steps
  /// of `simulation_time_step` until the target is within 1 cm or `projection_time` is over. Poses
  /// within `dock_collision_threshold` of the dock (docking) or of the start (undocking) are not
  /// checked. True without `use_collision_detection`.
  bool isFree(const DockControllerInput& view, const Pose2& target, bool isDocking,
              bool isBackward) const;
  /// A rotation in place by `angle` [rad] in a step `dt` [s], slow enough to stop in time: w =
  /// sqrt(2 a |angle|).
  BodyTwist rotation(double angle, double turnRate, double dt) const;

 private:
  DockControllerParameters parameters_;
  GracefulParameters law_;
  Distro distro_;
};

}  // namespace sim2d::nav2
