#include "sim2d/nav/RobotRoute.h"

#include "sim2d/map/Outlines.h"

namespace sim2d {
namespace {

constexpr double kOffPath = 1.0;       // [m]
constexpr double kBetweenPlans = 1.0;  // [s]

}  // namespace

bool RobotRoute::needsPlan(const Observation& observation, double sight) const {
  if (version_ != observation.navigation->version() || observation.goal != goal_) {
    return true;
  }
  if (observation.time - plannedAt_ < kBetweenPlans) {
    return false;
  }
  const Vec2& position = observation.pose.position;
  return points_.empty() || distanceFrom(position) > kOffPath ||
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
  plannedAt_ = observation.time;
}

RobotRoute::Foot RobotRoute::footOf(const Vec2& position) const {
  Foot best{0, points_.front()};
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
  const Foot foot = footOf(position);
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

double RobotRoute::restLength(const Vec2& position) const {
  return lengthOfWay(position, points_, footOf(position).leg + 1);
}

double RobotRoute::distanceFrom(const Vec2& position) const {
  return (footOf(position).point - position).norm();
}

}  // namespace sim2d
