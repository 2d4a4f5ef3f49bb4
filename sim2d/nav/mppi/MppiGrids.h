#pragma once

#include <vector>

#include "sim2d/nav/Observation.h"
#include "sim2d/nav/mppi/MppiKernel.h"

/// What MPPI looks up of the walls round the robot, kept from call to call. World frame, [m].
namespace sim2d {

/// Nodes of a lattice through the world's origin.
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
/// It holds all within `half` of the place, and moves in jumps.
NodeWindow windowAbout(const Vec2& place, double half, double spacing);

/// Distance to the nearest wall, negative inside of one; exact at the nodes, 5 cm apart, where it
/// is below kMost.
class ClearanceGrid {
 public:
  static constexpr double kMost = 1.5;  // [m]; larger distances are told as this

  void update(const Observation& observation, double half);
  MppiGrid view(const Vec2& origin) const { return window_.view(values_, origin); }
  /// Between the nodes; kMost outside of the window.
  double at(const Vec2& place) const;
  Vec2 slopeAt(const Vec2& place) const;

 private:
  NodeWindow window_;
  std::vector<float> values_;
  int version_ = -1;  // of the navigation map
};

/// A disc where somebody stands: ways lead round it if they can.
struct SlowDisc {
  Vec2 centre = Vec2::Zero();
  double radius = 0.0;  // [m]

  friend bool operator==(const SlowDisc& a, const SlowDisc& b) {
    return a.centre == b.centre && a.radius == b.radius;
  }
};

/// Length of the shortest way to the goal round the walls, for the middle of a body with `radius`:
/// the solution of |grad D| = slowness (fast sweeping, Zhao 2005) from where the route leaves the
/// window. Within walls the slowness is so large that ways lead round them, beside them a little
/// above one.
class ToGoGrid {
 public:
  void update(const Observation& observation, const std::vector<Vec2>& route, double half,
              double radius, const ClearanceGrid& clearance, const std::vector<SlowDisc>& discs);
  MppiGrid view(const Vec2& origin) const { return window_.view(values_, origin); }

 private:
  void setSlowness(double radius, const ClearanceGrid& clearance);
  void solve(const Obstacles& obstacles);
  void seedRoute();
  void seedGoal(const Obstacles& obstacles);
  bool holds(const Vec2& place) const;
  void lower(const Vec2& place, double rest);
  bool sweep(int stepX, int stepY);

  NodeWindow window_;
  std::vector<float> values_, slowness_;
  std::vector<Vec2> route_;
  std::vector<SlowDisc> discs_;
  int version_ = -1;
};

}  // namespace sim2d
