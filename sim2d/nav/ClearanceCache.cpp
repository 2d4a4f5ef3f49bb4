#include "sim2d/nav/ClearanceCache.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sim2d {
namespace {

constexpr int kCacheSide = 128;  // places along each side before one takes another's room; 2^n

}  // namespace

ClearanceCache::ClearanceCache(double spacing, double limit)
    : spacing_(spacing),
      limit_(limit),
      places_(static_cast<std::size_t>(kCacheSide) * static_cast<std::size_t>(kCacheSide)) {}

void ClearanceCache::update(const Observation& observation, const std::vector<Vec2>& points,
                            double pointsTime) {
  const int version = observation.navigation->version();
  if (version != version_ || observation.obstacles != obstacles_ ||
      observation.navigation != navigation_) {
    ++wallsOf_;
  }
  if (pointsTime != pointsTime_ || &points != points_) {
    ++pointsOf_;
  }
  version_ = version;
  obstacles_ = observation.obstacles;
  navigation_ = observation.navigation;
  points_ = &points;
  pointsTime_ = pointsTime;
}

double ClearanceCache::squaredToWalls(const Vec2& place) const {
  if (navigation_->clearance(place) >= limit_) {
    return limit_ * limit_;
  }
  const double distance = std::max(0.0, obstacles_->clearance(place, limit_));
  return distance * distance;
}

double ClearanceCache::squaredToPoints(const Vec2& place) const {
  double least = limit_ * limit_;
  for (const Vec2& point : *points_) {
    least = std::min(least, (point - place).squaredNorm());
  }
  return least;
}

double ClearanceCache::squaredAt(int column, int row) {
  constexpr int kLowBits = kCacheSide - 1;
  Place& place = places_[static_cast<std::size_t>(row & kLowBits) * kCacheSide +
                         static_cast<std::size_t>(column & kLowBits)];
  if (place.column != column || place.row != row) {
    place = {column, row, 0, 0, 0.0, 0.0};
  }
  if (place.wallsOf != wallsOf_) {
    place.wallsOf = wallsOf_;
    place.toWalls = squaredToWalls(spacing_ * Vec2(column, row));
  }
  if (points_->empty()) {
    return place.toWalls;
  }
  if (place.pointsOf != pointsOf_) {
    place.pointsOf = pointsOf_;
    place.toPoints = squaredToPoints(spacing_ * Vec2(column, row));
  }
  return std::min(place.toWalls, place.toPoints);
}

double ClearanceCache::distanceAt(const Vec2& place) {
  const double x = place.x() / spacing_;
  const double y = place.y() / spacing_;
  const double left = std::floor(x);
  const double bottom = std::floor(y);
  const auto column = static_cast<int>(left);
  const auto row = static_cast<int>(bottom);
  const double s = x - left;
  const double t = y - bottom;
  const double mean =
      (1.0 - t) * ((1.0 - s) * squaredAt(column, row) + s * squaredAt(column + 1, row)) +
      t * ((1.0 - s) * squaredAt(column, row + 1) + s * squaredAt(column + 1, row + 1));
  const double excess = spacing_ * spacing_ * (s * (1.0 - s) + t * (1.0 - t));
  return std::sqrt(std::max(0.0, mean - excess));
}

}  // namespace sim2d
