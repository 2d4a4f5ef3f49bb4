#include "sim2d/world/Detour.h"

#include <algorithm>

#include "sim2d/base/Math.h"

namespace sim2d {
namespace {

constexpr double kRoom = 0.15;  // [m] between the bodies when they pass
constexpr double kAhead = 2.5;  // [m]; who stands farther away does not count yet
constexpr double kTouch =
    0.1;  // [m]; bodies slide along each other, so a line may lead so much nearer

Vec2 nearestOn(const Vec2& from, const Vec2& to, const Vec2& point) {
  const Vec2 leg = to - from;
  const double share = (point - from).dot(leg) / std::max(leg.squaredNorm(), 1e-18);
  return from + std::clamp(share, 0.0, 1.0) * leg;
}

/// The line leads past the body, or away from it.
bool isFree(const StandingBody& body, double radius, const Vec2& from, const Vec2& to) {
  const Vec2 towards = body.position - from;
  const double least = std::min(body.radius + radius, towards.norm()) - kTouch;
  return (nearestOn(from, to, body.position) - body.position).norm() >= least;
}

const StandingBody* firstInTheWay(const std::vector<StandingBody>& standing, double radius,
                                  const Vec2& from, const Vec2& next) {
  const Vec2 ahead = next - from;
  const Vec2 end = from + ahead * std::min(1.0, kAhead / std::max(ahead.norm(), 1e-9));
  const StandingBody* first = nullptr;
  for (const StandingBody& body : standing) {
    const Vec2 towards = body.position - from;
    const double room = body.radius + radius + kRoom;
    const bool isInTheWay = towards.dot(ahead) > 0.0 &&
                            (nearestOn(from, end, body.position) - body.position).norm() < room;
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

}  // namespace sim2d
