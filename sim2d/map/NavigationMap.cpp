#include "sim2d/map/NavigationMap.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sim2d {
namespace {

constexpr double kOpen = 1e9;              // [m]
constexpr double kMostCells = 4e6;         // of all layers that are kept, but for the last used
constexpr std::size_t kMostLayers = 8;     // idem
constexpr double kRadiiPerMetre = 1000.0;  // bodies whose radii round alike share a planner

bool standsAnything(const OccupancyGrid& map, const Obstacles& obstacles) {
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

NavigationLayer::NavigationLayer(const OccupancyGrid& map, const Obstacles& obstacles,
                                 const std::vector<Vec2>& places)
    : field_(standsAnything(map, obstacles)
                 ? std::make_shared<const DistanceField>(map, obstacles, places)
                 : nullptr),
      blocks_(field_ != nullptr ? std::make_unique<const OpenBlocks>(field_) : nullptr) {}

PathPlanner& NavigationLayer::plannerFor(double radius) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::unique_ptr<PathPlanner>& planner = planners_[radius];
  if (planner == nullptr) {
    planner = std::make_unique<PathPlanner>(field_, radius);
  }
  return *planner;
}

std::shared_ptr<const NavigationLayer> NavigationLayers::of(const OccupancyGrid& map,
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
  wanted.layer = std::make_shared<const NavigationLayer>(map, obstacles, places);
  const DistanceField* const field = wanted.layer->field();
  const auto cells = static_cast<double>(field != nullptr ? field->grid().cells().size() : 1);
  const auto kept = static_cast<std::size_t>(
      std::clamp(kMostCells / cells, 1.0, static_cast<double>(kMostLayers)));
  entries_.push_front(std::move(wanted));
  entries_.resize(std::min(entries_.size(), kept));
  return entries_.front().layer;
}

NavigationMap::NavigationMap(const OccupancyGrid& map, const Obstacles& obstacles,
                             std::vector<Vec2> places, std::shared_ptr<NavigationLayers> layers)
    : places_(std::move(places)),
      layers_(layers != nullptr ? std::move(layers) : std::make_shared<NavigationLayers>()),
      layer_(layers_->of(map, obstacles, places_)) {
  if (isOpenPlane()) {
    places_ = {};  // what may stand is known from the start
  }
}

void NavigationMap::update(const OccupancyGrid& map, const Obstacles& obstacles) {
  layer_ = layers_->of(map, obstacles, places_);
  ++version_;
}

std::vector<Vec2> NavigationMap::plan(double radius, const Vec2& start, const Vec2& goal) const {
  return isOpenPlane() ? std::vector<Vec2>{start, goal}
                       : plannerFor(radius).plan(start, goal).points;
}

bool NavigationMap::isReachable(double radius, const Vec2& start, const Vec2& goal) const {
  return isOpenPlane() || plannerFor(radius).isReachable(start, goal);
}

bool NavigationMap::isClear(double radius, const Vec2& from, const Vec2& to) const {
  return isOpenPlane() || plannerFor(radius).isClear(from, to);
}

std::optional<Vec2> NavigationMap::nearestFit(double radius, const Vec2& point) const {
  return isOpenPlane() ? std::optional<Vec2>(point) : plannerFor(radius).nearestFit(point);
}

double NavigationMap::clearance(const Vec2& point) const {
  if (isOpenPlane()) {
    return kOpen;
  }
  const double slack = 1.5 * layer_->field()->grid().resolution();
  return std::max(0.0, layer_->field()->distanceAt(point) - slack);
}

PathPlanner& NavigationMap::plannerFor(double radius) const {
  return layer_->plannerFor(static_cast<double>(std::llround(radius * kRadiiPerMetre)) /
                            kRadiiPerMetre);
}

}  // namespace sim2d
