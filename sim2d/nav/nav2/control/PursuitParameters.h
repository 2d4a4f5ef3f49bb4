#pragma once

#include <vector>

#include "sim2d/nav/nav2/Nav2Key.h"

namespace sim2d::nav2 {

/// Keys of nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController.
struct PursuitParameters {
  double maxLinearVelocity = 0.5;     // desired_linear_vel, main: max_linear_vel [m/s]
  double lookahead = 0.6;             // L [m]
  double minLookahead = 0.3;          // [m]
  double maxLookahead = 0.9;          // [m]
  double lookaheadTime = 1.5;         // [s]
  bool scalesLookahead = false;       // L = |v| lookahead_time
  double minApproachVelocity = 0.05;  // [m/s]
  double approachDistance = 0.6;      // [m]
  bool regulatesByCurvature = true;
  double regulatedMinRadius = 0.9;  // [m]
  double regulatedMinSpeed = 0.25;  // [m/s]
  bool regulatesByCost = true;
  double costScalingDistance = 0.6;  // [m]
  double costScalingGain = 1.0;
  double inflationCostScaling = 3.0;  // must be the inflation layer's [1/m]
  double searchDistance = 0.0;        // [m]; < 0: all, 0: half the map
  bool detectsCollisions = true;
  double maxTimeToCollision = 1.0;      // [s]
  double minDistanceToObstacle = -1.0;  // main [m]; not above 0: off
  bool checksBeyondGoal = false;        // main
  bool rotatesToHeading = true;
  double rotateMinAngle = 0.785;        // [rad]
  double rotateVelocity = 1.8;          // [rad/s]
  double maxAngularAcceleration = 3.2;  // [rad/s^2]
  bool allowsReversing = false;
  bool interpolates = true;              // Humble
  bool fixesCurvatureLookahead = false;  // since Jazzy
  double curvatureLookahead = 0.6;       // [m]
  bool interpolatesAfterGoal = false;
  bool decelerantCancel = false;    // use_cancel_deceleration
  double cancelDeceleration = 3.2;  // [m/s^2]
  bool isStateful = true;           // Jazzy: the goal's place is latched
  // Main: dynamic window pure pursuit
  bool usesDynamicWindow = false;
  double minLinearVelocity = -0.5;       // [m/s]
  double maxAngularVelocity = 2.5;       // [rad/s]
  double minAngularVelocity = -2.5;      // [rad/s]
  double maxLinearAcceleration = 2.5;    // [m/s^2]
  double maxLinearDeceleration = -2.5;   // [m/s^2]
  double maxAngularDeceleration = -3.2;  // [rad/s^2]
};

const std::vector<Nav2Key<PursuitParameters>>& pursuitKeys();
const std::vector<IdleKey>& pursuitIdleKeys();

}  // namespace sim2d::nav2
