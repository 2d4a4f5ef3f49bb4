#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"

/// Costmap filters, which apply masks to the merged costs, and the denoise layer.
namespace sim2d::nav2 {
namespace {

constexpr double kMaskFull = 100.0;

FilterMask maskOf(const LayerSite& site) {
  const auto found = site.setup.masks.find(site.name);
  return found == site.setup.masks.end() ? FilterMask{} : found->second;
}

/// The mask raises costs (nav2_costmap_2d::KeepoutFilter): 100 becomes 254, unknown cells have no
/// effect.
class KeepoutFilter final : public CostmapLayer {
 public:
  KeepoutFilter(const KeepoutFilterParameters& parameters, const LayerSite& site)
      : CostmapLayer(site), parameters_(parameters), mask_(maskOf(site).grid) {}

  void updateBounds(const Observation& observation, const Costmap& /*master*/,
                    CostmapBounds& bounds) override {
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

  void updateCosts(Costmap& master, const CellWindow& window) override {
    if (!parameters_.enabled || mask_.isEmpty()) {
      return;
    }
    forEachCell(window, [&](Cell cell) {
      const std::uint8_t old = master.at(cell);
      std::uint8_t cost = maskCost(pointInMap(frame_, master.cellToWorld(cell)));
      if (cost == kNoInformation || (old != kNoInformation && cost <= old)) {
        return;
      }
      if (isOverridden_ && cost >= kInscribed) {
        cost = std::max(old == kNoInformation ? kFreeSpace : old,
                        static_cast<std::uint8_t>(parameters_.lethalOverrideCost));
      }
      master.set(cell, cost);
    });
  }

  void reset(double /*time*/) override { isNew_ = true; }

 private:
  std::uint8_t maskCost(const Vec2& place) const {
    const Cell cell = mask_.worldToCell(place);
    if (!mask_.contains(cell) || mask_.isUnknown(cell)) {
      return kNoInformation;
    }
    return static_cast<std::uint8_t>(std::round(mask_.valueAt(cell) * kLethal / kMaskFull));
  }

  KeepoutFilterParameters parameters_;
  OccupancyGrid mask_;
  Pose2 frame_;  // of the costmap, in the map frame
  bool isNew_ = true;
  bool isOverridden_ = false, wasOverridden_ = false;  // the robot is in a zone and may leave it
};

/// The mask under the robot is a switch (nav2_costmap_2d::BinaryFilter): the state is
/// `default_state`, and the opposite where base + multiplier * value > `flip_threshold`. Off the
/// mask it returns to the default, over unknown cells it is kept. Does not change costs.
class BinaryFilter final : public CostmapLayer {
 public:
  BinaryFilter(const BinaryFilterParameters& parameters, const LayerSite& site)
      : CostmapLayer(site),
        parameters_(parameters),
        mask_(maskOf(site)),
        published_{parameters.defaultState, 0} {}

  void updateBounds(const Observation& observation, const Costmap& /*master*/,
                    CostmapBounds& /*bounds*/) override {
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
    published_.changes += state != published_.state ? 1 : 0;
    published_.state = state;
  }
  void reset(double /*time*/) override { published_.state = parameters_.defaultState; }
  std::optional<BinaryState> binaryState() const override { return published_; }

 private:
  BinaryFilterParameters parameters_;
  FilterMask mask_;
  BinaryState published_;
};

/// The mask under the robot sets a speed limit (nav2_costmap_2d::SpeedFilter): base + multiplier *
/// value. 0 means no limit; unknown cells and positions off the mask keep the previous limit.
class SpeedFilter final : public CostmapLayer {
 public:
  SpeedFilter(const SpeedFilterParameters& parameters, const LayerSite& site)
      : CostmapLayer(site), parameters_(parameters), mask_(maskOf(site)) {}

  void updateBounds(const Observation& observation, const Costmap& /*master*/,
                    CostmapBounds& /*bounds*/) override {
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
  std::optional<SpeedLimit> takeNewLimit() override {
    const bool isChanged = std::exchange(isChanged_, false);
    return isChanged ? std::optional<SpeedLimit>(limit_) : std::nullopt;
  }

 private:
  SpeedFilterParameters parameters_;
  FilterMask mask_;
  SpeedLimit limit_;
  bool isChanged_ = false;
};

/// Frees small groups of obstacle cells in the merged costs (nav2_costmap_2d::DenoiseLayer). As in
/// Nav2 an obstacle is a cell of cost 254 or 253, or an unknown one in a costmap that does not
/// track unknown space. Groups are searched only in the updated window, so one at its border may be
/// cut.
class DenoiseLayer final : public CostmapLayer {
 public:
  DenoiseLayer(const DenoiseLayerParameters& parameters, const LayerSite& site)
      : CostmapLayer(site), parameters_(parameters) {}

  void updateCosts(Costmap& master, const CellWindow& window) override {
    const bool isEmpty = window.left >= window.right || window.bottom >= window.top;
    if (!parameters_.enabled || parameters_.minimalGroupSize <= 1 || isEmpty) {
      return;
    }
    window_ = window;
    seen_.assign(seenIndex({window.right - 1, window.top - 1}) + 1, 0);
    forEachCell(window, [&](Cell cell) {
      if (seen_[seenIndex(cell)] != 0 || !isObstacle(master.at(cell))) {
        return;
      }
      findGroup(master, cell);
      if (group_.size() < static_cast<std::size_t>(parameters_.minimalGroupSize)) {
        for (const Cell& each : group_) {
          master.set(each, kFreeSpace);
        }
      }
    });
  }

 private:
  std::size_t seenIndex(Cell cell) const {
    const auto width = static_cast<std::size_t>(window_.right - window_.left);
    return static_cast<std::size_t>(cell.row - window_.bottom) * width +
           static_cast<std::size_t>(cell.column - window_.left);
  }
  bool isObstacle(std::uint8_t cost) const {
    return cost == kLethal || cost == kInscribed ||
           (cost == kNoInformation && !context().tracksUnknown);
  }

  /// Collects the obstacle cells connected to `from` and marks them as seen.
  void findGroup(const Costmap& master, Cell from) {
    group_.assign(1, from);
    seen_[seenIndex(from)] = 1;
    for (std::size_t i = 0; i < group_.size(); ++i) {
      const Cell at = group_[i];
      forEachCell({at.column - 1, at.row - 1, at.column + 2, at.row + 2}, [&](Cell next) {
        const bool isDiagonal =
            std::abs(next.row - at.row) + std::abs(next.column - at.column) == 2;
        if ((isDiagonal && parameters_.groupConnectivityType == 4) || !window_.contains(next) ||
            seen_[seenIndex(next)] != 0 || !isObstacle(master.at(next))) {
          return;
        }
        seen_[seenIndex(next)] = 1;
        group_.push_back(next);
      });
    }
  }

  DenoiseLayerParameters parameters_;
  CellWindow window_;        // of the current update
  std::vector<char> seen_;   // cells of the window, row-major
  std::vector<Cell> group_;  // the last group found
};

}  // namespace

LayerPointer makeLayer(const KeepoutFilterParameters& parameters, const LayerSite& site) {
  return std::make_unique<KeepoutFilter>(parameters, site);
}
LayerPointer makeLayer(const BinaryFilterParameters& parameters, const LayerSite& site) {
  return std::make_unique<BinaryFilter>(parameters, site);
}
LayerPointer makeLayer(const SpeedFilterParameters& parameters, const LayerSite& site) {
  return std::make_unique<SpeedFilter>(parameters, site);
}
LayerPointer makeLayer(const DenoiseLayerParameters& parameters, const LayerSite& site) {
  return std::make_unique<DenoiseLayer>(parameters, site);
}

}  // namespace sim2d::nav2
