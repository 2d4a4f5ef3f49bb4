#pragma once

#include <string>
#include <vector>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"

namespace sim2d::nav2 {

/// Costs around the people that the detector reports, specific to this program (Kirby 2010,
/// appendix A: halves of two Gaussians). In a person's frame, x forward, y left: amplitude exp(-x²
/// / (2 s²) - y² / (2 (sideRatio s_h)²)), s_h = max(sigmaPerSpeed v, sigmaMin), s = s_h ahead and
/// rearRatio s_h behind. Lower costs, including unknown cells, are increased to this value.
class SocialLayer final : public CostmapLayer {
 public:
  SocialLayer(std::string name, const CostmapContext& context,
              const SocialLayerParameters& parameters);

  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override;
  void updateCosts(Costmap& master, const CellWindow& window) override;
  void reset(double time) override;

  /// Cost at a position in the frame of a person [m] moving at a speed [m/s]; before rounding and
  /// cutoff.
  static double costAt(const SocialLayerParameters& parameters, const Vec2& place, double speed);

 private:
  struct Zone {
    Pose2 person;
    double speed = 0.0;  // [m/s]
    CostmapBounds bounds;
  };
  void raiseCosts(const Zone& zone, Costmap& master, const CellWindow& window) const;

  SocialLayerParameters parameters_;
  std::vector<Zone> zones_;
  CostmapBounds last_;  // area of the previous update, which must be cleared
};

}  // namespace sim2d::nav2
