#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "sim2d/nav/nav2/global/PlannerParameters.h"
#include "sim2d/nav/nav2/global/ShortestCurve.h"
#include "sim2d/nav/nav2/global/SmacCommon.h"

/// The A* search over poses that Smac Hybrid-A* and Smac Lattice share (nav2_smac_planner,
/// a_star.cpp, analytic_expansion.cpp). Positions in cells of the costmap; (0, 0) is its lower left
/// corner. Headings are those of a list and are referred to by their indices.
namespace sim2d::nav2 {

class SmacPoseSearch {
 public:
  /// Hybrid: analytic expansions start from the earliest possible ancestor; too many nodes are a
  /// timeout. Lattice: a search that ends with no open node is no timeout.
  enum class Kind : std::uint8_t { Hybrid, Lattice };

  /// All references must outlive the search.
  struct Setup {
    Kind kind;
    const SmacPoseParameters& parameters;
    Distro distro;
    const Costmap& costmap;      // has the resolution of the search; is copied
    const PlanRequest& request;  // its footprint and stop flag are used
    ObstacleHeuristic& obstacles;
    CarMotion car;
    double turningRadius;  // R [cells]
    int headings;          // their number
    ObstacleHeuristic::Settings heuristic;
    int coarseSearchResolution = 1;
  };

  SmacPoseSearch(const SmacPoseSearch&) = delete;
  SmacPoseSearch& operator=(const SmacPoseSearch&) = delete;
  SmacPoseSearch(SmacPoseSearch&&) = delete;
  SmacPoseSearch& operator=(SmacPoseSearch&&) = delete;
  virtual ~SmacPoseSearch() = default;

  /// Finds a path from the start to the goal with one of the headings that `goal_heading_mode`
  /// allows, or as near as the tolerance allows.
  PlanResult plan(const Pose2& start, const Pose2& goal);

 protected:
  struct Node {
    Pose2 pose;
    double g = 0.0;
    int heading = 0;
    int parent = -1;
    int step = -1;  // index of the step into this node; -1: start
    bool isBackward = false, isVisited = false;
  };

  explicit SmacPoseSearch(const Setup& setup);

  virtual int nearestHeading(double heading) const = 0;
  virtual double headingOf(int index) const = 0;  // [rad]
  virtual void expand(int index) = 0;
  /// A lower bound of the length to a goal [cells], without obstacles; `round` is the bound of a
  /// point robot that avoids obstacles.
  virtual double curveEstimate(const Node& node, const Pose2& goal, double round) = 0;
  /// Appends the poses of the step into a node.
  virtual void addPoses(const Node& parent, const Node& node, Path& path) const;

  /// The cost of the robot's cell at a pose, or nullopt in a collision.
  std::optional<std::uint8_t> costAt(const Pose2& pose) const;
  /// Replaces the unvisited node at the position and heading of `next` if this has the lower cost.
  /// `costOf(next)` is the cost of the step into it [cells]; nullopt: a collision.
  template <class CostOf>
  void offer(Node next, const CostOf& costOf) {
    const int index = isInside(next.pose.position) ? nodeAt(next.pose.position, next.heading) : -1;
    if (index < 0 || nodeWith(index).isVisited) {
      return;
    }
    next.pose.heading = headingOf(next.heading);
    const std::optional<double> cost = costOf(next);
    if (!cost) {
      return;
    }
    next.g = nodeWith(next.parent).g + *cost;
    Node& known = nodes_[static_cast<std::size_t>(index)];
    if (next.g < known.g) {
      known = next;
      const double toGo = estimate(next);
      nearest_.offer(toGo, static_cast<std::size_t>(index));
      open_.push(next.g + toGo, static_cast<std::size_t>(index));
    }
  }
  const Node& nodeWith(int index) const { return nodes_[static_cast<std::size_t>(index)]; }
  double curveLength(const Node& node, const Pose2& goal) const;
  const Setup& setup() const { return setup_; }

 private:
  PlanResult find(const Pose2& start);
  void begin(const Pose2& start);
  std::vector<Pose2> goalsAt(const Pose2& goal) const;
  int nodeAt(const Vec2& place, int heading);
  bool isInside(const Vec2& place) const;
  void endWithoutGoal(PlanResult& result, int mostIterations) const;
  bool isFull() const;
  double tolerance() const;  // [cells]
  double estimate(const Node& node);
  std::optional<Path> connectToGoal(int index);
  std::optional<Path> tryAnalyticExpansion(int index);
  std::optional<Path> analyticExpansionFrom(const Node& node, const Pose2& goal) const;
  bool isTooCostly(const std::vector<std::uint8_t>& costs, double length) const;
  std::optional<Path> shortestToGoals(const Node& node, const Pose2*& goal) const;
  const Node* ancestorOf(const Node& node) const;
  Path pathTo(int index) const;

  Setup setup_;
  Costmap costmap_;
  std::vector<Pose2> goals_;  // all at the same position
  std::vector<int> goalNodes_;
  std::vector<Node> nodes_;
  std::vector<std::int32_t> blockOf_;  // per cell: index of its headings in `slots_`; -1: none yet
  std::vector<std::int32_t> slots_;    // per cell and heading: index of its node; -1: none yet
  OpenList<double> open_;
  NearestNode nearest_;
  int due_ = 0;            // nodes until the next analytic expansion
  int closest_ = 1 << 30;  // minimum estimate so far [cells]
};

Cell cellAt(const Vec2& inCells);
/// A pose in cells of a costmap; `isCentred`: moved to the centre of its cell.
Pose2 inCells(const Costmap& costmap, const Pose2& pose, bool isCentred);

/// Checks the request, calls `search`, which returns a path in cells, and returns that path in the
/// world frame, smoothed if `smooth_path` is set.
PlanResult planOverPoses(const Costmap& costmap, const PlanRequest& request,
                         const SmacPoseParameters& parameters, const CarModel& car,
                         const std::function<PlanResult()>& search);

/// A primitive after another one; null: at the start.
struct LatticeStep {
  const LatticePrimitive* before;
  const LatticePrimitive& primitive;
  bool isBackward;
};
/// Cost [cells] of a step into cells of that cost. `cellSize` [m] is that of the costmap.
double latticeCost(const SmacLatticeParameters& parameters, Distro distro, double cellSize,
                   const LatticeStep& step, double cellCost);

/// A motion primitive of Smac Hybrid-A* (nav2_smac_planner, node_hybrid.cpp). Lengths in cells,
/// headings in bins of 2 pi / `angle_quantization_bins`.
struct HybridStep {
  double dx = 0.0, dy = 0.0;  // [cells], in the frame of the start pose
  int bins = 0;               // heading change, counter-clockwise
  ShortestCurve::Turn turn = ShortestCurve::Turn::Straight;
  bool isBackward = false;
  double length = 0.0;  // L [cells]
};

/// The motion primitives of a car and their costs.
struct HybridMotion {
  HybridMotion(const SmacHybridParameters& parameters, double cellSize, Distro distro);

  int nearestBin(double heading) const;
  int wrappedBin(int bin) const { return ((bin % bins) + bins) % bins; }
  /// Displacement of a step from a heading, world axes [cells].
  const Vec2& offset(std::size_t step, int bin) const {
    return offsets[step * static_cast<std::size_t>(bins) + static_cast<std::size_t>(bin)];
  }
  /// Cost of a step into a cell after another step; `before` is null at the start.
  double cost(const HybridStep* before, const HybridStep& step, std::uint8_t cellCost) const;

  SmacHybridParameters parameters;
  CarMotion car;
  int bins;
  double binSize;        // [rad]
  double turningRadius;  // R [cells], at least 1
  bool isQuadratic;
  /// Straight, left, right, the same in reverse for Reeds-Shepp, then wider turns.
  std::vector<HybridStep> steps;
  std::vector<Vec2> offsets;  // see `offset`

 private:
  void addTurn(int turnedBins, double radius, double length);
};

}  // namespace sim2d::nav2
