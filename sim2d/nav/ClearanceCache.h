#pragma once

#include <vector>

#include "sim2d/nav/Observation.h"

namespace sim2d {

/// Distances to walls and to points of a scan, worked out once on a lattice of places round a
/// robot and remembered while it drives. One robot; thread: one at a time.
class ClearanceCache {
 public:
  /// `spacing` of the lattice [m]; `limit`: what lies farther away does not count [m].
  ClearanceCache(double spacing, double limit);

  /// Before the questions of one decision; the objects outlive them. Walls are forgotten when doors
  /// have moved, points when `pointsTime` [s] is another one.
  void update(const Observation& observation, const std::vector<Vec2>& points, double pointsTime);

  /// At most the distance [m] to the nearest wall or point, 0 inside of something solid, `limit`
  /// when nothing is nearer. Interpolated between four places so that it is never too great: the
  /// squared distance d² to any set, less |p|², is a concave function of the place p, therefore
  /// d²(p) >= mean of d² at the corners - (mean of |corner|² - |p|²).
  double distanceAt(const Vec2& place);
  double limit() const { return limit_; }

 private:
  struct Place {
    int column = 0, row = 0;
    int wallsOf = 0, pointsOf = 0;  // when they were worked out; 0: never
    double toWalls = 0.0;           // [m²]
    double toPoints = 0.0;          // [m²]
  };
  double squaredAt(int column, int row);
  double squaredToWalls(const Vec2& place) const;
  double squaredToPoints(const Vec2& place) const;

  double spacing_, limit_;
  std::vector<Place> places_;  // that of (column, row) lies at their lowest bits
  const Obstacles* obstacles_ = nullptr;
  const NavigationMap* navigation_ = nullptr;
  const std::vector<Vec2>* points_ = nullptr;
  int version_ = -1;          // of the navigation map
  double pointsTime_ = -1e9;  // [s]
  int wallsOf_ = 0, pointsOf_ = 0;
};

}  // namespace sim2d
