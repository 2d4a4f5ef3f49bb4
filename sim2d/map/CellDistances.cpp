#include "sim2d/map/CellDistances.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

namespace sim2d {

namespace {

constexpr float kNowhere = std::numeric_limits<float>::infinity();

float stepFrom(float neighbour) {
  return neighbour == 0.0F ? 0.5F : neighbour + 1.0F;
}

std::uint16_t stepFrom(std::uint16_t neighbour) {
  constexpr int kCell = static_cast<int>(kStepsPerCell);
  const int far = neighbour == 0 ? kCell / 2 : neighbour + kCell;
  return static_cast<std::uint16_t>(std::min<int>(far, kMaxSteps));
}

std::uint16_t stepsOf(float steps) {
  return static_cast<std::uint16_t>(std::min(steps, static_cast<float>(kMaxSteps)));
}

/// Distances within each column.
template <class Value>
std::vector<Value> columnDistances(std::size_t width, std::size_t height,
                                   const std::vector<char>& marked, Value none,
                                   const base::StopFlag& stop) {
  std::vector<Value> distance(marked.size());
  for (std::size_t row = 0; row < height; ++row) {
    stop.check();
    for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
      distance[i] = marked[i] != 0 ? Value{0} : (row == 0 ? none : stepFrom(distance[i - width]));
    }
  }
  for (std::size_t row = height - 1; row-- > 0;) {
    stop.check();
    for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
      distance[i] = std::min(distance[i], stepFrom(distance[i + width]));
    }
  }
  return distance;
}

/// Combines the column distances along one row. The nearest square in another column is reached at
/// its left or right border, so the parabolas are placed on the borders k - 0.5.
class RowPass {
 public:
  explicit RowPass(std::size_t width) : width_(width), height_(width + 1) {
    borders_.reserve(width + 1);
    from_.reserve(width + 1);
  }

  void run(float* row) {
    buildEnvelope(row);
    std::size_t at = 0;
    for (std::size_t x = 0; x < width_ && !borders_.empty(); ++x) {
      const auto place = static_cast<double>(x);
      while (at + 1 < borders_.size() && from_[at + 1] < place) {
        ++at;
      }
      const double offset = place - positionOf(borders_[at]);
      const double square = offset * offset + height_[borders_[at]];
      row[x] = std::min(row[x], static_cast<float>(std::sqrt(square)));
    }
  }

 private:
  static double positionOf(std::size_t border) { return static_cast<double>(border) - 0.5; }

  void buildEnvelope(const float* row) {
    borders_.clear();
    from_.clear();
    for (std::size_t border = 0; border <= width_; ++border) {
      const std::size_t right = std::min(border, width_ - 1);
      const std::size_t left = border > 0 ? border - 1 : 0;
      const double lower = std::min(row[left], row[right]);
      if (std::isinf(lower)) {
        continue;
      }
      height_[border] = lower * lower;
      double start = -std::numeric_limits<double>::infinity();
      while (!borders_.empty()) {
        start = crossing(borders_.back(), border);
        if (start > from_.back()) {
          break;
        }
        borders_.pop_back();
        from_.pop_back();
        start = -std::numeric_limits<double>::infinity();
      }
      borders_.push_back(border);
      from_.push_back(start);
    }
  }

  double crossing(std::size_t first, std::size_t second) const {
    const double a = positionOf(first);
    const double b = positionOf(second);
    return (height_[second] + b * b - height_[first] - a * a) / (2.0 * (b - a));
  }

  std::size_t width_;
  std::vector<double> height_;        // squared, by border
  std::vector<std::size_t> borders_;  // of the lower envelope
  std::vector<double> from_;          // where each parabola begins
};

constexpr std::int64_t kNoMark = std::numeric_limits<std::int64_t>::max();

/// [half cells] from a cell centre to the interval [low, high] along one axis; 0 inside.
std::int64_t offsetTo(std::int64_t middle, std::int64_t low, std::int64_t high) {
  return std::max({std::int64_t{0}, low - middle, middle - high});
}

}  // namespace

std::vector<float> distancesToMarked(int width, int height, const std::vector<char>& marked,
                                     const base::StopFlag& stop) {
  assert(width > 0 && height > 0);
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  assert(marked.size() == columns * rows);
  std::vector<float> distance = columnDistances(columns, rows, marked, kNowhere, stop);
  RowPass pass(columns);
  for (std::size_t row = 0; row < rows; ++row) {
    stop.check();
    pass.run(distance.data() + row * columns);
  }
  return distance;
}

std::vector<std::uint16_t> quantizedDistancesToMarked(int width, int height,
                                                      const std::vector<char>& marked,
                                                      const base::StopFlag& stop) {
  assert(width > 0 && height > 0);
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  std::vector<std::uint16_t> steps = columnDistances(columns, rows, marked, kMaxSteps, stop);
  RowPass pass(columns);
  std::vector<float> cells(columns);
  for (std::size_t row = 0; row < rows; ++row) {
    stop.check();
    std::uint16_t* const of = steps.data() + row * columns;
    std::transform(of, of + columns, cells.begin(), [](std::uint16_t value) {
      return value == kMaxSteps ? kNowhere : static_cast<float>(value) / kStepsPerCell;
    });
    pass.run(cells.data());
    std::transform(cells.begin(), cells.end(), of,
                   [](float value) { return stepsOf(value * kStepsPerCell); });
  }
  return steps;
}

CellDistances::CellDistances(int width, int height, const std::vector<char>& marked, float cell,
                             bool isQuantized, const base::StopFlag& stop)
    : step_(cell / kStepsPerCell) {
  if (isQuantized) {
    const bool isAny = std::find(marked.begin(), marked.end(), char{1}) != marked.end();
    saturatedValue_ = isAny ? static_cast<float>(kMaxSteps) * step_ : kNowhere;
    steps_ = quantizedDistancesToMarked(width, height, marked, stop);
    return;
  }
  exact_ = distancesToMarked(width, height, marked, stop);
  for (float& value : exact_) {
    value *= cell;
  }
}

void CellDistances::set(std::size_t index, float distance) {
  if (steps_.empty()) {
    exact_[index] = distance;
  } else {
    steps_[index] = stepsOf(distance / step_);
  }
}

void CellDistances::replaceInfinite(float distance) {
  const auto isFinite = [](float value) { return std::isfinite(value); };
  if (std::any_of(exact_.begin(), exact_.end(), isFinite)) {
    std::replace(exact_.begin(), exact_.end(), kNowhere, distance);
  }
  const auto isNear = [](std::uint16_t value) { return value < kMaxSteps; };
  if (std::isinf(saturatedValue_) && std::any_of(steps_.begin(), steps_.end(), isNear)) {
    saturatedValue_ = std::min(distance, static_cast<float>(kMaxSteps) * step_);
  }
}

MarkedCellIndex::MarkedCellIndex(int width, int height) {
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

void MarkedCellIndex::buildLevels() {
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

/// Branch and bound from the top level down, nearer blocks first.
struct MarkedCellIndex::Search {
  const std::vector<Level>& levels;
  std::int64_t column, row;     // [half cells], centre of the query cell
  std::int64_t best = kNoMark;  // squared

  /// Visits the block whose first bit is the cell `first` of its level.
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

float MarkedCellIndex::distance(Cell cell) const {
  Search search{levels_, 2 * std::int64_t{cell.column} + 1, 2 * std::int64_t{cell.row} + 1};
  search.enter(levels_.size() - 1, {0, 0});
  return search.best == kNoMark
             ? std::numeric_limits<float>::infinity()
             : static_cast<float>(std::sqrt(static_cast<double>(search.best) / 4.0));
}

std::size_t MarkedCellIndex::bytes() const {
  std::size_t blocks = 0;
  for (const Level& level : levels_) {
    blocks += level.blocks.size();
  }
  return sizeof(Block) * blocks;
}

bool extendBeyondGrid(const OccupancyGrid& grid, const Obstacles& obstacles) {
  const auto isOutside = [&](const Vec2& point) {
    constexpr double kEdge = 0.6;  // [cells]; the map's own outlines may lie on the grid's edge
    const Vec2 corner = grid.worldToCorner(point);
    return corner.minCoeff() < -kEdge || corner.x() > grid.width() + kEdge ||
           corner.y() > grid.height() + kEdge;
  };
  for (int part = 0; part < obstacles.partCount(); ++part) {
    for (const Outline& outline : obstacles.outlines(part)) {
      if (obstacles.isEnabled(part) &&
          std::any_of(outline.points.begin(), outline.points.end(), isOutside)) {
        return true;
      }
    }
  }
  return false;
}

ObstacleClearance::ObstacleClearance(const OccupancyGrid& grid, const Obstacles& obstacles)
    : grid_(grid),
      obstacles_(obstacles),
      size_(static_cast<float>(grid.resolution())),
      limit_(kExactRange + 2.0 * grid.resolution()),
      edge_(extendBeyondGrid(grid, obstacles) ? static_cast<int>(limit_ / grid.resolution()) : 0) {}

float ObstacleClearance::lowered(Cell cell, float distance, float toCovered) const {
  const float rough = size_ * toCovered;  // covered cells overestimate by up to one cell
  const bool isNearEdge = std::min({cell.column, grid_.width() - 1 - cell.column, cell.row,
                                    grid_.height() - 1 - cell.row}) < edge_;
  if (rough >= distance && !isNearEdge) {
    return distance;
  }
  if (toCovered == 0.0F) {
    return 0.0F;
  }
  const bool isFar = rough > static_cast<float>(kExactRange);
  const float far = std::min(distance, rough + 0.5F * size_);
  if (isFar && !isNearEdge) {
    return far;
  }
  const double exact = obstacles_.clearance(grid_.cellToWorld(cell), limit_);
  return exact < limit_ ? std::min(distance, static_cast<float>(std::max(0.0, exact))) : far;
}

LazyDistances::LazyDistances(const OccupancyGrid& grid, const Obstacles& obstacles,
                             const std::vector<char>& covered, const base::StopFlag& stop)
    : grid_(grid),
      walls_(
          grid.width(), grid.height(), [&grid](Cell cell) { return grid.isWall(cell); }, stop),
      covered_(
          grid.width(), grid.height(), [&](Cell cell) { return covered[grid.indexOf(cell)] != 0; },
          stop),
      unknown_(
          grid.width(), grid.height(),
          [&](Cell cell) { return grid.isUnknown(cell) && !covered_.isMarked(cell); }, stop),
      pass_(grid_, obstacles),
      isLowered_(covered_.isAny() || extendBeyondGrid(grid, obstacles)) {}

float LazyDistances::at(std::size_t index) const {
  const auto columns = static_cast<std::size_t>(grid_.width());
  const Cell cell{static_cast<int>(index % columns), static_cast<int>(index / columns)};
  const float distance = static_cast<float>(grid_.resolution()) * walls_.distance(cell);
  return isLowered_ ? pass_.lowered(cell, distance, covered_.distance(cell)) : distance;
}

}  // namespace sim2d
