#include "sim2d/world/RouteFollower.h"

#include <algorithm>

#include "sim2d/map/ConvexPolygon.h"
#include "sim2d/map/Outlines.h"

namespace sim2d {
namespace {

constexpr double kTargetMoved = 0.25;  // [m]; farther, and the path is planned anew
constexpr double kPassed = 0.2;        // [m]; a way point so near is passed
constexpr double kSharpTurn = 0.2;     // difference of two unit vectors, from which on it is a turn
constexpr double kLostAfter = 1.0;     // [s] without a clear line to the next way point
constexpr double kBetweenLooks = 0.2;  // [s]; lines are tested so often
constexpr double kBetweenPlans = 1.0;  // [s]
constexpr double kStuckAfter = 4.0;    // [s] without progress
constexpr double kProgress = 0.1;      // [m]
constexpr double kWalkingSpeed = 0.05;  // [m/s]; slower people cannot be stuck

constexpr double kLongestWait = 10.0;  // [s]; nobody waits longer before taking another way
constexpr double kFirstPause = 1.0;    // [s] between searches for one
constexpr double kLongestPause = 8.0;  // idem, when there is none

constexpr double kRoom = 0.15;       // [m] between the bodies when they pass
constexpr double kSightAhead = 2.5;  // [m]; who stands farther away does not count yet
constexpr double kTouch =
    0.1;  // [m]; bodies slide along each other, so a line may lead so much nearer

/// The line leads past the body, or away from it.
bool isFree(const StandingBody& body, double radius, const Vec2& from, const Vec2& to) {
  const Vec2 towards = body.position - from;
  const double least = std::min(body.radius + radius, towards.norm()) - kTouch;
  return distanceToSegment({from, to}, body.position) >= least;
}

const StandingBody* firstInTheWay(const std::vector<StandingBody>& standing, double radius,
                                  const Vec2& from, const Vec2& next) {
  const Vec2 ahead = next - from;
  const Vec2 end = from + ahead * std::min(1.0, kSightAhead / std::max(ahead.norm(), 1e-9));
  const StandingBody* first = nullptr;
  for (const StandingBody& body : standing) {
    const Vec2 towards = body.position - from;
    const double room = body.radius + radius + kRoom;
    const bool isInTheWay =
        towards.dot(ahead) > 0.0 && distanceToSegment({from, end}, body.position) < room;
    if (isInTheWay && (!first || towards.norm() < (first->position - from).norm())) {
      first = &body;
    }
  }
  return first;
}

}  // namespace

std::optional<Vec2> placeBeside(const std::vector<StandingBody>& standing, double radius,
                                const Vec2& from, const Vec2& next,
                                const NavigationMap& navigation) {
  const StandingBody* const body = firstInTheWay(standing, radius, from, next);
  if (!body) {
    return std::nullopt;
  }
  const double back = base::headingOf(from - body->position);
  const double distance = body->radius + radius + kRoom;
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

RouteFollower::Leg RouteFollower::straight(const Request& request) {
  Leg leg;
  const Vec2 toTarget = request.target.position - request.position;
  if (toTarget.norm() > request.target.radius) {
    leg.direction = toTarget.normalized();
  }
  return leg;
}

RouteFollower::Leg RouteFollower::follow(const Request& request, const NavigationMap& navigation,
                                         const Obstacles& obstacles) {
  Leg leg;
  const Vec2 toTarget = request.target.position - request.position;
  if (toTarget.norm() <= request.target.radius) {
    progressAt_ = request.time;
    return leg;
  }
  const bool isForThisTarget = version_ == navigation.version() &&
                               (request.target.position - target_).norm() <= kTargetMoved;
  if (!isForThisTarget) {
    closed_.clear();
    searchPause_ = 0.0;
    leg.replanned = version_ >= 0 && version_ != navigation.version();
    plan(request, navigation);
    clearAt_ = progressAt_ = request.time;
    bestRest_ = 1e300;
  } else if (!path_.empty() && request.target.position != target_) {
    const double before = lengthOfWay(request.position, path_, next_);
    path_.back() = request.target.position;
    target_ = request.target.position;
    bestRest_ +=
        lengthOfWay(request.position, path_, next_) - before;  // progress is what the person walks
  }
  const bool looks = request.time - lookedAt_ >= kBetweenLooks - 1e-9;
  lookedAt_ = looks ? request.time : lookedAt_;
  passWayPoints(request, navigation, looks);
  leg.stuck = isStuck(request);
  if (leg.stuck || (looks && isLost(request, navigation, obstacles))) {
    plan(request, navigation);
    passWayPoints(request, navigation, true);
    leg.replanned = true;
  }
  if (!path_.empty()) {
    beside_ = looks ? besideCorner(request, navigation) : beside_;
    const Vec2 toNext = path_[next_] + beside_ - request.position;
    leg.direction = toNext.norm() > 1e-9 ? toNext.normalized() : toTarget.normalized();
  }
  return leg;
}

void RouteFollower::plan(const Request& request, const NavigationMap& navigation) {
  path_.clear();
  if (!closed_.empty()) {
    path_ =
        navigation.planAround(request.radius, request.position, request.target.position, closed_);
  }
  if (path_.empty()) {
    closed_.clear();
    path_ = navigation.plan(request.radius, request.position, request.target.position);
  }
  if (!path_.empty()) {
    path_.back() = request.target.position;
  }
  next_ = path_.size() > 1 ? 1 : 0;
  target_ = request.target.position;
  version_ = navigation.version();
  plannedAt_ = clearAt_ = request.time;
  beside_ = Vec2::Zero();
  isRound_ = false;
}

std::vector<Vec2> RouteFollower::rest() const {
  std::vector<Vec2> rest(path_.begin() + static_cast<std::ptrdiff_t>(next_), path_.end());
  if (!rest.empty()) {
    rest.front() += beside_;
  }
  return rest;
}

bool RouteFollower::takeAnotherWay(const Request& request,
                                   const std::vector<std::vector<Vec2>>& closed, double waited,
                                   const NavigationMap& navigation) {
  if (path_.empty() || request.time - searchedAt_ < searchPause_) {
    return false;
  }
  searchedAt_ = request.time;
  std::vector<Vec2> way =
      navigation.planAround(request.radius, request.position, request.target.position, closed);
  if (way.empty()) {
    searchPause_ = std::clamp(2.0 * searchPause_, kFirstPause, kLongestPause);
    return false;
  }
  searchPause_ = kFirstPause;
  const double longer = lengthOfWay(way) - lengthOfWay(request.position, path_, next_);
  if (waited < std::min(longer / std::max(request.speed, kWalkingSpeed), kLongestWait)) {
    return false;
  }
  path_ = std::move(way);
  path_.back() = request.target.position;
  next_ = path_.size() > 1 ? 1 : 0;
  closed_ = closed;
  plannedAt_ = clearAt_ = progressAt_ = request.time;
  bestRest_ = 1e300;
  beside_ = Vec2::Zero();
  isRound_ = false;
  return true;
}

/// Out of what is kept out of.
bool RouteFollower::isOpen(const Vec2& from, const Vec2& to) const {
  return std::none_of(closed_.begin(), closed_.end(), [&](const std::vector<Vec2>& polygon) {
    return entryInto(polygon, from, to).has_value();
  });
}

void RouteFollower::goRound(const Request& request, const std::vector<StandingBody>& standing,
                            const NavigationMap& navigation) {
  if (path_.empty()) {
    return;
  }
  const std::optional<Vec2> place =
      placeBeside(standing, request.radius, request.position, path_[next_], navigation);
  if (place) {
    path_.insert(path_.begin() + static_cast<std::ptrdiff_t>(next_), *place);
    isRound_ = true;
  }
}

/// Away from the inside of the turn, as far as wanted or half or a quarter of it.
Vec2 RouteFollower::besideCorner(const Request& request, const NavigationMap& navigation) const {
  if (request.spread <= 0.0 || isRound_ || next_ == 0 || next_ + 1 >= path_.size()) {
    return Vec2::Zero();
  }
  const Vec2& corner = path_[next_];
  const Vec2 outside =
      (corner - path_[next_ - 1]).normalized() - (path_[next_ + 1] - corner).normalized();
  const double turn = outside.norm();
  if (turn < kSharpTurn) {
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
    return (path_[next_] - request.position).norm() < kPassed ||
           (path_[next_] + beside_ - request.position).norm() < kPassed;
  };
  while (next_ + 1 < path_.size() &&
         (hasPassed() || (looks && !isRound_ &&
                          navigation.isClear(request.radius, request.position, path_[next_ + 1]) &&
                          isOpen(request.position, path_[next_ + 1])))) {
    ++next_;
    isRound_ = false;
    beside_ = Vec2::Zero();
  }
}

bool RouteFollower::isLost(const Request& request, const NavigationMap& navigation,
                           const Obstacles& obstacles) {
  if (path_.empty()) {
    return request.time - plannedAt_ >= kStuckAfter;  // a way may have opened
  }
  if (navigation.isClear(request.radius, request.position, path_[next_])) {
    clearAt_ = request.time;
    return false;
  }
  if (request.time - plannedAt_ < kBetweenPlans) {
    return false;
  }
  return request.time - clearAt_ >= kLostAfter ||
         !obstacles.isVisible(request.position, path_[next_]);
}

bool RouteFollower::isStuck(const Request& request) {
  const double rest = lengthOfWay(request.position, path_, next_);
  if (rest < bestRest_ - kProgress || request.speed < kWalkingSpeed) {
    bestRest_ = std::min(bestRest_, rest);
    progressAt_ = request.time;
    return false;
  }
  if (request.time - progressAt_ < kStuckAfter) {
    return false;
  }
  progressAt_ = request.time;
  bestRest_ = 1e300;
  return true;
}

}  // namespace sim2d
