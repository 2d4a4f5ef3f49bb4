#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"

namespace sim2d::nav2 {
namespace {

/// Costs around the people that the detector reports, specific to this program (Kirby 2010,
/// appendix A: halves of two Gaussians). In a person's frame, x forward, y left: amplitude exp(-x²
/// / (2 s²) - y² / (2 (sideRatio s_h)²)), s_h = max(sigmaPerSpeed v, sigmaMin), s = s_h ahead and
/// rearRatio s_h behind. Lower costs, including unknown cells, are increased to this value.
class SocialLayer final : public CostmapLayer {
 public:
  SocialLayer(const SocialLayerParameters& parameters, const LayerSite& site)
      : CostmapLayer(site), parameters_(parameters) {}

  void updateBounds(const Observation& observation, const Costmap& /*master*/,
                    CostmapBounds& bounds) override {
    zones_.clear();
    if (!parameters_.enabled) {
      return;
    }
    bounds.touch(std::exchange(last_, {}));
    if (parameters_.amplitude < parameters_.cutoff) {
      return;
    }
    for (const TrackedBody& body : observation.bodies) {
      if (body.kind != BodyKind::Person) {
        continue;
      }
      Zone zone;
      zone.person = {body.position, body.heading};
      zone.sigma = std::max(parameters_.sigmaPerSpeed * body.velocity.norm(), parameters_.sigmaMin);
      const double most = std::max({1.0, parameters_.sideRatio, parameters_.rearRatio});
      const double reach = cutoffDeviations() * most * zone.sigma;
      zone.bounds.touch(body.position - Vec2::Constant(reach));
      zone.bounds.touch(body.position + Vec2::Constant(reach));
      last_.touch(zone.bounds);
      zones_.push_back(zone);
    }
    bounds.touch(last_);
  }

  void updateCosts(Costmap& master, const CellWindow& window) override {
    for (const Zone& zone : zones_) {
      raiseCosts(zone, master, window);
    }
  }
  void reset(double /*time*/) override { zones_.clear(); }

 private:
  struct Zone {
    Pose2 person;
    double sigma = 0.0;  // forward [m]
    CostmapBounds bounds;
  };

  /// Distance in standard deviations at which the cost equals the cutoff.
  double cutoffDeviations() const {
    return std::sqrt(2.0 * base::log(parameters_.amplitude / parameters_.cutoff));
  }

  void raiseCosts(const Zone& zone, Costmap& master, const CellWindow& window) const {
    const CellWindow inside = windowOf(master, zone.bounds);
    const Vec2 ahead = zone.person.direction();
    const double most = cutoffDeviations() * cutoffDeviations();
    const CellWindow both{std::max(window.left, inside.left),
                          std::max(window.bottom, inside.bottom),
                          std::min(window.right, inside.right), std::min(window.top, inside.top)};
    forEachCell(both, [&](Cell cell) {
      const Vec2 offset = master.cellToWorld(cell) - zone.person.position;
      const double x = ahead.dot(offset), y = base::cross(ahead, offset);
      const double along = x / (x >= 0.0 ? zone.sigma : parameters_.rearRatio * zone.sigma);
      const double aside = y / (parameters_.sideRatio * zone.sigma);
      const double square = along * along + aside * aside;  // [standard deviations²]
      if (square > most) {
        return;
      }
      const double cost =
          std::min<double>(parameters_.amplitude * base::exp(-0.5 * square), kLethal);
      const std::uint8_t old = master.at(cell);
      if (cost >= 1.0 && (old == kNoInformation || cost > old)) {
        master.set(cell, static_cast<std::uint8_t>(cost));
      }
    });
  }

  SocialLayerParameters parameters_;
  std::vector<Zone> zones_;
  CostmapBounds last_;  // area of the previous update, which must be cleared
};

}  // namespace

LayerPointer makeLayer(const SocialLayerParameters& parameters, const LayerSite& site) {
  return std::make_unique<SocialLayer>(parameters, site);
}

}  // namespace sim2d::nav2
