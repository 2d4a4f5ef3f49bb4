#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"

namespace sim2d::nav2 {
namespace {

constexpr double kInfiniteMargin = 1e-4;      // [m], as in Nav2's ObstacleLayer
constexpr double kBufferTimeRounding = 1e-9;  // [s], rounding of times

}  // namespace

void ObservationBuffer::observe(const LaserScan& scan) {
  if (!(scan.time > lastScan_)) {
    return;
  }
  lastScan_ = scan.time;
  lastTime_ = scan.time;
  PointCloud cloud;
  if (source_.observationPersistence == 0.0 && !clouds_.empty()) {
    cloud = std::move(clouds_.front());  // reuses its memory
    clouds_.clear();
    cloud.points.clear();
  }
  cloud.origin = scan.sensor.position;
  cloud.time = scan.time;
  if (lidarHeight_ >= source_.minObstacleHeight && lidarHeight_ <= source_.maxObstacleHeight) {
    cloud.points.reserve(scan.distances.size());
    for (std::size_t i = 0; i < scan.distances.size(); ++i) {
      double distance = scan.distances[i];
      if (!(distance >= 0.0)) {
        continue;
      }
      if (distance >= scan.range) {
        if (!source_.infIsValid) {
          continue;
        }
        distance = scan.range - kInfiniteMargin;
      }
      cloud.points.push_back(cloud.origin + distance * base::directionOf(scan.angle(i)));
    }
  }
  clouds_.push_front(std::move(cloud));
}

const std::deque<PointCloud>& ObservationBuffer::clouds(double time) {
  const double kept = source_.observationPersistence;
  while (clouds_.size() > 1 &&
         (kept == 0.0 || time - clouds_.back().time > kept + kBufferTimeRounding)) {
    clouds_.pop_back();
  }
  if (clouds_.size() == 1 && kept > 0.0 &&
      time - clouds_.front().time > kept + kBufferTimeRounding) {
    clouds_.clear();
  }
  return clouds_;
}

bool ObservationBuffer::isCurrent(double time) const {
  return source_.expectedUpdateRate == 0.0 ||
         time - lastTime_ <= source_.expectedUpdateRate + kBufferTimeRounding;
}

namespace {

constexpr int kMaxVoxels = 16;
constexpr double kEdgeMargin = 1e-3;  // [m] inside the map border where rays leave it, as in Nav2

struct RayRange {
  int most = 0, least = 0;  // [cells]
};

/// Frees the cells of a ray (nav2_util/raytrace_line_2d.hpp): Bresenham's line from the cell at the
/// minimum range, truncated by the ratio of maximum range to ray length, including the last cell.
void freeRay(Costmap& costmap, Cell from, Cell to, const RayRange& range) {
  const int acrossAll = to.column - from.column, upAll = to.row - from.row;
  const double length = std::sqrt(static_cast<double>(acrossAll * acrossAll + upAll * upAll));
  if (length < range.least) {
    return;
  }
  Cell cell = from;
  if (length > 0.0) {
    cell.column = static_cast<int>(from.column + acrossAll / length * range.least);
    cell.row = static_cast<int>(from.row + upAll / length * range.least);
  }
  const int longer = std::max(std::abs(to.column - cell.column), std::abs(to.row - cell.row));
  const double share = length == 0.0 ? 1.0 : std::min(1.0, range.most / length);
  int left = std::min(static_cast<int>(share * longer), longer);
  visitLine(cell, to, [&](Cell each) {
    costmap.set(each, kFreeSpace);
    return left-- > 0;
  });
}

/// The equivalent obstacle layer of a voxel layer; a lidar outside all voxels has no effect.
ObstacleLayerParameters asObstacleLayer(const VoxelLayerParameters& voxels, double lidarHeight) {
  ObstacleLayerParameters flat = static_cast<const ObstacleLayerParameters&>(voxels);
  const double top = voxels.originZ + voxels.zResolution * std::min(voxels.zVoxels, kMaxVoxels);
  for (ObservationSource& source : flat.sources) {
    source.clearing = source.clearing && lidarHeight >= voxels.originZ && lidarHeight < top;
    // Points below count for the lowest voxel. A single voxel does not exceed a threshold above 0.
    source.marking = source.marking && lidarHeight < top && voxels.markThreshold < 1;
  }
  return flat;
}

/// The end of a ray, clipped to the border of the map.
Vec2 clippedEnd(const Costmap& grid, const Vec2& origin, const Vec2& end) {
  const Vec2 way = end - origin;
  const Vec2& low = grid.origin();
  const Vec2 high = low + grid.resolution() * Vec2(grid.width(), grid.height());
  Vec2 cut = end;
  for (const int axis : {0, 1}) {
    const int other = 1 - axis;
    if (cut[axis] < low[axis]) {
      cut[other] = origin[other] + way[other] * (low[axis] - origin[axis]) / way[axis];
      cut[axis] = low[axis];
    }
  }
  for (const int axis : {0, 1}) {
    const int other = 1 - axis;
    if (cut[axis] > high[axis]) {
      cut[other] = origin[other] + way[other] * (high[axis] - origin[axis]) / way[axis];
      cut[axis] = high[axis] - kEdgeMargin;
    }
  }
  return cut;
}

/// Obstacles seen by the lidar (nav2_costmap_2d::ObstacleLayer): a grid in which hits stay until a
/// ray passes through them. A voxel layer differs in that rays end two cells before the hit, and
/// that it has no effect when the lidar is outside its heights.
class ObstacleLayer final : public GridLayer {
 public:
  /// `rayShortening`: length by which rays are shortened [m].
  ObstacleLayer(const ObstacleLayerParameters& parameters, double rayShortening,
                const LayerSite& site)
      : GridLayer(site, parameters.enabled, site.context.defaultCost()),
        parameters_(parameters),
        rayShortening_(rayShortening) {
    const CostmapContext& context = site.context;
    for (const ObservationSource& source : parameters.sources) {
      buffers_.emplace_back(source, context.lidarHeight);
    }
    const double least =
        context.distro == Distro::Humble ? -HUGE_VAL : parameters.minObstacleHeight;
    marksObstacles_ =
        context.lidarHeight >= least && context.lidarHeight <= parameters.maxObstacleHeight;
  }

  void observe(const Observation& observation) override {
    if (observation.scan == nullptr) {
      return;
    }
    for (ObservationBuffer& buffer : buffers_) {
      buffer.observe(*observation.scan);
    }
  }

  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override {
    moveWithRobot(observation, master);
    if (!parameters_.enabled) {
      return;
    }
    bounds.touch(extraBounds_);
    extraBounds_ = {};
    isCurrent_ = true;
    for (ObservationBuffer& buffer : buffers_) {
      isCurrent_ = isCurrent_ && buffer.isCurrent(observation.time);
      if (buffer.source().clearing) {
        for (const PointCloud& cloud : buffer.clouds(observation.time)) {
          clearRays(cloud, buffer.source(), bounds);
        }
      }
    }
    for (ObservationBuffer& buffer : buffers_) {
      if (buffer.source().marking && marksObstacles_) {
        for (const PointCloud& cloud : buffer.clouds(observation.time)) {
          mark(cloud, buffer.source(), bounds);
        }
      }
    }
    footprint_ = clearedFootprint(parameters_.footprintClearingEnabled, observation, bounds);
  }

  void updateCosts(Costmap& master, const CellWindow& window) override {
    if (!parameters_.enabled) {
      return;
    }
    if (wasReset_) {
      isCurrent_ = true;
      wasReset_ = false;
    }
    fillPolygon(grid_, footprint_, kFreeSpace);
    mergeWindow(grid_, window, parameters_.combinationMethod, master);
  }

  void reset(double time) override {
    resetGrid();
    for (ObservationBuffer& buffer : buffers_) {
      buffer.resetLastUpdated(time);
    }
  }

  void clearArea(const Vec2& low, const Vec2& high, bool isInverted) override {
    clearCells(grid_, low, high, isInverted, kNoInformation);
    isCurrent_ = false;
    extraBounds_.touch(grid_.origin());
    extraBounds_.touch(grid_.origin() + nav2SizeOf(grid_));
  }

 private:
  void clearRays(const PointCloud& cloud, const ObservationSource& source, CostmapBounds& bounds) {
    const std::optional<Cell> from = grid_.worldToCell(cloud.origin);
    if (!from) {
      return;  // Nav2 does not trace rays from off the map
    }
    bounds.touch(cloud.origin);
    for (const Vec2& point : cloud.points) {
      Vec2 end = point;
      if (rayShortening_ > 0.0) {
        const double length = (point - cloud.origin).norm();
        const double share = length > rayShortening_ ? (length - rayShortening_) / length : 0.0;
        end = cloud.origin + share * (point - cloud.origin);
      }
      clearRay(*from, cloud.origin, clippedEnd(grid_, cloud.origin, end), source, bounds);
    }
  }

  void clearRay(Cell from, const Vec2& origin, const Vec2& end, const ObservationSource& source,
                CostmapBounds& bounds) {
    const std::optional<Cell> to = grid_.worldToCell(end);
    if (!to) {
      return;
    }
    freeRay(
        grid_, from, *to,
        {grid_.cellDistance(source.raytraceMaxRange), grid_.cellDistance(source.raytraceMinRange)});
    const Vec2 way = end - origin;
    const double length = way.norm();
    if (length >= source.raytraceMinRange) {
      const double share = length > 0.0 ? std::min(1.0, source.raytraceMaxRange / length) : 1.0;
      bounds.touch(origin + share * way);
    }
  }

  void mark(const PointCloud& cloud, const ObservationSource& source, CostmapBounds& bounds) {
    const double most = source.obstacleMaxRange * source.obstacleMaxRange;
    const double least = source.obstacleMinRange * source.obstacleMinRange;
    const std::optional<Cell> sensorCell = grid_.worldToCell(cloud.origin);
    const double mostCells = grid_.cellDistance(source.obstacleMaxRange);
    for (const Vec2& point : cloud.points) {
      const double distance = (point - cloud.origin).squaredNorm();
      const std::optional<Cell> cell = grid_.worldToCell(point);
      if (distance > most || distance < least || !cell) {
        continue;
      }
      if (sensorCell && context().distro >= Distro::Lyrical) {
        const double across = cell->column - sensorCell->column, up = cell->row - sensorCell->row;
        if (std::floor(std::sqrt(across * across + up * up)) > mostCells) {
          continue;
        }
      }
      grid_.set(*cell, kLethal);
      bounds.touch(point);
    }
  }

  ObstacleLayerParameters parameters_;
  std::vector<ObservationBuffer> buffers_;
  double rayShortening_;        // [m]
  bool marksObstacles_ = true;  // the lidar is within the heights of the layer
  CostmapBounds extraBounds_;
  Polygon footprint_;  // in world frame; empty: clears nothing
};

}  // namespace

LayerPointer makeLayer(const ObstacleLayerParameters& parameters, const LayerSite& site) {
  return std::make_unique<ObstacleLayer>(parameters, 0.0, site);
}
LayerPointer makeLayer(const VoxelLayerParameters& parameters, const LayerSite& site) {
  return std::make_unique<ObstacleLayer>(asObstacleLayer(parameters, site.context.lidarHeight),
                                         2.0 * site.master.resolution(), site);
}

}  // namespace sim2d::nav2
