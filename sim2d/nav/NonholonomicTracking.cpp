#include "sim2d/nav/NonholonomicTracking.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "sim2d/base/Math.h"

namespace sim2d {
namespace {

constexpr double kNoAngle = 1e-6;      // [rad]
constexpr double kStraightOn = 1e-6;   // [m/s]; slower has no direction
constexpr double kNoDirection = 0.01;  // [m/s]
constexpr int kSpotCorners = 5;        // on each side
/// Where the curve of velocities that are met on the spot is as far back as at 180 degrees:
/// cos(x) / x = -1 / pi.
constexpr double kLastCorner = 2.4813323829;  // [rad]

/// x / 2 cot(x / 2): share of the wanted speed on the arc.
double arcSpeed(double angle) {
  const double half = 0.5 * std::fabs(angle);
  return half < kNoAngle ? 1.0 : half * base::cos(half) / base::sin(half);
}

/// Duration of the arc [s].
double arcTime(const TrackingModel& model, double speed, double angle) {
  double time = std::max(model.turnTime, std::fabs(angle) / model.maxOmega);
  if (model.kinematics == Kinematics::Ackermann) {
    const double half = 0.5 * std::fabs(angle);
    const double tangent = base::sin(half) / std::max(base::cos(half), kNoAngle);
    time = std::max(time, 2.0 * model.turningRadius * tangent / std::max(speed, kStraightOn));
  }
  return time;
}

HalfPlane edgeBetween(const Vec2& from, const Vec2& to) {
  return {from, (to - from).normalized()};
}

/// Directions up to `angle` to both sides, and of those what is not too far aside.
std::vector<HalfPlane> velocitiesAhead(double angle, double aside) {
  const Vec2 apex = Vec2::Zero();
  const Vec2 low = base::directionOf(-angle);
  const Vec2 high = base::directionOf(angle);
  return {{apex, low},
          {apex, Vec2(-high)},
          {Vec2(0.0, aside), Vec2(-1.0, 0.0)},
          {Vec2(0.0, -aside), Vec2(1.0, 0.0)}};
}

/// Chords of the curve V_H = epsilon omega_max / theta_H, which is bent outwards.
std::vector<HalfPlane> velocitiesOnSpot(double firstAngle, double unit) {
  std::vector<Vec2> corners;
  corners.reserve(std::size_t{2} * kSpotCorners);
  for (int i = 0; i < kSpotCorners; ++i) {
    const double angle = firstAngle + (kLastCorner - firstAngle) * i / (kSpotCorners - 1);
    corners.emplace_back(unit / angle * base::directionOf(angle));
  }
  for (int i = kSpotCorners - 1; i >= 0; --i) {
    const Vec2& left = corners[static_cast<std::size_t>(i)];
    corners.emplace_back(left.x(), -left.y());
  }
  std::vector<HalfPlane> edges;
  edges.reserve(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    edges.push_back(edgeBetween(corners[i], corners[(i + 1) % corners.size()]));
  }
  return edges;
}

}  // namespace

TrackingModel trackingModelOf(const RobotBody& body, double turnTime) {
  const DriveLimits& limits = body.limits;
  TrackingModel model;
  model.kinematics = body.kinematics;
  model.maxVel = limits.maxVel;
  model.maxOmega = limits.maxOmega;
  model.turnTime = std::max(turnTime, limits.maxOmega / limits.maxAlpha);
  model.turningRadius = limits.turningRadius;
  return model;
}

double arcAngle(const TrackingModel& model) {
  return std::min(model.maxOmega * model.turnTime, 0.5 * base::kPi);
}

double trackingError(const TrackingModel& model, double speed, double angle) {
  if (model.kinematics == Kinematics::Omnidirectional) {
    return 0.0;
  }
  const double size = std::fabs(angle);
  if (model.kinematics == Kinematics::Differential && size > arcAngle(model)) {
    return speed * size / model.maxOmega;
  }
  return speed * arcTime(model, speed, size) * base::sin(0.5 * size);
}

double steeringAngle(double turningRadius, double epsilon) {
  if (turningRadius <= 0.0) {
    return 0.5 * base::kPi;
  }
  // 2 R s^2 / sqrt(1 - s^2) = epsilon with s = sin(angle / 2).
  const double share = epsilon / (4.0 * turningRadius);
  const double squared = 2.0 * share * (std::sqrt(share * share + 1.0) - share);
  return std::min(base::acos(1.0 - 2.0 * squared), 0.5 * base::kPi);
}

double fastestTracked(const TrackingModel& model, double angle, double epsilon) {
  const double size = std::fabs(angle);
  if (model.kinematics == Kinematics::Omnidirectional || size < kNoAngle) {
    return model.maxVel;
  }
  if (model.kinematics == Kinematics::Differential && size > arcAngle(model)) {
    return std::min(model.maxVel, epsilon * model.maxOmega / size);
  }
  if (model.kinematics == Kinematics::Ackermann &&
      size > steeringAngle(model.turningRadius, epsilon)) {
    return 0.0;
  }
  const double time = arcTime(model, std::numeric_limits<double>::infinity(), size);
  return std::min(model.maxVel, epsilon / (time * base::sin(0.5 * size)));
}

std::vector<std::vector<HalfPlane>> trackedVelocities(const TrackingModel& model, double epsilon) {
  if (model.kinematics == Kinematics::Omnidirectional) {
    return {{}};
  }
  double angle = arcAngle(model);
  if (model.kinematics == Kinematics::Ackermann) {
    angle = std::min(angle, steeringAngle(model.turningRadius, epsilon));
  }
  // On the border of the set v_y = 2 epsilon / T cos(theta_H / 2).
  const double aside = 2.0 * epsilon / model.turnTime * base::cos(0.5 * angle);
  std::vector<std::vector<HalfPlane>> pieces;
  pieces.push_back(velocitiesAhead(angle, aside));
  if (model.kinematics == Kinematics::Differential) {
    pieces.push_back(velocitiesOnSpot(angle, epsilon * model.maxOmega));
  }
  return pieces;
}

BodyTwist track(const TrackingModel& model, const Vec2& velocity) {
  const double speed = std::min(velocity.norm(), model.maxVel);
  if (speed < kStraightOn) {
    return {};
  }
  const double fullTurn = std::min(1.0, speed / kNoDirection);
  const double angle = base::headingOf(velocity);
  if (model.kinematics == Kinematics::Omnidirectional) {
    const double turn = std::clamp(angle / model.turnTime, -model.maxOmega, model.maxOmega);
    return {speed * base::cos(angle), fullTurn * turn, speed * base::sin(angle)};
  }
  if (model.kinematics == Kinematics::Ackermann) {
    const double within = std::clamp(angle, -0.5 * base::kPi, 0.5 * base::kPi);
    return {speed * arcSpeed(within), within / arcTime(model, speed, within)};
  }
  if (std::fabs(angle) > arcAngle(model) + kNoAngle) {
    return {0.0, fullTurn * (angle > 0.0 ? model.maxOmega : -model.maxOmega)};
  }
  return {speed * arcSpeed(angle), fullTurn * angle / model.turnTime};
}

}  // namespace sim2d
