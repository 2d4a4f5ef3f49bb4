#pragma once

#include <vector>

#include "sim2d/nav/RobotRoute.h"

namespace sim2d {

/// How long the way to the goal still is from every place near a robot, round walls and round
/// people that stand: the route knows nothing of people, and who weighs short arcs by the distance
/// to it gets stuck before them. The eikonal equation |grad T| = slowness over a square of cells
/// about the robot, by fast sweeping (Zhao 2005), from the point where the route leaves the square.
/// One robot; thread: one at a time.
class CostToGo {
 public:
  /// Circles about the robot's origin inside and round its footprint [m]; room to leave [m].
  CostToGo(double inscribed, double reach, double margin);

  /// The route is not empty. Bodies slower than `slowSpeed` [m/s] stand; `points` stand as well
  /// (world frame, [m]).
  void update(const Observation& observation, const RobotRoute& route, double slowSpeed,
              const std::vector<Vec2>& points);

  /// Length of the way from there [m], more than that through places that are narrow or taken.
  double at(const Vec2& place) const;
  /// No place nearer than `radius` [m] to `from` has less [m].
  double leastWithin(const Vec2& from, double radius) const;
  /// Where to go from there: unit vector, zero where nothing is better.
  Vec2 direction(const Vec2& place) const;
  /// The goal, or the end of the way to it, lies in the square.
  bool endsHere() const { return endsHere_; }
  /// Where the route leaves the square, or ends.
  const Vec2& target() const { return target_; }

 private:
  struct Corners {  // of the square of cells' middles about a place
    double values[2][2] = {{0.0, 0.0}, {0.0, 0.0}};  // [row][column]
    double s = 0.0, t = 0.0;                         // place between them, 0 to 1
  };
  bool isCurrent(const Observation& observation) const;
  void choosePlace(const Observation& observation, const RobotRoute& route);
  void markWalls(const Observation& observation);
  void markDisc(const Vec2& centre, double radius);
  void start(const Observation& observation);
  void solve();
  bool sweep(bool isUp, bool isRight);
  bool improve(int index);
  void fillBlocked();
  void findLeast();
  Vec2 middleOf(int column, int row) const;
  int indexOf(int column, int row) const { return (row + 1) * kStride + column + 1; }
  Corners cornersAt(const Vec2& place) const;

  static constexpr int kSide = 48;           // cells along each side
  static constexpr int kStride = kSide + 2;  // a border of blocked cells runs round them

  double cell_;  // [m]
  double inscribed_, reach_, margin_;
  std::vector<double> slowness_;  // 0: blocked
  std::vector<double> value_;     // [m]
  std::vector<double> least_;     // [m] of cells at most that many cells away from madeFor_
  Vec2 origin_ = Vec2::Zero();    // lower left corner
  Vec2 target_ = Vec2::Zero();
  double rest_ = 0.0;  // of the route, from the target on [m]
  bool endsHere_ = false;
  Vec2 goal_ = Vec2::Zero();
  double madeAt_ = -1e9;  // [s]
  Vec2 madeFor_ = Vec2::Zero();
  int version_ = -1;
};

}  // namespace sim2d
