#include "sim2d/map/Terrain.h"

#include <algorithm>
#include <cmath>

namespace sim2d {

namespace {

constexpr std::uint32_t kDiagonal = 17;  // 17 / 12 is the root of two to 0.2 %
constexpr std::uint32_t kLeap = 27;      // 27 / 12 that of five to 0.7 %
constexpr double kCheapest = 6.0;

}  // namespace

namespace {

/// [m] that a body needs.
double leastFor(const OccupancyGrid& grid, double radius) {
  // Beside a wall a body of any size is closed out, else it could slip through where an obstacle
  // fills less than a cell.
  return std::max(radius, 0.72 * grid.resolution()) - 1e-6;
}

/// How many cells behind one of that clearance, in a row, are as open or closed as it. Clearances
/// of neighbours differ by a cell at most, but for the places where they begin to be exact.
int alikeBehind(const DistanceField& field, double clearance, double least) {
  constexpr double kAlikeSlack = 4.0;  // [cells]
  const double cells = std::fabs(clearance - least) / field.grid().resolution() - kAlikeSlack;
  return static_cast<int>(std::clamp(cells, 0.0, 1e6));
}

}  // namespace

std::uint8_t priceOf(const DistanceField& field, double radius, Cell cell) {
  const OccupancyGrid& grid = field.grid();
  const double clearance = field.distanceAt(cell);
  if (clearance < leastFor(grid, radius) || grid.isWall(cell)) {
    return 0;
  }
  const double lack = std::clamp(1.0 - (clearance - radius) / kWantedClearance, 0.0, 1.0);
  return static_cast<std::uint8_t>(std::lround(kCheapest * (1.0 + lack * lack)));
}

Terrain::Terrain(const DistanceField& field, double radius)
    : Terrain(field, radius, {0, 0}, {field.grid().width() - 1, field.grid().height() - 1}) {}

Terrain::Terrain(const DistanceField& field, double radius, Cell low, Cell high)
    : Terrain(field, low, high) {
  for (int row = low.row; row <= high.row; ++row) {
    stop_->check();
    Index index = indexOf({low.column, row});
    for (int column = low.column; column <= high.column; ++column, ++index) {
      const std::uint8_t price = priceOf(field, radius, {column, row});
      setPrice(index, price, price != 0 && field.isUnknown({column, row}));
    }
  }
}

Terrain::Terrain(const DistanceField& field, Cell low, Cell high)
    : stop_(&field.stopFlag()),
      low_(low),
      stride_(high.column - low.column + 3),
      price_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(high.row - low.row + 3),
             0) {
  const Index up = stride_;
  neighbours_ = {{{1, kCellLength, 0, 0},
                  {up, kCellLength, 0, 0},
                  {-1, kCellLength, 0, 0},
                  {-up, kCellLength, 0, 0},
                  {up + 1, kDiagonal, 1, up},
                  {up - 1, kDiagonal, -1, up},
                  {-up - 1, kDiagonal, -1, -up},
                  {1 - up, kDiagonal, 1, -up}}};
}

EvenTerrain::EvenTerrain(const DistanceField& field, double radius)
    : Terrain(field, {0, 0}, {field.grid().width() - 1, field.grid().height() - 1}) {
  const OccupancyGrid& grid = field.grid();
  const double least = leastFor(grid, radius);
  for (int row = 0; row < grid.height(); ++row) {
    stopFlag().check();
    for (int column = 0; column < grid.width();) {
      const double clearance = field.distanceAt(Cell{column, row});
      const int alike = field.isAskedAndSmooth() ? alikeBehind(field, clearance, least) : 0;
      for (const int end = std::min(column + 1 + alike, grid.width()); column < end; ++column) {
        if (clearance >= least) {
          setPrice(indexOf({column, row}), 1, field.isUnknown({column, row}));
        }
      }
    }
  }
  const Index up = stride();
  leaps_ = {{{2 + up, kLeap, 1, 1 + up},
             {2 - up, kLeap, 1, 1 - up},
             {2 * up + 1, kLeap, up, up + 1},
             {2 * up - 1, kLeap, up, up - 1},
             {up - 2, kLeap, -1, up - 1},
             {-up - 2, kLeap, -1, -up - 1},
             {1 - 2 * up, kLeap, -up, 1 - up},
             {-1 - 2 * up, kLeap, -up, -1 - up}}};
}

}  // namespace sim2d
