#pragma once

#include <vector>

#include "sim2d/nav/nav2/global/PathSmoother.h"

namespace sim2d::nav2 {

/// Weights of the poses of a window of 2 m + 1 for the value of the least-squares polynomial at its
/// centre (Savitzky and Golay, Anal. Chem. 36, 1964). 0 <= order <= 2 m.
std::vector<double> savitzkyGolayWeights(int window, int order);

/// nav2_smoother::SavitzkyGolaySmoother: replaces each pose by the centre value of a polynomial
/// through its neighbours. Before Main window 7 and order 3: (-2, 3, 6, 7, 6, 3, -2) / 21. Ignores
/// the costmap.
class SavitzkyGolaySmoother : public PathSmoother {
 public:
  SavitzkyGolaySmoother(const SavitzkyGolayParameters& parameters, Distro distro);

  SmoothResult smooth(const Path& path, const Costmap& costmap, double maxDuration) const override;

 private:
  void filter(Path& segment) const;

  SavitzkyGolayParameters parameters_;
  Distro distro_;
  std::vector<double> weights_;
};

}  // namespace sim2d::nav2
