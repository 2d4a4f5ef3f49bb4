#include "sim2d/map/BorderCells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace sim2d {

namespace {

constexpr std::size_t kChildren = 8;  // of a box

double squaredDistance(const Vec2& corner, Cell cell) {
  const double x = std::max(0.0, std::fabs(corner.x() - cell.column - 0.5) - 0.5);
  const double y = std::max(0.0, std::fabs(corner.y() - cell.row - 0.5) - 0.5);
  return x * x + y * y;
}

}  // namespace

struct BorderCells::Search {
  const BorderCells& border;
  Vec2 corner;
  double best = std::numeric_limits<double>::infinity();  // squared
  std::size_t examined = 0;

  /// Slightly less than the squared distance of each cell in the box.
  double bound(const Box& box) {
    constexpr double kRounding = 1.0 - 1e-9;
    ++examined;
    const double x =
        std::max({0.0, box.low.column - corner.x(), corner.x() - box.high.column - 1.0});
    const double y = std::max({0.0, box.low.row - corner.y(), corner.y() - box.high.row - 1.0});
    return kRounding * (x * x + y * y);
  }

  /// The children of a box: of level 0 cells, of others boxes of the level before.
  void enter(std::size_t level, std::size_t index) {
    const std::size_t first = kChildren * index;
    if (level == 0) {
      const std::size_t end = std::min(first + kChildren, border.cells_.size());
      for (std::size_t k = first; k < end; ++k) {
        ++examined;
        best = std::min(best, squaredDistance(corner, border.cells_[k]));
      }
      return;
    }
    const std::vector<Box>& boxes = border.levels_[level - 1];
    const std::size_t count = std::min(kChildren, boxes.size() - first);
    std::array<std::pair<double, std::size_t>, kChildren> children;
    for (std::size_t k = 0; k < count; ++k) {
      children[k] = {bound(boxes[first + k]), first + k};
    }
    std::sort(children.begin(), children.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t k = 0; k < count && children[k].first < best; ++k) {
      enter(level - 1, children[k].second);
    }
  }
};

void BorderCells::build(std::vector<Cell> cells) {
  cells_ = std::move(cells);
  std::vector<Box> below;
  below.reserve(cells_.size());
  std::transform(cells_.begin(), cells_.end(), std::back_inserter(below), [](Cell cell) {
    return Box{cell, cell};
  });
  levels_.clear();
  while (below.size() > 1) {
    std::vector<Box> level;
    level.reserve((below.size() + kChildren - 1) / kChildren);
    for (std::size_t k = 0; k < below.size(); ++k) {
      if (k % kChildren == 0) {
        level.push_back(below[k]);
        continue;
      }
      Box& box = level.back();
      box.low = {std::min(box.low.column, below[k].low.column),
                 std::min(box.low.row, below[k].low.row)};
      box.high = {std::max(box.high.column, below[k].high.column),
                  std::max(box.high.row, below[k].high.row)};
    }
    levels_.push_back(level);
    below = std::move(level);
  }
}

double BorderCells::distance(const Vec2& corner, std::size_t* examined) const {
  Search search{*this, corner};
  if (!cells_.empty()) {
    search.enter(levels_.empty() ? 0 : levels_.size() - 1, 0);
  }
  if (examined != nullptr) {
    *examined += search.examined;
  }
  return std::sqrt(search.best);
}

std::size_t BorderCells::bytes() const {
  std::size_t boxes = 0;
  for (const std::vector<Box>& level : levels_) {
    boxes += level.capacity();
  }
  return sizeof(Cell) * cells_.capacity() + sizeof(Box) * boxes;
}

}  // namespace sim2d
