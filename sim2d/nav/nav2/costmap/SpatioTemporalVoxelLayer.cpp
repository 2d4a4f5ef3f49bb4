#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"

namespace sim2d::nav2 {
namespace {

constexpr int kLinear = 0, kExponential = 1;
constexpr int kDepthCamera = 0;
constexpr double kNearest = 0.01;  // [m]; nearer points are not marked

/// Voxels with expiring marks (spatio_temporal_voxel_layer::SpatioTemporalVoxelLayer, S. Macenski,
/// D. Tsai, M. Feinberg: Spatio-temporal voxel layer, IJARS 2020), in two dimensions: one layer of
/// voxels, marked by the points of the lidar and never cleared by rays. A voxel of age t becomes
/// free when its remaining time, `voxel_decay` - t (linear) or `voxel_decay` exp(-t) (exponential),
/// is below 0. Within the field of view of a clearing source it also ages by `decay_acceleration`
/// t³ / 6 at each update, even if it is occluded.
class SpatioTemporalVoxelLayer final : public GridLayer {
 public:
  SpatioTemporalVoxelLayer(const SpatioTemporalVoxelLayerParameters& parameters,
                           const LayerSite& site)
      : GridLayer(site, parameters.enabled, site.context.defaultCost()), parameters_(parameters) {
    for (const SpatioTemporalVoxelSource& source : parameters.sources) {
      if (source.enabled) {
        ObservationSource scans = static_cast<const ObservationSource&>(source);
        scans.infIsValid = false;  // beams without a hit have no points
        sensors_.push_back({source, {scans, site.context.lidarHeight}});
      }
    }
  }

  void observe(const Observation& observation) override {
    if (observation.scan == nullptr) {
      return;
    }
    lidar_ = observation.scan->sensor;
    hasScan_ = true;
    for (Sensor& sensor : sensors_) {
      sensor.buffer.observe(*observation.scan);
    }
  }

  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override {
    moveWithRobot(observation, master);
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

  void updateCosts(Costmap& master, const CellWindow& window) override {
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

  void reset(double time) override {
    marks_.clear();
    resetGrid();
    for (Sensor& sensor : sensors_) {
      sensor.buffer.resetLastUpdated(time);
    }
  }

  void clearArea(const Vec2& low, const Vec2& high, bool isInverted) override {
    for (auto voxel = marks_.begin(); voxel != marks_.end();) {
      const Vec2 place = centreOf(voxel->first);
      const bool isInside = place.x() > low.x() && place.x() < high.x() && place.y() > low.y() &&
                            place.y() < high.y();
      voxel = isInside != isInverted ? marks_.erase(voxel) : std::next(voxel);
    }
    isCurrent_ = false;
    wasReset_ = true;
  }

 private:
  struct Sensor {
    SpatioTemporalVoxelSource source;
    ObservationBuffer buffer;
  };
  using Voxel = std::int64_t;  // column and row, 32 bits each

  Voxel voxelAt(const Vec2& place) const {
    const auto column = static_cast<std::int64_t>(std::floor(place.x() / parameters_.voxelSize));
    const auto row = static_cast<std::int64_t>(std::floor(place.y() / parameters_.voxelSize));
    return column * (std::int64_t{1} << 32) + row;
  }

  Vec2 centreOf(Voxel voxel) const {
    constexpr std::int64_t kColumn = std::int64_t{1} << 32, kHalf = kColumn / 2;
    const std::int64_t row = ((voxel + kHalf) % kColumn + kColumn) % kColumn - kHalf;
    const std::int64_t column = (voxel - row) / kColumn;
    return parameters_.voxelSize *
           Vec2(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
  }

  /// A camera's view is limited by two planes across its axis, a lidar's by two circles.
  bool isInView(const Sensor& sensor, const Vec2& place) const {
    const Vec2 offset = lidar_.toLocal(place);
    const bool isCamera = sensor.source.modelType == kDepthCamera;
    const double depth = isCamera ? offset.x() : offset.norm();
    return depth >= sensor.source.minZ && depth <= sensor.source.maxZ &&
           std::abs(base::headingOf(offset)) <= sensor.source.horizontalFieldOfView / 2.0;
  }

  /// Whether a voxel has expired; otherwise ages its mark if it is in the view of a clearing
  /// source.
  bool hasDecayed(double& marked, const Vec2& place, double time) const {
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

  void mark(Sensor& sensor, double time) {
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
  void updateGrid(CostmapBounds& bounds) {
    bounds.touch(drawnBounds_);
    drawnBounds_ = CostmapBounds();
    emptyGrid();
    for (const auto& [voxel, marked] : marks_) {
      const Vec2 place = centreOf(voxel);
      if (const auto cell = grid_.worldToCell(place)) {
        grid_.set(*cell, kLethal);
        drawnBounds_.touch(place);
      }
    }
    bounds.touch(drawnBounds_);
  }

  SpatioTemporalVoxelLayerParameters parameters_;
  std::vector<Sensor> sensors_;
  std::unordered_map<Voxel, double> marks_;  // time of each mark [s]; in any order
  Pose2 lidar_;                              // pose at the newest scan
  bool hasScan_ = false;
  CostmapBounds drawnBounds_;  // bounds of the voxels at the last update
  Polygon footprint_;          // in world frame; empty: clears nothing
};

}  // namespace

LayerPointer makeLayer(const SpatioTemporalVoxelLayerParameters& parameters,
                       const LayerSite& site) {
  return std::make_unique<SpatioTemporalVoxelLayer>(parameters, site);
}

}  // namespace sim2d::nav2
