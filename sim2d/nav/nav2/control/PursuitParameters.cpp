#include "sim2d/nav/nav2/control/PursuitParameters.h"

#include <vector>

namespace sim2d::nav2 {

namespace {

using PursuitKeys = std::vector<Nav2Key<PursuitParameters>>;

PursuitKeys speedKeysOfPursuit() {
  using P = PursuitParameters;
  return {
      {"desired_linear_vel", &P::maxLinearVelocity, "m/s", "speed on a straight, free path"},
      {"max_linear_vel", &P::maxLinearVelocity, "m/s", "speed on a straight, free path",
       kSinceLyrical},
      {"lookahead_dist", &P::lookahead, "m", "how far ahead the carrot is"},
      {"min_lookahead_dist", &P::minLookahead, "m", "at least, when scaled by speed"},
      {"max_lookahead_dist", &P::maxLookahead, "m", "at most, when scaled by speed"},
      {"lookahead_time", &P::lookaheadTime, "s", "the carrot is what is driven in this time"},
      {"use_velocity_scaled_lookahead_dist", &P::scalesLookahead, "",
       "the carrot's distance grows with the speed"},
      {"min_approach_linear_velocity", &P::minApproachVelocity, "m/s", "least speed near the goal"},
      {"approach_velocity_scaling_dist", &P::approachDistance, "m",
       "with less path left it slows down"},
      {"use_regulated_linear_velocity_scaling", &P::regulatesByCurvature, "", "slow in curves"},
      {"regulated_linear_scaling_min_radius", &P::regulatedMinRadius, "m",
       "narrower curves are driven more slowly"},
      {"regulated_linear_scaling_min_speed", &P::regulatedMinSpeed, "m/s",
       "least speed in curves and near obstacles"},
      {"use_cost_regulated_linear_velocity_scaling", &P::regulatesByCost, "",
       "slow near obstacles"},
      {"cost_scaling_dist", &P::costScalingDistance, "m", "nearer to an obstacle it slows down"},
      {"cost_scaling_gain", &P::costScalingGain, "", "less than 1: more slowly near obstacles"},
      {"inflation_cost_scaling_factor", &P::inflationCostScaling, "1/m",
       "turns costs into distances: must be the inflation layer's cost_scaling_factor"},
  };
}

PursuitKeys otherKeysOfPursuit() {
  using P = PursuitParameters;
  return {
      {"max_robot_pose_search_dist", &P::searchDistance, "m",
       "length of path searched for the robot; 0: half the costmap, negative: all", kUntilKilted},
      {"use_collision_detection", &P::detectsCollisions, "", "no command into an obstacle"},
      {"max_allowed_time_to_collision_up_to_carrot", &P::maxTimeToCollision, "s",
       "so long the command is looked ahead"},
      {"min_distance_to_obstacle", &P::minDistanceToObstacle, "m",
       "least distance that the command is simulated ahead; 0 or less: off", kSinceKilted},
      {"allow_obstacle_checking_beyond_goal", &P::checksBeyondGoal, "",
       "that distance applies beyond the end of the path too", kSinceLyrical},
      {"use_rotate_to_heading", &P::rotatesToHeading, "",
       "turns on the spot towards path and goal heading"},
      {"rotate_to_heading_min_angle", &P::rotateMinAngle, "rad", "larger angles are turned first"},
      {"rotate_to_heading_angular_vel", &P::rotateVelocity, "rad/s", "how fast it turns"},
      {"max_angular_accel", &P::maxAngularAcceleration, "rad/s^2", "how fast turning changes"},
      {"allow_reversing", &P::allowsReversing, "", "drives backwards where the path does"},
      {"use_interpolation", &P::interpolates, "", "the carrot lies between poses of the path",
       kHumble},
      {"use_fixed_curvature_lookahead", &P::fixesCurvatureLookahead, "",
       "the curvature is that to a carrot of its own", kSinceJazzy},
      {"curvature_lookahead_dist", &P::curvatureLookahead, "m", "how far that carrot is ahead",
       kSinceJazzy},
      {"interpolate_curvature_after_goal", &P::interpolatesAfterGoal, "",
       "that carrot may lie behind the goal", kSinceJazzy},
      {"use_cancel_deceleration", &P::decelerantCancel, "", "brakes when a goal is cancelled",
       kSinceJazzy},
      {"cancel_deceleration", &P::cancelDeceleration, "m/s^2", "how hard", kSinceJazzy},
      {"stateful", &P::isStateful, "", "the goal's place counts as reached until a new path",
       kJazzy | kKilted},
      {"use_dynamic_window", &P::usesDynamicWindow, "", "keeps within the accelerations",
       kSinceLyrical},
      {"min_linear_vel", &P::minLinearVelocity, "m/s", "of the dynamic window", kSinceLyrical},
      {"max_angular_vel", &P::maxAngularVelocity, "rad/s", "of the dynamic window", kSinceLyrical},
      {"min_angular_vel", &P::minAngularVelocity, "rad/s", "of the dynamic window", kSinceLyrical},
      {"max_linear_accel", &P::maxLinearAcceleration, "m/s^2", "of the dynamic window",
       kSinceLyrical},
      {"max_linear_decel", &P::maxLinearDeceleration, "m/s^2", "of the dynamic window",
       kSinceLyrical},
      {"max_angular_decel", &P::maxAngularDeceleration, "rad/s^2", "of the dynamic window",
       kSinceLyrical},
  };
}

}  // namespace

const std::vector<Nav2Key<PursuitParameters>>& pursuitKeys() {
  static const PursuitKeys kKeys = [] {
    PursuitKeys keys = speedKeysOfPursuit();
    const PursuitKeys others = otherKeysOfPursuit();
    keys.insert(keys.end(), others.begin(), others.end());
    return keys;
  }();
  return kKeys;
}

const std::vector<IdleKey>& pursuitIdleKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"transform_tolerance", "no TF here", kUntilKilted},
  };
  return kKeys;
}

}  // namespace sim2d::nav2
