#pragma once

#include <vector>

#include "sim2d/base/Types.h"

namespace sim2d {

using base::Vec2;

/// Neighbour search: a uniform grid over the points of one instant. Results come cell by cell,
/// within a cell by ascending index, so their order depends on the points only. Queries are
/// thread-safe, `rebuild` is not.
class NeighborGrid {
 public:
  /// Ignores points with `present` == 0.
  void rebuild(const std::vector<Vec2>& points, const std::vector<char>& present);

  /// Calls visit(index) for every point within `range` [m] of `centre`.
  template <class Visit>
  void forEachNear(const Vec2& centre, double range, Visit visit) const {
    const Span span = spanOf(centre, range);
    for (int row = span.row0; row <= span.row1; ++row) {
      for (int column = span.column0; column <= span.column1; ++column) {
        const auto cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                          static_cast<std::size_t>(column);
        const auto last = static_cast<std::size_t>(start_[cell + 1]);
        for (auto item = static_cast<std::size_t>(start_[cell]); item < last; ++item) {
          if ((points_[item] - centre).squaredNorm() <= range * range) {
            visit(items_[item]);
          }
        }
      }
    }
  }

 private:
  struct Span {
    int column0 = 0, column1 = -1, row0 = 0, row1 = -1;
  };
  Span spanOf(const Vec2& centre, double range) const;

  double cell_ = 2.0;  // [m]
  Vec2 origin_ = Vec2::Zero();
  int width_ = 0, height_ = 0;
  std::vector<int> start_, items_, cellOf_, next_;
  std::vector<Vec2> points_;
};

}  // namespace sim2d
