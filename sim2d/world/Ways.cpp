#include "sim2d/world/Ways.h"

#include <algorithm>
#include <cmath>

namespace sim2d {
namespace {

constexpr double kOpen = 1e9;  // [m]

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

Ways::Ways(const OccupancyGrid& map, const Obstacles& obstacles, std::vector<Vec2> places)
    : places_(std::move(places)) {
  rebuild(map, obstacles);
  version_ = 0;
}

void Ways::rebuild(const OccupancyGrid& map, const Obstacles& obstacles) {
  planners_.clear();
  field_ = standsAnything(map, obstacles)
               ? std::make_shared<const DistanceField>(map, obstacles, places_)
               : nullptr;
  if (field_ == nullptr) {
    places_ = {};  // what may stand is known from the start
  }
  blocks_ = field_ != nullptr ? std::make_unique<const OpenBlocks>(field_) : nullptr;
  ++version_;
}

std::vector<Vec2> Ways::plan(double radius, const Vec2& start, const Vec2& goal) {
  if (field_ == nullptr) {
    return {start, goal};
  }
  return plannerFor(radius).plan(start, goal).points;
}

bool Ways::isReachable(double radius, const Vec2& start, const Vec2& goal) {
  return field_ == nullptr || plannerFor(radius).isReachable(start, goal);
}

bool Ways::isClear(double radius, const Vec2& from, const Vec2& to) {
  return field_ == nullptr || plannerFor(radius).isClear(from, to);
}

std::optional<Vec2> Ways::nearestFit(double radius, const Vec2& point) {
  return field_ == nullptr ? std::optional<Vec2>(point) : plannerFor(radius).nearestFit(point);
}

double Ways::clearance(const Vec2& point) const {
  if (field_ == nullptr) {
    return kOpen;
  }
  const double slack = 1.5 * field_->grid().resolution();
  return std::max(0.0, field_->distanceAt(point) - slack);
}

PathPlanner& Ways::plannerFor(double radius) {
  const long long key = std::llround(radius * 1000.0);
  std::unique_ptr<PathPlanner>& planner = planners_[key];
  if (planner == nullptr) {
    planner = std::make_unique<PathPlanner>(field_, static_cast<double>(key) / 1000.0);
  }
  return *planner;
}

}  // namespace sim2d
