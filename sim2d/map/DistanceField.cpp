#include "sim2d/map/DistanceField.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "sim2d/map/ObstacleCells.h"

namespace sim2d {

namespace {

/// A free grid over the points and all outlines, with a margin of 3 m.
OccupancyGrid gridOver(const Obstacles& obstacles, const std::vector<Vec2>& points) {
  constexpr double kMargin = 3.0;      // [m]
  constexpr double kResolution = 0.1;  // [m]
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Vec2 low = Vec2::Constant(kFar);
  Vec2 high = Vec2::Constant(-kFar);
  const auto include = [&](const Vec2& point) {
    if (base::isInReach(point)) {
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
      std::max(kResolution, std::sqrt(extent.x() * extent.y() / DistanceField::kMostCells));
  const auto cells = [&](double length) {
    return static_cast<int>(std::ceil(length / resolution));
  };
  while (static_cast<double>(cells(extent.x())) * cells(extent.y()) > DistanceField::kMostCells) {
    resolution *= 1.01;  // the last cells of a row and column stick out
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

/// From distances [m] to the walls of the map to those to walls and obstacles together. `cells` are
/// those of the obstacles.
void lowerDistances(const OccupancyGrid& grid, const Obstacles& obstacles,
                    const std::vector<char>& cells, bool isLarge, const base::StopFlag& stop,
                    CellDistances& distance) {
  const bool isCovered = std::find(cells.begin(), cells.end(), char{1}) != cells.end();
  if (!isCovered && !reachBeyond(grid, obstacles)) {
    return;
  }
  const ObstaclePass pass(grid, obstacles);
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
  // All or none are infinite, so that values can be mixed: where only what stands beyond the grid
  // is felt, the cells far from its edge take the range within which it was looked for; else those
  // that are far from all that stands on a large map without walls the most that is kept.
  constexpr float kMostKept = 256.0F;  // [cells]
  distance.replaceInfinite(isCovered ? kMostKept * static_cast<float>(grid.resolution())
                                     : static_cast<float>(kExactRange));
}

/// The cells with all that stands on them as walls.
OccupancyGrid withObstacles(const OccupancyGrid& grid, const std::vector<char>& cells) {
  std::vector<std::int8_t> values = grid.cells();
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = cells[i] != 0 ? std::int8_t{100} : values[i];
  }
  return OccupancyGrid(grid.width(), grid.height(), grid.resolution(), grid.origin(),
                       std::move(values));
}

constexpr int kUnknownBlock = 16;  // [cells] along the side of those in `toUnknown_`

int blocksOf(int cells) {
  return (cells + kUnknownBlock - 1) / kUnknownBlock;
}

}  // namespace

std::shared_ptr<const CellDistances> DistanceField::wallsOf(const OccupancyGrid& grid, bool isLarge,
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
  // Of a large map the cells alone count, not its outlines, which are off them by half a cell.
  keepDistances(obstacles, cellsOfObstacles(grid_, obstacles, isLarge_, *stop_));
}

/// Of the map as an ordinary one.
DistanceField::DistanceField(const OccupancyGrid& grid, const Obstacles& obstacles, Asked)
    : stop_(std::make_shared<const base::StopFlag>()), grid_(grid) {
  const std::vector<char> covered = cellsOfObstacles(grid_, obstacles, false, *stop_);
  const auto isWall = [](std::int8_t value) { return value > 50; };
  if (std::find(covered.begin(), covered.end(), char{1}) == covered.end() &&
      std::none_of(grid_.cells().begin(), grid_.cells().end(), isWall)) {
    distance_ = distancesToWalls(grid_, false, *stop_);
    keepDistances(obstacles, covered);
    return;
  }
  asked_ = std::make_unique<const AskedDistances>(grid_, obstacles, covered, *stop_);
  findBorder();
}

std::shared_ptr<const DistanceField> DistanceField::ofExactCells(const OccupancyGrid& grid,
                                                                 const Obstacles& obstacles,
                                                                 const std::vector<Vec2>& bounds,
                                                                 double mostKept) {
  constexpr double kNoneIsLarge = std::numeric_limits<double>::infinity();
  if (static_cast<double>(grid.cells().size()) <= mostKept) {
    return std::make_shared<const DistanceField>(grid, obstacles, bounds, kNoneIsLarge);
  }
  return std::shared_ptr<const DistanceField>(new DistanceField(grid, obstacles, Asked()));
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
  if (grid_.isWall(cell) || (!isLarge_ && asked_ == nullptr) || !grid_.contains(cell)) {
    return grid_.isWall(cell);
  }
  return isLarge_ ? distance_.at(grid_.indexOf(cell)) == 0.0F : asked_->isCovered(cell);
}

/// From a place outside the grid, the nearest wall cell is never one behind another wall cell of
/// its row or column: the first and the last of each row and column are enough.
void DistanceField::findBorder() {
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
      border_.insert(border_.end(), {{first, row}, {last, row}});
    }
  }
  for (int column = 0; column < grid_.width(); ++column) {
    const auto at = static_cast<std::size_t>(column);
    if (lowest[at] >= 0) {
      border_.insert(border_.end(), {{column, lowest[at]}, {column, highest[at]}});
    }
  }
}

/// Of a large map by blocks of cells: a line that keeps off what is unknown may then have to be
/// tested at more places, with the same answer.
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
  if (asked_ != nullptr && grid_.contains(cell)) {
    return static_cast<double>(asked_->unknown().distance(cell));
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
  const std::size_t kept = asked_ != nullptr ? asked_->bytes() : distance_.bytes();
  return kept + sizeof(float) * toUnknown_.capacity() + sizeof(Cell) * border_.capacity();
}

double DistanceField::outsideDistance(const Vec2& corner) const {
  double best = std::numeric_limits<double>::infinity();
  for (const Cell cell : border_) {
    const double x = std::max(0.0, std::fabs(corner.x() - cell.column - 0.5) - 0.5);
    const double y = std::max(0.0, std::fabs(corner.y() - cell.row - 0.5) - 0.5);
    best = std::min(best, x * x + y * y);
  }
  return std::sqrt(best) * grid_.resolution();
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

}  // namespace sim2d
