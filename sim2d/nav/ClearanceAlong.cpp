#include "sim2d/nav/ClearanceAlong.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "sim2d/base/Math.h"
#include "sim2d/nav/FootprintGap.h"

namespace sim2d {
namespace {

constexpr double kSlack = 0.01;     // [m], of the room left inside the margin
constexpr double kHardShare = 0.3;  // of the margin that is never given up
constexpr double kOwnPoint = 0.15;  // [m]; nearer points of a scan are those of known walls, people
constexpr double kPointSpan = 0.05;  // [m]; points of a scan nearer to the last one say nothing new
constexpr double kPointsFrom = 5.0;  // [m]; farther ones do not matter yet

constexpr double kNeverScanned = -1e9;

double cacheSpacing(const Footprint& footprint) {
  return std::clamp(0.4 * inscribedRadius(footprint), 0.03, 0.1);
}

/// The pose at a time between those of the way.
Pose2 poseAfter(const ClearanceAlong::Way& way, double time) {
  const double at = time / way.step;
  const auto last = way.poses.size() - 1;
  const auto before = std::min(static_cast<std::size_t>(std::max(0.0, at)), last);
  const Pose2& from = way.poses[before];
  const Pose2& to = way.poses[std::min(before + 1, last)];
  const double share = at - static_cast<double>(before);
  Pose2 pose;
  pose.position = from.position + share * (to.position - from.position);
  pose.heading = from.heading + share * (to.heading - from.heading);
  return pose;
}

/// Number of poses to advance until the gap can be less than `wide`; 1 when the result is NaN.
int posesToSkip(double gap, double wide, double perStep) {
  const double poses = (gap - wide) / perStep;
  return poses > 0.0 ? 1 + static_cast<int>(std::min(poses, 1e4)) : 1;
}

}  // namespace

ClearanceAlong::ClearanceAlong(const RobotBody& body, double wide)
    : body_(body),
      reach_(reachOf(body.footprint)),
      wide_(wide),
      cache_(cacheSpacing(body.footprint), reachOf(body.footprint) + wide + 0.5) {}

double ClearanceAlong::leastOf(double gapNow) const {
  if (gapNow >= margin_) {
    return margin_;
  }
  return std::max(gapNow - kSlack, std::min(gapNow, kHardShare * margin_));
}

bool ClearanceAlong::isKnown(const Observation& observation, const Vec2& point) const {
  if (observation.navigation->clearance(point) < kOwnPoint &&
      observation.obstacles->clearance(point, 2.0 * kOwnPoint) < kOwnPoint) {
    return true;
  }
  const auto isOfBody = [&point](const TrackedBody& body) {
    const double within = body.radius + kOwnPoint;
    return (body.position - point).squaredNorm() < within * within;
  };
  return std::any_of(observation.bodies.begin(), observation.bodies.end(), isOfBody);
}

void ClearanceAlong::takePoints(const Observation& observation) {
  if (observation.scan == nullptr) {
    points_.clear();
    scanTime_ = kNeverScanned;
    return;
  }
  const LaserScan& scan = *observation.scan;
  if (scan.time == scanTime_) {
    return;
  }
  scanTime_ = scan.time;
  points_.clear();
  points_.reserve(scan.distances.size());
  double angle = scan.sensor.heading + scan.angleMin;
  for (const double distance : scan.distances) {
    if (distance < std::min(scan.range, kPointsFrom)) {
      const Vec2 point = scan.sensor.position + distance * base::directionOf(angle);
      const bool isNew =
          points_.empty() || (points_.back() - point).squaredNorm() > kPointSpan * kPointSpan;
      if (isNew && !isKnown(observation, point)) {
        points_.push_back(point);
      }
    }
    angle += scan.perBeam;
  }
}

void ClearanceAlong::takeBodies(const Observation& observation, double speed, double time) {
  near_.clear();
  near_.reserve(observation.bodies.size());
  gapAhead_ = std::numeric_limits<double>::infinity();
  const Vec2 ahead = observation.pose.direction();
  for (const TrackedBody& other : observation.bodies) {
    Near body{other.position, other.velocity, other.radius, other.velocity.norm(), 0.0, 0.0};
    const Vec2 towards = other.position - observation.pose.position;
    const double far = towards.norm() - other.radius - reach_;
    if (far > wide_ + (speed + body.speed) * time) {
      continue;
    }
    const double gap = gapTo(body, observation.pose, 0.0);
    // Who has come nearer than that counts all along, also when they part: `canStop` then allows
    // what does not bring the robot nearer by its own motion.
    body.gapNow = gap;
    body.least = std::max(leastOf(gap), kHardShare * margin_);
    near_.push_back(body);
    if (ahead.dot(towards) > 0.0) {
      gapAhead_ = std::min(gapAhead_, gap);
    }
  }
}

void ClearanceAlong::observe(const Observation& observation, double margin, double speed,
                             double time) {
  margin_ = margin;
  obstacles_ = observation.obstacles;
  takePoints(observation);
  cache_.update(observation, points_, scanTime_);
  takeBodies(observation, speed, time);
  wallLeast_ = leastOf(gapToWall(observation.pose));
}

double ClearanceAlong::gapTo(const Near& body, const Pose2& pose, double time) const {
  const Vec2 centre = body.position + time * body.velocity;
  const double gap = (centre - pose.position).norm() - body.radius - reach_;
  if (body_.footprint.isDisc() || gap >= margin_) {
    return gap;
  }
  return gapToDisc(body_.footprint, pose, centre, body.radius);
}

double ClearanceAlong::gapToWall(const Pose2& pose) {
  const double gap = cache_.distanceAt(pose.position) - reach_;
  if (body_.footprint.isDisc() || gap >= margin_) {
    return gap;
  }
  double exact = gapToWalls(body_.footprint, pose, *obstacles_, margin_);
  for (const Vec2& point : points_) {
    if ((point - pose.position).norm() < reach_ + exact) {
      exact = std::min(exact, gapToDisc(body_.footprint, pose, point, 0.0));
    }
  }
  return exact;
}

void ClearanceAlong::followWalls(const Way& way, Found& found) {
  const auto count = static_cast<int>(way.poses.size());
  const double perStep = std::max(way.speed * way.step, 1e-9);
  int i = 1;
  while (i < count) {
    const double gap = gapToWall(way.poses[static_cast<std::size_t>(i)]);
    found.gap = std::min(found.gap, gap);
    if (gap < wallLeast_) {
      found.wallStep = i;
      return;
    }
    i += posesToSkip(gap, wide_, perStep);
  }
}

void ClearanceAlong::followBody(const Way& way, const Near& body, Found& found) const {
  const int count = std::min(found.wallStep, found.bodyStep);
  const double perStep = std::max((way.speed + body.speed) * way.step, 1e-9);
  int i = posesToSkip(body.gapNow, wide_, perStep);
  while (i < count) {
    const double gap = gapTo(body, way.poses[static_cast<std::size_t>(i)], i * way.step);
    found.gap = std::min(found.gap, gap);
    if (gap < body.least) {
      found.bodyStep = i;
      return;
    }
    i += posesToSkip(gap, wide_, perStep);
  }
}

ClearanceAlong::Found ClearanceAlong::along(const Way& way) {
  const auto count = static_cast<int>(way.poses.size());
  Found found{count, count, wide_};
  followWalls(way, found);
  for (const Near& body : near_) {
    followBody(way, body, found);
  }
  return found;
}

bool ClearanceAlong::isHitWhile(const Pose2& before, const Pose2& pose, double time) const {
  return std::any_of(near_.begin(), near_.end(), [&](const Near& body) {
    const double gap = gapTo(body, pose, time);
    return gap < body.least && gapTo(body, before, time) > gap + 1e-9;
  });
}

bool ClearanceAlong::canStop(const Way& way, const Found& found, double hold,
                             double stopTime) const {
  const auto count = static_cast<int>(way.poses.size());
  if (found.wallStep < count && (found.wallStep - 1) * way.step < hold + 0.5 * stopTime) {
    return false;
  }
  if (found.bodyStep >= count) {
    return true;
  }
  const double end = hold + stopTime;
  const int steps = static_cast<int>(std::ceil(end / way.step));
  Pose2 before = way.poses.front();
  for (int i = 1; i <= steps; ++i) {
    const double time = std::min(i * way.step, end);
    const double braking = std::max(0.0, time - hold);
    // How far along the way: time that full speed would have taken.
    const double lost = stopTime > 0.0 ? 0.5 * braking * braking / stopTime : braking;
    const Pose2 pose = poseAfter(way, time - lost);
    if (isHitWhile(before, pose, time)) {
      return false;
    }
    before = pose;
  }
  return true;
}

}  // namespace sim2d
