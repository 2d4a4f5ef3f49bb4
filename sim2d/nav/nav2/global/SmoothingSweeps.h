#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/global/PathSmoother.h"

/// Functions shared by Nav2's smoothers (nav2_smoother/simple_smoother.cpp, smoother_utils.hpp and
/// the smoother of nav2_smac_planner).
namespace sim2d::nav2 {

/// Poses of a path that are driven in one direction, including both ends.
struct PathSegment {
  std::size_t first = 0, last = 0;
};

/// Splits a path at cusps and turns in place.
std::vector<PathSegment> directionalSegments(const Path& path);

/// Sets all headings but the last to the direction to the next pose, reversed where the segment is
/// driven in reverse. Returns whether it is driven in reverse; false if `isHolonomic`.
/// Precondition: at least three poses.
bool orientSegment(Path& segment, bool isHolonomic);

struct SweepSettings {
  double tolerance = 1e-10;  // sum of changes of a sweep at convergence [m]
  int maxSweeps = 1000;
  double wData = 0.2, wSmooth = 0.3;
  int refinements = 0;  // how often the result is smoothed again
  bool isHolonomic = false;
};

enum class SweepResult { Converged, MaxSweeps, Obstacle, OutOfBudget };

/// Gauss-Seidel sweeps over all poses except the first and the last: y_i += w_data (x_i - y_i) +
/// w_smooth (y_(i+1) + y_(i-1) - 2 y_i). A sweep that enters a cell above 252 (except 255) or
/// leaves the map is undone and ends the smoothing. `budget`: number of poses that may still be
/// moved; reduced by the moved ones. Returns the result of the first round; refinements that end
/// early keep their current state.
SweepResult smoothBySweeps(Path& segment, const SweepSettings& settings, const Costmap& costmap,
                           long long& budget);

/// nav2_smoother::SimpleSmoother: sweeps (SmoothingSweeps.h) over each segment that is driven in
/// one direction, if it is long enough. When the limit is reached, Humble keeps the current state,
/// later branches return Timeout.
class SimpleSmoother : public PathSmoother {
 public:
  SimpleSmoother(const SimpleSmootherParameters& parameters, Distro distro);

  SmoothResult smooth(const Path& path, const Costmap& costmap, double maxDuration) const override;

 private:
  SimpleSmootherParameters parameters_;
  Distro distro_;
};

}  // namespace sim2d::nav2
