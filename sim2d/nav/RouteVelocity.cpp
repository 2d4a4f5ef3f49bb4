#include "sim2d/nav/RouteVelocity.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sim2d {
namespace {

constexpr double kGoalBraking = 0.8;  // share of the deceleration with which it comes to the goal

constexpr double kLeastProgress = 0.1;  // [m]; less is none
constexpr double kCompany = 2.0;        // [m]; people nearer than that may be why there is none
constexpr double kFirstPatience = 4.0;  // [s]
constexpr double kMostPatience = 64.0;  // [s]
constexpr double kDetourTime = 0.75;    // of the patience
constexpr double kDetourTurn = 1.9;     // [rad]; more than a right angle: out of a pocket
constexpr double kPassed = 1.0;         // [m] of progress after which the right counts again

bool hasCompany(const Observation& observation) {
  return std::any_of(observation.bodies.begin(), observation.bodies.end(),
                     [&](const TrackedBody& body) {
                       return (body.position - observation.pose.position).norm() < kCompany;
                     });
}

}  // namespace

Vec2 velocityAlong(const RobotRoute& route, const Observation& observation, double lookahead,
                   double speed, double maxAcc) {
  const Vec2& position = observation.pose.position;
  const double rest = route.restLength(position);
  const Vec2 way = route.pointAhead(position, lookahead) - position;
  const double length = way.norm();
  if (rest < 0.5 * observation.goalRadius || length <= 0.0) {
    return Vec2::Zero();
  }
  return std::min(speed, std::sqrt(2.0 * kGoalBraking * maxAcc * rest)) / length * way;
}

void PassingSide::noteProgress(const Observation& observation, double restLength) {
  if (best_ < 0.0 || observation.goal != goal_) {
    goal_ = observation.goal;
    best_ = restLength;
    bestTime_ = observation.time;
    patience_ = kFirstPatience;
    side_ = -1.0;
  }
  if (restLength < best_ - kLeastProgress) {
    best_ = restLength;
    bestTime_ = observation.time;
  }
  if (!hasCompany(observation)) {
    bestTime_ = observation.time;
  }
  if (patience_ > kFirstPatience && best_ < atChange_ - kPassed) {
    patience_ = kFirstPatience;
    side_ = -1.0;
  }
}

void PassingSide::update(const Observation& observation, double restLength) {
  noteProgress(observation, restLength);
  const double time = observation.time;
  if (time - bestTime_ >= patience_) {
    side_ = -side_;
    hasChanged_ = true;
    detourUntil_ = time + kDetourTime * patience_;
    patience_ = std::min(2.0 * patience_, kMostPatience);
    best_ = restLength;
    atChange_ = restLength;
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

}  // namespace sim2d
