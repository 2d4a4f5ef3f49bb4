#include "sim2d/nav/ReciprocalVelocity.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sim2d {
namespace {

constexpr double kSmall = 1e-9;

Vec2 leftOf(const Vec2& direction) {
  return {-direction.y(), direction.x()};
}

/// The plane whose allowed side lies along `outwards` from `edge`.
HalfPlane planeThrough(const Vec2& edge, const Vec2& outwards) {
  return {edge, Vec2(outwards.y(), -outwards.x())};
}

/// Change of the relative velocity to the nearest place outside the disc of velocities that lead to
/// contact after exactly `time`.
struct Change {
  Vec2 amount = Vec2::Zero();
  Vec2 outwards = Vec2(1.0, 0.0);
};

Change outOfDisc(const Vec2& relative, const Vec2& apart, double reach, double time) {
  const Vec2 fromCentre = relative - apart / time;
  const double length = fromCentre.norm();
  Change change;
  if (length > kSmall) {
    change.outwards = fromCentre / length;
  } else {
    const double distance = apart.norm();
    change.outwards = distance > kSmall ? Vec2(-apart / distance) : Vec2(1.0, 0.0);
  }
  change.amount = (reach / time - length) * change.outwards;
  return change;
}

/// The same for the cone of velocities that lead to contact at any time: out at its nearer leg.
Change outOfCone(const Vec2& relative, const Vec2& apart, double reach, bool isLeft) {
  const double squared = apart.squaredNorm();
  const double tangent = std::sqrt(std::max(0.0, squared - reach * reach));
  const double side = isLeft ? 1.0 : -1.0;
  const Vec2 leg = (tangent * apart + side * reach * leftOf(apart)) / squared;
  Change change;
  change.outwards = side * leftOf(leg);
  change.amount = -relative.dot(change.outwards) * change.outwards;
  return change;
}

/// Part of a line that other planes leave over.
struct Stretch {
  double from = 0.0, to = 0.0;
};

std::optional<Stretch> stretchWithin(const std::vector<HalfPlane>& planes, std::size_t line,
                                     double fastest) {
  const HalfPlane& on = planes[line];
  const double along = on.point.dot(on.direction);
  const double square = along * along + fastest * fastest - on.point.squaredNorm();
  if (square < 0.0) {
    return std::nullopt;
  }
  const double half = std::sqrt(square);
  Stretch stretch{-along - half, -along + half};
  for (std::size_t i = 0; i < line; ++i) {
    const double crossing = base::cross(on.direction, planes[i].direction);
    const double beyond = base::cross(planes[i].direction, on.point - planes[i].point);
    if (std::fabs(crossing) <= kSmall) {
      if (beyond < 0.0) {
        return std::nullopt;
      }
      continue;
    }
    const double place = beyond / crossing;
    if (crossing >= 0.0) {
      stretch.to = std::min(stretch.to, place);
    } else {
      stretch.from = std::max(stretch.from, place);
    }
    if (stretch.from > stretch.to) {
      return std::nullopt;
    }
  }
  return stretch;
}

enum class Aim { Nearest, Farthest };  // to a velocity, or in a direction

/// Best velocity under the first planes; the number of planes that could be kept.
std::size_t solve(const std::vector<HalfPlane>& planes, const Vec2& wanted, double fastest, Aim aim,
                  Vec2& best) {
  const double length = wanted.norm();
  best = wanted;
  if (aim == Aim::Farthest) {
    best = wanted * fastest;
  } else if (length > fastest) {
    best = wanted * (fastest / length);
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (planes[i].violation(best) <= 0.0) {
      continue;
    }
    const std::optional<Stretch> stretch = stretchWithin(planes, i, fastest);
    if (!stretch) {
      return i;
    }
    const Vec2& direction = planes[i].direction;
    double place = direction.dot(wanted - planes[i].point);
    if (aim == Aim::Farthest) {
      place = direction.dot(wanted) > 0.0 ? stretch->to : stretch->from;
    }
    best = planes[i].point + std::clamp(place, stretch->from, stretch->to) * direction;
  }
  return planes.size();
}

/// The planes of equal violation of `plane` and each of the earlier ones that can give.
std::vector<HalfPlane> balanced(const std::vector<HalfPlane>& planes, std::size_t fixed,
                                std::size_t plane) {
  const HalfPlane& own = planes[plane];
  std::vector<HalfPlane> found(planes.begin(), planes.begin() + static_cast<std::ptrdiff_t>(fixed));
  for (std::size_t k = fixed; k < plane; ++k) {
    const HalfPlane& other = planes[k];
    const double crossing = base::cross(own.direction, other.direction);
    HalfPlane middle;
    if (std::fabs(crossing) <= kSmall) {
      if (own.direction.dot(other.direction) > 0.0) {
        continue;  // the same way: one of them holds with the other
      }
      middle.point = 0.5 * (own.point + other.point);
    } else {
      const double place = base::cross(other.direction, own.point - other.point) / crossing;
      middle.point = own.point + place * own.direction;
    }
    const Vec2 between = other.direction - own.direction;
    const double length = between.norm();
    if (length > kSmall) {
      middle.direction = between / length;
      found.push_back(middle);
    }
  }
  return found;
}

/// From plane `first` on: as little violation of the worst one as possible.
void relax(const std::vector<HalfPlane>& planes, std::size_t fixed, std::size_t first,
           double fastest, Vec2& best) {
  double worst = 0.0;
  for (std::size_t i = first; i < planes.size(); ++i) {
    if (planes[i].violation(best) <= worst) {
      continue;
    }
    const std::vector<HalfPlane> between = balanced(planes, fixed, i);
    const Vec2 before = best;
    if (solve(between, leftOf(planes[i].direction), fastest, Aim::Farthest, best) <
        between.size()) {
      best = before;  // only by rounding: the old velocity is on the edge
    }
    worst = planes[i].violation(best);
  }
}

}  // namespace

HalfPlane avoidBody(const Walker& self, const Walker& other, double horizon, double dt,
                    double share) {
  const Vec2 apart = other.position - self.position;
  const Vec2 relative = self.velocity - other.velocity;
  const double reach = self.radius + other.radius;
  Change change;
  if (apart.squaredNorm() <= reach * reach) {
    change = outOfDisc(relative, apart, reach, dt);
  } else {
    const Vec2 fromCentre = relative - apart / horizon;
    const double inFront = fromCentre.dot(apart);
    const bool isRound =
        inFront < 0.0 && inFront * inFront > reach * reach * fromCentre.squaredNorm();
    change = isRound ? outOfDisc(relative, apart, reach, horizon)
                     : outOfCone(relative, apart, reach, base::cross(apart, fromCentre) > 0.0);
  }
  return planeThrough(self.velocity + share * change.amount, change.outwards);
}

HalfPlane avoidPoint(const Walker& self, const Obstacles::Point& point, double horizon, double dt) {
  const Vec2 apart = point.position - self.position;
  const double distance = apart.norm();
  if (distance < kSmall) {
    return planeThrough(Vec2::Zero(), Vec2(1.0, 0.0));
  }
  const double side = point.inside ? -1.0 : 1.0;
  const Vec2 towards = side * apart / distance;
  const double room = side * distance - self.radius;
  const double fastest = room >= 0.0 ? room / horizon : std::max(room / dt, -0.5);
  return planeThrough(fastest * towards, -towards);
}

Vec2 nearestAllowed(const std::vector<HalfPlane>& planes, std::size_t fixed, const Vec2& wanted,
                    double fastest) {
  Vec2 best = Vec2::Zero();
  const std::size_t kept = solve(planes, wanted, fastest, Aim::Nearest, best);
  if (kept < planes.size()) {
    relax(planes, fixed, kept, fastest, best);
  }
  return best;
}

}  // namespace sim2d
