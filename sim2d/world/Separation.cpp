#include "sim2d/world/Separation.h"

#include <algorithm>

namespace sim2d {
namespace {

constexpr double kClearance = 0.0005;  // [m]; less than the skin that discs have in the physics
constexpr double kSmallExcess = 1e-6;  // [m/s]
constexpr int kMostRounds = 20;

/// Closing speed beyond what the gap allows [m/s].
double excess(double closingSpeed, double gap, double dt) {
  return closingSpeed - std::max(gap - kClearance, 0.0) / dt;
}

bool stopAtWalls(MovingDisc& disc, double dt) {
  bool changed = false;
  if (disc.walls == nullptr) {
    return changed;
  }
  for (const Obstacles::Point& point : *disc.walls) {
    if (point.inside || point.distance < 1e-9) {
      continue;
    }
    const Vec2 toWall = (point.position - disc.position) / point.distance;
    const double tooFast = excess(disc.velocity.dot(toWall), point.distance - disc.radius, dt);
    if (tooFast > kSmallExcess) {
      disc.velocity -= tooFast * toWall;
      changed = true;
    }
  }
  return changed;
}

bool stopAtEachOther(MovingDisc& first, MovingDisc& second, const Vec2& shift, double dt) {
  const Vec2 apart = second.position + shift - first.position;
  const double distance = apart.norm();
  if (distance < 1e-9) {
    return false;
  }
  const Vec2 normal = apart / distance;
  const double closing = (first.velocity - second.velocity).dot(normal);
  const double tooFast = excess(closing, distance - first.radius - second.radius, dt);
  if (tooFast <= kSmallExcess) {
    return false;
  }
  const double share = second.mass / (first.mass + second.mass);
  first.velocity -= share * tooFast * normal;
  second.velocity += (1.0 - share) * tooFast * normal;
  return true;
}

}  // namespace

void keepApart(std::vector<MovingDisc>& discs, const std::vector<DiscPair>& pairs, double dt) {
  bool changed = true;
  for (int round = 0; round < kMostRounds && changed; ++round) {
    changed = false;
    for (const DiscPair& pair : pairs) {
      changed |=
          stopAtEachOther(discs[static_cast<std::size_t>(pair.first)],
                          discs[static_cast<std::size_t>(pair.second)], Vec2(pair.shift, 0.0), dt);
    }
    for (MovingDisc& disc : discs) {
      changed |= stopAtWalls(disc, dt);
    }
  }
}

}  // namespace sim2d
