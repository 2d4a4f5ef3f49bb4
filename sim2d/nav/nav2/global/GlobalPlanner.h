#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/base/Stop.h"
#include "sim2d/nav/nav2/Costmap.h"

/// Global planners of Nav2 (nav2_core::GlobalPlanner): a path from here to there through a costmap.
/// They know no clock: a limit of wall-clock time is one of iterations here (PlannerParameters.h).
namespace sim2d::nav2 {

/// Why there is no path, with the numbers of nav2_msgs/action/ComputePathToPose. Humble has no such
/// codes; there only None and the rest can be told apart.
enum class PlanError : std::uint16_t {
  None = 0,
  Unknown = 200,
  InvalidPlanner = 201,
  TfError = 202,  // the robot has no pose in the map
  StartOutsideMap = 203,
  GoalOutsideMap = 204,
  StartOccupied = 205,
  GoalOccupied = 206,
  Timeout = 207,  // the limit of iterations is used up
  NoValidPath = 208,
};
const char* planErrorName(PlanError error);   // "GOAL_OCCUPIED"
const char* planErrorWords(PlanError error);  // "the goal is occupied"; "" for None

struct PlanRequest {
  PlanRequest(const Costmap& where, const Pose2& from, const Pose2& to)
      : costmap(where), start(from), goal(to) {}

  const Costmap& costmap;  // the global one, as last updated; must outlive the call
  Pose2 start, goal;       // world frame [m], [rad]
  /// Corners with padding in the robot's frame [m]. Empty: a round robot, for which the cost of the
  /// cell under its centre decides. Only Smac Hybrid looks at it.
  std::vector<Vec2> footprint;
  /// What the inflation layer writes at the footprint's circumscribed radius: cheaper cells need no
  /// look at the footprint. 0 or less: looks always.
  double circumscribedCost = -1.0;
  const base::StopFlag* stop = nullptr;  // heeded by throwing base::Stopped
};

struct PlanResult {
  PlanError error = PlanError::None;
  Path path;           // from the start to the goal or as near as allowed; empty with an error
  int iterations = 0;  // cells or poses expanded
};

/// Equal requests give equal bytes whatever was asked before (but `cache_obstacle_heuristic` keeps
/// what it saw, as it shall). Thread: one at a time.
class GlobalPlanner {
 public:
  GlobalPlanner() = default;
  virtual ~GlobalPlanner() = default;
  GlobalPlanner(const GlobalPlanner&) = delete;
  GlobalPlanner& operator=(const GlobalPlanner&) = delete;
  GlobalPlanner(GlobalPlanner&&) = delete;
  GlobalPlanner& operator=(GlobalPlanner&&) = delete;

  virtual PlanResult plan(const PlanRequest& request) = 0;
};

}  // namespace sim2d::nav2
