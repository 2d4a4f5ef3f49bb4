#include "sim2d/map/TraversableSpace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sim2d {

namespace {

constexpr std::uint32_t kDiagonal = 17;    // 17 / 12: square root of 2, to 0.2 %
constexpr std::uint32_t kKnightMove = 27;  // 27 / 12: square root of 5, to 0.7 %
constexpr double kMinCellCost = 6.0;

/// Clearance [m] that a body needs.
double requiredClearance(const OccupancyGrid& grid, double radius) {
  // Next to a wall bodies of any size are excluded; otherwise they could pass where an obstacle
  // fills less than a cell.
  return std::max(radius, 0.72 * grid.resolution()) - 1e-6;
}

/// Number of further cells in the row that are certainly open or closed like this one. Neighbouring
/// clearances differ by at most one cell, except where the exact range begins.
int uniformRunLength(const DistanceField& field, double clearance, double least) {
  constexpr double kAlikeSlack = 4.0;  // [cells]
  const double cells = std::fabs(clearance - least) / field.grid().resolution() - kAlikeSlack;
  return static_cast<int>(std::clamp(cells, 0.0, 1e6));
}

constexpr double kMoveLimit = 1.0;        // [m], to move a closed start or goal to an open cell
constexpr double kClearanceSlack = 1e-3;  // [m], tolerance between cell centres

bool hasOpenUnknown(const DistanceField& field, double radius) {
  const OccupancyGrid& grid = field.grid();
  for (int row = 0; field.hasUnknown() && row < grid.height(); ++row) {
    field.stopFlag().check();
    for (int column = 0; column < grid.width(); ++column) {
      const Cell cell{column, row};
      if (field.isUnknown(cell) && cellCostOf(field, radius, cell) != 0) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

std::uint8_t cellCostOf(const DistanceField& field, double radius, Cell cell) {
  const OccupancyGrid& grid = field.grid();
  const double clearance = field.distanceAt(cell);
  if (clearance < requiredClearance(grid, radius) || grid.isWall(cell)) {
    return 0;
  }
  const double lack = std::clamp(1.0 - (clearance - radius) / kPreferredClearance, 0.0, 1.0);
  return static_cast<std::uint8_t>(std::lround(kMinCellCost * (1.0 + lack * lack)));
}

Terrain::Terrain(const DistanceField& field, double radius)
    : Terrain(field, radius, {0, 0}, {field.grid().width() - 1, field.grid().height() - 1}) {}

Terrain::Terrain(const DistanceField& field, double radius, Cell low, Cell high)
    : Terrain(field, low, high) {
  for (int row = low.row; row <= high.row; ++row) {
    stop_->check();
    Index index = indexOf({low.column, row});
    for (int column = low.column; column <= high.column; ++column, ++index) {
      const std::uint8_t cellCost = cellCostOf(field, radius, {column, row});
      setCellCost(index, cellCost, cellCost != 0 && field.isUnknown({column, row}));
    }
  }
}

Terrain::Terrain(const DistanceField& field, Cell low, Cell high)
    : stop_(&field.stopFlag()),
      low_(low),
      stride_(high.column - low.column + 3),
      cellCosts_(
          static_cast<std::size_t>(stride_) * static_cast<std::size_t>(high.row - low.row + 3), 0) {
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

UniformTerrain::UniformTerrain(const DistanceField& field, double radius)
    : Terrain(field, {0, 0}, {field.grid().width() - 1, field.grid().height() - 1}) {
  const OccupancyGrid& grid = field.grid();
  const double least = requiredClearance(grid, radius);
  for (int row = 0; row < grid.height(); ++row) {
    stopFlag().check();
    for (int column = 0; column < grid.width();) {
      const double clearance = field.distanceAt(Cell{column, row});
      const int alike = field.isLazyAndSmooth() ? uniformRunLength(field, clearance, least) : 0;
      for (const int end = std::min(column + 1 + alike, grid.width()); column < end; ++column) {
        if (clearance >= least) {
          setCellCost(indexOf({column, row}), 1, field.isUnknown({column, row}));
        }
      }
    }
  }
  const Index up = stride();
  knightMoves_ = {{{2 + up, kKnightMove, 1, 1 + up},
                   {2 - up, kKnightMove, 1, 1 - up},
                   {2 * up + 1, kKnightMove, up, up + 1},
                   {2 * up - 1, kKnightMove, up, up - 1},
                   {up - 2, kKnightMove, -1, up - 1},
                   {-up - 2, kKnightMove, -1, -up - 1},
                   {1 - 2 * up, kKnightMove, -up, 1 - up},
                   {-1 - 2 * up, kKnightMove, -up, -1 - up}}};
}

TraversableSpace::TraversableSpace(std::shared_ptr<const DistanceField> field, double radius)
    : field_(std::move(field)),
      radius_(radius),
      bodyRadius_(std::max(radius, 0.5 * field_->grid().resolution())),
      hasUnknown_(hasOpenUnknown(*field_, radius)) {}

bool TraversableSpace::fits(const Vec2& point) const {
  return isInWorld(point) && field_->distanceAt(point) >= bodyRadius_ - kClearanceSlack;
}

/// [m] to the nearest unknown cell, accurate to one cell; 0 inside, infinite if there is none.
double TraversableSpace::unknownDistance(const Vec2& point) const {
  return hasUnknown_ ? field_->unknownDistance(grid().worldToCell(point)) * grid().resolution()
                     : std::numeric_limits<double>::infinity();
}

bool TraversableSpace::lineHasClearance(const Vec2& from, const Vec2& to, double clearance,
                                        bool mayEnterUnknown) const {
  const double length = (to - from).norm();
  const double least = 0.5 * grid().resolution();
  const Vec2 along = length > 0.0 ? Vec2((to - from) / length) : Vec2::Zero();
  for (double at = 0.0;;) {
    const Vec2 point = from + at * along;
    double room = field_->distanceAt(point) - clearance;
    if (room < -kClearanceSlack || !isInWorld(point)) {
      return false;
    }
    if (!mayEnterUnknown) {
      const double unknown = unknownDistance(point);
      if (unknown <= 0.0) {
        return false;
      }
      room = std::min(room, unknown - grid().resolution());
    }
    if (at >= length) {
      return true;
    }
    at = std::min(length, at + std::max(least, room));  // the clearance permits this step
  }
}

bool TraversableSpace::canExitTo(const Vec2& from, const Vec2& to) const {
  const double length = (to - from).norm();
  const double wall = 0.3 * grid().resolution();
  const int steps = static_cast<int>(std::ceil(8.0 * length / grid().resolution()));
  bool isFree = false;
  for (int i = 0; i <= steps; ++i) {
    const double share = steps > 0 ? static_cast<double>(i) / steps : 0.0;
    const bool isWall = field_->distanceAt(Vec2(from + share * (to - from))) < wall;
    if (isFree && isWall) {
      return false;
    }
    isFree = !isWall;
  }
  return true;
}

/// The open cell nearest to the point, within 1 m, for which `accept` returns true.
template <class Accept>
std::optional<Cell> TraversableSpace::nearestOpenCell(const Vec2& point, Accept accept) const {
  const Cell middle = grid().worldToCell(point);
  const int reach = static_cast<int>(std::ceil(kMoveLimit / grid().resolution())) + 1;
  const int lastRow = std::min(middle.row + reach, grid().height() - 1);
  const int lastColumn = std::min(middle.column + reach, grid().width() - 1);
  std::vector<std::pair<double, Cell>> candidates;
  for (int row = std::max(middle.row - reach, 0); row <= lastRow; ++row) {
    for (int column = std::max(middle.column - reach, 0); column <= lastColumn; ++column) {
      const Cell cell{column, row};
      const double distance = (grid().cellToWorld(cell) - point).norm();
      if (distance <= kMoveLimit && isOpen(cell)) {
        candidates.emplace_back(distance, cell);
      }
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  const auto found = std::find_if(candidates.begin(), candidates.end(),
                                  [&](const auto& entry) { return accept(entry.second); });
  return found == candidates.end() ? std::nullopt : std::optional<Cell>(found->second);
}

std::optional<Vec2> TraversableSpace::nearestFreePosition(const Vec2& point) const {
  if (!point.allFinite()) {
    return std::nullopt;
  }
  if (fits(point)) {
    return point;
  }
  std::optional<Cell> cell =
      nearestOpenCell(point, [&](Cell open) { return canExitTo(point, grid().cellToWorld(open)); });
  if (!cell) {
    cell = nearestOpenCell(point, [](Cell) { return true; });
  }
  return cell ? std::optional<Vec2>(grid().cellToWorld(*cell)) : std::nullopt;
}

std::optional<TraversableSpace::Anchor> TraversableSpace::anchorOf(const Vec2& point) const {
  const std::optional<Vec2> place = nearestFreePosition(point);
  if (!place) {
    return std::nullopt;
  }
  Cell cell = grid().worldToCell(*place);
  if (field_->isOpenPlane()) {
    cell = {std::clamp(cell.column, 0, grid().width() - 1),
            std::clamp(cell.row, 0, grid().height() - 1)};
  }
  if (isOpen(cell)) {
    return Anchor{*place, cell};
  }
  const std::optional<Cell> near = nearestOpenCell(*place, [&](Cell open) {
    return lineHasClearance(*place, grid().cellToWorld(open), bodyRadius_, true);
  });
  return near ? std::optional<Anchor>(Anchor{*place, *near}) : std::nullopt;
}

}  // namespace sim2d
