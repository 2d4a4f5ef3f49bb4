#pragma once

#include <vector>

#include "sim2d/nav/nav2/global/PathSmoother.h"

namespace sim2d::nav2 {

/// A pose of the optimization: position and direction of the following movement.
struct ConstrainedPose {
  Vec2 position = Vec2::Zero();  // [m]
  double direction = 1.0;        // 1 forward, -1 backward
};

/// Least squares over all poses except the ends (nav2_constrained_smoother::ConstrainedSmoother).
/// Each inner pose p between its neighbours a and b has four residuals, whose squares are summed:
///   w_smooth |ratio (b - p) - (p - a)|²        ratio = |p - a| / |b - p| of the given path;
///                                              negative at a cusp
///   w_curve (1/r - 1/minimum_turning_radius)²  for arcs with a radius r below the minimum
///   w_dist |p - p_given|²
///   weight cost(p)²                            costmap, interpolated with cubic splines; or
///                                              at points of the robot (cost_check_points)
/// The weight is w_cost, and near a cusp up to w_cost_cusp_multiplier times w_cost. The minimum is
/// found by Levenberg-Marquardt with the rules of Ceres Solver 2 (Agarwal, Mierle and others),
/// which Nav2 uses, in a fixed order of operations.
class ConstrainedSmoother final : public PathSmoother {
 public:
  explicit ConstrainedSmoother(const ConstrainedSmootherParameters& parameters);

  /// FailedToSmoothPath for a path of one pose. `maxDuration` [s] limits the iterations: 1000 poses
  /// in a million per second.
  SmoothResult smooth(const Path& path, const Costmap& costmap, double maxDuration) const override;

 private:
  ConstrainedSmootherParameters parameters_;
};

}  // namespace sim2d::nav2
