#include "sim2d/map/GoalField.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace sim2d {

namespace {

constexpr std::uint32_t kNoWay = CellCosts::kNone;
constexpr std::uint32_t kStraight = 12;  // 17 / 12 is the root of two to 0.2 %
constexpr std::uint32_t kDiagonal = 17;
constexpr std::uint32_t kUnknownFactor = 16;
constexpr double kCheapest = 6.0;

}  // namespace

Terrain::Terrain(const DistanceField& field, double radius)
    : stride_(field.grid().width() + 2),
      price_(
          static_cast<std::size_t>(stride_) * static_cast<std::size_t>(field.grid().height() + 2),
          0),
      unknown_(price_.size(), 0) {
  const OccupancyGrid& grid = field.grid();
  // Beside a wall a body of any size is closed out, else it could slip through where an obstacle
  // fills less than a cell.
  const double least = std::max(radius, 0.72 * grid.resolution()) - 1e-6;
  for (int row = 0; row < grid.height(); ++row) {
    for (int column = 0; column < grid.width(); ++column) {
      const Cell cell{column, row};
      const double clearance = field.distanceAt(cell);
      if (clearance < least || grid.isWall(cell)) {
        continue;
      }
      const double lack = std::clamp(1.0 - (clearance - radius) / kWantedClearance, 0.0, 1.0);
      const auto index = static_cast<std::size_t>(indexOf(cell));
      price_[index] = static_cast<std::uint8_t>(std::lround(kCheapest * (1.0 + lack * lack)));
      unknown_[index] = grid.isUnknown(cell) ? char{1} : char{0};
      hasUnknown_ = hasUnknown_ || grid.isUnknown(cell);
    }
  }
}

void CellCosts::set(Terrain::Index index, std::uint32_t cost) {
  const auto cell = static_cast<std::size_t>(index);
  std::unique_ptr<Tile>& tile = tiles_[cell / kTile];
  if (!tile) {
    tile = std::make_unique<Tile>();
    tile->fill(kNone);
  }
  (*tile)[cell % kTile] = cost;
}

GoalField::GoalField(const Terrain& terrain, Index goal)
    : terrain_(terrain), goal_(goal), cost_(terrain.size()) {
  const Index up = terrain.stride();
  neighbours_ = {{{1, kStraight, 0, 0},
                  {up, kStraight, 0, 0},
                  {-1, kStraight, 0, 0},
                  {-up, kStraight, 0, 0},
                  {up + 1, kDiagonal, 1, up},
                  {up - 1, kDiagonal, -1, up},
                  {-up - 1, kDiagonal, -1, -up},
                  {1 - up, kDiagonal, 1, -up}}};
  relax(goal, 0);
}

bool GoalField::canStep(Index from, const Neighbour& neighbour) const {
  return terrain_.isOpen(from + neighbour.offset) && terrain_.isOpen(from + neighbour.first) &&
         terrain_.isOpen(from + neighbour.second);
}

std::uint32_t GoalField::stepCost(Index from, const Neighbour& neighbour) const {
  const Index to = from + neighbour.offset;
  const std::uint32_t cost = neighbour.length * (terrain_.price(from) + terrain_.price(to));
  const bool isUnknown = terrain_.isUnknown(from) || terrain_.isUnknown(to);
  return isUnknown ? kUnknownFactor * cost : cost;
}

void GoalField::relax(Index cell, std::uint32_t cost) {
  if (cost < cost_.at(cell)) {
    cost_.set(cell, cost);
    heap_.push(cost, cell);
  }
}

void GoalField::expand(Index cell) {
  const std::uint32_t cost = cost_.at(cell);
  for (const Neighbour& neighbour : neighbours_) {
    if (!canStep(cell, neighbour)) {
      continue;
    }
    const std::uint32_t step = stepCost(cell, neighbour);
    const Index to = cell + neighbour.offset;
    if (step >= kNoWay - cost) {
      continue;  // beyond what can be counted
    }
    if (terrain_.isUnknown(to) && !inUnknown_) {
      seeds_.push_back({to, cost + step});
    } else {
      relax(to, cost + step);
    }
  }
}

/// All costs from here on lie above those of the first search, so that what it found stays.
bool GoalField::enterUnknown() {
  const std::uint32_t above = frontier_ + 1;
  inUnknown_ = true;
  for (const Seed& seed : seeds_) {
    if (seed.cost < kNoWay - above) {
      relax(seed.cell, above + seed.cost);
    }
  }
  seeds_ = {};
  return !heap_.isEmpty();
}

bool GoalField::reach(Index from) {
  while (cost_.at(from) > frontier_) {
    if (heap_.isEmpty() && (inUnknown_ || !enterUnknown())) {
      return false;
    }
    const auto [cost, cell] = heap_.pop();
    if (cost == cost_.at(cell)) {
      frontier_ = cost;
      expand(cell);
    }
  }
  return true;
}

GoalField::Index GoalField::next(Index from) const {
  const std::uint32_t here = cost_.at(from);
  Index best = from;
  std::uint32_t lowest = kNoWay;
  for (const Neighbour& neighbour : neighbours_) {
    const Index to = from + neighbour.offset;
    const std::uint32_t there = cost_.at(to);
    if (there < here && canStep(from, neighbour)) {
      const std::uint32_t step = stepCost(from, neighbour);
      if (step < kNoWay - there && there + step < lowest) {
        lowest = there + step;
        best = to;
      }
    }
  }
  assert(best != from || from == goal_);
  return best;
}

}  // namespace sim2d
