#include "sim2d/nav/nav2/control/GracefulParameters.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim2d/base/Math.h"

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
      {"k_phi", &P::kPhi, "",
       "control law: how early the robot turns towards the target's "
       "heading"},
      {"k_delta", &P::kDelta, "1/m", "control law: gain of the heading correction"},
      {"beta", &P::beta, "", "control law: amount of slowdown in curves"},
      {"lambda", &P::lambda, "", "control law: sharpness of that slowdown"},
      {"v_linear_min", &P::minLinear, "m/s", "minimum speed"},
      {"v_linear_max", &P::maxLinear, "m/s", "maximum speed"},
      {"v_angular_max", &P::maxAngular, "rad/s", "maximum turn rate"},
      {"v_angular_min_in_place", &P::minAngularInPlace, "rad/s",
       "minimum turn rate for rotation in place", kSinceJazzy},
      {"slowdown_radius", &P::slowdownRadius, "m",
       "distance to the target below which the robot slows down"},
      {"deceleration_max", &P::maxDeceleration, "m/s^2",
       "deceleration that limits the speed near the target", kSinceLyrical},
      {"max_robot_pose_search_dist", &P::searchDistance, "m",
       "length of the path that is searched for the robot; 0: half the costmap, negative: all",
       kUntilKilted},
      {"min_lookahead", &P::minLookahead, "m", "minimum distance of a target", kJazzy | kKilted},
      {"max_lookahead", &P::maxLookahead, "m", "maximum distance of a target", kSinceJazzy},
      {"motion_target_dist", &P::targetDistance, "m", "distance of the target", kHumble},
      {"initial_rotation", &P::initialRotation, "", "rotates in place at the start of a new path"},
      {"initial_rotation_tolerance", &P::initialRotationTolerance, "rad",
       "minimum angle for this rotation", kSinceJazzy},
      {"initial_rotation_min_angle", &P::initialRotationTolerance, "rad",
       "minimum angle for this rotation", kHumble},
      {"prefer_final_rotation", &P::prefersFinalRotation, "",
       "near the goal its heading is used only after the position is reached", kSinceJazzy},
      {"final_rotation", &P::prefersFinalRotation, "", "rotates in place to the goal's heading",
       kHumble},
      {"rotation_scaling_factor", &P::rotationScaling, "1/rad", "turn rate per remaining angle"},
      {"allow_backward", &P::allowsBackward, "", "drives backwards to targets behind the robot"},
      {"in_place_collision_resolution", &P::inPlaceResolution, "rad",
       "angle step of collision checks for rotation in place", kSinceJazzy},
      {"use_collision_detection", &P::usesCollisionDetection, "",
       "rejects commands that lead into an obstacle", kSinceKilted},
      {"footprint_scaling_linear_vel", &P::footprintScalingVelocity, "m/s",
       "speed above which the footprint is enlarged", kSinceLyrical},
      {"footprint_scaling_factor", &P::footprintScalingFactor, "",
       "enlargement at the maximum speed", kSinceLyrical},
      {"footprint_scaling_step", &P::footprintScalingStep, "m/s",
       "speed reduction when a target that led to a collision is tried again", kSinceLyrical},
  };
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredGracefulKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"transform_tolerance", "TF is not used", kUntilKilted},
      {"obstacle_cost_margin", "not re-implemented: treated as its default", kSinceLyrical},
      {"final_rotation_search_step", "not re-implemented: treated as its default", kSinceLyrical},
      {"min_lookahead", "the target is interpolated at max_lookahead", kSinceLyrical},
  };
  return kKeys;
}

namespace {

double power(double x, double exponent) {  // x >= 0
  if (exponent == 2.0 || std::isinf(x)) {
    return x * x;
  }
  return x == 0.0 ? (exponent == 0.0 ? 1.0 : 0.0) : base::exp(exponent * base::log(x));
}

}  // namespace

EgoPolar egoPolar(const Pose2& target, const Pose2& robot, bool isBackward) {
  const Vec2 d = target.position - robot.position;
  const double sight = base::atan2(-d.y(), d.x()) + (isBackward ? base::kPi : 0.0);
  return {d.norm(), base::wrapToPi(target.heading + sight), base::wrapToPi(robot.heading + sight)};
}

double gracefulCurvature(const GracefulParameters& p, const EgoPolar& polar) {
  const double slow = base::atan2(-p.kPhi * polar.phi, 1.0);  // desired heading
  const double turned = p.kPhi * polar.phi;
  const double proportional = p.kDelta * (polar.delta - slow);
  const double feedback = (1.0 + p.kPhi / (1.0 + turned * turned)) * base::sin(polar.delta);
  const double steering = proportional + feedback;
  return steering == 0.0 ? 0.0 : -1.0 / polar.r * steering;  // at the target: infinite, not NaN
}

BodyTwist gracefulCommand(const GracefulParameters& p, Distro distro, const Pose2& target,
                          const Pose2& robot, bool isBackward) {
  const EgoPolar polar = egoPolar(target, robot, isBackward);
  const double sign = isBackward ? -1.0 : 1.0;
  const double curvature = sign * gracefulCurvature(p, polar);
  double v = p.maxLinear / (1.0 + p.beta * power(std::abs(curvature), p.lambda));
  v = std::min(v, p.maxLinear * polar.r / p.slowdownRadius);
  if (distro >= Distro::Lyrical) {
    v = std::min(v, std::sqrt(2.0 * polar.r * p.maxDeceleration));
  }
  v = sign * std::min(std::max(v, p.minLinear), p.maxLinear);
  const double w = std::min(std::max(curvature * v, -p.maxAngular), p.maxAngular);
  return {curvature != 0.0 ? w / curvature : v, w};
}

}  // namespace sim2d::nav2
