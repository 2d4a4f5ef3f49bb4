#include "sim2d/nav/nav2/costmap/PluginContainerLayer.h"

#include <algorithm>
#include <utility>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"

namespace sim2d::nav2 {

PluginContainerLayer::PluginContainerLayer(std::string name, const CostmapContext& context,
                                           const PluginContainerLayerParameters& parameters,
                                           const Costmap& master, Layers layers)
    : CostmapLayer(std::move(name), context),
      parameters_(parameters),
      layers_(std::move(layers)),
      grid_(master) {
  fillWindow(grid_, wholeWindow(grid_), context.defaultCost());
}

void PluginContainerLayer::observe(const Observation& observation) {
  for (const auto& layer : layers_) {
    layer->observe(observation);
  }
}

void PluginContainerLayer::updateBounds(const Observation& observation, const Costmap& master,
                                        CostmapBounds& bounds) {
  moveWithRobot(grid_, observation, master, context().defaultCost());
  if (!parameters_.enabled) {
    return;
  }
  for (const auto& layer : layers_) {
    layer->updateBounds(observation, grid_, bounds);
  }
}

void PluginContainerLayer::updateCosts(Costmap& master, const CellWindow& window) {
  if (!parameters_.enabled) {
    return;
  }
  fillWindow(grid_, window, context().defaultCost());
  for (const auto& layer : layers_) {
    layer->updateCosts(grid_, window);
  }
  mergeWindow(grid_, window, parameters_.combinationMethod, master);
}

void PluginContainerLayer::reset(double time) {
  fillWindow(grid_, wholeWindow(grid_), context().defaultCost());
  for (const auto& layer : layers_) {
    layer->reset(time);
  }
}

bool PluginContainerLayer::isCurrent() const {
  return !parameters_.enabled || std::all_of(layers_.begin(), layers_.end(),
                                             [](const auto& layer) { return layer->isCurrent(); });
}

bool PluginContainerLayer::isClearable() const {
  return std::any_of(layers_.begin(), layers_.end(),
                     [](const auto& layer) { return layer->isClearable(); });
}

void PluginContainerLayer::clearArea(const Vec2& low, const Vec2& high, bool isInverted) {
  for (const auto& layer : layers_) {
    if (layer->isClearable()) {
      layer->clearArea(low, high, isInverted);
    }
  }
}

void PluginContainerLayer::setPlan(const Path& plan) {
  for (const auto& layer : layers_) {
    layer->setPlan(plan);
  }
}

}  // namespace sim2d::nav2
