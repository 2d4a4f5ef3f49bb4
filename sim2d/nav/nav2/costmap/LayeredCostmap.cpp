#include "sim2d/nav/nav2/costmap/LayeredCostmap.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "sim2d/nav/SensedWorld.h"
#include "sim2d/nav/nav2/costmap/AsymmetricInflationLayer.h"
#include "sim2d/nav/nav2/costmap/ContainerLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapCells.h"
#include "sim2d/nav/nav2/costmap/CostmapFilters.h"
#include "sim2d/nav/nav2/costmap/InflationLayer.h"
#include "sim2d/nav/nav2/costmap/LayerMaker.h"
#include "sim2d/nav/nav2/costmap/StaticLayer.h"

namespace sim2d::nav2 {
namespace {

CostmapFootprint footprintOf(const CostmapParameters& parameters) {
  // As in Nav2 a text that is no footprint leaves the radius.
  const base::Result<Polygon> corners = readPolygon(parameters.footprint);
  return costmapFootprint(parameters.robotRadius, corners ? *corners : Polygon{},
                          parameters.footprintPadding);
}

bool hasStaticLayer(const std::vector<CostmapPlugin>& plugins) {
  return std::any_of(plugins.begin(), plugins.end(), [](const CostmapPlugin& plugin) {
    const auto* const container = std::get_if<ContainerLayerParameters>(&plugin.parameters);
    return std::holds_alternative<StaticLayerParameters>(plugin.parameters) ||
           (container != nullptr && hasStaticLayer(container->layers));
  });
}

/// The cells of the costmap, fresh.
Costmap emptyCostmap(const CostmapSetup& setup) {
  const CostmapParameters& parameters = setup.settings.parameters;
  Costmap costmap(static_cast<int>(parameters.width / parameters.resolution),
                  static_cast<int>(parameters.height / parameters.resolution),
                  parameters.resolution, {parameters.originX, parameters.originY});
  if (!parameters.rollingWindow && !setup.map.isEmpty() && hasStaticLayer(setup.settings.plugins)) {
    costmap = costmapOf(setup.map, parameters, setup.distro);
  }
  fillWindow(costmap, wholeWindow(costmap),
             parameters.trackUnknownSpace ? kNoInformation : kFreeSpace);
  return costmap;
}

/// The inflation law of a layer with that name, or of any with an empty one; those within
/// containers have the name of the container in front.
std::optional<InflationLaw> lawIn(const std::vector<std::unique_ptr<CostmapLayer>>& layers,
                                  const std::string& name) {
  for (const auto& each : layers) {
    if (const auto* const container = dynamic_cast<const ContainerLayer*>(each.get())) {
      if (auto law = lawIn(container->layers(), name)) {
        return law;
      }
    }
    if (!name.empty() && each->name() != name) {
      continue;
    }
    if (const auto* const inflation = dynamic_cast<const InflationLayer*>(each.get())) {
      return inflation->law();
    }
    if (const auto* const sided = dynamic_cast<const AsymmetricInflationLayer*>(each.get())) {
      return sided->law();
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
  const std::int64_t due = eventAt(observation.time, updateFrequency_);
  if (updateFrequency_ <= 0.0 || due <= lastUpdate_) {  // at 0 Hz the thread of Nav2 ends
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
  return lawIn(plugins_, name);
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
