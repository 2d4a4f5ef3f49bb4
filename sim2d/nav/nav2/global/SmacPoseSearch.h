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
  /// The node at a position and heading; -1 outside the costmap or if it is visited.
  int unvisitedNode(const Vec2& place, int heading);
  /// Replaces an unvisited node by `found` if this has the lower cost.
  void offer(int index, const Node& found);
  const Node& nodeWith(int index) const { return nodes_[static_cast<std::size_t>(index)]; }
  double curveLength(const Node& node, const Pose2& goal) const;
  const Setup& setup() const { return setup_; }

 private:
  PlanResult find(const Pose2& start);
  void begin(const Pose2& start);
  std::vector<Pose2> goalsAt(const Pose2& goal) const;
  int nodeAt(const Vec2& place, int heading);
  bool isInside(const Vec2& place) const;
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

}  // namespace sim2d::nav2
