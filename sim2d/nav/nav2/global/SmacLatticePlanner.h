#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"
#include "sim2d/nav/nav2/global/SmacPoseSearch.h"

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

/// nav2_smac_planner::SmacPlannerLattice: A* over the motion primitives of a file. Lengths are
/// measured in cells of the costmap, regardless of the file's resolution.
class SmacLatticePlanner : public GlobalPlanner {
 public:
  /// Precondition: `parameters.lattice` is not null.
  SmacLatticePlanner(const SmacLatticeParameters& parameters, Distro distro);

  PlanResult plan(const PlanRequest& request) override;

 private:
  SmacLatticeParameters parameters_;
  Distro distro_;
  ObstacleHeuristic obstacles_;
};

/// One search of Smac Lattice (nav2_smac_planner, node_lattice.cpp): A* over the primitives of a
/// file.
class LatticeSearch : public SmacPoseSearch {
 public:
  /// All references must outlive the search.
  LatticeSearch(const SmacLatticeParameters& parameters, Distro distro, const PlanRequest& request,
                ObstacleHeuristic& obstacles);

  /// Cost of a primitive into cells of that cost after another primitive (null: at the start).
  double cost(const LatticePrimitive* before, const LatticePrimitive& primitive, bool isBackward,
              double cellCost) const;

 private:
  int nearestHeading(double heading) const override { return lattice_.nearestHeading(heading); }
  double headingOf(int index) const override {
    return lattice_.headings[static_cast<std::size_t>(index)];
  }
  double curveEstimate(const Node& node, const Pose2& goal, double round) override;
  void expand(int index) override;
  void addPoses(const Node& parent, const Node& node, Path& path) const override;
  const std::vector<LatticePrimitive>& primitivesFrom(int heading, bool isBackward) const;
  /// The primitive into a node; null: start.
  const LatticePrimitive* primitiveInto(const Node& node) const;
  void applyStep(int from, int step, bool isBackward);
  std::optional<double> costAlong(const Pose2& from, const LatticePrimitive& primitive,
                                  bool isBackward) const;

  const SmacLatticeParameters& parameters_;
  const Lattice& lattice_;
  double cellSize_;  // [m]
};

}  // namespace sim2d::nav2
