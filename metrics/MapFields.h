#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/base/Types.h"

namespace metrics {

/// Personal space as a Gaussian that is elongated in walking direction: 1 at the person, decreasing
/// with distance. Person frame: x ahead, y to the left. Source: Kirby 2010, "Social Robot
/// Navigation", with the parameters of SRPB.
struct GaussianPersonalSpace {
  double ahead = 0.5, behind = 0.25, side = 1.0 / 3.0;  // variances [m²]

  /// Exponent; 0 at the person. The value of the Gaussian is exp(-outsideness).
  double outsideness(const base::Vec2& local) const {
    const double along = local.x() > 0.0 ? ahead : behind;
    return local.x() * local.x() / (2.0 * along) + local.y() * local.y() / (2.0 * side);
  }
};

/// Vf = max(2 |v|, 0.5) ahead, Vf/2 behind, 2/3 Vf to the sides.
GaussianPersonalSpace personalSpaceOf(double speed);  // [m/s]

/// Contour at `level`, 0 < level < 1: corners in the world frame [m], counter-clockwise from
/// straight ahead.
std::vector<base::Vec2> personalSpaceContour(const GaussianPersonalSpace& space,
                                             const base::Pose2& person, double level,
                                             int corners = 48);

/// Kernel radius R [m].
constexpr double kDensityRadius = 1.0;

/// Density of people at a point [1/m²]: the sum over people of exp(-d²/R²) / (pi R²), so that each
/// person contributes one in total. Source: Helbing, Johansson and Al-Abideen 2007, "Dynamics of
/// crowd disasters", with R = 1 m. Walls are ignored.
double densityAt(const std::vector<base::Vec2>& people, const base::Vec2& place);

/// The density at the centres of square cells. People farther than 3 R are ignored; their
/// contribution is below 4e-5 of one per m².
struct DensityField {
  base::Vec2 low = base::Vec2::Zero();  // corner of the first cell [m]
  double cell = 0.25;                   // side [m]
  int columns = 0, rows = 0;
  std::vector<float> values;  // [1/m²], row-major, ascending y

  base::Vec2 centreOf(int column, int row) const {
    return low + cell * base::Vec2(column + 0.5, row + 0.5);
  }
  float at(int column, int row) const {
    return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)];
  }
  double peak() const;  // 0 without cells
};

/// Density over the box from `low` to `high`, with at most about `mostCells` cells and 4096 along a
/// side; the cell size is increased if necessary.
DensityField densityField(const std::vector<base::Vec2>& people, const base::Vec2& low,
                          const base::Vec2& high, double cell = 0.25,
                          std::size_t mostCells = std::size_t{1} << 18);

}  // namespace metrics
