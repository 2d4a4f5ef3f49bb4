#pragma once

#include <string>
#include <vector>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"

namespace sim2d::nav2 {

/// Costs round people whom the detector tells, ours (Kirby 2010, appendix A: halves of two
/// Gaussians). In a person's frame, x ahead, y to the left:
/// amplitude exp(-x² / (2 s²) - y² / (2 (sideRatio s_h)²)), s_h = max(sigmaPerSpeed v, sigmaMin),
/// s = s_h ahead and rearRatio s_h behind. Costs are raised to it, unknown cells too.
class SocialLayer final : public CostmapLayer {
 public:
  SocialLayer(std::string name, const CostmapContext& context,
              const SocialLayerParameters& parameters);

  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override;
  void updateCosts(Costmap& master, const CellWindow& window) override;
  void reset(double time) override;

  /// At a place in the person's frame [m], moving at a speed [m/s]; before rounding and cutoff.
  static double costAt(const SocialLayerParameters& parameters, const Vec2& place, double speed);

 private:
  struct Zone {
    Pose2 person;
    double speed = 0.0;  // [m/s]
    CostmapBounds bounds;
  };
  void raise(const Zone& zone, Costmap& master, const CellWindow& window) const;

  SocialLayerParameters parameters_;
  std::vector<Zone> zones_;
  CostmapBounds last_;  // of the update before, which has to be wiped
};

}  // namespace sim2d::nav2
