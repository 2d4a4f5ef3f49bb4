#include "sim2d/nav/nav2/costmap/SpatioTemporalVoxelLayer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"

namespace sim2d::nav2 {
namespace {

constexpr int kLinear = 0, kExponential = 1;
constexpr int kDepthCamera = 0;
constexpr double kNearest = 0.01;  // [m]; nearer points are not marked

ObservationSource asObservationSource(const SpatioTemporalVoxelSource& source) {
  ObservationSource taken;
  taken.name = source.name;
  taken.observationPersistence = source.observationPersistence;
  taken.expectedUpdateRate = source.expectedUpdateRate;
  taken.minObstacleHeight = source.minObstacleHeight;
  taken.maxObstacleHeight = source.maxObstacleHeight;
  return taken;
}

}  // namespace

SpatioTemporalVoxelLayer::SpatioTemporalVoxelLayer(
    std::string name, const CostmapContext& context,
    const SpatioTemporalVoxelLayerParameters& parameters, const Costmap& master)
    : CostmapLayer(std::move(name), context), parameters_(parameters), grid_(master) {
  for (const SpatioTemporalVoxelSource& source : parameters.sources) {
    if (source.enabled) {
      sensors_.push_back({source, {asObservationSource(source), context.lidarHeight}});
    }
  }
  fillWindow(grid_, wholeWindow(grid_), context.defaultCost());
}

void SpatioTemporalVoxelLayer::observe(const Observation& observation) {
  if (observation.scan == nullptr) {
    return;
  }
  lidar_ = observation.scan->sensor;
  hasScan_ = true;
  for (Sensor& sensor : sensors_) {
    sensor.buffer.observe(*observation.scan);
  }
}

void SpatioTemporalVoxelLayer::updateBounds(const Observation& observation, const Costmap& master,
                                            CostmapBounds& bounds) {
  moveWithRobot(grid_, observation, master, context().defaultCost());
  if (!parameters_.enabled) {
    return;
  }
  for (auto voxel = marks_.begin(); voxel != marks_.end();) {
    const bool isGone = hasDecayed(voxel->second, centreOf(voxel->first), observation.time);
    voxel = isGone ? marks_.erase(voxel) : std::next(voxel);
  }
  bool areFresh = true;
  for (Sensor& sensor : sensors_) {
    areFresh = areFresh && sensor.buffer.isCurrent(observation.time);
    if (sensor.source.marking) {
      mark(sensor, observation.time);
    }
  }
  isCurrent_ = areFresh && !wasReset_;
  updateGrid(bounds);
  footprint_ = clearedFootprint(parameters_.updateFootprintEnabled, observation, bounds);
}

void SpatioTemporalVoxelLayer::updateCosts(Costmap& master, const CellWindow& window) {
  if (!parameters_.enabled) {
    return;
  }
  if (std::exchange(wasReset_, false)) {
    isCurrent_ = true;
  }
  fillPolygon(grid_, footprint_, kFreeSpace);
  mergeWindow(grid_, window,
              parameters_.combinationMethod == 0 ? CombinationMethod::Overwrite
                                                 : CombinationMethod::Maximum,
              master);
}

void SpatioTemporalVoxelLayer::reset(double time) {
  marks_.clear();
  fillWindow(grid_, wholeWindow(grid_), context().defaultCost());
  for (Sensor& sensor : sensors_) {
    sensor.buffer.resetLastUpdated(time);
  }
  isCurrent_ = false;
  wasReset_ = true;
}

void SpatioTemporalVoxelLayer::clearArea(const Vec2& low, const Vec2& high, bool isInverted) {
  for (auto voxel = marks_.begin(); voxel != marks_.end();) {
    const Vec2 place = centreOf(voxel->first);
    const bool isInside =
        place.x() > low.x() && place.x() < high.x() && place.y() > low.y() && place.y() < high.y();
    voxel = isInside != isInverted ? marks_.erase(voxel) : std::next(voxel);
  }
  isCurrent_ = false;
  wasReset_ = true;
}

SpatioTemporalVoxelLayer::Voxel SpatioTemporalVoxelLayer::voxelAt(const Vec2& place) const {
  const auto column = static_cast<std::int64_t>(std::floor(place.x() / parameters_.voxelSize));
  const auto row = static_cast<std::int64_t>(std::floor(place.y() / parameters_.voxelSize));
  return column * (std::int64_t{1} << 32) + row;
}

Vec2 SpatioTemporalVoxelLayer::centreOf(Voxel voxel) const {
  constexpr std::int64_t kColumn = std::int64_t{1} << 32, kHalf = kColumn / 2;
  const std::int64_t row = ((voxel + kHalf) % kColumn + kColumn) % kColumn - kHalf;
  const std::int64_t column = (voxel - row) / kColumn;
  return parameters_.voxelSize *
         Vec2(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
}

/// A camera's view is limited by two planes across its axis, a lidar's by two circles.
bool SpatioTemporalVoxelLayer::isInView(const Sensor& sensor, const Vec2& place) const {
  const Vec2 offset = lidar_.toLocal(place);
  const bool isCamera = sensor.source.modelType == kDepthCamera;
  const double depth = isCamera ? offset.x() : offset.norm();
  return depth >= sensor.source.minZ && depth <= sensor.source.maxZ &&
         std::abs(base::headingOf(offset)) <= sensor.source.horizontalFieldOfView / 2.0;
}

/// Whether a voxel has expired; otherwise ages its mark if it is in the view of a clearing source.
bool SpatioTemporalVoxelLayer::hasDecayed(double& marked, const Vec2& place, double time) const {
  const double age = time - marked, decay = parameters_.voxelDecay;
  const double left = parameters_.decayModel == kLinear        ? decay - age
                      : parameters_.decayModel == kExponential ? decay * base::exp(-age)
                                                               : std::abs(decay);
  for (const Sensor& sensor : sensors_) {
    if (hasScan_ && sensor.source.clearing && isInView(sensor, place)) {
      const double acceleratedDecay = sensor.source.decayAcceleration * age * age * age / 6.0;
      marked -= acceleratedDecay;
      return left - acceleratedDecay < 0.0;
    }
  }
  return left < 0.0;
}

void SpatioTemporalVoxelLayer::mark(Sensor& sensor, double time) {
  for (const PointCloud& cloud : sensor.buffer.clouds(time)) {
    for (const Vec2& point : cloud.points) {
      const double distance = (point - cloud.origin).norm();
      if (distance <= sensor.source.obstacleRange && distance >= kNearest) {
        marks_[voxelAt(point)] = time;
      }
    }
  }
}

/// Writes the current voxels into the grid.
void SpatioTemporalVoxelLayer::updateGrid(CostmapBounds& bounds) {
  bounds.touch(drawnBounds_);
  drawnBounds_ = CostmapBounds();
  fillWindow(grid_, wholeWindow(grid_), context().defaultCost());
  for (const auto& [voxel, marked] : marks_) {
    const Vec2 place = centreOf(voxel);
    if (const auto cell = grid_.worldToCell(place)) {
      grid_.set(*cell, kLethal);
      drawnBounds_.touch(place);
    }
  }
  bounds.touch(drawnBounds_);
}

}  // namespace sim2d::nav2
