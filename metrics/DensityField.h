#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/base/Types.h"

namespace metrics {

/// R of the kernel [m].
constexpr double kDensityRadius = 1.0;

/// How dense people stand at a place [1/m²]: the sum over people of exp(-d²/R²) / (pi R²), so that
/// each is one person in all. Source: Helbing, Johansson and Al-Abideen 2007, "Dynamics of crowd
/// disasters", with their R = 1 m. Walls are not heeded.
double densityAt(const std::vector<base::Vec2>& people, const base::Vec2& place);

/// The same at the centres of square cells. Nobody counts farther away than 3 R, where a person is
/// 4e-5 of one per m².
struct DensityField {
  base::Vec2 low = base::Vec2::Zero();  // corner of the first cell [m]
  double cell = 0.25;                   // side [m]
  int columns = 0, rows = 0;
  std::vector<float> values;  // [1/m²], row by row, y rising

  base::Vec2 centreOf(int column, int row) const {
    return low + cell * base::Vec2(column + 0.5, row + 0.5);
  }
  float at(int column, int row) const {
    return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)];
  }
  double peak() const;  // 0 without cells
};

/// Over the box from `low` to `high`, of at most about `mostCells` cells, and 4096 along a side:
/// they grow where there would be more.
DensityField densityField(const std::vector<base::Vec2>& people, const base::Vec2& low,
                          const base::Vec2& high, double cell = 0.25,
                          std::size_t mostCells = std::size_t{1} << 18);

}  // namespace metrics
