#pragma once

#include <cstdint>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2Key.h"
#include "sim2d/nav/nav2/control/PursuitParameters.h"

/// The rules of Regulated Pure Pursuit (regulated_pure_pursuit_controller.cpp,
/// regulation_functions.hpp). Paths and points lie in the robot's frame.
namespace sim2d::nav2 {

/// L [m] at the measured speed [m/s].
double lookaheadDistance(const PursuitParameters& parameters, double speed);
/// Where the way from p1 (inside) to p2 (outside) leaves the circle about the robot.
Vec2 circleSegmentIntersection(const Vec2& p1, const Vec2& p2, double radius);
/// The point of the path at `distance`: the first pose so far away or, `interpolates`, the place on
/// the segment before it; else its end, or, `goesOn`, a place on the last segment made longer.
Vec2 carrotAt(const Path& path, double distance, bool interpolates, bool goesOn);
/// kappa of the arc to a point [1/m]; 0 nearer than 0.0316 m.
double curvatureTo(const Vec2& point);
/// How far the first change of direction is [m]: a cusp, or a turn on the spot; infinite: none.
double distanceToCusp(const Path& path);

/// What bounds the speed of a command.
struct SpeedRegulation {
  double curvature = 0.0;        // kappa [1/m]
  std::uint8_t cost = 0;         // of the robot's cell
  double inscribedRadius = 0.0;  // [m]
  double pathLength = 0.0;       // of the local path [m]
  double goalDistance = 0.0;     // of its last pose [m]
  double sign = 1.0;             // -1: backwards
};
/// The speed v [m/s] within the bounds of curvature, cost, approach and greatest speed.
double regulatedSpeed(const PursuitParameters& parameters, Distro distro, double v,
                      const SpeedRegulation& regulation);
/// The summands of it, each for a speed v [m/s].
double curvatureSpeed(const PursuitParameters& parameters, double v, double curvature);
double costSpeed(const PursuitParameters& parameters, Distro distro, double v,
                 const SpeedRegulation& regulation);
double approachSpeed(const PursuitParameters& parameters, double v,
                     const SpeedRegulation& regulation);

}  // namespace sim2d::nav2
