#include "sim2d/nav/nav2/control/RegulationFunctions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "sim2d/base/Math.h"

namespace sim2d::nav2 {

namespace {

using PursuitKeys = std::vector<Nav2Key<PursuitParameters>>;

PursuitKeys speedKeysOfPursuit() {
  using P = PursuitParameters;
  return {
      {"desired_linear_vel", &P::maxLinearVelocity, "m/s", "speed on a straight, free path"},
      {"max_linear_vel", &P::maxLinearVelocity, "m/s", "speed on a straight, free path",
       kSinceLyrical},
      {"lookahead_dist", &P::lookahead, "m", "distance of the lookahead point"},
      {"min_lookahead_dist", &P::minLookahead, "m",
       "minimum lookahead distance when scaled by speed"},
      {"max_lookahead_dist", &P::maxLookahead, "m",
       "maximum lookahead distance when scaled by speed"},
      {"lookahead_time", &P::lookaheadTime, "s", "lookahead distance as driving time"},
      {"use_velocity_scaled_lookahead_dist", &P::usesVelocityScaledLookahead, "",
       "the lookahead distance is proportional to the speed"},
      {"min_approach_linear_velocity", &P::minApproachVelocity, "m/s",
       "minimum speed near the goal"},
      {"approach_velocity_scaling_dist", &P::approachDistance, "m",
       "remaining path length below which the robot slows down"},
      {"use_regulated_linear_velocity_scaling", &P::regulatesByCurvature, "",
       "slows down in curves"},
      {"regulated_linear_scaling_min_radius", &P::regulatedMinRadius, "m",
       "curve radius below which the robot slows down"},
      {"regulated_linear_scaling_min_speed", &P::regulatedMinSpeed, "m/s",
       "minimum speed in curves and near obstacles"},
      {"use_cost_regulated_linear_velocity_scaling", &P::regulatesByCost, "",
       "slows down near obstacles"},
      {"cost_scaling_dist", &P::costScalingDistance, "m",
       "distance to an obstacle below which the robot slows down"},
      {"cost_scaling_gain", &P::costScalingGain, "",
       "values below 1 reduce the speed near obstacles further"},
      {"inflation_cost_scaling_factor", &P::inflationCostScaling, "1/m",
       "converts costs to distances: must be equal to cost_scaling_factor of the inflation layer"},
  };
}

PursuitKeys otherKeysOfPursuit() {
  using P = PursuitParameters;
  return {
      {"max_robot_pose_search_dist", &P::searchDistance, "m",
       "length of the path that is searched for the robot; 0: half the costmap, negative: all",
       kUntilKilted},
      {"use_collision_detection", &P::usesCollisionDetection, "",
       "rejects commands that lead into an obstacle"},
      {"max_allowed_time_to_collision_up_to_carrot", &P::maxTimeToCollision, "s",
       "time for which the command is simulated ahead"},
      {"min_distance_to_obstacle", &P::minDistanceToObstacle, "m",
       "minimum distance that the command is simulated ahead; 0 or less: off", kSinceKilted},
      {"allow_obstacle_checking_beyond_goal", &P::checksBeyondGoal, "",
       "this minimum distance also applies beyond the end of the path", kSinceLyrical},
      {"use_rotate_to_heading", &P::rotatesToHeading, "",
       "rotates in place to the headings of path and goal"},
      {"rotate_to_heading_min_angle", &P::rotateMinAngle, "rad",
       "angle to the path above which the robot rotates first"},
      {"rotate_to_heading_angular_vel", &P::rotateVelocity, "rad/s", "turn rate of the rotation"},
      {"max_angular_accel", &P::maxAngularAcceleration, "rad/s^2", "maximum angular acceleration"},
      {"allow_reversing", &P::allowsReversing, "", "drives backwards where the path does so"},
      {"use_interpolation", &P::usesInterpolation, "",
       "the lookahead point is interpolated between poses of the path", kHumble},
      {"use_fixed_curvature_lookahead", &P::usesFixedCurvatureLookahead, "",
       "the curvature uses its own lookahead point", kSinceJazzy},
      {"curvature_lookahead_dist", &P::curvatureLookahead, "m",
       "distance of the lookahead point for the curvature", kSinceJazzy},
      {"interpolate_curvature_after_goal", &P::interpolatesCurvatureAfterGoal, "",
       "the lookahead point for the curvature may lie beyond the goal", kSinceJazzy},
      {"use_cancel_deceleration", &P::usesCancelDeceleration, "", "brakes when a goal is cancelled",
       kSinceJazzy},
      {"cancel_deceleration", &P::cancelDeceleration, "m/s^2",
       "deceleration when a goal is cancelled", kSinceJazzy},
      {"stateful", &P::isStateful, "", "the goal's position stays reached until a new path",
       kJazzy | kKilted},
      {"use_dynamic_window", &P::usesDynamicWindow, "",
       "dynamic window: respects the acceleration limits", kSinceLyrical},
      {"min_linear_vel", &P::minLinearVelocity, "m/s", "limit of the dynamic window",
       kSinceLyrical},
      {"max_angular_vel", &P::maxAngularVelocity, "rad/s", "limit of the dynamic window",
       kSinceLyrical},
      {"min_angular_vel", &P::minAngularVelocity, "rad/s", "limit of the dynamic window",
       kSinceLyrical},
      {"max_linear_accel", &P::maxLinearAcceleration, "m/s^2", "limit of the dynamic window",
       kSinceLyrical},
      {"max_linear_decel", &P::maxLinearDeceleration, "m/s^2", "limit of the dynamic window",
       kSinceLyrical},
      {"max_angular_decel", &P::maxAngularDeceleration, "rad/s^2", "limit of the dynamic window",
       kSinceLyrical},
  };
}

}  // namespace

const std::vector<Nav2Key<PursuitParameters>>& pursuitKeys() {
  static const PursuitKeys kKeys =
      joinedKeys<PursuitParameters>(speedKeysOfPursuit(), otherKeysOfPursuit());
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredPursuitKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"transform_tolerance", "TF is not used", kUntilKilted},
  };
  return kKeys;
}

double lookaheadDistance(const PursuitParameters& parameters, double speed) {
  if (!parameters.usesVelocityScaledLookahead) {
    return parameters.lookahead;
  }
  // Like std::clamp, but defined if the bounds are swapped.
  const double scaled = std::abs(speed) * parameters.lookaheadTime;
  return std::min(std::max(scaled, parameters.minLookahead), parameters.maxLookahead);
}

Vec2 circleSegmentIntersection(const Vec2& p1, const Vec2& p2, double radius) {
  const Vec2 d = p2 - p1;
  const double dr2 = d.squaredNorm();
  const double determinant = base::cross(p1, p2);
  const double sign = p2.squaredNorm() - p1.squaredNorm() < 0.0 ? -1.0 : 1.0;
  const double root = std::sqrt(radius * radius * dr2 - determinant * determinant);
  return {(determinant * d.y() + sign * d.x() * root) / dr2,
          (-determinant * d.x() + sign * d.y() * root) / dr2};
}

Vec2 carrotAt(const Path& path, double distance, bool usesInterpolation, bool extrapolates) {
  const auto far = std::find_if(path.begin(), path.end(), [&](const Pose2& pose) {
    return pose.position.norm() >= distance;
  });
  if (far != path.end()) {
    const bool isBetween = usesInterpolation && far != path.begin();
    return isBetween ? circleSegmentIntersection((far - 1)->position, far->position, distance)
                     : far->position;
  }
  Vec2 end = path.back().position;
  if (!extrapolates || path.size() < 2) {
    return end;
  }
  const double heading = base::headingOf(end - path[path.size() - 2].position);
  const Vec2 beyond = end + distance * base::directionOf(heading);
  return circleSegmentIntersection(end, beyond, distance);
}

double curvatureTo(const Vec2& point) {
  constexpr double kMinimum = 0.001;  // [m^2]
  const double squared = point.squaredNorm();
  return squared > kMinimum ? 2.0 * point.y() / squared : 0.0;
}

double distanceToCusp(const Path& path) {
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Vec2 before = path[i].position - path[i - 1].position;
    const Vec2 after = path[i + 1].position - path[i].position;
    const bool isTurnBefore = before.isZero(0.0) && path[i - 1].heading != path[i].heading;
    const bool isTurnAfter = after.isZero(0.0) && path[i].heading != path[i + 1].heading;
    if (before.dot(after) < 0.0 || isTurnBefore || isTurnAfter) {
      return path[i].position.norm();
    }
  }
  return std::numeric_limits<double>::infinity();
}

double curvatureSpeed(const PursuitParameters& parameters, double v, double curvature) {
  const double radius = std::abs(1.0 / curvature);
  const double least = parameters.regulatedMinRadius;
  return radius < least ? v * (1.0 - std::abs(radius - least) / least) : v;
}

double costSpeed(const PursuitParameters& parameters, Distro distro, double v,
                 const SpeedRegulation& regulation) {
  if (regulation.cost == kNoInformation || regulation.cost == kFreeSpace) {
    return v;
  }
  const double full = distro == Distro::Humble ? kInscribed - 1 : kInscribed;
  const double distance = regulation.inscribedRadius -
                          base::log(regulation.cost / full) / parameters.inflationCostScaling;
  return distance < parameters.costScalingDistance
             ? v * (parameters.costScalingGain * distance / parameters.costScalingDistance)
             : v;
}

double approachSpeed(const PursuitParameters& parameters, double v,
                     const SpeedRegulation& regulation) {
  const bool isNear = regulation.pathLength < parameters.approachDistance;
  const double scale = isNear ? regulation.goalDistance / parameters.approachDistance : 1.0;
  return std::min(v, std::max(v * scale, parameters.minApproachVelocity));
}

double regulatedSpeed(const PursuitParameters& parameters, Distro distro, double v,
                      const SpeedRegulation& regulation) {
  double bounded = v;
  if (parameters.regulatesByCurvature) {
    bounded = curvatureSpeed(parameters, v, regulation.curvature);
  }
  if (parameters.regulatesByCost) {
    bounded = std::min(bounded, costSpeed(parameters, distro, v, regulation));
  }
  bounded = std::max(bounded, parameters.regulatedMinSpeed);
  bounded = approachSpeed(parameters, bounded, regulation);
  return regulation.sign * std::min(std::abs(bounded), parameters.maxLinearVelocity);
}

}  // namespace sim2d::nav2
