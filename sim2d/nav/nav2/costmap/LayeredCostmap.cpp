#include "sim2d/nav/nav2/costmap/LayeredCostmap.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "sim2d/nav/Observation.h"
#include "sim2d/nav/nav2/costmap/CostmapFilters.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/DenoiseLayer.h"
#include "sim2d/nav/nav2/costmap/InflationLayer.h"
#include "sim2d/nav/nav2/costmap/ObstacleLayer.h"
#include "sim2d/nav/nav2/costmap/PluginContainerLayer.h"
#include "sim2d/nav/nav2/costmap/RangeSensorLayer.h"
#include "sim2d/nav/nav2/costmap/SocialLayer.h"
#include "sim2d/nav/nav2/costmap/SpatioTemporalVoxelLayer.h"
#include "sim2d/nav/nav2/costmap/StaticLayer.h"

namespace sim2d::nav2 {
namespace {

CostmapFootprint footprintOf(const CostmapParameters& parameters) {
  // As in Nav2 the radius is used if the text is not a valid footprint.
  const base::Result<Polygon> corners = readPolygon(parameters.footprint);
  return costmapFootprint(parameters.robotRadius, corners ? *corners : Polygon{},
                          parameters.footprintPadding);
}

bool hasStaticLayer(const std::vector<CostmapPlugin>& plugins) {
  return std::any_of(plugins.begin(), plugins.end(), [](const CostmapPlugin& plugin) {
    const auto* const container = std::get_if<PluginContainerLayerParameters>(&plugin.parameters);
    return std::holds_alternative<StaticLayerParameters>(plugin.parameters) ||
           (container != nullptr && hasStaticLayer(container->layers));
  });
}

/// The cells of the costmap with initial costs.
Costmap emptyCostmap(const CostmapSetup& setup) {
  const CostmapParameters& parameters = setup.settings.parameters;
  Costmap costmap(static_cast<int>(parameters.width / parameters.resolution),
                  static_cast<int>(parameters.height / parameters.resolution),
                  parameters.resolution, {parameters.originX, parameters.originY});
  if (!parameters.rollingWindow && !setup.map.isEmpty() && hasStaticLayer(setup.settings.plugins)) {
    costmap = costmapFromMap(setup.map, parameters, setup.distro);
  }
  fillWindow(costmap, wholeWindow(costmap),
             parameters.trackUnknownSpace ? kNoInformation : kFreeSpace);
  return costmap;
}

/// The cost function of the layer of that name, or of any layer if it is empty. Names of layers
/// within containers begin with the container's name.
std::optional<InflationCostFunction> findCostFunction(
    const std::vector<std::unique_ptr<CostmapLayer>>& layers, const std::string& name) {
  for (const auto& each : layers) {
    if (const auto* const container = dynamic_cast<const PluginContainerLayer*>(each.get())) {
      if (auto costFunction = findCostFunction(container->layers(), name)) {
        return costFunction;
      }
    }
    if (!name.empty() && each->name() != name) {
      continue;
    }
    if (const auto* const inflation = dynamic_cast<const InflationLayer*>(each.get())) {
      return inflation->costFunction();
    }
    if (const auto* const asymmetric = dynamic_cast<const AsymmetricInflationLayer*>(each.get())) {
      return asymmetric->costFunction();
    }
  }
  return std::nullopt;
}

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
    plugins_.push_back(makeLayer(plugin, setup, *context_, primary_));
  }
  for (const CostmapPlugin& filter : setup.settings.filters) {
    filters_.push_back(makeLayer(filter, setup, *context_, primary_));
  }
}

bool LayeredCostmap::update(const Observation& observation) {
  time_ = observation.time;
  for (const auto& layer : plugins_) {
    layer->observe(observation);
  }
  const std::int64_t due = eventIndexAt(observation.time, updateFrequency_);
  if (updateFrequency_ <= 0.0 || due <= lastUpdate_) {  // at 0 Hz Nav2's update thread ends
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
    moveOrigin(combined_, origin, context_->defaultCost());
    if (!filters_.empty()) {
      moveOrigin(primary_, origin, context_->defaultCost());
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
  fillWindow(merged, window, context_->defaultCost());
  for (const auto& plugin : plugins_) {
    plugin->updateCosts(merged, window);
  }
  if (!filters_.empty()) {  // so that layers do not see the costs of filters
    mergeWindow(primary_, window, CombinationMethod::Copy, combined_);
    for (const auto& filter : filters_) {
      filter->updateCosts(combined_, window);
      if (auto* const speed = dynamic_cast<SpeedFilter*>(filter.get())) {
        speedLimit_ = speed->takeNewLimit().value_or(speedLimit_);
      }
    }
  }
  ++updates_;
  publish(observation.time);
}

void LayeredCostmap::publish(double time) {
  if (publishFrequency_ > 0.0) {
    const std::int64_t due = eventIndexAt(time, publishFrequency_);
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

std::optional<InflationCostFunction> LayeredCostmap::inflation(const std::string& name) const {
  return findCostFunction(plugins_, name);
}

void LayeredCostmap::setPlan(const Path& plan) {
  for (const auto& layer : plugins_) {
    layer->setPlan(plan);
  }
}

std::map<std::string, BinaryState> LayeredCostmap::binaryStates() const {
  std::map<std::string, BinaryState> states;
  for (const auto& filter : filters_) {
    if (const auto* const binary = dynamic_cast<const BinaryFilter*>(filter.get())) {
      states[filter->name()] = {binary->state(), binary->changes()};
    }
  }
  return states;
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
    return clearSquare(combined_.origin(), 0.0, true, plugins);  // the complement of an empty area
  }
  fillWindow(combined_, wholeWindow(combined_), context_->defaultCost());
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

namespace {

/// Creates the layer for each type of parameters.
struct LayerFactory {
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
  Layer operator()(const LegacyInflationLayerParameters& parameters) const {
    return std::make_unique<LegacyInflationLayer>(name, context, parameters, master.resolution());
  }
  Layer operator()(const AsymmetricInflationLayerParameters& parameters) const {
    return std::make_unique<AsymmetricInflationLayer>(name, context, parameters,
                                                      master.resolution());
  }
  Layer operator()(const SocialLayerParameters& parameters) const {
    return std::make_unique<SocialLayer>(name, context, parameters);
  }
  Layer operator()(const DenoiseLayerParameters& parameters) const {
    return std::make_unique<DenoiseLayer>(name, context, parameters);
  }
  Layer operator()(const RangeSensorLayerParameters& parameters) const {
    return std::make_unique<RangeSensorLayer>(name, context, parameters, master);
  }
  Layer operator()(const SpatioTemporalVoxelLayerParameters& parameters) const {
    return std::make_unique<SpatioTemporalVoxelLayer>(name, context, parameters, master);
  }
  Layer operator()(const PluginContainerLayerParameters& parameters) const {
    PluginContainerLayer::Layers layers;
    layers.reserve(parameters.layers.size());
    for (const CostmapPlugin& inner : parameters.layers) {
      layers.push_back(makeLayer(inner, setup, context, master));
    }
    return std::make_unique<PluginContainerLayer>(name, context, parameters, master,
                                                  std::move(layers));
  }
  Layer operator()(const KeepoutFilterParameters& parameters) const {
    return std::make_unique<KeepoutFilter>(name, context, parameters, mask().grid);
  }
  Layer operator()(const SpeedFilterParameters& parameters) const {
    return std::make_unique<SpeedFilter>(name, context, parameters, mask());
  }
  Layer operator()(const BinaryFilterParameters& parameters) const {
    return std::make_unique<BinaryFilter>(name, context, parameters, mask());
  }
  FilterMask mask() const {
    const auto found = setup.masks.find(name);
    return found == setup.masks.end() ? FilterMask{} : found->second;
  }
};

}  // namespace

std::unique_ptr<CostmapLayer> makeLayer(const CostmapPlugin& plugin, const CostmapSetup& setup,
                                        const CostmapContext& context, const Costmap& master) {
  return std::visit(LayerFactory{setup, context, master, plugin.name}, plugin.parameters);
}

}  // namespace sim2d::nav2
