#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"

namespace sim2d::nav2 {

/// Layers that work on their own costmap, which is merged into the master like a single layer
/// (nav2_costmap_2d::PluginContainerLayer). Each update first resets its window of that costmap.
class PluginContainerLayer final : public CostmapLayer {
 public:
  using Layers = std::vector<std::unique_ptr<CostmapLayer>>;
  /// `master`: size and origin of the costmap; `layers`: created for it, in update order.
  PluginContainerLayer(std::string name, const CostmapContext& context,
                       const PluginContainerLayerParameters& parameters, const Costmap& master,
                       Layers layers);

  void observe(const Observation& observation) override;
  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override;
  void updateCosts(Costmap& master, const CellWindow& window) override;
  void reset(double time) override;
  bool isCurrent() const override;
  bool isClearable() const override;
  void clearArea(const Vec2& low, const Vec2& high, bool isInverted) override;
  void setPlan(const Path& plan) override;
  const Costmap* grid() const override { return &grid_; }

  const Layers& layers() const { return layers_; }

 private:
  PluginContainerLayerParameters parameters_;
  Layers layers_;
  Costmap grid_;
};

}  // namespace sim2d::nav2
