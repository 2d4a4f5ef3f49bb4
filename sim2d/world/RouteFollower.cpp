#include "sim2d/world/RouteFollower.h"

#include <algorithm>

#include "sim2d/map/Outlines.h"

namespace sim2d {
namespace {

constexpr double kReplanDistance = 0.25;          // [m]; a larger displacement triggers replanning
constexpr double kWayPointTolerance = 0.2;        // [m]; way points within this distance are passed
constexpr double kMinTurn = 0.2;                  // minimum difference of unit vectors
constexpr double kLostTime = 1.0;                 // [s] without a clear line to the next way point
constexpr double kVisibilityCheckInterval = 0.2;  // [s] between visibility tests
constexpr double kPersonReplanInterval = 1.0;     // [s]
constexpr double kStuckTime = 4.0;                // [s] without progress
constexpr double kProgress = 0.1;                 // [m]
constexpr double kWalkingSpeed = 0.05;            // [m/s]; slower people cannot be stuck

constexpr double kMaxWait = 10.0;        // [s]; nobody waits longer before taking another way
constexpr double kMinSearchPause = 1.0;  // [s] between searches for another path
constexpr double kMaxSearchPause = 8.0;  // same, when there is none

constexpr double kPassingClearance = 0.15;  // [m], clearance when passing a body
constexpr double kLookaheadDistance = 2.5;  // [m]; bodies farther ahead are ignored
constexpr double kOverlapTolerance =
    0.1;  // [m]; accepted overlap with a line, since bodies slide along each other

/// True if the line passes the body or leads away from it.
bool isFree(const StandingBody& body, double radius, const Vec2& from, const Vec2& to) {
  const Vec2 towards = body.position - from;
  const double least = std::min(body.radius + radius, towards.norm()) - kOverlapTolerance;
  return distanceToSegment({from, to}, body.position) >= least;
}

const StandingBody* firstBlockingBody(const std::vector<StandingBody>& standing, double radius,
                                      const Vec2& from, const Vec2& next) {
  const Vec2 ahead = next - from;
  const Vec2 end = from + ahead * std::min(1.0, kLookaheadDistance / std::max(ahead.norm(), 1e-9));
  const StandingBody* first = nullptr;
  for (const StandingBody& body : standing) {
    const Vec2 towards = body.position - from;
    const double room = body.radius + radius + kPassingClearance;
    const bool isInTheWay =
        towards.dot(ahead) > 0.0 && distanceToSegment({from, end}, body.position) < room;
    if (isInTheWay && (!first || towards.norm() < (first->position - from).norm())) {
      first = &body;
    }
  }
  return first;
}

}  // namespace

std::optional<Vec2> passingPoint(const std::vector<StandingBody>& standing, double radius,
                                 const Vec2& from, const Vec2& next,
                                 const NavigationMap& navigation) {
  const StandingBody* const body = firstBlockingBody(standing, radius, from, next);
  if (!body) {
    return std::nullopt;
  }
  const double back = base::headingOf(from - body->position);
  const double distance = body->radius + radius + kPassingClearance;
  std::optional<Vec2> best;
  double shortest = 1e300;
  for (const double share : {1.0 / 3.0, 0.5, 2.0 / 3.0, -1.0 / 3.0, -0.5, -2.0 / 3.0}) {
    const double heading = base::wrapToPi(back + share * base::kPi);
    const Vec2 place = body->position + distance * base::directionOf(heading);
    const double length = (place - from).norm() + (next - place).norm();
    const bool isWay = std::all_of(standing.begin(), standing.end(), [&](const StandingBody& each) {
      return isFree(each, radius, from, place);
    });
    if (length < shortest && isWay && navigation.isClear(radius, from, place) &&
        navigation.isReachable(radius, place, next)) {
      shortest = length;
      best = place;
    }
  }
  return best;
}

RouteFollower::Guidance RouteFollower::straight(const Request& request) {
  Guidance leg;
  const Vec2 toTarget = request.target.position - request.position;
  if (toTarget.norm() > request.target.radius) {
    leg.direction = toTarget.normalized();
  }
  return leg;
}

RouteFollower::Guidance RouteFollower::follow(const Request& request,
                                              const NavigationMap& navigation,
                                              const Obstacles& obstacles) {
  Guidance leg;
  const Vec2 toTarget = request.target.position - request.position;
  if (toTarget.norm() <= request.target.radius) {
    lastProgressTime_ = request.time;
    return leg;
  }
  const bool isForThisTarget = version_ == navigation.version() &&
                               (request.target.position - target_).norm() <= kReplanDistance;
  if (!isForThisTarget) {
    blockedAreas_.clear();
    searchPause_ = 0.0;
    leg.replanned = version_ >= 0 && version_ != navigation.version();
    plan(request, navigation);
    lastClearTime_ = lastProgressTime_ = request.time;
    minRemaining_ = 1e300;
  } else if (!path_.empty() && request.target.position != target_) {
    const double before = polylineLength(request.position, path_, next_);
    path_.back() = request.target.position;
    target_ = request.target.position;
    minRemaining_ += polylineLength(request.position, path_, next_) -
                     before;  // progress is what the person walks
  }
  const bool looks = request.time - lastCheckTime_ >= kVisibilityCheckInterval - 1e-9;
  lastCheckTime_ = looks ? request.time : lastCheckTime_;
  passWayPoints(request, navigation, looks);
  leg.stuck = isStuck(request);
  if (leg.stuck || (looks && isLost(request, navigation, obstacles))) {
    plan(request, navigation);
    passWayPoints(request, navigation, true);
    leg.replanned = true;
  }
  if (!path_.empty()) {
    cornerOffset_ = looks ? cornerOffset(request, navigation) : cornerOffset_;
    const Vec2 toNext = path_[next_] + cornerOffset_ - request.position;
    leg.direction = toNext.norm() > 1e-9 ? toNext.normalized() : toTarget.normalized();
  }
  return leg;
}

void RouteFollower::plan(const Request& request, const NavigationMap& navigation) {
  path_.clear();
  if (!blockedAreas_.empty()) {
    path_ = navigation.planAround(request.radius, request.position, request.target.position,
                                  blockedAreas_);
  }
  if (path_.empty()) {
    blockedAreas_.clear();
    path_ = navigation.plan(request.radius, request.position, request.target.position);
  }
  if (!path_.empty()) {
    path_.back() = request.target.position;
  }
  next_ = path_.size() > 1 ? 1 : 0;
  target_ = request.target.position;
  version_ = navigation.version();
  planTime_ = lastClearTime_ = request.time;
  cornerOffset_ = Vec2::Zero();
  isDetour_ = false;
}

std::vector<Vec2> RouteFollower::rest() const {
  std::vector<Vec2> rest(path_.begin() + static_cast<std::ptrdiff_t>(next_), path_.end());
  if (!rest.empty()) {
    rest.front() += cornerOffset_;
  }
  return rest;
}

bool RouteFollower::tryAlternativePath(const Request& request,
                                       const std::vector<std::vector<Vec2>>& closed, double waited,
                                       const NavigationMap& navigation) {
  if (path_.empty() || request.time - lastSearchTime_ < searchPause_) {
    return false;
  }
  lastSearchTime_ = request.time;
  std::vector<Vec2> way =
      navigation.planAround(request.radius, request.position, request.target.position, closed);
  if (way.empty()) {
    searchPause_ = std::clamp(2.0 * searchPause_, kMinSearchPause, kMaxSearchPause);
    return false;
  }
  searchPause_ = kMinSearchPause;
  const double longer = polylineLength(way) - polylineLength(request.position, path_, next_);
  if (waited < std::min(longer / std::max(request.speed, kWalkingSpeed), kMaxWait)) {
    return false;
  }
  path_ = std::move(way);
  path_.back() = request.target.position;
  next_ = path_.size() > 1 ? 1 : 0;
  blockedAreas_ = closed;
  planTime_ = lastClearTime_ = lastProgressTime_ = request.time;
  minRemaining_ = 1e300;
  cornerOffset_ = Vec2::Zero();
  isDetour_ = false;
  return true;
}

/// True if the line does not enter a closed polygon.
bool RouteFollower::isOpen(const Vec2& from, const Vec2& to) const {
  return std::none_of(
      blockedAreas_.begin(), blockedAreas_.end(),
      [&](const std::vector<Vec2>& polygon) { return entryPoint(polygon, from, to).has_value(); });
}

void RouteFollower::insertDetour(const Request& request, const std::vector<StandingBody>& standing,
                                 const NavigationMap& navigation) {
  if (path_.empty()) {
    return;
  }
  const std::optional<Vec2> place =
      passingPoint(standing, request.radius, request.position, path_[next_], navigation);
  if (place) {
    path_.insert(path_.begin() + static_cast<std::ptrdiff_t>(next_), *place);
    isDetour_ = true;
  }
}

/// Offset away from the inside of the turn: the desired spread, or half or a quarter of it.
Vec2 RouteFollower::cornerOffset(const Request& request, const NavigationMap& navigation) const {
  if (request.spread <= 0.0 || isDetour_ || next_ == 0 || next_ + 1 >= path_.size()) {
    return Vec2::Zero();
  }
  const Vec2& corner = path_[next_];
  const Vec2 outside =
      (corner - path_[next_ - 1]).normalized() - (path_[next_ + 1] - corner).normalized();
  const double turn = outside.norm();
  if (turn < kMinTurn) {
    return Vec2::Zero();
  }
  for (const double share : {1.0, 0.5, 0.25}) {
    Vec2 beside = share * request.spread / turn * outside;
    const Vec2 place = corner + beside;
    if (navigation.isClear(request.radius, corner, place) &&
        navigation.isClear(request.radius, request.position, place)) {
      return beside;
    }
  }
  return Vec2::Zero();
}

void RouteFollower::passWayPoints(const Request& request, const NavigationMap& navigation,
                                  bool looks) {
  const auto hasPassed = [&] {
    return (path_[next_] - request.position).norm() < kWayPointTolerance ||
           (path_[next_] + cornerOffset_ - request.position).norm() < kWayPointTolerance;
  };
  while (next_ + 1 < path_.size() &&
         (hasPassed() || (looks && !isDetour_ &&
                          navigation.isClear(request.radius, request.position, path_[next_ + 1]) &&
                          isOpen(request.position, path_[next_ + 1])))) {
    ++next_;
    isDetour_ = false;
    cornerOffset_ = Vec2::Zero();
  }
}

bool RouteFollower::isLost(const Request& request, const NavigationMap& navigation,
                           const Obstacles& obstacles) {
  if (path_.empty()) {
    return request.time - planTime_ >= kStuckTime;  // a path may have opened
  }
  if (navigation.isClear(request.radius, request.position, path_[next_])) {
    lastClearTime_ = request.time;
    return false;
  }
  if (request.time - planTime_ < kPersonReplanInterval) {
    return false;
  }
  return request.time - lastClearTime_ >= kLostTime ||
         !obstacles.isVisible(request.position, path_[next_]);
}

bool RouteFollower::isStuck(const Request& request) {
  const double rest = polylineLength(request.position, path_, next_);
  if (rest < minRemaining_ - kProgress || request.speed < kWalkingSpeed) {
    minRemaining_ = std::min(minRemaining_, rest);
    lastProgressTime_ = request.time;
    return false;
  }
  if (request.time - lastProgressTime_ < kStuckTime) {
    return false;
  }
  lastProgressTime_ = request.time;
  minRemaining_ = 1e300;
  return true;
}

}  // namespace sim2d
