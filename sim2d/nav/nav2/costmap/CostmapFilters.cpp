#include "sim2d/nav/nav2/costmap/CostmapFilters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"

namespace sim2d::nav2 {
namespace {

constexpr double kMaskFull = 100.0;

}  // namespace

KeepoutFilter::KeepoutFilter(std::string name, const CostmapContext& context,
                             const KeepoutFilterParameters& parameters, const OccupancyGrid& mask)
    : CostmapLayer(std::move(name), context), parameters_(parameters), mask_(mask) {}

void KeepoutFilter::updateBounds(const Observation& observation, const Costmap& /*master*/,
                                 CostmapBounds& bounds) {
  if (!parameters_.enabled) {
    return;
  }
  frame_ = observation.frame;
  wasOverridden_ = isOverridden_;
  isOverridden_ = false;
  if (parameters_.overrideLethalCost && context().distro != Distro::Humble) {
    const std::uint8_t cost = maskCost(pointInMap(frame_, observation.pose.position));
    isOverridden_ = cost == kInscribed || cost == kLethal;
  }
  if (isNew_ || isOverridden_ != wasOverridden_) {  // the whole mask must be applied again
    isNew_ = false;
    for (const double column : {0.0, static_cast<double>(mask_.width())}) {
      for (const double row : {0.0, static_cast<double>(mask_.height())}) {
        const Vec2 corner = mask_.cornerToWorld(column, row);
        bounds.touch(toFrame(frame_, {corner, 0.0}).position);
      }
    }
  }
}

void KeepoutFilter::updateCosts(Costmap& master, const CellWindow& window) {
  if (!parameters_.enabled || mask_.isEmpty()) {
    return;
  }
  for (int row = window.bottom; row < window.top; ++row) {
    for (int column = window.left; column < window.right; ++column) {
      const Cell cell{column, row};
      const std::uint8_t old = master.at(cell);
      std::uint8_t cost = maskCost(pointInMap(frame_, master.cellToWorld(cell)));
      if (cost == kNoInformation || (old != kNoInformation && cost <= old)) {
        continue;
      }
      if (isOverridden_ && cost >= kInscribed) {
        cost = std::max(old == kNoInformation ? kFreeSpace : old,
                        static_cast<std::uint8_t>(parameters_.lethalOverrideCost));
      }
      master.set(cell, cost);
    }
  }
}

void KeepoutFilter::reset(double /*time*/) {
  isNew_ = true;
}

std::uint8_t KeepoutFilter::maskCost(const Vec2& place) const {
  const Cell cell = mask_.worldToCell(place);
  if (!mask_.contains(cell) || mask_.isUnknown(cell)) {
    return kNoInformation;
  }
  return static_cast<std::uint8_t>(std::round(mask_.valueAt(cell) * kLethal / kMaskFull));
}

BinaryFilter::BinaryFilter(std::string name, const CostmapContext& context,
                           const BinaryFilterParameters& parameters, const FilterMask& mask)
    : CostmapLayer(std::move(name), context),
      parameters_(parameters),
      mask_(mask),
      state_(parameters.defaultState) {}

void BinaryFilter::updateBounds(const Observation& observation, const Costmap& /*master*/,
                                CostmapBounds& /*bounds*/) {
  if (!parameters_.enabled || mask_.grid.isEmpty()) {
    return;
  }
  const Cell cell = mask_.grid.worldToCell(observation.pose.position);
  const bool isOnMask = mask_.grid.contains(cell);
  if (isOnMask && mask_.grid.isUnknown(cell)) {
    return;
  }
  const bool isFlipped = isOnMask && mask_.base + mask_.multiplier * mask_.grid.valueAt(cell) >
                                         parameters_.flipThreshold;
  const bool state = isFlipped != parameters_.defaultState;
  changes_ += state != state_ ? 1 : 0;
  state_ = state;
}

SpeedFilter::SpeedFilter(std::string name, const CostmapContext& context,
                         const SpeedFilterParameters& parameters, const FilterMask& mask)
    : CostmapLayer(std::move(name), context), parameters_(parameters), mask_(mask) {}

void SpeedFilter::updateBounds(const Observation& observation, const Costmap& /*master*/,
                               CostmapBounds& /*bounds*/) {
  const Cell cell =
      mask_.grid.worldToCell(pointInMap(observation.frame, observation.pose.position));
  if (!parameters_.enabled || !mask_.grid.contains(cell) || mask_.grid.isUnknown(cell)) {
    return;
  }
  SpeedLimit limit{0.0, mask_.isPercentage};
  const double value = mask_.grid.valueAt(cell);
  if (value != 0.0) {
    const double speed = mask_.base + mask_.multiplier * value;
    const bool isPossible = speed >= 0.0 && (!mask_.isPercentage || speed <= 100.0);
    limit.value = isPossible ? speed : 0.0;
  }
  isChanged_ = isChanged_ || !(limit == limit_);
  limit_ = limit;
}

std::optional<SpeedLimit> SpeedFilter::takeNewLimit() {
  const bool isChanged = std::exchange(isChanged_, false);
  return isChanged ? std::optional<SpeedLimit>(limit_) : std::nullopt;
}

}  // namespace sim2d::nav2
