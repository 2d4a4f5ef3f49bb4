#include "sim2d/nav/ReciprocalVelocity.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sim2d {
namespace {

constexpr double kOrcaEpsilon = 1e-9;

Vec2 leftOf(const Vec2& direction) {
  return {-direction.y(), direction.x()};
}

/// The half plane with its boundary through `edge` and its allowed side along `outwards`.
HalfPlane halfPlaneThrough(const Vec2& edge, const Vec2& outwards) {
  return {edge, Vec2(outwards.y(), -outwards.x())};
}

/// Change of the relative velocity to the nearest point outside the disc of velocities that lead to
/// contact after exactly `time`.
struct Change {
  Vec2 amount = Vec2::Zero();
  Vec2 outwards = Vec2(1.0, 0.0);
};

Change escapeDisc(const Vec2& relative, const Vec2& apart, double reach, double time) {
  const Vec2 fromCentre = relative - apart / time;
  const double length = fromCentre.norm();
  Change change;
  if (length > kOrcaEpsilon) {
    change.outwards = fromCentre / length;
  } else {
    const double distance = apart.norm();
    change.outwards = distance > kOrcaEpsilon ? Vec2(-apart / distance) : Vec2(1.0, 0.0);
  }
  change.amount = (reach / time - length) * change.outwards;
  return change;
}

/// Same for the cone of velocities that lead to contact at any time, over its nearer leg.
Change escapeCone(const Vec2& relative, const Vec2& apart, double reach, bool isLeft) {
  const double squared = apart.squaredNorm();
  const double tangent = std::sqrt(std::max(0.0, squared - reach * reach));
  const double side = isLeft ? 1.0 : -1.0;
  const Vec2 leg = (tangent * apart + side * reach * leftOf(apart)) / squared;
  Change change;
  change.outwards = side * leftOf(leg);
  change.amount = -relative.dot(change.outwards) * change.outwards;
  return change;
}

/// Part of a line that satisfies other half planes.
struct LineInterval {
  double from = 0.0, to = 0.0;
};

std::optional<LineInterval> feasibleInterval(const std::vector<HalfPlane>& planes, std::size_t line,
                                             double fastest) {
  const HalfPlane& on = planes[line];
  const double along = on.point.dot(on.direction);
  const double square = along * along + fastest * fastest - on.point.squaredNorm();
  if (square < 0.0) {
    return std::nullopt;
  }
  const double half = std::sqrt(square);
  LineInterval stretch{-along - half, -along + half};
  for (std::size_t i = 0; i < line; ++i) {
    const double crossing = base::cross(on.direction, planes[i].direction);
    const double beyond = base::cross(planes[i].direction, on.point - planes[i].point);
    if (std::fabs(crossing) <= kOrcaEpsilon) {
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

enum class Objective { Nearest, Farthest };  // nearest to a velocity, or farthest in a direction

/// Best velocity under the half planes; returns the number of planes that could be satisfied.
std::size_t solve(const std::vector<HalfPlane>& planes, const Vec2& wanted, double fastest,
                  Objective aim, Vec2& best) {
  const double length = wanted.norm();
  best = wanted;
  if (aim == Objective::Farthest) {
    best = wanted * fastest;
  } else if (length > fastest) {
    best = wanted * (fastest / length);
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (planes[i].violation(best) <= 0.0) {
      continue;
    }
    const std::optional<LineInterval> stretch = feasibleInterval(planes, i, fastest);
    if (!stretch) {
      return i;
    }
    const Vec2& direction = planes[i].direction;
    double place = direction.dot(wanted - planes[i].point);
    if (aim == Objective::Farthest) {
      place = direction.dot(wanted) > 0.0 ? stretch->to : stretch->from;
    }
    best = planes[i].point + std::clamp(place, stretch->from, stretch->to) * direction;
  }
  return planes.size();
}

/// The planes of equal violation of `plane` and each of the earlier ones that are not fixed.
std::vector<HalfPlane> bisectorPlanes(const std::vector<HalfPlane>& planes, std::size_t fixed,
                                      std::size_t plane) {
  const HalfPlane& own = planes[plane];
  std::vector<HalfPlane> found(planes.begin(), planes.begin() + static_cast<std::ptrdiff_t>(fixed));
  for (std::size_t k = fixed; k < plane; ++k) {
    const HalfPlane& other = planes[k];
    const double crossing = base::cross(own.direction, other.direction);
    HalfPlane middle;
    if (std::fabs(crossing) <= kOrcaEpsilon) {
      if (own.direction.dot(other.direction) > 0.0) {
        continue;  // same direction: one of them implies the other
      }
      middle.point = 0.5 * (own.point + other.point);
    } else {
      const double place = base::cross(other.direction, own.point - other.point) / crossing;
      middle.point = own.point + place * own.direction;
    }
    const Vec2 between = other.direction - own.direction;
    const double length = between.norm();
    if (length > kOrcaEpsilon) {
      middle.direction = between / length;
      found.push_back(middle);
    }
  }
  return found;
}

/// Minimises the largest violation of the planes from `first` on.
void relax(const std::vector<HalfPlane>& planes, std::size_t fixed, std::size_t first,
           double fastest, Vec2& best) {
  double worst = 0.0;
  for (std::size_t i = first; i < planes.size(); ++i) {
    if (planes[i].violation(best) <= worst) {
      continue;
    }
    const std::vector<HalfPlane> between = bisectorPlanes(planes, fixed, i);
    const Vec2 before = best;
    if (solve(between, leftOf(planes[i].direction), fastest, Objective::Farthest, best) <
        between.size()) {
      best = before;  // rounding only: the previous velocity is on the boundary
    }
    worst = planes[i].violation(best);
  }
}

}  // namespace

HalfPlane bodyHalfPlane(const Walker& self, const Walker& other, double horizon, double dt,
                        double share) {
  const Vec2 apart = other.position - self.position;
  const Vec2 relative = self.velocity - other.velocity;
  const double reach = self.radius + other.radius;
  Change change;
  if (apart.squaredNorm() <= reach * reach) {
    change = escapeDisc(relative, apart, reach, dt);
  } else {
    const Vec2 fromCentre = relative - apart / horizon;
    const double inFront = fromCentre.dot(apart);
    const bool isRound =
        inFront < 0.0 && inFront * inFront > reach * reach * fromCentre.squaredNorm();
    change = isRound ? escapeDisc(relative, apart, reach, horizon)
                     : escapeCone(relative, apart, reach, base::cross(apart, fromCentre) > 0.0);
  }
  return halfPlaneThrough(self.velocity + share * change.amount, change.outwards);
}

HalfPlane pointHalfPlane(const Walker& self, const Obstacles::Point& point, double horizon,
                         double dt) {
  const Vec2 apart = point.position - self.position;
  const double distance = apart.norm();
  if (distance < kOrcaEpsilon) {
    return halfPlaneThrough(Vec2::Zero(), Vec2(1.0, 0.0));
  }
  const double side = point.inside ? -1.0 : 1.0;
  const Vec2 towards = side * apart / distance;
  const double room = side * distance - self.radius;
  const double fastest = room >= 0.0 ? room / horizon : std::max(room / dt, -0.5);
  return halfPlaneThrough(fastest * towards, -towards);
}

Vec2 nearestFeasibleVelocity(const std::vector<HalfPlane>& planes, std::size_t fixed,
                             const Vec2& wanted, double fastest) {
  Vec2 best = Vec2::Zero();
  const std::size_t kept = solve(planes, wanted, fastest, Objective::Nearest, best);
  if (kept < planes.size()) {
    relax(planes, fixed, kept, fastest, best);
  }
  return best;
}

}  // namespace sim2d
