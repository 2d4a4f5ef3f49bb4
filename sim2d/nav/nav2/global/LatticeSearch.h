#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim2d/nav/nav2/global/HybridEstimates.h"
#include "sim2d/nav/nav2/global/Lattice.h"
#include "sim2d/nav/nav2/global/SmacGrid.h"

namespace sim2d::nav2 {

/// One search of Smac Lattice (nav2_smac_planner, a_star.cpp, node_lattice.cpp): A* over the
/// primitives of a file. Places in cells of the costmap, (0, 0) is its lower left corner.
class LatticeSearch {
 public:
  /// All must outlive the search.
  struct Setting {
    const SmacLatticeParameters& parameters;
    Distro distro;
    const Lattice& lattice;
    const Costmap& costmap;
    const PlanRequest& request;  // whose footprint and stop flag count
    ObstacleDistance& obstacles;
  };
  explicit LatticeSearch(const Setting& setting);

  /// Whether the robot can be there; the cost of its cell if so.
  std::optional<std::uint8_t> costAt(const Pose2& pose) const;

  /// The goals lie at one place. Poses from the start to a goal, or as near as the tolerance
  /// allows.
  PlanResult find(const Pose2& start, const std::vector<Pose2>& goals);

  /// Cost of a primitive after another one (null: out of the start) into cells of that cost.
  double cost(const LatticePrimitive* before, const LatticePrimitive& primitive, bool isBackward,
              double cellCost) const;

 private:
  struct Node {
    Pose2 pose;
    double g = 0.0;
    int heading = 0;
    int parent = -1;
    const LatticePrimitive* primitive = nullptr;  // that led here; null: start
    bool isBackward = false, isVisited = false;
  };

  CarMotion car() const;
  double radius() const;
  int nodeAt(const Vec2& place, int heading);
  bool isInside(const Vec2& place) const;
  double estimate(const Node& node);
  void expand(int index);
  void enter(int from, const LatticePrimitive& primitive, bool isBackward);
  std::optional<double> costAlong(const Pose2& from, const LatticePrimitive& primitive,
                                  bool isBackward) const;
  std::optional<Path> curveToGoal(int index);
  std::optional<Path> curveFrom(const Node& node, const Pose2& goal) const;
  Path pathTo(int index) const;
  void addPoses(const Node& parent, const Node& node, Path& path) const;

  Setting setting_;
  std::vector<Pose2> goals_;
  std::vector<int> goalNodes_;
  std::vector<Node> nodes_;
  std::vector<std::int32_t> slots_;  // per cell and heading: its node; -1: none yet
  OpenList<double> open_;
  SmacNearest nearest_;
  int due_ = 0, closest_ = 1 << 30;  // when the next curve to the goal is tried
};

}  // namespace sim2d::nav2
