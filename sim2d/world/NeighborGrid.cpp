#include "sim2d/world/NeighborGrid.h"

#include <algorithm>
#include <cmath>

#include "sim2d/world/StepBuffers.h"

namespace sim2d {
namespace {

constexpr double kWantedCell = 2.0;  // [m]
constexpr double kMaxCells = 250000.0;

int clampedCell(double value, int count) {
  return static_cast<int>(std::clamp(std::floor(value), 0.0, static_cast<double>(count - 1)));
}

}  // namespace

void NeighborGrid::rebuild(const std::vector<Vec2>& points, const std::vector<char>& present) {
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (present[i] == 0) {
      continue;
    }
    low = count == 0 ? points[i] : Vec2(low.cwiseMin(points[i]));
    high = count == 0 ? points[i] : Vec2(high.cwiseMax(points[i]));
    ++count;
  }
  const Vec2 size = high - low;
  const double fewest = std::sqrt(size.x() * size.y() / kMaxCells);
  cell_ = std::max({kWantedCell, fewest, std::max(size.x(), size.y()) / kMaxCells});
  origin_ = low;
  width_ = count == 0 ? 0 : static_cast<int>(size.x() / cell_) + 1;
  height_ = count == 0 ? 0 : static_cast<int>(size.y() / cell_) + 1;
  cellOf_.assign(points.size(), -1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (present[i] != 0) {
      cellOf_[i] = clampedCell((points[i].y() - low.y()) / cell_, height_) * width_ +
                   clampedCell((points[i].x() - low.x()) / cell_, width_);
    }
  }
  sortByCell(cellOf_, static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), start_,
             next_, items_);
  points_.resize(count, Vec2::Zero());
  for (std::size_t slot = 0; slot < count; ++slot) {
    points_[slot] = points[static_cast<std::size_t>(items_[slot])];
  }
}

NeighborGrid::Span NeighborGrid::spanOf(const Vec2& centre, double range) const {
  if (width_ == 0) {
    return {};
  }
  const Vec2 low = (centre - origin_ - Vec2(range, range)) / cell_;
  const Vec2 high = (centre - origin_ + Vec2(range, range)) / cell_;
  if (high.x() < 0.0 || high.y() < 0.0 || low.x() >= width_ || low.y() >= height_) {
    return {};
  }
  return {clampedCell(low.x(), width_), clampedCell(high.x(), width_),
          clampedCell(low.y(), height_), clampedCell(high.y(), height_)};
}

}  // namespace sim2d
