#include <algorithm>
#include <cmath>

#include "sim2d/world/DensityForce.h"
#include "sim2d/world/ReciprocalVelocity.h"

namespace sim2d {
namespace {

constexpr double kShortestLook = 0.05;  // t_c [s]
constexpr double kPersonLook = 6.0;     // [m/s]; people whose gap is below this times t_c count
constexpr double kWallLook = 1.5;       // [m]
constexpr double kPartingSpeed = -0.3;  // [m/s], at most, of bodies that overlap
constexpr double kGivingWay = 0.6;      // [m/s]; so much faster than wanted may who gives way be
constexpr double kTie = 1e-9;
constexpr double kTolerance = 1e-6;  // [m/s] of a bound

/// velocity · towards <= most.
struct Bound {
  Vec2 towards = Vec2::Zero();  // unit vector
  double most = 0.0;            // [m/s]
  HalfPlane plane() const { return {most * towards, Vec2(-towards.y(), towards.x())}; }
};

/// What keeps bodies apart, and what of them should part beyond that, where it can.
struct Bounds {
  std::vector<Bound> contacts;
  std::vector<Bound> givingWay;
};

/// The one who sees more of the other ahead gives way.
bool givesWay(const Pedestrian& self, const Pedestrian& other, const Vec2& apart) {
  const double ofOther = self.desired.direction.dot(apart);
  const double ofSelf = -other.desired.direction.dot(apart);
  if (std::fabs(ofOther - ofSelf) <= kTie) {
    return self.body.id > other.body.id;
  }
  return ofOther > ofSelf;
}

void addPeople(const DensityParameters& parameters, const Pedestrian& self,
               const std::vector<Pedestrian>& others, double look, Bounds& bounds) {
  for (const Pedestrian& other : others) {
    const Vec2 apart = other.body.position - self.body.position;
    const double distance = apart.norm();
    const double gap = distance - self.body.radius - other.body.radius;
    if (distance < kTie || gap >= kPersonLook * look) {
      continue;
    }
    const Vec2 towards = apart / distance;
    bounds.contacts.push_back({towards, std::max(gap / (2.0 * look), kPartingSpeed)});
    if (gap < parameters.yieldGap && givesWay(self, other, apart)) {
      const double closeness = 1.0 - std::max(0.0, gap) / parameters.yieldGap;
      const double leaving = std::max(0.0, other.body.velocity.dot(towards));
      bounds.givingWay.push_back({towards, leaving - parameters.yieldSpeed * closeness});
    }
  }
}

void addWalls(const Pedestrian& self, const std::vector<Obstacles::Point>& points, double look,
              Bounds& bounds) {
  for (const Obstacles::Point& point : points) {
    const Vec2 apart = point.position - self.body.position;
    const double distance = apart.norm();
    if (distance < kTie || distance > kWallLook) {
      continue;
    }
    const double side = point.inside ? -1.0 : 1.0;
    const double room = side * distance - self.body.radius;
    bounds.contacts.push_back({side * apart / distance, std::max(room / look, kPartingSpeed)});
  }
}

}  // namespace

Vec2 guardContacts(const DensityParameters& parameters, const Pedestrian& self,
                   const std::vector<Pedestrian>& others,
                   const std::vector<Obstacles::Point>& points, const Vec2& velocity, double dt) {
  const double look = std::max(dt, kShortestLook);
  Bounds bounds;
  addWalls(self, points, look, bounds);
  addPeople(parameters, self, others, look, bounds);
  std::vector<HalfPlane> planes;
  planes.reserve(bounds.contacts.size() + bounds.givingWay.size());
  for (const std::vector<Bound>* part : {&bounds.contacts, &bounds.givingWay}) {
    for (const Bound& bound : *part) {
      planes.push_back(bound.plane());
    }
  }
  const Vec2 allowed =
      nearestAllowed(planes, bounds.contacts.size(), velocity, velocity.norm() + kGivingWay);
  double share = 1.0;  // of it, where bodies overlap and cannot part
  for (const Bound& bound : bounds.contacts) {
    const double approach = allowed.dot(bound.towards);
    const double most = std::max(0.0, bound.most);
    if (approach > most + kTolerance) {
      share = std::min(share, most / approach);
    }
  }
  return share * allowed;
}

}  // namespace sim2d
