#include "sim2d/nav/nav2/costmap/SocialLayer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"

namespace sim2d::nav2 {
namespace {

double forwardSigma(const SocialLayerParameters& parameters, double speed) {
  return std::max(parameters.sigmaPerSpeed * speed, parameters.sigmaMin);
}

/// Squared distance in standard deviations of a position in the person's frame [m].
double squaredDeviations(const SocialLayerParameters& parameters, const Vec2& place, double ahead) {
  const double along = place.x() / (place.x() >= 0.0 ? ahead : parameters.rearRatio * ahead);
  const double aside = place.y() / (parameters.sideRatio * ahead);
  return along * along + aside * aside;
}

/// Distance in standard deviations at which the cost equals the cutoff.
double cutoffDeviations(const SocialLayerParameters& parameters) {
  return std::sqrt(2.0 * base::log(parameters.amplitude / parameters.cutoff));
}

}  // namespace

SocialLayer::SocialLayer(std::string name, const CostmapContext& context,
                         const SocialLayerParameters& parameters)
    : CostmapLayer(std::move(name), context), parameters_(parameters) {}

double SocialLayer::costAt(const SocialLayerParameters& parameters, const Vec2& place,
                           double speed) {
  return parameters.amplitude *
         base::exp(-0.5 * squaredDeviations(parameters, place, forwardSigma(parameters, speed)));
}

void SocialLayer::updateBounds(const Observation& observation, const Costmap& /*master*/,
                               CostmapBounds& bounds) {
  zones_.clear();
  if (!parameters_.enabled) {
    return;
  }
  bounds.touch(std::exchange(last_, {}));
  if (parameters_.amplitude < parameters_.cutoff) {
    return;
  }
  // exp(-d² / 2) equals cutoff / amplitude at this distance.
  const double deviations = std::sqrt(2.0 * base::log(parameters_.amplitude / parameters_.cutoff));
  for (const TrackedBody& body : observation.bodies) {
    if (body.kind != BodyKind::Person) {
      continue;
    }
    Zone zone;
    zone.person = {body.position, body.heading};
    zone.speed = body.velocity.norm();
    const double most = std::max({1.0, parameters_.sideRatio, parameters_.rearRatio});
    const double reach = deviations * most * forwardSigma(parameters_, zone.speed);
    zone.bounds.touch(body.position - Vec2::Constant(reach));
    zone.bounds.touch(body.position + Vec2::Constant(reach));
    last_.touch(zone.bounds);
    zones_.push_back(zone);
  }
  bounds.touch(last_);
}

void SocialLayer::updateCosts(Costmap& master, const CellWindow& window) {
  for (const Zone& zone : zones_) {
    raiseCosts(zone, master, window);
  }
}

void SocialLayer::reset(double /*time*/) {
  zones_.clear();
}

void SocialLayer::raiseCosts(const Zone& zone, Costmap& master, const CellWindow& window) const {
  const CellWindow inside = windowOf(master, zone.bounds);
  const Vec2 ahead = zone.person.direction();
  const double sigma = forwardSigma(parameters_, zone.speed);
  const double most = cutoffDeviations(parameters_) * cutoffDeviations(parameters_);
  for (int row = std::max(window.bottom, inside.bottom); row < std::min(window.top, inside.top);
       ++row) {
    for (int column = std::max(window.left, inside.left);
         column < std::min(window.right, inside.right); ++column) {
      const Cell cell{column, row};
      const Vec2 offset = master.cellToWorld(cell) - zone.person.position;
      const Vec2 place(ahead.dot(offset), base::cross(ahead, offset));
      const double square = squaredDeviations(parameters_, place, sigma);
      if (square > most) {
        continue;
      }
      const double cost =
          std::min<double>(parameters_.amplitude * base::exp(-0.5 * square), kLethal);
      const std::uint8_t old = master.at(cell);
      if (cost >= 1.0 && (old == kNoInformation || cost > old)) {
        master.set(cell, static_cast<std::uint8_t>(cost));
      }
    }
  }
}

}  // namespace sim2d::nav2
