#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/Lattice.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"
#include "sim2d/nav/nav2/global/SmacCommon.h"

namespace sim2d::nav2 {

/// nav2_smac_planner::SmacPlannerLattice: A* over the motion primitives of a file. Lengths are
/// measured in cells of the costmap, regardless of the file's resolution.
class SmacLatticePlanner : public GlobalPlanner {
 public:
  /// Precondition: `parameters.lattice` is not null.
  SmacLatticePlanner(const SmacLatticeParameters& parameters, Distro distro);

  PlanResult plan(const PlanRequest& request) override;

 private:
  PlanResult planIn(Costmap costmap, const PlanRequest& request);

  SmacLatticeParameters parameters_;
  Distro distro_;
  ObstacleHeuristic obstacles_;
};

/// One search of Smac Lattice (nav2_smac_planner, a_star.cpp, node_lattice.cpp): A* over the
/// primitives of a file. Positions in cells of the costmap; (0, 0) is its lower left corner.
class LatticeSearch {
 public:
  /// All references must outlive the search.
  struct Context {
    const SmacLatticeParameters& parameters;
    Distro distro;
    const Lattice& lattice;
    const Costmap& costmap;
    const PlanRequest& request;  // its footprint and stop flag are used
    ObstacleHeuristic& obstacles;
  };
  explicit LatticeSearch(const Context& context);

  /// The cost of the robot's cell at a pose, or nullopt in a collision.
  std::optional<std::uint8_t> costAt(const Pose2& pose) const;

  /// Finds a path from the start to a goal, or as near as the tolerance allows. All goals have the
  /// same position.
  PlanResult find(const Pose2& start, const std::vector<Pose2>& goals);

  /// Cost of a primitive into cells of that cost after another primitive (null: at the start).
  double cost(const LatticePrimitive* before, const LatticePrimitive& primitive, bool isBackward,
              double cellCost) const;

 private:
  struct Node {
    Pose2 pose;
    double g = 0.0;
    int heading = 0;
    int parent = -1;
    const LatticePrimitive* primitive = nullptr;  // into this node; null: start
    bool isBackward = false, isVisited = false;
  };

  CarMotion car() const;
  double radius() const;
  int nodeAt(const Vec2& place, int heading);
  bool isInside(const Vec2& place) const;
  double estimate(const Node& node);
  void expand(int index);
  void applyStep(int from, const LatticePrimitive& primitive, bool isBackward);
  std::optional<double> costAlong(const Pose2& from, const LatticePrimitive& primitive,
                                  bool isBackward) const;
  std::optional<Path> tryAnalyticExpansion(int index);
  std::optional<Path> analyticExpansionFrom(const Node& node, const Pose2& goal) const;
  Path pathTo(int index) const;
  void addPoses(const Node& parent, const Node& node, Path& path) const;

  Context context_;
  std::vector<Pose2> goals_;
  std::vector<int> goalNodes_;
  std::vector<Node> nodes_;
  std::vector<std::int32_t> slots_;  // per cell and heading: index of its node; -1: none yet
  OpenList<double> open_;
  NearestNode nearest_;
  int due_ = 0, closest_ = 1 << 30;  // schedule of analytic expansions
};

}  // namespace sim2d::nav2
