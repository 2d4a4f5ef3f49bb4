#include "metrics/DensityField.h"

#include <algorithm>
#include <cmath>

namespace metrics {

using base::Vec2;

namespace {

constexpr double kKernel = 1.0 / (base::kPi * kDensityRadius * kDensityRadius);  // at its middle
constexpr double kReach = 3.0 * kDensityRadius;
constexpr double kMostAlong = 4096.0;  // cells of a side, of long narrow boxes

/// Which cells of one axis a person reaches, and the person's share in each of them.
struct AxisShares {
  int first = 0, end = 0;
  std::vector<float> shares;

  void take(double at, double low, double cell, int count) {
    const auto cellAt = [&](double place) {
      return static_cast<int>(std::clamp(std::floor((place - low) / cell), 0.0, count * 1.0));
    };
    first = cellAt(at - kReach);
    end = std::min(count, cellAt(at + kReach) + 1);
    shares.clear();
    for (int k = first; k < end; ++k) {
      const double off = (low + (k + 0.5) * cell - at) / kDensityRadius;
      shares.push_back(static_cast<float>(std::exp(-off * off)));
    }
  }
};

}  // namespace

double densityAt(const std::vector<Vec2>& people, const Vec2& place) {
  double sum = 0.0;
  for (const Vec2& person : people) {
    sum += std::exp(-(person - place).squaredNorm() / (kDensityRadius * kDensityRadius));
  }
  return kKernel * sum;
}

double DensityField::peak() const {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

DensityField densityField(const std::vector<Vec2>& people, const Vec2& low, const Vec2& high,
                          double cell, std::size_t mostCells) {
  DensityField field;
  const Vec2 size = (high - low).cwiseMax(0.0);
  const double least = std::sqrt(size.x() * size.y() / static_cast<double>(mostCells));
  field.low = low;
  const double mostAlong = std::min(kMostAlong, static_cast<double>(mostCells));
  field.cell = std::max({cell, least, size.maxCoeff() / mostAlong});
  field.columns = std::max(1, static_cast<int>(std::ceil(size.x() / field.cell)));
  field.rows = std::max(1, static_cast<int>(std::ceil(size.y() / field.cell)));
  const auto columns = static_cast<std::size_t>(field.columns);
  field.values.assign(columns * static_cast<std::size_t>(field.rows), 0.0F);
  AxisShares across;
  AxisShares up;
  for (const Vec2& person : people) {
    across.take(person.x(), low.x(), field.cell, field.columns);
    up.take(person.y(), low.y(), field.cell, field.rows);
    for (int row = up.first; row < up.end; ++row) {
      const float share = static_cast<float>(kKernel) * up.shares[std::size_t(row - up.first)];
      float* const line = field.values.data() + static_cast<std::size_t>(row) * columns;
      for (int column = across.first; column < across.end; ++column) {
        line[column] += share * across.shares[std::size_t(column - across.first)];
      }
    }
  }
  return field;
}

}  // namespace metrics
