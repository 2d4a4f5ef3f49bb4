#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"

/// What Nav2's smoothers share (nav2_smoother/simple_smoother.cpp, smoother_utils.hpp and the
/// smoother of nav2_smac_planner).
namespace sim2d::nav2 {

/// Poses of a path that are driven in one direction; both ends belong to it.
struct PathSegment {
  std::size_t first = 0, last = 0;
};

/// Ends a segment where the path turns back or the robot turns on the spot.
std::vector<PathSegment> directionalSegments(const Path& path);

/// Sets the headings, but the last, to the directions to the next pose, turned round where the
/// segment is driven backward. Whether it is; never with `isHolonomic`. At least three poses.
bool faceAlongSegment(Path& segment, bool isHolonomic);

struct SweepSettings {
  double tolerance = 1e-10;  // sum of the changes of a sweep below which it is done [m]
  int mostSweeps = 1000;
  double wData = 0.2, wSmooth = 0.3;
  int refinements = 0;  // how often the result is smoothed again
  bool isHolonomic = false;
};

enum class SweepEnd { Converged, MostSweeps, Obstacle, OutOfBudget };

/// Gauss-Seidel sweeps over all poses but the first and the last:
/// y_i += w_data (x_i - y_i) + w_smooth (y_(i+1) + y_(i-1) - 2 y_i). A sweep that leads into a cell
/// above 252 (255 is none) or off the map is undone and ends it. `budget`: poses that may still be
/// moved, reduced by those that were. The answer is that of the first round; refinements that end
/// early are kept as far as they came.
SweepEnd smoothBySweeps(Path& segment, const SweepSettings& settings, const Costmap& costmap,
                        long long& budget);

}  // namespace sim2d::nav2
