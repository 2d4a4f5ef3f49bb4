#include "sim2d/map/OccupancyGrid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace sim2d {

namespace {

int floorToInt(double value) {
  constexpr double kLimit = 1e9;
  if (std::isnan(value)) {
    return -1;
  }
  return static_cast<int>(std::floor(std::clamp(value, -kLimit, kLimit)));
}

}  // namespace

OccupancyGrid::OccupancyGrid(int width, int height, double resolution, Pose2 origin,
                             std::vector<std::int8_t> cells)
    : width_(width),
      height_(height),
      resolution_(resolution),
      origin_(std::move(origin)),
      cells_(std::make_shared<const std::vector<std::int8_t>>(std::move(cells))) {
  assert(width > 0 && height > 0 && resolution > 0.0);
  assert(cells_->size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  if (origin_.heading != 0.0) {
    axis_ = origin_.direction();
  }
}

const std::vector<std::int8_t>& OccupancyGrid::cells() const {
  static const std::vector<std::int8_t> kNone;
  return cells_ != nullptr ? *cells_ : kNone;
}

Vec2 OccupancyGrid::worldToCorner(const Vec2& point) const {
  const Vec2 offset = point - origin_.position;
  return Vec2(offset.dot(axis_), base::cross(axis_, offset)) / resolution_;
}

Cell OccupancyGrid::worldToCell(const Vec2& point) const {
  const Vec2 corner = worldToCorner(point);
  return {floorToInt(corner.x()), floorToInt(corner.y())};
}

Vec2 OccupancyGrid::cornerToWorld(double column, double row) const {
  const Vec2 left(-axis_.y(), axis_.x());
  return origin_.position + column * resolution_ * axis_ + row * resolution_ * left;
}

bool operator==(const OccupancyGrid& a, const OccupancyGrid& b) {
  return a.width_ == b.width_ && a.height_ == b.height_ && a.resolution_ == b.resolution_ &&
         a.origin_ == b.origin_ && (a.cells_ == b.cells_ || a.cells() == b.cells());
}

}  // namespace sim2d
