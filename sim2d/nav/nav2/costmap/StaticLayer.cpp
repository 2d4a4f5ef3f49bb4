#include <algorithm>
#include <cmath>
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
  forEachCell(wholeWindow(costs), [&](Cell place) {
    const Cell cell = map.worldToCell(costs.cellToWorld(place));
    if (map.contains(cell)) {
      costs.set(place, costOfOccupancy(map.valueAt(cell), parameters, distro));
    } else if (!parameters.trackUnknownSpace) {
      costs.set(place, kFreeSpace);
    }
  });
  return costs;
}

namespace {

/// The known map (nav2_costmap_2d::StaticLayer). Non-rolling costmaps have its cells; for rolling
/// ones it is sampled at the cell centres.
class StaticLayer final : public CostmapLayer {
 public:
  StaticLayer(const StaticLayerParameters& parameters, const LayerSite& site)
      : CostmapLayer(site),
        parameters_(parameters),
        usesMaximum_(site.setup.settings.parameters.useMaximum),
        grid_(costmapFromMap(site.setup.map, site.setup.settings.parameters, site.context.distro)) {
  }

  void updateBounds(const Observation& observation, const Costmap& /*master*/,
                    CostmapBounds& bounds) override {
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

  void updateCosts(Costmap& master, const CellWindow& window) override {
    isCurrent_ = true;
    if (grid_.costs().empty() || !parameters_.enabled) {
      return;
    }
    // In Humble and Jazzy cleared cells stay clear; later branches restore them.
    const bool isRestored =
        context().distro >= Distro::Kilted && parameters_.restoreClearedFootprint;
    std::optional<Costmap> before;
    if (isRestored && !footprint_.empty()) {
      before = grid_;
    }
    fillPolygon(grid_, footprint_, kFreeSpace);
    if (context().isRolling) {
      sampleInto(master, window);
    } else {
      mergeWindow(grid_, window,
                  usesMaximum_ ? CombinationMethod::Maximum : CombinationMethod::Copy, master);
    }
    if (before) {
      grid_ = *std::move(before);
    }
  }

  void reset(double /*time*/) override {
    isNew_ = true;
    isCurrent_ = false;
  }
  bool isCurrent() const override { return isCurrent_; }
  const Costmap* grid() const override { return &grid_; }

 private:
  void sampleInto(Costmap& master, const CellWindow& window) const {
    forEachCell(window, [&](Cell place) {
      if (const auto cell = grid_.worldToCell(pointInMap(frame_, master.cellToWorld(place)))) {
        const std::uint8_t cost = grid_.at(*cell);
        master.set(place, usesMaximum_ ? std::max(cost, master.at(place)) : cost);
      }
    });
  }

  StaticLayerParameters parameters_;
  bool usesMaximum_;
  bool isNew_ = true, isCurrent_ = true;
  Pose2 frame_;        // of the costmap, in the map frame
  Polygon footprint_;  // in world frame; empty: clears nothing
  Costmap grid_;
};

}  // namespace

LayerPointer makeLayer(const StaticLayerParameters& parameters, const LayerSite& site) {
  return std::make_unique<StaticLayer>(parameters, site);
}

}  // namespace sim2d::nav2
