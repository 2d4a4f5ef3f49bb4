#include "sim2d/map/NearestMark.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace sim2d {

namespace {

constexpr std::int64_t kNoMark = std::numeric_limits<std::int64_t>::max();

/// [half cells] from the middle of a cell to what lies between two borders, along one axis.
std::int64_t offsetTo(std::int64_t middle, std::int64_t low, std::int64_t high) {
  return std::max({std::int64_t{0}, low - middle, middle - high});
}

}  // namespace

NearestMark::NearestMark(int width, int height) {
  assert(width > 0 && height > 0);
  do {
    const int columns = (width + 7) / 8;
    const int rows = (height + 7) / 8;
    levels_.push_back({columns, std::vector<Block>(static_cast<std::size_t>(columns) *
                                                   static_cast<std::size_t>(rows))});
    width = columns;
    height = rows;
  } while (width > 1 || height > 1);
}

void NearestMark::summarise() {
  for (std::size_t k = 1; k < levels_.size(); ++k) {
    const Level& below = levels_[k - 1];
    for (std::size_t i = 0; i < below.blocks.size(); ++i) {
      const auto columns = static_cast<std::size_t>(below.columns);
      const Cell block{static_cast<int>(i % columns), static_cast<int>(i / columns)};
      if (below.blocks[i] != 0) {
        levels_[k].blocks[indexOf(levels_[k], block)] |= bitOf(block);
      }
    }
  }
}

/// From the whole down, nearer blocks first; what cannot be nearer than the best is not entered.
struct NearestMark::Search {
  const std::vector<Level>& levels;
  std::int64_t column, row;     // [half cells] of the middle of the cell
  std::int64_t best = kNoMark;  // squared

  /// The block whose first bit is this cell of its level.
  void enter(std::size_t level, Cell first) {
    struct Part {
      std::int64_t square = 0;
      Cell cell;
    };
    std::array<Part, 64> parts;
    std::size_t count = 0;
    const std::int64_t side = std::int64_t{2} << (3 * level);  // [half cells]
    for (Block rest = blockOf(levels[level], first); rest != 0; rest &= rest - 1) {
      const int bit = __builtin_ctzll(rest);
      const Cell cell{first.column + bit % 8, first.row + bit / 8};
      const std::int64_t x = offsetTo(column, side * cell.column, side * (cell.column + 1));
      const std::int64_t y = offsetTo(row, side * cell.row, side * (cell.row + 1));
      if (x * x + y * y < best) {
        if (level == 0) {
          best = x * x + y * y;
        } else {
          parts[count++] = {x * x + y * y, cell};
        }
      }
    }
    while (count > 0) {
      const auto end = parts.begin() + static_cast<std::ptrdiff_t>(count);
      const auto nearest = std::min_element(
          parts.begin(), end, [](const Part& a, const Part& b) { return a.square < b.square; });
      if (nearest->square >= best) {
        return;
      }
      const Cell cell = nearest->cell;
      *nearest = parts[--count];
      enter(level - 1, {8 * cell.column, 8 * cell.row});
    }
  }
};

float NearestMark::distance(Cell cell) const {
  Search search{levels_, 2 * std::int64_t{cell.column} + 1, 2 * std::int64_t{cell.row} + 1};
  search.enter(levels_.size() - 1, {0, 0});
  return search.best == kNoMark
             ? std::numeric_limits<float>::infinity()
             : static_cast<float>(std::sqrt(static_cast<double>(search.best) / 4.0));
}

std::size_t NearestMark::bytes() const {
  std::size_t blocks = 0;
  for (const Level& level : levels_) {
    blocks += level.blocks.size();
  }
  return sizeof(Block) * blocks;
}

}  // namespace sim2d
