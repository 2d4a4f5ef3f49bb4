#pragma once

#include <cstdint>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

namespace sim2d::nav2 {

/// Keys of nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController.
struct PursuitParameters {
  double maxLinearVelocity = 0.5;            // desired_linear_vel, main: max_linear_vel [m/s]
  double lookahead = 0.6;                    // L [m]
  double minLookahead = 0.3;                 // [m]
  double maxLookahead = 0.9;                 // [m]
  double lookaheadTime = 1.5;                // [s]
  bool usesVelocityScaledLookahead = false;  // L = |v| lookahead_time
  double minApproachVelocity = 0.05;         // [m/s]
  double approachDistance = 0.6;             // [m]
  bool regulatesByCurvature = true;
  double regulatedMinRadius = 0.9;  // [m]
  double regulatedMinSpeed = 0.25;  // [m/s]
  bool regulatesByCost = true;
  double costScalingDistance = 0.6;  // [m]
  double costScalingGain = 1.0;
  double inflationCostScaling = 3.0;  // must equal the inflation layer's [1/m]
  double searchDistance = 0.0;        // [m]; < 0: all, 0: half the map
  bool usesCollisionDetection = true;
  double maxTimeToCollision = 1.0;      // [s]
  double minDistanceToObstacle = -1.0;  // main [m]; <= 0: off
  bool checksBeyondGoal = false;        // main
  bool rotatesToHeading = true;
  double rotateMinAngle = 0.785;        // [rad]
  double rotateVelocity = 1.8;          // [rad/s]
  double maxAngularAcceleration = 3.2;  // [rad/s^2]
  bool allowsReversing = false;
  bool usesInterpolation = true;             // Humble
  bool usesFixedCurvatureLookahead = false;  // since Jazzy
  double curvatureLookahead = 0.6;           // [m]
  bool interpolatesCurvatureAfterGoal = false;
  bool usesCancelDeceleration = false;  // use_cancel_deceleration
  double cancelDeceleration = 3.2;      // [m/s^2]
  bool isStateful = true;               // Jazzy: latches the goal position
  // Main: dynamic window pure pursuit.
  bool usesDynamicWindow = false;
  double minLinearVelocity = -0.5;       // [m/s]
  double maxAngularVelocity = 2.5;       // [rad/s]
  double minAngularVelocity = -2.5;      // [rad/s]
  double maxLinearAcceleration = 2.5;    // [m/s^2]
  double maxLinearDeceleration = -2.5;   // [m/s^2]
  double maxAngularDeceleration = -3.2;  // [rad/s^2]
};

const std::vector<Nav2Key<PursuitParameters>>& pursuitKeys();
const std::vector<IgnoredKey>& ignoredPursuitKeys();

/// Functions of Regulated Pure Pursuit (regulated_pure_pursuit_controller.cpp,
/// regulation_functions.hpp). Paths and points are in the robot's frame.

/// Lookahead distance L [m] at the measured speed [m/s].
double lookaheadDistance(const PursuitParameters& parameters, double speed);
/// Intersection of the segment from p1 (inside) to p2 (outside) with the circle around the robot.
Vec2 circleSegmentIntersection(const Vec2& p1, const Vec2& p2, double radius);
/// The point of the path at `distance`: the first pose at that distance or, with
/// `usesInterpolation`, a point on the segment before it; else its end or, with `extrapolates`, a
/// point on the extended last segment.
Vec2 carrotAt(const Path& path, double distance, bool usesInterpolation, bool extrapolates);
/// Curvature kappa of the arc to a point [1/m]; 0 below a distance of 0.0316 m.
double curvatureTo(const Vec2& point);
/// Distance of the first cusp or turn in place [m]; infinite if there is none.
double distanceToCusp(const Path& path);

/// Inputs of the speed regulation.
struct SpeedRegulation {
  double curvature = 0.0;        // kappa [1/m]
  std::uint8_t cost = 0;         // cost of the robot's cell
  double inscribedRadius = 0.0;  // [m]
  double pathLength = 0.0;       // of the local path [m]
  double goalDistance = 0.0;     // distance of its last pose [m]
  double sign = 1.0;             // -1: backwards
};
/// The speed v [m/s] limited by curvature, cost, approach and maximum speed.
double regulatedSpeed(const PursuitParameters& parameters, Distro distro, double v,
                      const SpeedRegulation& regulation);
/// The separate limits, each for a speed v [m/s].
double curvatureSpeed(const PursuitParameters& parameters, double v, double curvature);
double costSpeed(const PursuitParameters& parameters, Distro distro, double v,
                 const SpeedRegulation& regulation);
double approachSpeed(const PursuitParameters& parameters, double v,
                     const SpeedRegulation& regulation);

}  // namespace sim2d::nav2
