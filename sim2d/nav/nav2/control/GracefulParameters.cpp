#include "sim2d/nav/nav2/control/GracefulParameters.h"

#include <vector>

namespace sim2d::nav2 {

GracefulParameters gracefulDefaults(Distro distro) {
  GracefulParameters parameters;
  if (distro == Distro::Humble) {
    parameters.kPhi = 3.0;
    parameters.kDelta = 2.0;
    parameters.beta = 0.2;
  }
  return parameters;
}

const std::vector<Nav2Key<GracefulParameters>>& gracefulKeys() {
  using P = GracefulParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"k_phi", &P::kPhi, "", "how early it turns towards the target's heading"},
      {"k_delta", &P::kDelta, "1/m", "how hard it steers back"},
      {"beta", &P::beta, "", "how much it slows down in curves"},
      {"lambda", &P::lambda, "", "how sharply it does"},
      {"v_linear_min", &P::minLinear, "m/s", "least speed"},
      {"v_linear_max", &P::maxLinear, "m/s", "greatest speed"},
      {"v_angular_max", &P::maxAngular, "rad/s", "greatest angular speed"},
      {"v_angular_min_in_place", &P::minAngularInPlace, "rad/s", "least when turning on the spot",
       kSinceJazzy},
      {"slowdown_radius", &P::slowdownRadius, "m", "nearer to its target it slows down"},
      {"deceleration_max", &P::maxDeceleration, "m/s^2", "no faster than it can brake by",
       kSinceLyrical},
      {"max_robot_pose_search_dist", &P::searchDistance, "m",
       "length of path searched for the robot; 0: half the costmap, negative: all", kUntilKilted},
      {"min_lookahead", &P::minLookahead, "m", "least distance of a target", kJazzy | kKilted},
      {"max_lookahead", &P::maxLookahead, "m", "a target is no farther", kSinceJazzy},
      {"motion_target_dist", &P::targetDistance, "m", "how far the target is", kHumble},
      {"initial_rotation", &P::rotatesFirst, "", "turns on the spot first on a new path"},
      {"initial_rotation_tolerance", &P::firstRotationTolerance, "rad",
       "smaller angles it does not", kSinceJazzy},
      {"initial_rotation_min_angle", &P::firstRotationTolerance, "rad",
       "smaller angles it does not", kHumble},
      {"prefer_final_rotation", &P::prefersFinalRotation, "",
       "near the goal its heading counts once the place is reached", kSinceJazzy},
      {"final_rotation", &P::prefersFinalRotation, "", "turns to the goal's heading on the spot",
       kHumble},
      {"rotation_scaling_factor", &P::rotationScaling, "1/rad", "how fast it turns by the angle"},
      {"allow_backward", &P::allowsBackward, "", "drives backwards to targets behind it"},
      {"in_place_collision_resolution", &P::inPlaceResolution, "rad",
       "turns on the spot are checked in such steps", kSinceJazzy},
      {"use_collision_detection", &P::detectsCollisions, "", "no command into an obstacle",
       kSinceKilted},
      {"footprint_scaling_linear_vel", &P::footprintScalingVelocity, "m/s",
       "the footprint is enlarged above this speed", kSinceLyrical},
      {"footprint_scaling_factor", &P::footprintScalingFactor, "",
       "enlargement at the greatest speed", kSinceLyrical},
      {"footprint_scaling_step", &P::footprintScalingStep, "m/s",
       "reduction of the speed when a colliding target is tried again", kSinceLyrical},
  };
  return kKeys;
}

const std::vector<IdleKey>& gracefulIdleKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"transform_tolerance", "no TF here", kUntilKilted},
      {"obstacle_cost_margin", "not re-implemented: it counts as its default", kSinceLyrical},
      {"final_rotation_search_step", "not re-implemented: it counts as its default", kSinceLyrical},
      {"min_lookahead", "the target is interpolated at max_lookahead", kSinceLyrical},
  };
  return kKeys;
}

}  // namespace sim2d::nav2
