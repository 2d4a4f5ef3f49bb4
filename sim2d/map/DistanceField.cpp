#include "sim2d/map/DistanceField.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace sim2d {

namespace {

/// A free grid that covers the points and all outlines, with a margin of 3 m.
OccupancyGrid gridOver(const Obstacles& obstacles, const std::vector<Vec2>& points) {
  constexpr double kMargin = 3.0;      // [m]
  constexpr double kResolution = 0.1;  // [m]
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Vec2 low = Vec2::Constant(kFar);
  Vec2 high = Vec2::Constant(-kFar);
  const auto include = [&](const Vec2& point) {
    if (base::isWithinCoordinateRange(point)) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  };
  std::for_each(points.begin(), points.end(), include);
  for (int part = 0; part < obstacles.partCount(); ++part) {
    for (const Outline& outline : obstacles.outlines(part)) {
      std::for_each(outline.points.begin(), outline.points.end(), include);
    }
  }
  if (low.x() > high.x()) {
    low = high = Vec2::Zero();
  }
  const Vec2 extent = high - low + Vec2::Constant(2.0 * kMargin);
  double resolution =
      std::max(kResolution, std::sqrt(extent.x() * extent.y() / DistanceField::kMaxCells));
  const auto cells = [&](double length) {
    return static_cast<int>(std::ceil(length / resolution));
  };
  while (static_cast<double>(cells(extent.x())) * cells(extent.y()) > DistanceField::kMaxCells) {
    resolution *= 1.01;  // the cells are rounded up
  }
  const int width = cells(extent.x());
  const int height = cells(extent.y());
  std::vector<std::int8_t> free(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                                0);
  return OccupancyGrid(width, height, resolution, {low - Vec2::Constant(kMargin), 0.0},
                       std::move(free));
}

CellDistances distancesToWalls(const OccupancyGrid& grid, bool isLarge,
                               const base::StopFlag& stop) {
  return CellDistances(grid.width(), grid.height(), cellsOfWalls(grid),
                       static_cast<float>(grid.resolution()), isLarge, stop);
}

/// Lowers distances [m] to the map's walls to those to walls and obstacles. `cells` marks the cells
/// that obstacles cover.
void lowerDistances(const OccupancyGrid& grid, const Obstacles& obstacles,
                    const std::vector<char>& cells, bool isLarge, const base::StopFlag& stop,
                    CellDistances& distance) {
  const bool isCovered = std::find(cells.begin(), cells.end(), char{1}) != cells.end();
  if (!isCovered && !extendBeyondGrid(grid, obstacles)) {
    return;
  }
  const ObstacleClearance pass(grid, obstacles);
  const CellDistances toCovered(grid.width(), grid.height(), cells, 1.0F, isLarge, stop);
  for (int row = 0; row < grid.height(); ++row) {
    stop.check();
    for (int column = 0; column < grid.width(); ++column) {
      const std::size_t index = grid.indexOf({column, row});
      const float before = distance.at(index);
      const float after = pass.lowered({column, row}, before, toCovered.at(index));
      if (after != before) {
        distance.set(index, after);
      }
    }
  }
  // Interpolation needs all or no values infinite. If only obstacles beyond the grid matter, cells
  // far from the edge get the search range; on a large map without walls, cells far from all
  // obstacles get the largest stored distance.
  constexpr float kMaxKept = 256.0F;  // [cells]
  distance.replaceInfinite(isCovered ? kMaxKept * static_cast<float>(grid.resolution())
                                     : static_cast<float>(kExactRange));
}

/// The map with all covered cells as walls.
OccupancyGrid withObstacles(const OccupancyGrid& grid, const std::vector<char>& cells) {
  std::vector<std::int8_t> values = grid.cells();
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = cells[i] != 0 ? std::int8_t{100} : values[i];
  }
  return OccupancyGrid(grid.width(), grid.height(), grid.resolution(), grid.origin(),
                       std::move(values));
}

constexpr int kUnknownBlock = 16;  // [cells] side of a block of `toUnknown_`

int blocksOf(int cells) {
  return (cells + kUnknownBlock - 1) / kUnknownBlock;
}

constexpr double kCellSlack = 1e-9;  // [cells]

/// Also true for a wall cell.
bool isBesideWall(const OccupancyGrid& grid, Cell cell) {
  for (int row = cell.row - 1; row <= cell.row + 1; ++row) {
    for (int column = cell.column - 1; column <= cell.column + 1; ++column) {
      if (grid.isWall({column, row})) {
        return true;
      }
    }
  }
  return false;
}

/// Rasterises outlines in grid coordinates.
class Rasteriser {
 public:
  Rasteriser(const OccupancyGrid& grid, const base::StopFlag& stop)
      : grid_(grid), stop_(stop), marks_(grid.cells().size(), char{0}) {}

  void add(const std::vector<Outline>& outlines) {
    crossings_.clear();
    background_ = 0;
    double area = 0.0;
    for (const Outline& outline : outlines) {
      stop_.check();
      area += signedArea(outline.points);
      for (std::size_t i = 0; i < outline.points.size(); ++i) {
        const Vec2 a = grid_.worldToCorner(outline.points[i]);
        const Vec2 b = grid_.worldToCorner(outline.points[(i + 1) % outline.points.size()]);
        markAlong(a, b);
        addCrossings(a, b);
      }
    }
    background_ = area < 0.0 ? 1 : 0;
    fill();
  }

  std::vector<char> takeMarks() { return std::move(marks_); }

 private:
  struct Crossing {
    int row = 0;
    double column = 0.0;
    int sense = 0;
  };

  static int cellOf(double value) {
    return static_cast<int>(std::floor(std::clamp(value, -1e8, 1e8)));
  }

  void mark(Cell cell) {
    if (grid_.contains(cell)) {
      marks_[grid_.indexOf(cell)] = 1;
    }
  }

  void markAlong(const Vec2& a, const Vec2& b) {
    const double lowY = std::min(a.y(), b.y());
    const double highY = std::max(a.y(), b.y());
    const int firstRow = cellOf(lowY + kCellSlack);
    const int lastRow =
        std::min(std::max(cellOf(highY - kCellSlack), firstRow), grid_.height() - 1);
    for (int row = std::max(firstRow, 0); row <= lastRow; ++row) {
      double x[2] = {a.x(), b.x()};
      if (highY - lowY > kCellSlack) {
        const double slope = (b.x() - a.x()) / (b.y() - a.y());
        for (int end = 0; end < 2; ++end) {
          x[end] =
              a.x() + slope * (std::clamp(static_cast<double>(row + end), lowY, highY) - a.y());
        }
      }
      const int first = cellOf(std::min(x[0], x[1]) + kCellSlack);
      const int last = std::max(cellOf(std::max(x[0], x[1]) - kCellSlack), first);
      for (int column = std::max(first, 0); column <= std::min(last, grid_.width() - 1); ++column) {
        if (!isBesideWall(grid_, {column, row})) {
          mark({column, row});
        }
      }
    }
  }

  /// Intersections of an edge with the centre lines of the rows.
  void addCrossings(const Vec2& a, const Vec2& b) {
    const double low = std::min(a.y(), b.y());
    const double high = std::max(a.y(), b.y());
    const int first = std::max(cellOf(std::ceil(low - 0.5)), 0);
    for (int row = first; row < grid_.height() && row + 0.5 < high; ++row) {
      const double t = (row + 0.5 - a.y()) / (b.y() - a.y());
      crossings_.push_back({row, a.x() + t * (b.x() - a.x()), b.y() > a.y() ? 1 : -1});
    }
  }

  /// The solid lies to the left of a rising edge: scanning from +x, a rising edge increments the
  /// winding number.
  void fill() {
    std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& a, const Crossing& b) {
      return a.row != b.row ? a.row < b.row : a.column > b.column;
    });
    std::size_t at = 0;
    for (int row = 0; row < grid_.height(); ++row) {
      stop_.check();
      int winding = background_;
      int end = grid_.width();  // columns from here on are done
      for (; at < crossings_.size() && crossings_[at].row == row; ++at) {
        const int begin = std::clamp(cellOf(crossings_[at].column - 0.5) + 1, 0, grid_.width());
        markRow(row, begin, winding > 0 ? end : begin);
        end = std::min(end, begin);
        winding += crossings_[at].sense;
      }
      markRow(row, 0, winding > 0 ? end : 0);
    }
  }

  void markRow(int row, int begin, int end) {
    for (int column = begin; column < end; ++column) {
      mark({column, row});
    }
  }

  const OccupancyGrid& grid_;
  const base::StopFlag& stop_;
  std::vector<char> marks_;
  std::vector<Crossing> crossings_;
  int background_ = 0;
};

}  // namespace

std::shared_ptr<const CellDistances> DistanceField::mapWallDistances(const OccupancyGrid& grid,
                                                                     bool isLarge,
                                                                     const base::StopFlag& stop) {
  return std::make_shared<const CellDistances>(distancesToWalls(grid, isLarge, stop));
}

DistanceField::DistanceField(const OccupancyGrid& grid, const Obstacles& obstacles,
                             const std::vector<Vec2>& bounds, double mostCells,
                             base::StopFlagPtr stop,
                             const std::shared_ptr<const CellDistances>& walls)
    : stop_(std::move(stop)),
      grid_(grid.isEmpty() ? gridOver(obstacles, bounds) : grid),
      isOpenPlane_(grid.isEmpty()),
      isLarge_(!isOpenPlane_ && static_cast<double>(grid_.cells().size()) > mostCells) {
  distance_ = walls != nullptr ? *walls : distancesToWalls(grid_, isLarge_, *stop_);
  // On a large map only the cells count: the map's outlines deviate from them by half a cell.
  keepDistances(obstacles, cellsOfObstacles(grid_, obstacles, isLarge_, *stop_));
}

/// For an exact field computed on demand.
DistanceField::DistanceField(const OccupancyGrid& grid, const Obstacles& obstacles, LazyTag)
    : stop_(std::make_shared<const base::StopFlag>()), grid_(grid) {
  const std::vector<char> covered = cellsOfObstacles(grid_, obstacles, false, *stop_);
  const auto isWall = [](std::int8_t value) { return value > 50; };
  if (std::find(covered.begin(), covered.end(), char{1}) == covered.end() &&
      std::none_of(grid_.cells().begin(), grid_.cells().end(), isWall)) {
    distance_ = distancesToWalls(grid_, false, *stop_);
    keepDistances(obstacles, covered);
    return;
  }
  lazy_ = std::make_unique<const LazyDistances>(grid_, obstacles, covered, *stop_);
  findBorder();
}

std::shared_ptr<const DistanceField> DistanceField::withExactDistances(
    const OccupancyGrid& grid, const Obstacles& obstacles, const std::vector<Vec2>& bounds,
    double mostKept) {
  constexpr double kNoneIsLarge = std::numeric_limits<double>::infinity();
  if (static_cast<double>(grid.cells().size()) <= mostKept) {
    return std::make_shared<const DistanceField>(grid, obstacles, bounds, kNoneIsLarge);
  }
  return std::shared_ptr<const DistanceField>(new DistanceField(grid, obstacles, LazyTag()));
}

void DistanceField::keepDistances(const Obstacles& obstacles, const std::vector<char>& covered) {
  lowerDistances(grid_, obstacles, covered, isLarge_, *stop_, distance_);
  if (!isLarge_ && std::find(covered.begin(), covered.end(), char{1}) != covered.end()) {
    grid_ = withObstacles(grid_, covered);
  }
  findBorder();
  measureUnknown();
}

bool DistanceField::isSolid(Cell cell) const {
  if (grid_.isWall(cell) || (!isLarge_ && lazy_ == nullptr) || !grid_.contains(cell)) {
    return grid_.isWall(cell);
  }
  return isLarge_ ? distance_.at(grid_.indexOf(cell)) == 0.0F : lazy_->isCovered(cell);
}

/// Seen from outside the grid, the nearest wall cell is always the first or last one of its row or
/// column.
void DistanceField::findBorder() {
  std::vector<Cell> left, right;
  std::vector<int> lowest(static_cast<std::size_t>(grid_.width()), -1);
  std::vector<int> highest = lowest;
  for (int row = 0; row < grid_.height(); ++row) {
    stop_->check();
    int first = -1;
    int last = -1;
    for (int column = 0; column < grid_.width(); ++column) {
      if (isSolid({column, row})) {
        const auto at = static_cast<std::size_t>(column);
        first = first < 0 ? column : first;
        last = column;
        lowest[at] = lowest[at] < 0 ? row : lowest[at];
        highest[at] = row;
      }
    }
    if (first >= 0) {
      left.push_back({first, row});
      right.push_back({last, row});
    }
  }
  std::vector<Cell> cells = std::move(left);
  cells.insert(cells.end(), right.begin(), right.end());
  for (const std::vector<int>& rows : {lowest, highest}) {
    for (int column = 0; column < grid_.width(); ++column) {
      if (const int row = rows[static_cast<std::size_t>(column)]; row >= 0) {
        cells.push_back({column, row});
      }
    }
  }
  border_.build(std::move(cells));
}

/// On a large map per block of cells: line checks may then need more samples, with the same result.
void DistanceField::measureUnknown() {
  const std::vector<std::int8_t>& cells = grid_.cells();
  if (std::none_of(cells.begin(), cells.end(), [](std::int8_t value) { return value < 0; })) {
    return;
  }
  const int block = isLarge_ ? kUnknownBlock : 1;
  const int width = isLarge_ ? blocksOf(grid_.width()) : grid_.width();
  const int height = isLarge_ ? blocksOf(grid_.height()) : grid_.height();
  std::vector<char> marks(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  for (int row = 0; row < grid_.height(); ++row) {
    stop_->check();
    for (int column = 0; column < grid_.width(); ++column) {
      if (grid_.isUnknown({column, row})) {
        marks[static_cast<std::size_t>(row / block) * static_cast<std::size_t>(width) +
              static_cast<std::size_t>(column / block)] = 1;
      }
    }
  }
  toUnknown_ = distancesToMarked(width, height, marks, *stop_);
}

double DistanceField::unknownDistance(Cell cell) const {
  if (lazy_ != nullptr && grid_.contains(cell)) {
    return static_cast<double>(lazy_->unknown().distance(cell));
  }
  if (toUnknown_.empty() || !grid_.contains(cell)) {
    return std::numeric_limits<double>::infinity();
  }
  if (!isLarge_) {
    return static_cast<double>(toUnknown_[grid_.indexOf(cell)]);
  }
  constexpr double kHalfDiagonal = 0.7072;  // [blocks]
  const int blocks = blocksOf(grid_.width());
  const int number = cell.row / kUnknownBlock * blocks + cell.column / kUnknownBlock;
  const auto block = static_cast<std::size_t>(number);
  const double least = kUnknownBlock * (static_cast<double>(toUnknown_[block]) - kHalfDiagonal);
  return grid_.isUnknown(cell) ? 0.0 : std::max(1.0, least);
}

std::size_t DistanceField::bytes() const {
  const std::size_t kept = lazy_ != nullptr ? lazy_->bytes() : distance_.bytes();
  return kept + sizeof(float) * toUnknown_.capacity() + border_.bytes();
}

double DistanceField::distanceAt(Cell cell) const {
  return grid_.contains(cell) ? static_cast<double>(valueAt(grid_.indexOf(cell)))
                              : outsideDistance(Vec2(cell.column + 0.5, cell.row + 0.5));
}

double DistanceField::distanceAt(const Vec2& point) const {
  if (std::isinf(valueAt(0))) {
    return std::numeric_limits<double>::infinity();
  }
  const Vec2 corner = grid_.worldToCorner(point);
  const bool isOutside = !(corner.x() >= 0.0 && corner.y() >= 0.0 && corner.x() <= grid_.width() &&
                           corner.y() <= grid_.height());
  if (isOutside) {
    return outsideDistance(corner);
  }
  const double x = std::clamp(corner.x() - 0.5, 0.0, grid_.width() - 1.0);
  const double y = std::clamp(corner.y() - 0.5, 0.0, grid_.height() - 1.0);
  const Cell low{static_cast<int>(x), static_cast<int>(y)};
  const std::size_t first = grid_.indexOf(low);
  const std::size_t right = low.column + 1 < grid_.width() ? 1 : 0;
  const std::size_t up = low.row + 1 < grid_.height() ? static_cast<std::size_t>(grid_.width()) : 0;
  const double tx = x - low.column;
  const double ty = y - low.row;
  const auto value = [&](std::size_t offset) {
    return static_cast<double>(valueAt(first + offset));
  };
  return (1.0 - ty) * ((1.0 - tx) * value(0) + tx * value(right)) +
         ty * ((1.0 - tx) * value(up) + tx * value(up + right));
}

std::vector<char> cellsOfObstacles(const OccupancyGrid& grid, const Obstacles& obstacles,
                                   bool isLarge, const base::StopFlag& stop) {
  Rasteriser rasteriser(grid, stop);
  for (int part = 0; part < obstacles.partCount(); ++part) {
    if (obstacles.isEnabled(part) && !(isLarge && obstacles.isOfMap(part))) {
      rasteriser.add(obstacles.outlines(part));
    }
  }
  return rasteriser.takeMarks();
}

std::vector<char> cellsOfWalls(const OccupancyGrid& grid) {
  std::vector<char> marks(grid.cells().size());
  std::transform(grid.cells().begin(), grid.cells().end(), marks.begin(),
                 [](std::int8_t value) { return value > 50 ? char{1} : char{0}; });
  return marks;
}

}  // namespace sim2d
