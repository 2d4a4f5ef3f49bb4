#include "sim2d/nav/nav2/costmap/LayeredCostmap.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "sim2d/nav/SensedWorld.h"
#include "sim2d/nav/nav2/costmap/CostmapCells.h"
#include "sim2d/nav/nav2/costmap/CostmapFilters.h"
#include "sim2d/nav/nav2/costmap/InflationLayer.h"
#include "sim2d/nav/nav2/costmap/ObstacleLayer.h"
#include "sim2d/nav/nav2/costmap/SocialLayer.h"
#include "sim2d/nav/nav2/costmap/StaticLayer.h"

namespace sim2d::nav2 {
namespace {

CostmapFootprint footprintOf(const CostmapParameters& parameters) {
  // As in Nav2 a text that is no footprint leaves the radius.
  const base::Result<Polygon> corners = readPolygon(parameters.footprint);
  return costmapFootprint(parameters.robotRadius, corners ? *corners : Polygon{},
                          parameters.footprintPadding);
}

bool hasStaticLayer(const CostmapSettings& settings) {
  return std::any_of(settings.plugins.begin(), settings.plugins.end(),
                     [](const CostmapPlugin& plugin) {
                       return std::holds_alternative<StaticLayerParameters>(plugin.parameters);
                     });
}

/// The cells of the costmap, fresh.
Costmap emptyCostmap(const CostmapSetup& setup) {
  const CostmapParameters& parameters = setup.settings.parameters;
  Costmap costmap(static_cast<int>(parameters.width / parameters.resolution),
                  static_cast<int>(parameters.height / parameters.resolution),
                  parameters.resolution, {parameters.originX, parameters.originY});
  if (!parameters.rollingWindow && !setup.map.isEmpty() && hasStaticLayer(setup.settings)) {
    costmap = costmapOf(setup.map, parameters, setup.distro);
  }
  fillWindow(costmap, wholeWindow(costmap),
             parameters.trackUnknownSpace ? kNoInformation : kFreeSpace);
  return costmap;
}

/// Makes the layer of each kind of parameters.
struct LayerMaker {
  const CostmapSetup& setup;
  const CostmapContext& context;
  const Costmap& master;
  const std::string& name;

  using Layer = std::unique_ptr<CostmapLayer>;
  Layer operator()(const StaticLayerParameters& parameters) const {
    return std::make_unique<StaticLayer>(name, context, parameters, setup.settings.parameters,
                                         setup.map);
  }
  Layer operator()(const ObstacleLayerParameters& parameters) const {
    return std::make_unique<ObstacleLayer>(name, context, parameters, master);
  }
  Layer operator()(const VoxelLayerParameters& parameters) const {
    return std::make_unique<ObstacleLayer>(name, context, parameters, master);
  }
  Layer operator()(const InflationLayerParameters& parameters) const {
    return std::make_unique<InflationLayer>(name, context, parameters, master.resolution());
  }
  Layer operator()(const SocialLayerParameters& parameters) const {
    return std::make_unique<SocialLayer>(name, context, parameters);
  }
  Layer operator()(const KeepoutFilterParameters& parameters) const {
    return std::make_unique<KeepoutFilter>(name, context, parameters, mask().grid);
  }
  Layer operator()(const SpeedFilterParameters& parameters) const {
    return std::make_unique<SpeedFilter>(name, context, parameters, mask());
  }
  FilterMask mask() const {
    const auto found = setup.masks.find(name);
    return found == setup.masks.end() ? FilterMask{} : found->second;
  }
};

bool areCurrent(const std::vector<std::unique_ptr<CostmapLayer>>& layers) {
  return std::all_of(layers.begin(), layers.end(),
                     [](const auto& layer) { return layer->isCurrent(); });
}

}  // namespace

LayeredCostmap::LayeredCostmap(const CostmapSetup& setup)
    : context_(std::make_unique<CostmapContext>()),
      updateFrequency_(setup.settings.parameters.updateFrequency),
      publishFrequency_(setup.settings.parameters.publishFrequency),
      primary_(emptyCostmap(setup)),
      combined_(primary_),
      published_(primary_) {
  const CostmapParameters& parameters = setup.settings.parameters;
  context_->distro = setup.distro;
  context_->footprint = footprintOf(parameters);
  context_->isRolling = parameters.rollingWindow;
  context_->tracksUnknown = parameters.trackUnknownSpace;
  context_->lidarHeight = setup.lidarHeight;
  for (const CostmapPlugin& plugin : setup.settings.plugins) {
    plugins_.push_back(
        std::visit(LayerMaker{setup, *context_, primary_, plugin.name}, plugin.parameters));
  }
  for (const CostmapPlugin& filter : setup.settings.filters) {
    filters_.push_back(
        std::visit(LayerMaker{setup, *context_, primary_, filter.name}, filter.parameters));
  }
}

bool LayeredCostmap::update(const Observation& observation) {
  time_ = observation.time;
  for (const auto& layer : plugins_) {
    layer->observe(observation);
  }
  const std::int64_t due = eventAt(observation.time, updateFrequency_);
  if (due <= lastUpdate_) {
    return false;
  }
  lastUpdate_ = due;
  updateMap(observation);
  return true;
}

void LayeredCostmap::updateNow(const Observation& observation) {
  time_ = observation.time;
  for (const auto& layer : plugins_) {
    layer->observe(observation);
  }
  updateMap(observation);
}

void LayeredCostmap::updateMap(const Observation& observation) {
  Costmap& merged = filters_.empty() ? combined_ : primary_;
  if (context_->isRolling) {
    const Vec2 origin = observation.pose.position - 0.5 * nav2SizeOf(combined_);
    moveOrigin(combined_, origin, context_->freshCost());
    if (!filters_.empty()) {
      moveOrigin(primary_, origin, context_->freshCost());
    }
  }
  CostmapBounds bounds;
  for (const auto& plugin : plugins_) {
    plugin->updateBounds(observation, merged, bounds);
  }
  for (const auto& filter : filters_) {
    filter->updateBounds(observation, merged, bounds);
  }
  const CellWindow window = windowOf(combined_, bounds);
  fillWindow(merged, window, context_->freshCost());
  for (const auto& plugin : plugins_) {
    plugin->updateCosts(merged, window);
  }
  if (!filters_.empty()) {  // so that layers never see what filters have made
    mergeWindow(primary_, window, Merge::Copy, combined_);
    for (const auto& filter : filters_) {
      filter->updateCosts(combined_, window);
      if (auto* const speed = dynamic_cast<SpeedFilter*>(filter.get())) {
        speedLimit_ = speed->takeChange().value_or(speedLimit_);
      }
    }
  }
  ++updates_;
  publish(observation.time);
}

void LayeredCostmap::publish(double time) {
  if (publishFrequency_ > 0.0) {
    const std::int64_t due = eventAt(time, publishFrequency_);
    if (due > lastPublished_) {
      lastPublished_ = due;
      published_ = combined_;
    }
  }
}

const Costmap& LayeredCostmap::published() const {
  return publishFrequency_ > 0.0 ? published_ : combined_;
}

bool LayeredCostmap::isCurrent() const {
  return areCurrent(plugins_) && areCurrent(filters_);
}

std::optional<InflationLaw> LayeredCostmap::inflation(const std::string& name) const {
  for (const auto& plugin : plugins_) {
    const auto* const layer = dynamic_cast<const InflationLayer*>(plugin.get());
    if (layer != nullptr && (name.empty() || plugin->name() == name)) {
      return layer->law();
    }
  }
  return std::nullopt;
}

const CostmapLayer* LayeredCostmap::layer(const std::string& name) const {
  for (const auto* const layers : {&plugins_, &filters_}) {
    for (const auto& layer : *layers) {
      if (layer->name() == name) {
        return layer.get();
      }
    }
  }
  return nullptr;
}

bool LayeredCostmap::clearEntirely(const std::vector<std::string>& plugins) {
  if (!plugins.empty()) {
    return clearSquare(combined_.origin(), 0.0, true, plugins);  // outside of nothing
  }
  fillWindow(combined_, wholeWindow(combined_), context_->freshCost());
  for (const auto* const layers : {&plugins_, &filters_}) {
    for (const auto& layer : *layers) {
      layer->reset(time_);
    }
  }
  return true;
}

bool LayeredCostmap::clearAround(const Vec2& place, double side,
                                 const std::vector<std::string>& plugins) {
  return clearSquare(place, side, false, plugins);
}

bool LayeredCostmap::clearExcept(const Vec2& place, double side,
                                 const std::vector<std::string>& plugins) {
  return clearSquare(place, side, true, plugins);
}

bool LayeredCostmap::clearSquare(const Vec2& place, double side, bool isInverted,
                                 const std::vector<std::string>& plugins) {
  for (const std::string& name : plugins) {
    const CostmapLayer* const named = layer(name);
    if (named == nullptr || !named->isClearable()) {
      return false;
    }
  }
  const Vec2 low = place - Vec2::Constant(0.5 * side);
  for (const auto& plugin : plugins_) {
    const bool isMeant = plugins.empty() ||
                         std::find(plugins.begin(), plugins.end(), plugin->name()) != plugins.end();
    if (isMeant && plugin->isClearable()) {
      plugin->clearArea(low, low + Vec2::Constant(side), isInverted);
    }
  }
  return true;
}

}  // namespace sim2d::nav2
