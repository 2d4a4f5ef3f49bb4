#include "sim2d/nav/nav2/costmap/LayeredCostmap.h"

#include <algorithm>
#include <variant>

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

/// The cost function of the layer of that name, or of any layer if it is empty.
std::optional<InflationCostFunction> findCostFunction(const std::vector<LayerPointer>& layers,
                                                      const std::string& name) {
  for (const LayerPointer& layer : layers) {
    if (auto costFunction = layer->inflation(name)) {
      return costFunction;
    }
  }
  return std::nullopt;
}

bool areCurrent(const std::vector<LayerPointer>& layers) {
  return std::all_of(layers.begin(), layers.end(),
                     [](const auto& layer) { return layer->isCurrent(); });
}

std::vector<LayerPointer> makeLayers(const std::vector<CostmapPlugin>& plugins,
                                     const CostmapContext& context, const Costmap& master,
                                     const CostmapSetup& setup) {
  std::vector<LayerPointer> layers;
  layers.reserve(plugins.size());
  for (const CostmapPlugin& plugin : plugins) {
    layers.push_back(makeLayer(plugin, context, master, setup));
  }
  return layers;
}

/// Layers that work on their own costmap, which is merged into the master like a single layer
/// (nav2_costmap_2d::PluginContainerLayer). Each update first resets its window of that costmap.
class PluginContainerLayer final : public GridLayer {
 public:
  PluginContainerLayer(const PluginContainerLayerParameters& parameters, const LayerSite& site)
      : GridLayer(site, parameters.enabled, site.context.defaultCost()),
        combinationMethod_(parameters.combinationMethod),
        layers_(makeLayers(parameters.layers, site.context, site.master, site.setup)) {}

  void observe(const Observation& observation) override {
    for (const LayerPointer& layer : layers_) {
      layer->observe(observation);
    }
  }

  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override {
    moveWithRobot(observation, master);
    for (const LayerPointer& layer : layers_) {
      if (isEnabled_) {
        layer->updateBounds(observation, grid_, bounds);
      }
    }
  }

  void updateCosts(Costmap& master, const CellWindow& window) override {
    if (!isEnabled_) {
      return;
    }
    fillWindow(grid_, window, emptyCost_);
    for (const LayerPointer& layer : layers_) {
      layer->updateCosts(grid_, window);
    }
    mergeWindow(grid_, window, combinationMethod_, master);
  }

  void reset(double time) override {
    emptyGrid();
    for (const LayerPointer& layer : layers_) {
      layer->reset(time);
    }
  }
  bool isCurrent() const override { return !isEnabled_ || areCurrent(layers_); }
  bool isClearable() const override {
    return std::any_of(layers_.begin(), layers_.end(),
                       [](const auto& layer) { return layer->isClearable(); });
  }

  void clearArea(const Vec2& low, const Vec2& high, bool isInverted) override {
    for (const LayerPointer& layer : layers_) {
      if (layer->isClearable()) {
        layer->clearArea(low, high, isInverted);
      }
    }
  }
  void setPlan(const Path& plan) override {
    for (const LayerPointer& layer : layers_) {
      layer->setPlan(plan);
    }
  }
  /// Names of layers within containers begin with the container's name.
  std::optional<InflationCostFunction> inflation(const std::string& wanted) const override {
    return findCostFunction(layers_, wanted);
  }

 private:
  int combinationMethod_;
  std::vector<LayerPointer> layers_;
};

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
  plugins_ = makeLayers(setup.settings.plugins, *context_, primary_, setup);
  filters_ = makeLayers(setup.settings.filters, *context_, primary_, setup);
}

bool LayeredCostmap::update(const Observation& observation) {
  observe(observation);
  const std::int64_t due = eventIndexAt(observation.time, updateFrequency_);
  if (updateFrequency_ <= 0.0 || due <= lastUpdate_) {  // at 0 Hz Nav2's update thread ends
    return false;
  }
  lastUpdate_ = due;
  updateMap(observation);
  return true;
}

void LayeredCostmap::updateNow(const Observation& observation) {
  observe(observation);
  updateMap(observation);
}

void LayeredCostmap::observe(const Observation& observation) {
  time_ = observation.time;
  for (const auto& layer : plugins_) {
    layer->observe(observation);
  }
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
      speedLimit_ = filter->takeNewLimit().value_or(speedLimit_);
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
    if (const auto state = filter->binaryState()) {
      states[filter->name()] = *state;
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

LayerPointer makeLayer(const PluginContainerLayerParameters& parameters, const LayerSite& site) {
  return std::make_unique<PluginContainerLayer>(parameters, site);
}

LayerPointer makeLayer(const CostmapPlugin& plugin, const CostmapContext& context,
                       const Costmap& master, const CostmapSetup& setup) {
  return std::visit(
      [&](const auto& parameters) {
        return makeLayer(parameters, LayerSite{plugin.name, context, master, setup});
      },
      plugin.parameters);
}

}  // namespace sim2d::nav2
