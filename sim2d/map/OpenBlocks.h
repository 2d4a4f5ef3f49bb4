#pragma once

#include <memory>
#include <vector>

#include "sim2d/map/DistanceField.h"

namespace sim2d {

/// Which blocks of cells no wall reaches into, so that a line of sight across such blocks alone
/// needs no look at the walls. Immutable; thread: any.
class OpenBlocks {
 public:
  explicit OpenBlocks(std::shared_ptr<const DistanceField> field);

  /// True: no wall stands in the rectangle, along the grid, about the two points. False: one may.
  bool areFree(const Vec2& from, const Vec2& to) const;

 private:
  bool covers(const Vec2& place) const;  // in blocks
  int wallsBelow(int column, int row) const;

  std::shared_ptr<const DistanceField> field_;
  int width_ = 0, height_ = 0;  // blocks
  double perCell_ = 1.0;        // blocks
  std::vector<int> below_;  // blocks with walls of lower column and row, (width + 1) x (height + 1)
};

}  // namespace sim2d
