#include <algorithm>
#include <cmath>

#include "sim2d/world/DensityForce.h"

namespace sim2d {
namespace {

constexpr double kShortestLook = 0.05;  // t_c [s]
constexpr double kPersonLook = 6.0;     // [m/s]; people whose gap is below this times t_c count
constexpr double kWallLook = 1.5;       // [m]
constexpr double kPartingSpeed = -0.3;  // [m/s], at most, of bodies that overlap
constexpr double kTie = 1e-9;
constexpr int kMostSweeps = 10;

/// velocity · towards <= most.
struct Bound {
  Vec2 towards = Vec2::Zero();  // unit vector
  double most = 0.0;            // [m/s]
  double excess(const Vec2& velocity) const { return velocity.dot(towards) - most; }
};

/// The one who sees more of the other ahead gives way.
bool givesWay(const Pedestrian& self, const Pedestrian& other, const Vec2& apart) {
  const double ofOther = self.course.direction.dot(apart);
  const double ofSelf = -other.course.direction.dot(apart);
  if (std::fabs(ofOther - ofSelf) <= kTie) {
    return self.body.id > other.body.id;
  }
  return ofOther > ofSelf;
}

void addPeople(const DensityParameters& parameters, const Pedestrian& self,
               const std::vector<Pedestrian>& others, double look, std::vector<Bound>& bounds) {
  for (const Pedestrian& other : others) {
    const Vec2 apart = other.body.position - self.body.position;
    const double distance = apart.norm();
    const double gap = distance - self.body.radius - other.body.radius;
    if (distance < kTie || gap >= kPersonLook * look) {
      continue;
    }
    double most = std::max(gap / (2.0 * look), kPartingSpeed);
    if (gap < parameters.yieldGap && givesWay(self, other, apart)) {
      const double closeness = 1.0 - std::max(0.0, gap) / parameters.yieldGap;
      most = std::min(most, -parameters.yieldSpeed * closeness);
    }
    bounds.push_back({apart / distance, most});
  }
}

void addWalls(const Pedestrian& self, const std::vector<Obstacles::Point>& points, double look,
              std::vector<Bound>& bounds) {
  for (const Obstacles::Point& point : points) {
    const Vec2 apart = point.position - self.body.position;
    const double distance = apart.norm();
    if (distance < kTie || distance > kWallLook) {
      continue;
    }
    const double side = point.inside ? -1.0 : 1.0;
    const double room = side * distance - self.body.radius;
    bounds.push_back({side * apart / distance, std::max(room / look, kPartingSpeed)});
  }
}

}  // namespace

Vec2 guardContacts(const DensityParameters& parameters, const Pedestrian& self,
                   const std::vector<Pedestrian>& others,
                   const std::vector<Obstacles::Point>& points, const Vec2& velocity, double dt) {
  const double look = std::max(dt, kShortestLook);
  std::vector<Bound> bounds;
  addPeople(parameters, self, others, look, bounds);
  addWalls(self, points, look, bounds);
  Vec2 allowed = velocity;
  bool changed = true;
  for (int sweep = 0; sweep < kMostSweeps && changed; ++sweep) {
    changed = false;
    for (const Bound& bound : bounds) {
      const double excess = bound.excess(allowed);
      if (excess > kTie) {
        allowed -= excess * bound.towards;
        changed = true;
      }
    }
  }
  double share = 1.0;
  for (const Bound& bound : bounds) {
    if (bound.excess(allowed) > kTie) {
      const double speed = allowed.dot(bound.towards);
      share = std::min(share, speed > kTie ? std::max(0.0, bound.most) / speed : 0.0);
    }
  }
  return share * allowed;
}

}  // namespace sim2d
