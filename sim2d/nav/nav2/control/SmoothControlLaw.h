#pragma once

#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2Key.h"
#include "sim2d/nav/nav2/control/GracefulParameters.h"

/// The law of nav2_graceful_controller (smooth_control_law.cpp; Park, Kuipers, "A Smooth Control
/// Law for Graceful Motion of Differential Wheeled Mobile Robots in 2D Environment", ICRA 2011).
namespace sim2d::nav2 {

/// A target seen by a robot; angles against the line of sight, clockwise from it as in the paper.
struct EgoPolar {
  double r = 0.0;      // [m]
  double phi = 0.0;    // of the target's heading [rad]
  double delta = 0.0;  // of the robot's heading [rad]
};
EgoPolar egoPolar(const Pose2& target, const Pose2& robot, bool isBackward);

/// kappa [1/m], forwards.
double gracefulCurvature(const GracefulParameters& parameters, const EgoPolar& polar);
/// The command towards a target.
BodyTwist gracefulCommand(const GracefulParameters& parameters, Distro distro, const Pose2& target,
                          const Pose2& robot, bool isBackward);

}  // namespace sim2d::nav2
