#include "sim2d/nav/nav2/costmap/AsymmetricInflationLayer.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "sim2d/nav/nav2/costmap/CostmapCells.h"

namespace sim2d::nav2 {
namespace {

InflationLayerParameters withFactor(const AsymmetricInflationLayerParameters& parameters,
                                    double factor) {
  InflationLayerParameters one;
  one.enabled = parameters.enabled;
  one.inflationRadius = parameters.inflationRadius;
  one.costScalingFactor = factor;
  one.inflateUnknown = parameters.inflateUnknown;
  one.inflateAroundUnknown = parameters.inflateAroundUnknown;
  return one;
}

CostmapContext ofJazzy(CostmapContext context) {
  context.distro = Distro::Jazzy;
  return context;
}

}  // namespace

LegacyInflationLayer::LegacyInflationLayer(std::string name, const CostmapContext& context,
                                           const LegacyInflationLayerParameters& parameters,
                                           double resolution)
    : CostmapContext(ofJazzy(context)),
      InflationLayer(std::move(name), static_cast<const CostmapContext&>(*this), parameters,
                     resolution) {}

AsymmetricInflationLayer::AsymmetricInflationLayer(
    const std::string& name, const CostmapContext& context,
    const AsymmetricInflationLayerParameters& parameters, double resolution)
    : CostmapLayer(name, context),
      parameters_(parameters),
      left_(name, context, withFactor(parameters, parameters.costScalingFactorLeft), resolution),
      right_(name, context, withFactor(parameters, parameters.costScalingFactorRight), resolution),
      both_(name, context,
            withFactor(parameters, std::max(parameters.costScalingFactorLeft,
                                            parameters.costScalingFactorRight)),
            resolution) {}

void AsymmetricInflationLayer::setPlan(const Path& plan) {
  isNew_ = isNew_ || plan != plan_;
  plan_ = plan;
}

void AsymmetricInflationLayer::updateBounds(const Observation& observation, const Costmap& master,
                                            CostmapBounds& bounds) {
  const bool wasSided = isSided_;
  isSided_ = plan_.size() >= 2 && (observation.pose.position - plan_.back().position).norm() >
                                      parameters_.goalDistanceThreshold;
  left_.updateBounds(observation, master, bounds);
  if (wasSided != isSided_ || (isNew_ && isSided_)) {
    bounds = unboundedBounds();
  }
  isNew_ = false;
}

void AsymmetricInflationLayer::updateCosts(Costmap& master, const CellWindow& window) {
  isCurrent_ = true;
  if (!isSided_) {
    both_.updateCosts(master, window);
    return;
  }
  Costmap left = master, right = master;
  removeOtherSide(master, left, right);
  left_.updateCosts(left, window);
  right_.updateCosts(right, window);
  for (int row = window.bottom; row < window.top; ++row) {
    for (int column = window.left; column < window.right; ++column) {
      const Cell cell{column, row};
      const std::uint8_t old = master.at(cell), l = left.at(cell), r = right.at(cell);
      if (old != kNoInformation) {
        master.set(cell, std::max({old, l, r}));
      } else if (!isSource(old)) {  // 255 only where neither side raises it
        master.set(cell, l == old ? r : r == old ? l : std::max(l, r));
      }
    }
  }
}

bool AsymmetricInflationLayer::isSource(std::uint8_t cost) const {
  return cost == kLethal || (cost == kNoInformation && parameters_.inflateAroundUnknown);
}

/// Keeps in `left` and `right` only the obstacles on that side of the plan.
void AsymmetricInflationLayer::removeOtherSide(const Costmap& master, Costmap& left,
                                               Costmap& right) const {
  for (int row = 0; row < master.height(); ++row) {
    for (int column = 0; column < master.width(); ++column) {
      const Cell cell{column, row};
      if (isSource(master.at(cell))) {
        (isLeft(master.cellToWorld(cell)) ? right : left).set(cell, kFreeSpace);
      }
    }
  }
}

void AsymmetricInflationLayer::reset(double time) {
  left_.reset(time);
  plan_.clear();
  isNew_ = true;
  isCurrent_ = false;
}

InflationLaw AsymmetricInflationLayer::law() const {
  InflationLaw law = left_.law();
  law.scaling = 0.5 * (parameters_.costScalingFactorLeft + parameters_.costScalingFactorRight);
  return law;
}

bool AsymmetricInflationLayer::isLeft(const Vec2& place) const {
  std::size_t nearest = 0;
  double least = (plan_[0].position - place).squaredNorm();
  for (std::size_t i = 1; i < plan_.size(); ++i) {
    const double square = (plan_[i].position - place).squaredNorm();
    if (square < least) {
      least = square;
      nearest = i;
    }
  }
  const std::size_t from = std::min(nearest, plan_.size() - 2);
  const Vec2 way = plan_[from + 1].position - plan_[from].position;
  const Vec2 offset = place - plan_[from].position;
  return way.x() * offset.y() - way.y() * offset.x() > 0.0;
}

}  // namespace sim2d::nav2
