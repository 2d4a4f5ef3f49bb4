#include "sim2d/map/WalkSpace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sim2d {

namespace {

constexpr double kMoveLimit = 1.0;        // [m] from a closed start or goal to an open cell
constexpr double kClearanceSlack = 1e-3;  // [m] of the clearance between centres of cells

bool hasOpenUnknown(const DistanceField& field, double radius) {
  const OccupancyGrid& grid = field.grid();
  for (int row = 0; field.hasUnknown() && row < grid.height(); ++row) {
    field.stopFlag().check();
    for (int column = 0; column < grid.width(); ++column) {
      const Cell cell{column, row};
      if (field.isUnknown(cell) && priceOf(field, radius, cell) != 0) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

WalkSpace::WalkSpace(std::shared_ptr<const DistanceField> field, double radius)
    : field_(std::move(field)),
      radius_(radius),
      bodyRadius_(std::max(radius, 0.5 * field_->grid().resolution())),
      hasUnknown_(hasOpenUnknown(*field_, radius)) {}

bool WalkSpace::fits(const Vec2& point) const {
  return isInWorld(point) && field_->distanceAt(point) >= bodyRadius_ - kClearanceSlack;
}

/// [m] to the nearest unknown cell, to one cell; 0 inside, infinite where there is none.
double WalkSpace::unknownDistance(const Vec2& point) const {
  return hasUnknown_ ? field_->unknownDistance(grid().worldToCell(point)) * grid().resolution()
                     : std::numeric_limits<double>::infinity();
}

bool WalkSpace::lineKeeps(const Vec2& from, const Vec2& to, double clearance,
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
    at = std::min(length, at + std::max(least, room));  // as far as the clearance allows
  }
}

bool WalkSpace::leadsOut(const Vec2& from, const Vec2& to) const {
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

/// The open cell nearest to the point within 1 m for which `accept` holds.
template <class Accept>
std::optional<Cell> WalkSpace::nearestOpenCell(const Vec2& point, Accept accept) const {
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

std::optional<Vec2> WalkSpace::nearestFit(const Vec2& point) const {
  if (!point.allFinite()) {
    return std::nullopt;
  }
  if (fits(point)) {
    return point;
  }
  std::optional<Cell> cell =
      nearestOpenCell(point, [&](Cell open) { return leadsOut(point, grid().cellToWorld(open)); });
  if (!cell) {
    cell = nearestOpenCell(point, [](Cell) { return true; });
  }
  return cell ? std::optional<Vec2>(grid().cellToWorld(*cell)) : std::nullopt;
}

std::optional<WalkSpace::Anchor> WalkSpace::anchorOf(const Vec2& point) const {
  const std::optional<Vec2> place = nearestFit(point);
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
    return lineKeeps(*place, grid().cellToWorld(open), bodyRadius_, true);
  });
  return near ? std::optional<Anchor>(Anchor{*place, *near}) : std::nullopt;
}

}  // namespace sim2d
