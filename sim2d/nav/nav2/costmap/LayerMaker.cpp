#include "sim2d/nav/nav2/costmap/LayerMaker.h"

#include <string>
#include <utility>
#include <variant>

#include "sim2d/nav/nav2/costmap/AsymmetricInflationLayer.h"
#include "sim2d/nav/nav2/costmap/ContainerLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapFilters.h"
#include "sim2d/nav/nav2/costmap/DecayLayer.h"
#include "sim2d/nav/nav2/costmap/DenoiseLayer.h"
#include "sim2d/nav/nav2/costmap/InflationLayer.h"
#include "sim2d/nav/nav2/costmap/ObstacleLayer.h"
#include "sim2d/nav/nav2/costmap/RangeSensorLayer.h"
#include "sim2d/nav/nav2/costmap/SocialLayer.h"
#include "sim2d/nav/nav2/costmap/StaticLayer.h"

namespace sim2d::nav2 {
namespace {

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
  Layer operator()(const DecayLayerParameters& parameters) const {
    return std::make_unique<DecayLayer>(name, context, parameters, master);
  }
  Layer operator()(const ContainerLayerParameters& parameters) const {
    ContainerLayer::Layers layers;
    layers.reserve(parameters.layers.size());
    for (const CostmapPlugin& inner : parameters.layers) {
      layers.push_back(makeLayer(inner, setup, context, master));
    }
    return std::make_unique<ContainerLayer>(name, context, parameters, master, std::move(layers));
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
  return std::visit(LayerMaker{setup, context, master, plugin.name}, plugin.parameters);
}

}  // namespace sim2d::nav2
