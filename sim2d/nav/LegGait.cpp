#include "sim2d/nav/LegGait.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sim2d/base/Rng.h"

namespace sim2d {
namespace {

constexpr std::uint32_t kGaitPhaseDraw = 0x80000000U;  // above the draw indices of beams
constexpr double kWalkRatio = 0.39;                    // W [m s]
constexpr double kHalfShoulder = 0.1;                  // [m]
constexpr double kLegRadius = 0.06;                    // [m]
constexpr double kMinStepLength = 0.005;               // [m]; slower people hardly lift their feet

double advancedPhase(double stride, double walked, double speed) {
  const double after = stride + walked / (2.0 * std::max(stepLength(speed), kMinStepLength));
  return after - std::floor(after);
}

}  // namespace

double stepLength(double speed) {
  return std::sqrt(kWalkRatio * speed);
}

Legs legsAt(const SensedBody& person, double stride) {
  Legs legs;
  legs.radius = std::min(kLegRadius, 0.5 * person.radius);
  const double reach = person.radius - legs.radius;  // of a leg's centre
  const double aside = std::min(kHalfShoulder, reach);
  const double room = std::sqrt(std::max(reach * reach - aside * aside, 0.0));
  const double swing = 0.5 * stepLength(person.velocity.norm());
  const double ahead = std::clamp(swing * (std::fabs(4.0 * stride - 2.0) - 1.0), -room, room);
  const Vec2 direction = base::directionOf(person.heading);
  const Vec2 offset =
      ahead * direction + aside * Vec2(-direction.y(), direction.x());  // of the left leg
  // The right leg mirrors the left one at the body's centre.
  legs.left = person.position + offset;
  legs.right = person.position - offset;
  return legs;
}

void LegGait::update(const std::vector<SensedBody>& bodies) {
  walkers_.swap(before_);
  walkers_.resize(bodies.size());
  std::size_t old = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const SensedBody& body = bodies[i];
    if (body.kind != BodyKind::Person) {
      walkers_[i] = {};
      continue;
    }
    while (old < before_.size() && before_[old].id >= 0 && before_[old].id < body.id) {
      ++old;
    }
    const bool isKnown = old < before_.size() && before_[old].id == body.id;
    const double stride =
        isKnown
            ? advancedPhase(before_[old].stride, (body.position - before_[old].position).norm(),
                            body.velocity.norm())
            : base::AgentRng(seed_, body.id).uniform01(base::DrawPurpose::Lidar, kGaitPhaseDraw);
    walkers_[i] = {body.id, body.position, stride};
  }
}

}  // namespace sim2d
