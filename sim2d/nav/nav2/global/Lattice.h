#pragma once

#include <string>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"

namespace sim2d::nav2 {

/// A motion primitive from the origin.
struct LatticePrimitive {
  int startHeading = 0, endHeading = 0;  // indices of headings of the lattice
  bool isLeftTurn = true;
  double length = 0.0;       // [m]; 0: a turn in place
  double arcLength = 0.0;    // arc part [m]
  std::vector<Pose2> poses;  // along the primitive; the last is its end [m], [rad]
};

/// A file of motion primitives of nav2_smac_planner's generator (lattice_primitives).
struct Lattice {
  std::string file;
  std::string motionModel = "diff";  // "diff", "ackermann", "omni"
  double turningRadius = 0.5;        // [m]
  std::vector<double> headings;      // [rad], ascending from 0; with all opposite headings
  std::vector<std::vector<LatticePrimitive>> primitives;  // by the index of the start heading

  int size() const { return static_cast<int>(headings.size()); }
  /// The index of the nearest heading.
  int nearestHeading(double heading) const;
  int oppositeOf(int heading) const { return (heading + size() / 2) % size(); }
};

}  // namespace sim2d::nav2
