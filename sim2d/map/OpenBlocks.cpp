#include "sim2d/map/OpenBlocks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sim2d {
namespace {

constexpr double kBlock = 0.5;       // [m]
constexpr double kMostBlocks = 1e6;  // coarser beyond
constexpr double kNearWall = 1.5;    // [cells] from the middle of a cell: a wall may reach into it

int cellsPerBlock(const OccupancyGrid& grid) {
  const double cells = static_cast<double>(grid.width()) * grid.height();
  const double usual = kBlock / grid.resolution();
  return static_cast<int>(std::ceil(std::max({1.0, usual, std::sqrt(cells / kMostBlocks)})));
}

}  // namespace

OpenBlocks::OpenBlocks(std::shared_ptr<const DistanceField> field) : field_(std::move(field)) {
  const OccupancyGrid& grid = field_->grid();
  const int cells = cellsPerBlock(grid);
  width_ = (grid.width() + cells - 1) / cells;
  height_ = (grid.height() + cells - 1) / cells;
  perCell_ = 1.0 / cells;
  const auto stride = static_cast<std::size_t>(width_) + 1;
  below_.assign(stride * (static_cast<std::size_t>(height_) + 1), 0);
  const double near = kNearWall * grid.resolution();
  for (int row = 0; row < grid.height(); ++row) {
    int* const ofRow = &below_[(static_cast<std::size_t>(row / cells) + 1) * stride + 1];
    for (int column = 0; column < grid.width(); ++column) {
      if (field_->distanceAt(Cell{column, row}) <= near) {
        ofRow[column / cells] = 1;
      }
    }
  }
  for (std::size_t i = stride; i < below_.size(); ++i) {
    if (i % stride != 0) {
      below_[i] += below_[i - 1] + below_[i - stride] - below_[i - stride - 1];
    }
  }
}

int OpenBlocks::wallsBelow(int column, int row) const {
  return below_[static_cast<std::size_t>(row) * (static_cast<std::size_t>(width_) + 1) +
                static_cast<std::size_t>(column)];
}

bool OpenBlocks::covers(const Vec2& place) const {
  return place.x() >= 0.0 && place.y() >= 0.0 && place.x() < width_ && place.y() < height_;
}

bool OpenBlocks::areFree(const Vec2& from, const Vec2& to) const {
  const Vec2 a = perCell_ * field_->grid().worldToCorner(from);
  const Vec2 b = perCell_ * field_->grid().worldToCorner(to);
  if (!covers(a) || !covers(b)) {
    return false;
  }
  const Vec2 low = a.cwiseMin(b);
  const Vec2 high = a.cwiseMax(b);
  const auto left = static_cast<int>(low.x());
  const auto bottom = static_cast<int>(low.y());
  const int right = static_cast<int>(high.x()) + 1;
  const int top = static_cast<int>(high.y()) + 1;
  return wallsBelow(right, top) - wallsBelow(left, top) - wallsBelow(right, bottom) +
             wallsBelow(left, bottom) ==
         0;
}

}  // namespace sim2d
