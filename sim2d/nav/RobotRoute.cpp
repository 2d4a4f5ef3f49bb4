#include "sim2d/nav/RobotRoute.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim2d/map/Outlines.h"

namespace sim2d {
namespace {

constexpr double kMaxDeviation = 1.0;    // [m]
constexpr double kReplanInterval = 1.0;  // [s]

}  // namespace

bool RobotRoute::needsPlan(const Observation& observation, double sight) const {
  if (version_ != observation.navigation->version() || observation.goal != goal_) {
    return true;
  }
  if (observation.time - planTime_ < kReplanInterval) {
    return false;
  }
  const Vec2& position = observation.pose.position;
  return points_.empty() || distanceFrom(position) > kMaxDeviation ||
         !observation.obstacles->isVisible(position, pointAhead(position, sight));
}

void RobotRoute::update(const Observation& observation, double bodyRadius, double sight) {
  if (!needsPlan(observation, sight)) {
    return;
  }
  replanned_ = version_ >= 0 && observation.goal == goal_;
  points_ = observation.navigation->plan(bodyRadius, observation.pose.position, observation.goal);
  goal_ = observation.goal;
  version_ = observation.navigation->version();
  planTime_ = observation.time;
}

RobotRoute::Projection RobotRoute::projectionOf(const Vec2& position) const {
  Projection best{0, points_.front()};
  double least = (points_.front() - position).norm();
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const Vec2 foot = closestOnSegment({points_[i], points_[i + 1]}, position);
    const double distance = (foot - position).norm();
    if (distance <= least) {
      least = distance;
      best = {i, foot};
    }
  }
  return best;
}

Vec2 RobotRoute::pointAhead(const Vec2& position, double distance) const {
  const Projection foot = projectionOf(position);
  double rest = distance;
  Vec2 from = foot.point;
  for (std::size_t i = foot.leg + 1; i < points_.size(); ++i) {
    const double length = (points_[i] - from).norm();
    if (length >= rest && length > 0.0) {
      return from + rest / length * (points_[i] - from);
    }
    rest -= length;
    from = points_[i];
  }
  return points_.back();
}

double RobotRoute::remainingLength(const Vec2& position) const {
  return polylineLength(position, points_, projectionOf(position).leg + 1);
}

double RobotRoute::distanceFrom(const Vec2& position) const {
  return (projectionOf(position).point - position).norm();
}

namespace {

constexpr double kGoalBraking = 0.8;  // fraction of the maximum deceleration

constexpr double kMinProgress = 0.1;     // [m]; smaller changes are not progress
constexpr double kNearbyDistance = 2.0;  // [m]; people within this distance may block the robot
constexpr double kFirstPatience = 4.0;   // [s]
constexpr double kMaxPatience = 64.0;    // [s]
constexpr double kDetourTime = 0.75;     // fraction of the patience
constexpr double kDetourTurn = 1.9;      // [rad]; above 90 degrees, to leave a dead end
constexpr double kProgressToReset =
    1.0;  // [m] of progress after which the right side is used again

bool hasPeopleNearby(const Observation& observation) {
  return std::any_of(observation.bodies.begin(), observation.bodies.end(),
                     [&](const TrackedBody& body) {
                       return (body.position - observation.pose.position).norm() < kNearbyDistance;
                     });
}

}  // namespace

Vec2 routeVelocity(const RobotRoute& route, const Observation& observation, double lookahead,
                   double speed, double maxAcc) {
  const Vec2& position = observation.pose.position;
  const double rest = route.remainingLength(position);
  const Vec2 way = route.pointAhead(position, lookahead) - position;
  const double length = way.norm();
  if (rest < 0.5 * observation.goalRadius || length <= 0.0) {
    return Vec2::Zero();
  }
  return std::min(speed, std::sqrt(2.0 * kGoalBraking * maxAcc * rest)) / length * way;
}

void PassingSide::recordProgress(const Observation& observation, double remainingLength) {
  if (minRemaining_ < 0.0 || observation.goal != goal_) {
    goal_ = observation.goal;
    minRemaining_ = remainingLength;
    bestTime_ = observation.time;
    patience_ = kFirstPatience;
    side_ = -1.0;
  }
  if (remainingLength < minRemaining_ - kMinProgress) {
    minRemaining_ = remainingLength;
    bestTime_ = observation.time;
  }
  if (!hasPeopleNearby(observation)) {
    bestTime_ = observation.time;
  }
  if (patience_ > kFirstPatience && minRemaining_ < remainingAtChange_ - kProgressToReset) {
    patience_ = kFirstPatience;
    side_ = -1.0;
  }
}

void PassingSide::update(const Observation& observation, double remainingLength) {
  recordProgress(observation, remainingLength);
  const double time = observation.time;
  if (time - bestTime_ >= patience_) {
    side_ = -side_;
    hasChanged_ = true;
    detourUntil_ = time + kDetourTime * patience_;
    patience_ = std::min(2.0 * patience_, kMaxPatience);
    minRemaining_ = remainingLength;
    remainingAtChange_ = remainingLength;
    bestTime_ = time;
  }
  isOnDetour_ = patience_ > kFirstPatience && time < detourUntil_;
}

double PassingSide::detour() const {
  return isOnDetour_ ? side_ * kDetourTurn : 0.0;
}

bool PassingSide::takeChanged() {
  return std::exchange(hasChanged_, false);
}

namespace {

constexpr double kStuckProgress = 0.1;    // [m]; smaller changes are not progress
constexpr double kProgressToRelax = 0.5;  // [m] of progress that restores the full margin
constexpr double kStuckJump = 0.5;        // [m] per step; faster than any robot drives
constexpr double kMaxRecoveryTime = 2.0;  // [s]
constexpr double kMinMarginScale = 0.2;

}  // namespace

void StuckDetector::update(double time, const Vec2& position, const Vec2& goal, double rest) {
  hasJustStarted_ = false;
  if (isFirst_ || goal != goal_) {
    isFirst_ = false;
    isRecovering_ = false;
    tries_ = 0;
    share_ = 1.0;
    since_ = time;
    minRemaining_ = rest;
    stuckRemaining_ = rest;
    remaining_ = rest;
    goal_ = goal;
    return;
  }
  if (isRecovering_) {
    if ((position - startPosition_).norm() >= distance_ || time - since_ > kMaxRecoveryTime) {
      isRecovering_ = false;
      since_ = time;
      minRemaining_ = rest;
      remaining_ = rest;
    }
    return;
  }
  const double jump = rest - remaining_;
  remaining_ = rest;
  if (jump > kStuckJump) {  // not driven: the route itself has changed
    minRemaining_ += jump;
    stuckRemaining_ += jump;
  }
  if (rest < minRemaining_ - kStuckProgress) {
    minRemaining_ = rest;
    since_ = time;
  }
  if (rest < stuckRemaining_ - kProgressToRelax) {
    tries_ = 0;
    share_ = 1.0;
  }
  if (time - since_ > patience_) {
    isRecovering_ = true;
    hasJustStarted_ = true;
    ++tries_;
    share_ = std::max(kMinMarginScale, 0.5 * share_);
    stuckRemaining_ = tries_ == 1 ? rest : std::min(stuckRemaining_, rest);
    since_ = time;
    startPosition_ = position;
  }
}

}  // namespace sim2d
