#include "metrics/MapFields.h"

#include <algorithm>
#include <cmath>

namespace metrics {

using base::Vec2;

GaussianPersonalSpace personalSpaceOf(double speed) {
  const double front = std::max(2.0 * speed, 0.5);
  return {front, front / 2.0, front * 2.0 / 3.0};
}

std::vector<Vec2> personalSpaceContour(const GaussianPersonalSpace& space,
                                       const base::Pose2& person, double level, int corners) {
  const double reach = -2.0 * std::log(level);  // squared distance for a variance of 1 m²
  const double side = std::sqrt(space.side * reach);
  const Vec2 ahead = base::directionOf(person.heading);
  const Vec2 left(-ahead.y(), ahead.x());
  std::vector<Vec2> contour;
  contour.reserve(static_cast<std::size_t>(corners));
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * base::kPi * k / corners;
    const double along = std::cos(angle);
    const double half = std::sqrt((along > 0.0 ? space.ahead : space.behind) * reach);
    contour.push_back(person.position + half * along * ahead + side * std::sin(angle) * left);
  }
  return contour;
}

namespace {

constexpr double kKernel = 1.0 / (base::kPi * kDensityRadius * kDensityRadius);  // at its centre
constexpr double kReach = 3.0 * kDensityRadius;
constexpr double kMostAlong = 4096.0;  // cells along a side, for long narrow boxes

/// The cells of one axis within a person's reach, and the person's share in each.
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
