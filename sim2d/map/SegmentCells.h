#pragma once

#include <algorithm>
#include <vector>

#include "sim2d/map/Outlines.h"

namespace sim2d {

/// Which segments are near a point, each named once: unlike in SegmentGrid a segment lies in one
/// square alone, that of its middle. Immutable after build; safe to share between threads.
class SegmentCells {
 public:
  /// `side` of the squares that one would like [m]; they grow when there would be more than a
  /// million.
  void build(const std::vector<Segment>& segments, double side);

  /// visit(int segment) once for each that may come nearer than `range` [m] to the point, and
  /// perhaps for some that do not; in an order that is always the same.
  template <class Visit>
  void visitNear(const Vec2& point, double range, Visit visit) const;

 private:
  struct Item {
    Vec2 middle = Vec2::Zero();
    double half = 0.0;  // of the length [m], a little more
    int segment = 0;
  };
  Cell cellAt(const Vec2& point) const;  // within the squares
  template <class Visit>
  static void visitItems(const Item* from, const Item* to, const Vec2& point, double range,
                         Visit& visit);

  Vec2 origin_ = Vec2::Zero();
  double side_ = 1.0;     // [m]
  double longest_ = 0.0;  // half of the longest one in a square [m]
  int width_ = 0, height_ = 0;
  std::size_t long_ = 0;     // items at the front that are too long for a square
  std::vector<Item> items_;  // then square by square, row by row
  std::vector<std::size_t> start_;
};

template <class Visit>
void SegmentCells::visitItems(const Item* from, const Item* to, const Vec2& point, double range,
                              Visit& visit) {
  for (const Item* item = from; item != to; ++item) {
    const double within = range + item->half;
    if ((item->middle - point).squaredNorm() < within * within) {
      visit(item->segment);
    }
  }
}

template <class Visit>
void SegmentCells::visitNear(const Vec2& point, double range, Visit visit) const {
  if (items_.empty()) {
    return;
  }
  const Item* const items = items_.data();
  visitItems(items, items + long_, point, range, visit);
  if (width_ == 0) {
    return;
  }
  const Vec2 reach = Vec2::Constant(range + longest_);
  const Cell low = cellAt(point - reach);
  const Cell high = cellAt(point + reach);
  for (int row = low.row; row <= high.row; ++row) {
    const auto first = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
    visitItems(items + start_[first + static_cast<std::size_t>(low.column)],
               items + start_[first + static_cast<std::size_t>(high.column) + 1], point, range,
               visit);
  }
}

}  // namespace sim2d
