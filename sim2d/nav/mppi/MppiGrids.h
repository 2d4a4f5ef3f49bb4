#pragma once

#include <vector>

#include "sim2d/nav/Observation.h"
#include "sim2d/nav/mppi/MppiKernel.h"

/// Grids of distances around the robot, reused between calls. World frame, [m].
namespace sim2d {

/// A window of a lattice through the world's origin.
struct NodeWindow {
  double spacing = 0.1;           // [m]
  long long column = 0, row = 0;  // of the first node
  int columns = 0, rows = 0;

  Vec2 nodeAt(int i, int j) const {
    return spacing * Vec2(static_cast<double>(column + i), static_cast<double>(row + j));
  }
  bool contains(long long i, long long j) const {
    return i >= 0 && j >= 0 && i < columns && j < rows;
  }
  std::size_t indexOf(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(i);
  }
  MppiGrid view(const std::vector<float>& values, const Vec2& origin) const;
  friend bool operator==(const NodeWindow& a, const NodeWindow& b) {
    return a.spacing == b.spacing && a.column == b.column && a.row == b.row &&
           a.columns == b.columns && a.rows == b.rows;
  }
  friend bool operator!=(const NodeWindow& a, const NodeWindow& b) { return !(a == b); }
};
/// Contains all places within `half` of `place`; moves in discrete jumps.
NodeWindow windowAround(const Vec2& place, double half, double spacing);

/// Signed distance to the nearest wall, negative inside; exact at the nodes, which are 5 cm apart,
/// below kMaxClearance.
class ClearanceGrid {
 public:
  static constexpr double kMaxClearance = 1.5;  // [m]; larger distances are clamped

  void update(const Observation& observation, double half);
  MppiGrid view(const Vec2& origin) const { return window_.view(values_, origin); }
  /// Interpolated; kMaxClearance outside the window.
  double at(const Vec2& place) const;
  Vec2 slopeAt(const Vec2& place) const;

 private:
  NodeWindow window_;
  std::vector<float> values_;
  int version_ = -1;  // of the navigation map
};

/// A disc around a standing person, which paths avoid if possible.
struct SlowDisc {
  Vec2 centre = Vec2::Zero();
  double radius = 0.0;  // [m]

  friend bool operator==(const SlowDisc& a, const SlowDisc& b) {
    return a.centre == b.centre && a.radius == b.radius;
  }
};

/// Shortest path length to the goal around the walls, for the centre of a body with `radius`: the
/// solution of |grad D| = slowness (fast sweeping, Zhao 2005), seeded where the route leaves the
/// window. The slowness is large inside walls, so that paths avoid them, and slightly above one
/// next to them.
class CostToGoGrid {
 public:
  void update(const Observation& observation, const std::vector<Vec2>& route, double half,
              double radius, const ClearanceGrid& clearance, const std::vector<SlowDisc>& discs);
  MppiGrid view(const Vec2& origin) const { return window_.view(values_, origin); }

 private:
  void setSlowness(double radius, const ClearanceGrid& clearance);
  void solve(const Obstacles& obstacles);
  void seedRoute();
  void seedGoal(const Obstacles& obstacles);
  bool contains(const Vec2& place) const;
  void lowerValues(const Vec2& place, double rest);
  bool sweep(int stepX, int stepY);

  NodeWindow window_;
  std::vector<float> values_, slowness_;
  std::vector<Vec2> route_;
  std::vector<SlowDisc> discs_;
  int version_ = -1;
};

}  // namespace sim2d
