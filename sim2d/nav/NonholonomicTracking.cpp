#include "sim2d/nav/NonholonomicTracking.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "sim2d/base/Math.h"
#include "sim2d/nav/DriveKinematics.h"
#include "sim2d/nav/FootprintGap.h"

namespace sim2d {
namespace {

constexpr double kMinAngle = 1e-6;      // [rad]
constexpr double kMinSpeed = 1e-6;      // [m/s]; lower speeds have no direction
constexpr double kSlowSpeed = 0.01;     // [m/s]
constexpr int kTurnInPlaceCorners = 5;  // per side
/// Angle at which the boundary of turn-in-place velocities is as far back as at 180 degrees: cos(x)
/// / x = -1 / pi.
constexpr double kLastCorner = 2.4813323829;  // [rad]

/// x / 2 cot(x / 2): ratio of the speed on the arc to the reference speed.
double arcSpeed(double angle) {
  const double half = 0.5 * std::fabs(angle);
  return half < kMinAngle ? 1.0 : half * base::cos(half) / base::sin(half);
}

/// Duration of the arc [s].
double arcTime(const TrackingModel& model, double speed, double angle) {
  double time = std::max(model.turnTime, std::fabs(angle) / model.maxOmega);
  if (model.kinematics == Kinematics::Ackermann) {
    const double half = 0.5 * std::fabs(angle);
    const double tangent = base::sin(half) / std::max(base::cos(half), kMinAngle);
    time = std::max(time, 2.0 * model.turningRadius * tangent / std::max(speed, kMinSpeed));
  }
  return time;
}

HalfPlane edgeBetween(const Vec2& from, const Vec2& to) {
  return {from, (to - from).normalized()};
}

/// Directions up to `angle` to both sides, with a lateral component of at most `aside`.
std::vector<HalfPlane> forwardVelocities(double angle, double aside) {
  const Vec2 apex = Vec2::Zero();
  const Vec2 low = base::directionOf(-angle);
  const Vec2 high = base::directionOf(angle);
  return {{apex, low},
          {apex, Vec2(-high)},
          {Vec2(0.0, aside), Vec2(-1.0, 0.0)},
          {Vec2(0.0, -aside), Vec2(1.0, 0.0)}};
}

/// Chords of the convex curve V_H = epsilon omega_max / theta_H.
std::vector<HalfPlane> turnInPlaceVelocities(double firstAngle, double unit) {
  std::vector<Vec2> corners;
  corners.reserve(std::size_t{2} * kTurnInPlaceCorners);
  for (int i = 0; i < kTurnInPlaceCorners; ++i) {
    const double angle = firstAngle + (kLastCorner - firstAngle) * i / (kTurnInPlaceCorners - 1);
    corners.emplace_back(unit / angle * base::directionOf(angle));
  }
  for (int i = kTurnInPlaceCorners - 1; i >= 0; --i) {
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

TrackingModel trackingModelFor(const RobotBody& body, double turnTime) {
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

double maxTrackableAngle(double turningRadius, double epsilon) {
  if (turningRadius <= 0.0) {
    return 0.5 * base::kPi;
  }
  // 2 R s^2 / sqrt(1 - s^2) = epsilon with s = sin(angle / 2).
  const double share = epsilon / (4.0 * turningRadius);
  const double squared = 2.0 * share * (std::sqrt(share * share + 1.0) - share);
  return std::min(base::acos(1.0 - 2.0 * squared), 0.5 * base::kPi);
}

std::vector<std::vector<HalfPlane>> trackableVelocities(const TrackingModel& model,
                                                        double epsilon) {
  if (model.kinematics == Kinematics::Omnidirectional) {
    return {{}};
  }
  double angle = arcAngle(model);
  if (model.kinematics == Kinematics::Ackermann) {
    angle = std::min(angle, maxTrackableAngle(model.turningRadius, epsilon));
  }
  // On the boundary of the set, v_y = 2 epsilon / T cos(theta_H / 2).
  const double aside = 2.0 * epsilon / model.turnTime * base::cos(0.5 * angle);
  std::vector<std::vector<HalfPlane>> pieces;
  pieces.push_back(forwardVelocities(angle, aside));
  if (model.kinematics == Kinematics::Differential) {
    pieces.push_back(turnInPlaceVelocities(angle, epsilon * model.maxOmega));
  }
  return pieces;
}

BodyTwist track(const TrackingModel& model, const Vec2& velocity) {
  const double speed = std::min(velocity.norm(), model.maxVel);
  if (speed < kMinSpeed) {
    return {};
  }
  const double fullTurn = std::min(1.0, speed / kSlowSpeed);
  const double angle = base::headingOf(velocity);
  if (model.kinematics == Kinematics::Omnidirectional) {
    const double turn = std::clamp(angle / model.turnTime, -model.maxOmega, model.maxOmega);
    return {speed * base::cos(angle), fullTurn * turn, speed * base::sin(angle)};
  }
  if (model.kinematics == Kinematics::Ackermann) {
    const double within = std::clamp(angle, -0.5 * base::kPi, 0.5 * base::kPi);
    return {speed * arcSpeed(within), within / arcTime(model, speed, within)};
  }
  if (std::fabs(angle) > arcAngle(model) + kMinAngle) {
    return {0.0, fullTurn * (angle > 0.0 ? model.maxOmega : -model.maxOmega)};
  }
  return {speed * arcSpeed(angle), fullTurn * angle / model.turnTime};
}

namespace {

constexpr double kGearStandstillSpeed = 0.02;  // [m/s]
constexpr double kBlockedTime = 1.0;           // [s] at standstill before the gear is changed
constexpr double kMinGearTime = 2.0;           // minimum time in a gear, unless blocked [s]
constexpr double kMaxReverseTime = 6.0;        // [s]
constexpr double kTurningCircleFactor =
    1.2;                                  // in turning radii; beyond it the robot drives forward
constexpr double kGoalRadiusRatio = 0.8;  // in goal radii; maximum miss distance of an arc
constexpr double kLookaheadRadii = 1.5;

}  // namespace

BodyTwist DriveReference::toRobotCommand(const BodyTwist& twist) const {
  return isReversing ? BodyTwist{-twist.linear, twist.angular, -twist.lateral} : twist;
}

GearSelector::GearSelector(const RobotBody& body, double turnTime)
    : model_(trackingModelFor(body, turnTime)), maxReverse_(body.limits.maxReverse) {}

double GearSelector::minLookahead() const {
  return model_.kinematics == Kinematics::Ackermann ? kLookaheadRadii * model_.turningRadius : 0.0;
}

/// Whether `target` (robot frame) lies inside the circle to its left or right.
bool GearSelector::isInsideTurningCircle(const Vec2& target, double radius) const {
  return Vec2(target.x(), std::fabs(target.y()) - model_.turningRadius).norm() < radius;
}

void GearSelector::update(const Observation& observation, const Vec2& target, bool wantsToMove) {
  const double time = observation.time;
  if (lastMotionTime_ < 0.0 || !wantsToMove ||
      std::fabs(observation.motion.linear) > kGearStandstillSpeed) {
    lastMotionTime_ = time;
  }
  bool isChanging = time - lastMotionTime_ > kBlockedTime;
  const double lasted = time - since_;
  if (isReversing_) {
    isChanging = isChanging || lasted > kMaxReverseTime ||
                 (lasted > kMinGearTime &&
                  !isInsideTurningCircle(target, kTurningCircleFactor * model_.turningRadius));
  } else if (lasted > kMinGearTime) {
    const double missed = model_.turningRadius - kGoalRadiusRatio * observation.goalRadius;
    isChanging = isChanging || (wantsToMove && isInsideTurningCircle(target, missed));
  }
  if (isChanging) {
    isReversing_ = !isReversing_;
    since_ = time;
    lastMotionTime_ = time;
  }
}

DriveReference GearSelector::choose(const Observation& observation, const Vec2& target,
                                    const Vec2& wanted, double epsilon) {
  const Pose2& pose = observation.pose;
  DriveReference aim{model_, pose.heading, wanted, false};
  if (model_.kinematics != Kinematics::Ackermann) {
    return aim;
  }
  const double speed = wanted.norm();
  if (maxReverse_ > 0.0) {
    update(observation, pose.toLocal(target), speed > 0.0);
  }
  const double bearing = base::headingOf(rotated(wanted, -pose.heading));
  const double most = maxTrackableAngle(model_.turningRadius, epsilon);
  double aside = std::clamp(bearing, -most, most);
  aim.isReversing = isReversing_;
  if (isReversing_) {
    aim.model.maxVel = std::min(model_.maxVel, maxReverse_);
    aim.heading = base::wrapToPi(pose.heading + base::kPi);
    aside = bearing > 0.0 ? most : -most;
  }
  aim.wanted =
      std::min(speed, aim.model.maxVel) * base::directionOf(base::wrapToPi(aim.heading + aside));
  return aim;
}

namespace {

constexpr std::size_t kMaxVisible = 24;
constexpr double kWallTolerance =
    2e-3;  // [m], minimum distance to walls, so that the planes do not exclude zero

}  // namespace

std::vector<TrackedBody> visibleBodies(const Observation& observation, double range) {
  const Vec2& eye = observation.pose.position;
  const auto distance = [&eye](const TrackedBody& body) {
    return (body.position - eye).squaredNorm();
  };
  std::vector<TrackedBody> found;
  found.reserve(observation.bodies.size());
  for (const TrackedBody& body : observation.bodies) {
    if (distance(body) <= range * range &&
        (observation.navigation->isOpenBetween(eye, body.position) ||
         observation.obstacles->isVisible(eye, body.position))) {
      found.push_back(body);
    }
  }
  std::sort(found.begin(), found.end(), [&](const TrackedBody& a, const TrackedBody& b) {
    return distance(a) != distance(b) ? distance(a) < distance(b) : a.id < b.id;
  });
  if (found.size() > kMaxVisible) {
    found.resize(kMaxVisible);
  }
  return found;
}

std::vector<HalfPlane> wallPlanes(const Observation& observation, double radius, double speed,
                                  double horizon) {
  std::vector<Obstacles::Point> points;
  const Vec2& position = observation.pose.position;
  observation.obstacles->boundaryPoints(position, points, radius + speed * horizon);
  std::vector<HalfPlane> planes;
  planes.reserve(points.size());
  for (const Obstacles::Point& point : points) {
    const double size = point.inside ? radius : std::min(radius, point.distance - kWallTolerance);
    planes.push_back(
        pointHalfPlane(Walker(0, position, Vec2::Zero(), size), point, horizon, observation.dt));
  }
  return planes;
}

Vec2 rotated(const Vec2& vector, double angle) {
  const double cosine = base::cos(angle);
  const double sine = base::sin(angle);
  return {cosine * vector.x() - sine * vector.y(), sine * vector.x() + cosine * vector.y()};
}

HalfPlane rotated(const HalfPlane& plane, double heading) {
  return {rotated(plane.point, heading), rotated(plane.direction, heading)};
}

double worstViolation(const std::vector<HalfPlane>& planes, std::size_t first,
                      const Vec2& velocity) {
  double worst = 0.0;
  for (std::size_t i = first; i < planes.size(); ++i) {
    worst = std::max(worst, planes[i].violation(velocity));
  }
  return worst;
}

namespace {

constexpr double kSpeedFractions[] = {1.0, 0.75, 0.5, 0.25};
constexpr double kSameGap = 1e-9;  // [m]
constexpr int kMaxBrakingSteps = 1000;

/// Poses at the end of each step until the robot stands still.
std::vector<Pose2> brakingPoses(const RobotBody& body, const Observation& observation,
                                const BodyTwist& twist) {
  const double dt = observation.dt;
  std::vector<Pose2> poses;
  BodyTwist now = reached(body, observation.motion, twist, dt);
  Pose2 pose = observation.pose;
  for (int step = 0; step < kMaxBrakingSteps && now != BodyTwist{}; ++step) {
    pose = propagated(pose, now, dt);
    poses.push_back(pose);
    now = reached(body, now, BodyTwist{}, dt);
  }
  return poses;
}

/// Largest displacement from `start` [m].
double maxDisplacement(const std::vector<Pose2>& poses, const Vec2& start) {
  double farthest = 0.0;
  for (const Pose2& pose : poses) {
    farthest = std::max(farthest, (pose.position - start).norm());
  }
  return farthest;
}

bool keepsClearOfBody(const TrackedBody& other, const RobotBody& body,
                      const Observation& observation, const std::vector<Pose2>& poses,
                      double margin) {
  double time = 0.0;
  for (const Pose2& pose : poses) {
    time += observation.dt;
    const Vec2 place = other.position + time * other.velocity;
    const double gap = gapToDisc(body.footprint, pose, place, other.radius);
    if (gap < margin &&
        gap < gapToDisc(body.footprint, observation.pose, place, other.radius) - kSameGap) {
      return false;
    }
  }
  return true;
}

bool keepsClearOfWalls(const RobotBody& body, const Observation& observation,
                       const std::vector<Pose2>& poses, double margin, double room) {
  const Obstacles& walls = *observation.obstacles;
  if (walls.clearance(observation.pose.position, room) >= room) {
    return true;
  }
  const double now = gapToWalls(body.footprint, observation.pose, walls, room);
  const double least = std::min(margin, now - kSameGap);
  return std::all_of(poses.begin(), poses.end(), [&](const Pose2& pose) {
    return gapToWalls(body.footprint, pose, walls, room) >= least;
  });
}

}  // namespace

bool isPassivelySafe(const RobotBody& body, const Observation& observation, const BodyTwist& twist,
                     double margin) {
  const std::vector<Pose2> poses = brakingPoses(body, observation, twist);
  const double time = static_cast<double>(poses.size()) * observation.dt;
  const Vec2& start = observation.pose.position;
  const double room = circumscribedRadius(body.footprint) + maxDisplacement(poses, start) + margin;
  for (const TrackedBody& other : observation.bodies) {
    const double near = room + other.radius + time * other.velocity.norm();
    if ((other.position - start).squaredNorm() < near * near &&
        !keepsClearOfBody(other, body, observation, poses, margin)) {
      return false;
    }
  }
  return keepsClearOfWalls(body, observation, poses, margin, room);
}

BodyTwist nearestSafeTwist(const RobotBody& body, const Observation& observation,
                           const BodyTwist& wanted, double margin) {
  const BodyTwist full = reached(body, observation.motion, wanted, observation.dt);
  const BodyTwist turning{0.0, wanted.angular, 0.0};
  const BodyTwist slow = reached(body, observation.motion, turning, observation.dt);
  for (const double share : kSpeedFractions) {
    const BodyTwist tried{slow.linear + share * (full.linear - slow.linear),
                          slow.angular + share * (full.angular - slow.angular),
                          slow.lateral + share * (full.lateral - slow.lateral)};
    if (isPassivelySafe(body, observation, tried, margin)) {
      return tried;
    }
  }
  return isPassivelySafe(body, observation, slow, margin) ? slow : BodyTwist{};
}

}  // namespace sim2d
