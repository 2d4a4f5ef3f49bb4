#include "sim2d/nav/nav2/costmap/StaticLayer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"

namespace sim2d::nav2 {
namespace {

/// The axis-aligned cells that cover a rotated map.
Costmap rotatedMapCover(const OccupancyGrid& map) {
  CostmapBounds bounds;
  for (const double column : {0.0, static_cast<double>(map.width())}) {
    for (const double row : {0.0, static_cast<double>(map.height())}) {
      bounds.touch(map.cornerToWorld(column, row));
    }
  }
  constexpr double kRounding = 1e-6;  // [cells]
  const Vec2 cells = (bounds.high - bounds.low) / map.resolution();
  return Costmap(static_cast<int>(std::ceil(cells.x() - kRounding)),
                 static_cast<int>(std::ceil(cells.y() - kRounding)), map.resolution(), bounds.low,
                 kNoInformation);
}

}  // namespace

std::uint8_t costOfOccupancy(std::int8_t occupancy, const CostmapParameters& parameters,
                             Distro distro) {
  const int value = static_cast<std::uint8_t>(occupancy);  // -1 is 255
  const int lethal = std::clamp(parameters.lethalCostThreshold, 0, 100);
  if (value == parameters.unknownCostValue) {
    return parameters.trackUnknownSpace ? kNoInformation : kFreeSpace;
  }
  if (distro >= Distro::Lyrical && value == parameters.inscribedObstacleCostValue) {
    return kInscribed;
  }
  if (value >= lethal) {
    return kLethal;
  }
  if (parameters.trinaryCostmap) {
    return kFreeSpace;
  }
  return static_cast<std::uint8_t>(static_cast<double>(value) / lethal * kLethal);
}

Costmap costmapFromMap(const OccupancyGrid& map, const CostmapParameters& parameters,
                       Distro distro) {
  if (map.origin().heading == 0.0) {
    Costmap costs(map.width(), map.height(), map.resolution(), map.origin().position);
    if (!map.isEmpty()) {
      std::transform(map.cells().begin(), map.cells().end(), costs.costs().begin(),
                     [&parameters, distro](std::int8_t occupancy) {
                       return costOfOccupancy(occupancy, parameters, distro);
                     });
    }
    return costs;
  }
  Costmap costs = rotatedMapCover(map);
  for (int row = 0; row < costs.height(); ++row) {
    for (int column = 0; column < costs.width(); ++column) {
      const Cell cell = map.worldToCell(costs.cellToWorld({column, row}));
      if (map.contains(cell)) {
        costs.set({column, row}, costOfOccupancy(map.valueAt(cell), parameters, distro));
      } else if (!parameters.trackUnknownSpace) {
        costs.set({column, row}, kFreeSpace);
      }
    }
  }
  return costs;
}

StaticLayer::StaticLayer(std::string name, const CostmapContext& context,
                         const StaticLayerParameters& parameters, const CostmapParameters& costmap,
                         const OccupancyGrid& map)
    : CostmapLayer(std::move(name), context),
      parameters_(parameters),
      usesMaximum_(costmap.useMaximum),
      grid_(costmapFromMap(map, costmap, context.distro)) {}

void StaticLayer::updateBounds(const Observation& observation, const Costmap& /*master*/,
                               CostmapBounds& bounds) {
  frame_ = observation.frame;
  if (grid_.costs().empty() || !parameters_.enabled) {
    return;
  }
  if (isNew_ || context().isRolling) {
    isNew_ = false;
    bounds.touch(grid_.cellToWorld({0, 0}));  // centres, as in Nav2
    bounds.touch(grid_.cellToWorld({grid_.width(), grid_.height()}));
  }
  footprint_ = clearedFootprint(parameters_.footprintClearingEnabled, observation, bounds);
}

void StaticLayer::updateCosts(Costmap& master, const CellWindow& window) {
  isCurrent_ = true;
  if (grid_.costs().empty() || !parameters_.enabled) {
    return;
  }
  // In Humble and Jazzy cleared cells stay clear; later branches restore them.
  const bool isRestored = context().distro >= Distro::Kilted && parameters_.restoreClearedFootprint;
  std::optional<Costmap> before;
  if (isRestored && !footprint_.empty()) {
    before = grid_;
  }
  fillPolygon(grid_, footprint_, kFreeSpace);
  if (context().isRolling) {
    sampleInto(master, window);
  } else {
    mergeWindow(grid_, window, usesMaximum_ ? CombinationMethod::Maximum : CombinationMethod::Copy,
                master);
  }
  if (before) {
    grid_ = *std::move(before);
  }
}

void StaticLayer::reset(double /*time*/) {
  isNew_ = true;
  isCurrent_ = false;
}

void StaticLayer::sampleInto(Costmap& master, const CellWindow& window) const {
  for (int row = window.bottom; row < window.top; ++row) {
    for (int column = window.left; column < window.right; ++column) {
      const std::optional<Cell> cell =
          grid_.worldToCell(pointInMap(frame_, master.cellToWorld({column, row})));
      if (cell) {
        const std::uint8_t cost = grid_.at(*cell);
        master.set({column, row}, usesMaximum_ ? std::max(cost, master.at({column, row})) : cost);
      }
    }
  }
}

}  // namespace sim2d::nav2
