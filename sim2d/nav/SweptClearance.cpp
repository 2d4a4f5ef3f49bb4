#include "sim2d/nav/SweptClearance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "sim2d/base/Math.h"
#include "sim2d/nav/FootprintGap.h"

namespace sim2d {
namespace {

constexpr int kCacheSide = 128;  // nodes per side before slots are reused; a power of two

}  // namespace

ClearanceCache::ClearanceCache(double spacing, double limit)
    : spacing_(spacing),
      limit_(limit),
      places_(static_cast<std::size_t>(kCacheSide) * static_cast<std::size_t>(kCacheSide)) {}

void ClearanceCache::update(const Observation& observation, const std::vector<Vec2>& points,
                            double pointsTime) {
  const int version = observation.navigation->version();
  if (version != version_ || observation.obstacles != obstacles_ ||
      observation.navigation != navigation_) {
    ++wallsRevision_;
  }
  if (pointsTime != pointsTime_ || &points != points_) {
    ++pointsRevision_;
  }
  version_ = version;
  obstacles_ = observation.obstacles;
  navigation_ = observation.navigation;
  points_ = &points;
  pointsTime_ = pointsTime;
}

double ClearanceCache::squaredToWalls(const Vec2& place) const {
  if (navigation_->clearance(place) >= limit_) {
    return limit_ * limit_;
  }
  const double distance = std::max(0.0, obstacles_->clearance(place, limit_));
  return distance * distance;
}

double ClearanceCache::squaredToPoints(const Vec2& place) const {
  double least = limit_ * limit_;
  for (const Vec2& point : *points_) {
    least = std::min(least, (point - place).squaredNorm());
  }
  return least;
}

double ClearanceCache::squaredAt(int column, int row) {
  constexpr int kLowBits = kCacheSide - 1;
  Place& place = places_[static_cast<std::size_t>(row & kLowBits) * kCacheSide +
                         static_cast<std::size_t>(column & kLowBits)];
  if (place.column != column || place.row != row) {
    place = {column, row, 0, 0, 0.0, 0.0};
  }
  if (place.wallsRevision != wallsRevision_) {
    place.wallsRevision = wallsRevision_;
    place.toWalls = squaredToWalls(spacing_ * Vec2(column, row));
  }
  if (points_->empty()) {
    return place.toWalls;
  }
  if (place.pointsRevision != pointsRevision_) {
    place.pointsRevision = pointsRevision_;
    place.toPoints = squaredToPoints(spacing_ * Vec2(column, row));
  }
  return std::min(place.toWalls, place.toPoints);
}

double ClearanceCache::distanceAt(const Vec2& place) {
  const double x = place.x() / spacing_;
  const double y = place.y() / spacing_;
  const double left = std::floor(x);
  const double bottom = std::floor(y);
  const auto column = static_cast<int>(left);
  const auto row = static_cast<int>(bottom);
  const double s = x - left;
  const double t = y - bottom;
  const double mean =
      (1.0 - t) * ((1.0 - s) * squaredAt(column, row) + s * squaredAt(column + 1, row)) +
      t * ((1.0 - s) * squaredAt(column, row + 1) + s * squaredAt(column + 1, row + 1));
  const double excess = spacing_ * spacing_ * (s * (1.0 - s) + t * (1.0 - t));
  return std::sqrt(std::max(0.0, mean - excess));
}

namespace {

constexpr double kSlack = 0.01;           // [m], tolerance for gaps below the margin
constexpr double kHardMarginRatio = 0.3;  // ratio of the margin that always applies
constexpr double kKnownPointDistance =
    0.15;  // [m]; scan points nearer to a known wall or person are ignored
constexpr double kPointSpacing = 0.05;  // [m]; minimum spacing of scan points
constexpr double kPointRange = 5.0;     // [m]; scan points farther away are ignored

constexpr double kNeverScanned = -1e9;

double cacheSpacing(const Footprint& footprint) {
  return std::clamp(0.4 * inscribedRadius(footprint), 0.03, 0.1);
}

/// Interpolated pose of the trajectory at `time`.
Pose2 poseAt(const SweptClearance::Trajectory& way, double time) {
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

SweptClearance::SweptClearance(const RobotBody& body, double wide)
    : body_(body),
      reach_(circumscribedRadius(body.footprint)),
      maxGap_(wide),
      cache_(cacheSpacing(body.footprint), circumscribedRadius(body.footprint) + wide + 0.5) {}

double SweptClearance::contactGap(double gapNow) const {
  if (gapNow >= margin_) {
    return margin_;
  }
  return std::max(gapNow - kSlack, std::min(gapNow, kHardMarginRatio * margin_));
}

bool SweptClearance::isExplained(const Observation& observation, const Vec2& point) const {
  if (observation.navigation->clearance(point) < kKnownPointDistance &&
      observation.obstacles->clearance(point, 2.0 * kKnownPointDistance) < kKnownPointDistance) {
    return true;
  }
  const auto isOfBody = [&point](const TrackedBody& body) {
    const double within = body.radius + kKnownPointDistance;
    return (body.position - point).squaredNorm() < within * within;
  };
  return std::any_of(observation.bodies.begin(), observation.bodies.end(), isOfBody);
}

void SweptClearance::updatePoints(const Observation& observation) {
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
    if (distance < std::min(scan.range, kPointRange)) {
      const Vec2 point = scan.sensor.position + distance * base::directionOf(angle);
      const bool isNew =
          points_.empty() || (points_.back() - point).squaredNorm() > kPointSpacing * kPointSpacing;
      if (isNew && !isExplained(observation, point)) {
        points_.push_back(point);
      }
    }
    angle += scan.angleIncrement;
  }
}

void SweptClearance::updateBodies(const Observation& observation, double speed, double time) {
  near_.clear();
  near_.reserve(observation.bodies.size());
  gapAhead_ = std::numeric_limits<double>::infinity();
  const Vec2 ahead = observation.pose.direction();
  for (const TrackedBody& other : observation.bodies) {
    NearbyBody body{other.position, other.velocity, other.radius, other.velocity.norm(), 0.0, 0.0};
    const Vec2 towards = other.position - observation.pose.position;
    const double far = towards.norm() - other.radius - reach_;
    if (far > maxGap_ + (speed + body.speed) * time) {
      continue;
    }
    const double gap = gapTo(body, observation.pose, 0.0);
    // For a body that is already nearer, the minimum applies along the whole trajectory, even while
    // the gap grows; `canStop` then allows motions in which the robot itself does not come nearer.
    body.gapNow = gap;
    body.least = std::max(contactGap(gap), kHardMarginRatio * margin_);
    near_.push_back(body);
    if (ahead.dot(towards) > 0.0) {
      gapAhead_ = std::min(gapAhead_, gap);
    }
  }
}

void SweptClearance::observe(const Observation& observation, double margin, double speed,
                             double time) {
  margin_ = margin;
  obstacles_ = observation.obstacles;
  updatePoints(observation);
  cache_.update(observation, points_, scanTime_);
  updateBodies(observation, speed, time);
  wallContactGap_ = contactGap(gapToWall(observation.pose));
}

double SweptClearance::gapTo(const NearbyBody& body, const Pose2& pose, double time) const {
  const Vec2 centre = body.position + time * body.velocity;
  const double gap = (centre - pose.position).norm() - body.radius - reach_;
  if (body_.footprint.isDisc() || gap >= margin_) {
    return gap;
  }
  return gapToDisc(body_.footprint, pose, centre, body.radius);
}

double SweptClearance::gapToWall(const Pose2& pose) {
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

void SweptClearance::checkWalls(const Trajectory& way, Evaluation& found) {
  const auto count = static_cast<int>(way.poses.size());
  const double perStep = std::max(way.speed * way.step, 1e-9);
  int i = 1;
  while (i < count) {
    const double gap = gapToWall(way.poses[static_cast<std::size_t>(i)]);
    found.gap = std::min(found.gap, gap);
    if (gap < wallContactGap_) {
      found.wallStep = i;
      return;
    }
    i += posesToSkip(gap, maxGap_, perStep);
  }
}

void SweptClearance::checkBody(const Trajectory& way, const NearbyBody& body,
                               Evaluation& found) const {
  const int count = std::min(found.wallStep, found.bodyStep);
  const double perStep = std::max((way.speed + body.speed) * way.step, 1e-9);
  int i = posesToSkip(body.gapNow, maxGap_, perStep);
  while (i < count) {
    const double gap = gapTo(body, way.poses[static_cast<std::size_t>(i)], i * way.step);
    found.gap = std::min(found.gap, gap);
    if (gap < body.least) {
      found.bodyStep = i;
      return;
    }
    i += posesToSkip(gap, maxGap_, perStep);
  }
}

SweptClearance::Evaluation SweptClearance::along(const Trajectory& way) {
  const auto count = static_cast<int>(way.poses.size());
  Evaluation found{count, count, maxGap_};
  checkWalls(way, found);
  for (const NearbyBody& body : near_) {
    checkBody(way, body, found);
  }
  return found;
}

bool SweptClearance::isHitAt(const Pose2& before, const Pose2& pose, double time) const {
  return std::any_of(near_.begin(), near_.end(), [&](const NearbyBody& body) {
    const double gap = gapTo(body, pose, time);
    return gap < body.least && gapTo(body, before, time) > gap + 1e-9;
  });
}

bool SweptClearance::canStop(const Trajectory& way, const Evaluation& found, double hold,
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
    // Distance along the trajectory, as the time needed at full speed.
    const double lost = stopTime > 0.0 ? 0.5 * braking * braking / stopTime : braking;
    const Pose2 pose = poseAt(way, time - lost);
    if (isHitAt(before, pose, time)) {
      return false;
    }
    before = pose;
  }
  return true;
}

}  // namespace sim2d
