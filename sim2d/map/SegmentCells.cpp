#include "sim2d/map/SegmentCells.h"

#include <cassert>
#include <cmath>
#include <cstddef>

namespace sim2d {

Cell SegmentCells::cellAt(const Vec2& point) const {
  const Vec2 at = (point - origin_) / side_;
  const auto within = [](double value, int count) {  // NaN: the first
    return value > 0.0 ? static_cast<int>(std::min(value, count - 1.0)) : 0;
  };
  return {within(at.x(), width_), within(at.y(), height_)};
}

void SegmentCells::build(const std::vector<Segment>& segments, double side) {
  assert(side > 0.0);
  *this = SegmentCells();
  constexpr double kRounding = 1e-6;  // [m]
  std::vector<Item> small;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    const Item item{0.5 * (segment.a + segment.b), 0.5 * (segment.b - segment.a).norm() + kRounding,
                    static_cast<int>(i)};
    (item.half > side ? items_ : small).push_back(item);
  }
  long_ = items_.size();
  if (small.empty()) {
    return;
  }
  Vec2 low = small.front().middle;
  Vec2 high = low;
  for (const Item& item : small) {
    low = low.cwiseMin(item.middle);
    high = high.cwiseMax(item.middle);
    longest_ = std::max(longest_, item.half);
  }
  constexpr double kMostCells = 1e6;
  const Vec2 extent = high - low;
  side_ = std::max(
      {side, std::sqrt(extent.x() * extent.y() / kMostCells), extent.maxCoeff() / kMostCells});
  origin_ = low;
  width_ = static_cast<int>(extent.x() / side_) + 1;
  height_ = static_cast<int>(extent.y() / side_) + 1;
  const auto numberOf = [this](const Item& item) {
    const Cell cell = cellAt(item.middle);
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.column);
  };
  start_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) + 1, 0);
  for (const Item& item : small) {
    ++start_[numberOf(item) + 1];
  }
  start_.front() = long_;
  for (std::size_t i = 1; i < start_.size(); ++i) {
    start_[i] += start_[i - 1];
  }
  items_.resize(items_.size() + small.size());
  std::vector<std::size_t> fill(start_.begin(), start_.end() - 1);
  for (const Item& item : small) {
    items_[fill[numberOf(item)]++] = item;
  }
}

}  // namespace sim2d
