#include "sim2d/nav/nav2/control/PursuitRules.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "sim2d/base/Math.h"

namespace sim2d::nav2 {

double lookaheadDistance(const PursuitParameters& parameters, double speed) {
  if (!parameters.scalesLookahead) {
    return parameters.lookahead;
  }
  // As std::clamp, which knows no answer when the bounds are the wrong way round.
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

Vec2 carrotAt(const Path& path, double distance, bool interpolates, bool goesOn) {
  const auto far = std::find_if(path.begin(), path.end(), [&](const Pose2& pose) {
    return pose.position.norm() >= distance;
  });
  if (far != path.end()) {
    const bool isBetween = interpolates && far != path.begin();
    return isBetween ? circleSegmentIntersection((far - 1)->position, far->position, distance)
                     : far->position;
  }
  Vec2 end = path.back().position;
  if (!goesOn || path.size() < 2) {
    return end;
  }
  const double heading = base::headingOf(end - path[path.size() - 2].position);
  const Vec2 beyond = end + distance * base::directionOf(heading);
  return circleSegmentIntersection(end, beyond, distance);
}

double curvatureTo(const Vec2& point) {
  constexpr double kLeast = 0.001;  // [m^2]
  const double squared = point.squaredNorm();
  return squared > kLeast ? 2.0 * point.y() / squared : 0.0;
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
