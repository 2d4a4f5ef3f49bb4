#pragma once

#include <vector>

#include "sim2d/base/Types.h"

namespace metrics {

/// The space of a person as a Gaussian, longer ahead of who walks and shorter behind: 1 at the
/// person, the less the farther away. Person frame: x ahead, y to the left. Source: Kirby 2010,
/// "Social Robot Navigation", with the numbers of SRPB.
struct GaussianSpace {
  double ahead = 0.5, behind = 0.25, side = 1.0 / 3.0;  // variances [m²]

  /// 0 at the person: the value there is exp(-outsideness).
  double outsideness(const base::Vec2& local) const {
    const double along = local.x() > 0.0 ? ahead : behind;
    return local.x() * local.x() / (2.0 * along) + local.y() * local.y() / (2.0 * side);
  }
};

/// Vf = max(2 |v|, 0.5) ahead, Vf/2 behind, 2/3 Vf to the sides.
GaussianSpace gaussianSpaceOf(double speed);  // [m/s]

/// Where the value is `level`, 0 < level < 1: corners in the world frame [m], counter-clockwise
/// from straight ahead.
std::vector<base::Vec2> contourOf(const GaussianSpace& space, const base::Pose2& person,
                                  double level, int corners = 48);

}  // namespace metrics
