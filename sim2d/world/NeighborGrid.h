#pragma once

#include <vector>

#include "sim2d/base/Types.h"

namespace sim2d {

using base::Vec2;

/// Who is near a place: a uniform grid over the points of one instant. Answers come cell by cell,
/// inside a cell by ascending index, so their order depends on the points alone. Thread: queries
/// any, `rebuild` alone.
class NeighborGrid {
 public:
  explicit NeighborGrid(double cell = 2.0) : wantedCell_(cell) {}

  /// Only points with `present` != 0 count.
  void rebuild(const std::vector<double>& x, const std::vector<double>& y,
               const std::vector<char>& present);

  /// Calls visit(index) for every point within `range` [m] of `centre`.
  template <class Visit>
  void forEachNear(const Vec2& centre, double range, Visit visit) const {
    const Span span = spanOf(centre, range);
    for (int row = span.row0; row <= span.row1; ++row) {
      for (int column = span.column0; column <= span.column1; ++column) {
        visitCell(row * width_ + column, centre, range * range, visit);
      }
    }
  }

 private:
  struct Span {
    int column0 = 0, column1 = -1, row0 = 0, row1 = -1;
  };
  Span spanOf(const Vec2& centre, double range) const;

  template <class Visit>
  void visitCell(int cell, const Vec2& centre, double squaredRange, Visit& visit) const {
    const auto at = static_cast<std::size_t>(cell);
    for (int slot = start_[at]; slot < start_[at + 1]; ++slot) {
      const auto item = static_cast<std::size_t>(slot);
      if ((points_[item] - centre).squaredNorm() <= squaredRange) {
        visit(items_[item]);
      }
    }
  }

  double wantedCell_;
  double cell_ = 2.0;  // [m]
  Vec2 origin_ = Vec2::Zero();
  int width_ = 0, height_ = 0;
  std::vector<int> start_, items_, cellOf_, next_;
  std::vector<Vec2> points_;
};

}  // namespace sim2d
