#include "sim2d/map/NavigationMap.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace sim2d {
namespace {

constexpr double kOpen = 1e9;  // [m]
constexpr std::size_t kMaxLayers = 8;
constexpr double kRadiiPerMetre = 1000.0;  // radii that round to the same value share a planner

constexpr double kBlock = 0.5;      // [m]
constexpr double kMaxBlocks = 1e6;  // larger blocks above this
constexpr double kNearWall = 1.5;   // [cells] from the cell centre: a wall may reach into the cell

int cellsPerBlock(const OccupancyGrid& grid) {
  const double cells = static_cast<double>(grid.width()) * grid.height();
  const double usual = kBlock / grid.resolution();
  return static_cast<int>(std::ceil(std::max({1.0, usual, std::sqrt(cells / kMaxBlocks)})));
}

bool hasAnyObstacle(const OccupancyGrid& map, const Obstacles& obstacles) {
  if (!map.isEmpty()) {
    return true;
  }
  for (int part = 0; part < obstacles.partCount(); ++part) {
    if (!obstacles.outlines(part).empty()) {
      return true;
    }
  }
  return false;
}

}  // namespace

OpenBlocks::OpenBlocks(std::shared_ptr<const DistanceField> field) : field_(std::move(field)) {
  const OccupancyGrid& grid = field_->grid();
  const int cells = cellsPerBlock(grid);
  width_ = (grid.width() + cells - 1) / cells;
  height_ = (grid.height() + cells - 1) / cells;
  perCell_ = 1.0 / cells;
  const auto stride = static_cast<std::size_t>(width_) + 1;
  below_.assign(stride * (static_cast<std::size_t>(height_) + 1), 0);
  const double near = kNearWall * grid.resolution();
  for (int row = 0; row < grid.height(); ++row) {
    field_->stopFlag().check();
    int* const ofRow = &below_[(static_cast<std::size_t>(row / cells) + 1) * stride + 1];
    for (int column = 0; column < grid.width(); ++column) {
      if (field_->distanceAt(Cell{column, row}) <= near) {
        ofRow[column / cells] = 1;
      }
    }
  }
  for (std::size_t i = stride; i < below_.size(); ++i) {
    if (i % stride != 0) {
      below_[i] += below_[i - 1] + below_[i - stride] - below_[i - stride - 1];
    }
  }
}

int OpenBlocks::wallsBelow(int column, int row) const {
  return below_[static_cast<std::size_t>(row) * (static_cast<std::size_t>(width_) + 1) +
                static_cast<std::size_t>(column)];
}

bool OpenBlocks::areFree(const Vec2& from, const Vec2& to) const {
  const Vec2 a = perCell_ * field_->grid().worldToCorner(from);
  const Vec2 b = perCell_ * field_->grid().worldToCorner(to);
  const auto isCovered = [this](const Vec2& place) {
    return place.x() >= 0.0 && place.y() >= 0.0 && place.x() < width_ && place.y() < height_;
  };
  if (!isCovered(a) || !isCovered(b)) {
    return false;
  }
  const Vec2 low = a.cwiseMin(b);
  const Vec2 high = a.cwiseMax(b);
  const auto left = static_cast<int>(low.x());
  const auto bottom = static_cast<int>(low.y());
  const int right = static_cast<int>(high.x()) + 1;
  const int top = static_cast<int>(high.y()) + 1;
  return wallsBelow(right, top) - wallsBelow(left, top) - wallsBelow(right, bottom) +
             wallsBelow(left, bottom) ==
         0;
}

NavigationLayer::NavigationLayer(const OccupancyGrid& map, const Obstacles& obstacles,
                                 const std::vector<Vec2>& places, base::StopFlagPtr stop,
                                 const std::shared_ptr<const CellDistances>& walls,
                                 std::size_t mostBytes)
    : field_(hasAnyObstacle(map, obstacles)
                 ? std::make_shared<const DistanceField>(
                       map, obstacles, places, DistanceField::kMaxCells, std::move(stop), walls)
                 : nullptr),
      blocks_(field_ != nullptr ? std::make_unique<const OpenBlocks>(field_) : nullptr),
      mostBytes_(mostBytes) {}

std::size_t NavigationLayer::plannerBytes() const {
  std::size_t bytes = 0;
  for (const auto& [radius, kept] : planners_) {
    bytes += kept.planner->bytes();
  }
  return bytes;
}

std::size_t NavigationLayer::bytes() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return plannerBytes() + (field_ != nullptr ? field_->bytes() : 0);
}

std::shared_ptr<PathPlanner> NavigationLayer::plannerFor(double radius) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto found = planners_.find(radius);
  if (found == planners_.end()) {
    while (!planners_.empty() && plannerBytes() > mostBytes_) {
      planners_.erase(std::min_element(
          planners_.begin(), planners_.end(),
          [](const auto& a, const auto& b) { return a.second.lastUse < b.second.lastUse; }));
    }
    found = planners_.emplace(radius, Kept{std::make_shared<PathPlanner>(field_, radius)}).first;
  }
  found->second.lastUse = ++uses_;
  return found->second.planner;
}

std::shared_ptr<const NavigationLayer> NavigationLayerCache::of(const OccupancyGrid& map,
                                                                const Obstacles& obstacles,
                                                                const std::vector<Vec2>& places) {
  Entry wanted;
  for (int part = 0; part < obstacles.partCount(); ++part) {
    wanted.enabled.push_back(obstacles.isEnabled(part) ? 1 : 0);
  }
  if (map.isEmpty()) {
    wanted.places = places;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.enabled == wanted.enabled && entry.places == wanted.places;
  });
  if (found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
    return entries_.front().layer;
  }
  if (walls_ == nullptr && !map.isEmpty() &&
      static_cast<double>(map.cells().size()) <= DistanceField::kMaxCells) {
    walls_ = DistanceField::mapWallDistances(map, false, *stop_);
  }
  wanted.layer =
      std::make_shared<const NavigationLayer>(map, obstacles, places, stop_, walls_, mostBytes_);
  entries_.push_front(std::move(wanted));
  const auto bytes = [this] {
    return std::accumulate(
        entries_.begin(), entries_.end(), std::size_t{0},
        [](std::size_t sum, const Entry& entry) { return sum + entry.layer->bytes(); });
  };
  while (entries_.size() > 1 && (entries_.size() > kMaxLayers || bytes() > mostBytes_)) {
    entries_.pop_back();
  }
  return entries_.front().layer;
}

NavigationMap::NavigationMap(const OccupancyGrid& map, const Obstacles& obstacles,
                             std::vector<Vec2> places, std::shared_ptr<NavigationLayerCache> layers)
    : places_(std::move(places)),
      layers_(layers != nullptr ? std::move(layers) : std::make_shared<NavigationLayerCache>()),
      layer_(layers_->of(map, obstacles, places_)) {
  if (isOpenPlane()) {
    places_ = {};  // without obstacles the positions are not needed
  }
}

void NavigationMap::update(const OccupancyGrid& map, const Obstacles& obstacles) {
  layer_ = layers_->of(map, obstacles, places_);
  ++version_;
}

std::vector<Vec2> NavigationMap::plan(double radius, const Vec2& start, const Vec2& goal) const {
  return isOpenPlane() ? std::vector<Vec2>{start, goal} : plannerFor(radius)->plan(start, goal);
}

std::optional<Vec2> NavigationMap::nearestFreePosition(double radius, const Vec2& point) const {
  return isOpenPlane() ? std::optional<Vec2>(point)
                       : plannerFor(radius)->space().nearestFreePosition(point);
}

double NavigationMap::clearance(const Vec2& point) const {
  if (isOpenPlane()) {
    return kOpen;
  }
  const double slack = 1.5 * layer_->field()->grid().resolution();
  return std::max(0.0, layer_->field()->distanceAt(point) - slack);
}

std::shared_ptr<PathPlanner> NavigationMap::plannerFor(double radius) const {
  return layer_->plannerFor(static_cast<double>(std::llround(radius * kRadiiPerMetre)) /
                            kRadiiPerMetre);
}

}  // namespace sim2d
