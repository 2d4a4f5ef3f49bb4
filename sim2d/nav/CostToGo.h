#pragma once

#include <vector>

#include "sim2d/nav/RobotRoute.h"

namespace sim2d {

/// Remaining path length to the goal from every place near one robot, around walls and people who
/// stand still. The route ignores people, and a planner that scores short arcs by their distance to
/// the route would get stuck in front of them. Solves the eikonal equation |grad T| = slowness on a
/// square grid around the robot by fast sweeping (Zhao 2005), from the point where the route leaves
/// the grid. Not thread-safe.
class CostToGo {
 public:
  /// Inscribed and circumscribed radius of the footprint [m]; clearance to keep [m].
  CostToGo(double inscribed, double reach, double margin);

  /// The route must not be empty. Bodies slower than `slowSpeed` [m/s] and all `points` (world
  /// frame, [m]) count as standing obstacles.
  void update(const Observation& observation, const RobotRoute& route, double slowSpeed,
              const std::vector<Vec2>& points);

  /// Remaining path length from `place` [m]; larger through narrow or occupied places.
  double at(const Vec2& place) const;
  /// Lower bound of `at` over the places within `radius` [m] of `from` [m].
  double minWithin(const Vec2& from, double radius) const;
  /// Descent direction: unit vector, or zero at a minimum.
  Vec2 direction(const Vec2& place) const;
  /// True if the goal, or the end of the route, lies in the grid.
  bool containsRouteEnd() const { return containsRouteEnd_; }

 private:
  struct Corners {  // bilinear interpolation between four cell centres
    double values[2][2] = {{0.0, 0.0}, {0.0, 0.0}};  // [row][column]
    double s = 0.0, t = 0.0;                         // relative position between them, 0 to 1
  };
  bool isCurrent(const Observation& observation) const;
  void placeGrid(const Observation& observation, const RobotRoute& route);
  void markWalls(const Observation& observation);
  void markDisc(const Vec2& centre, double radius);
  void seedTarget(const Observation& observation);
  void solve();
  bool sweep(bool isUp, bool isRight);
  bool improve(int index);
  void fillBlocked();
  void updateMinima();
  Vec2 cellCentre(int column, int row) const;
  int indexOf(int column, int row) const { return (row + 1) * kStride + column + 1; }
  Corners cornersAt(const Vec2& place) const;

  static constexpr int kSide = 48;           // cells along each side
  static constexpr int kStride = kSide + 2;  // including a border of blocked cells

  double cell_;  // [m]
  double inscribed_, reach_, margin_;
  std::vector<double> slowness_;  // 0: blocked
  std::vector<double> value_;     // [m]
  std::vector<double>
      minByRadius_;             // [m], minimum over cells within that many cells of updatePosition_
  Vec2 origin_ = Vec2::Zero();  // lower left corner
  Vec2 target_ = Vec2::Zero();  // where the route leaves the grid, or its end
  double remainingLength_ = 0.0;  // length of the route after the target [m]
  bool containsRouteEnd_ = false;
  Vec2 goal_ = Vec2::Zero();
  double updateTime_ = -1e9;  // [s]
  Vec2 updatePosition_ = Vec2::Zero();
  int version_ = -1;
};

}  // namespace sim2d
