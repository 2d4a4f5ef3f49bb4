#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/base/StopFlag.h"
#include "sim2d/nav/nav2/Costmap.h"

/// Global planners of Nav2 (nav2_core::GlobalPlanner), which plan a path through a costmap. They do
/// not read a clock: limits of wall-clock time are limits of iterations (PlannerParameters.h).
namespace sim2d::nav2 {

/// Why there is no path, with the codes of nav2_msgs/action/ComputePathToPose. Humble has no error
/// codes and distinguishes only None from failures.
enum class PlanError : std::uint16_t {
  None = 0,
  Unknown = 200,
  InvalidPlanner = 201,
  TfError = 202,  // the robot's pose in the map is unknown
  StartOutsideMap = 203,
  GoalOutsideMap = 204,
  StartOccupied = 205,
  GoalOccupied = 206,
  Timeout = 207,  // the iteration limit is reached
  NoValidPath = 208,
};
const char* planErrorName(PlanError error);     // "GOAL_OCCUPIED"
const char* planErrorMessage(PlanError error);  // "the goal is occupied"; "" for None

struct PlanRequest {
  PlanRequest(const Costmap& where, const Pose2& from, const Pose2& to)
      : costmap(where), start(from), goal(to) {}

  const Costmap& costmap;  // global costmap after its last update; must outlive the call
  Pose2 start, goal;       // world frame [m], [rad]
  /// Padded corners in the robot's frame [m]. Empty: a round robot, for which the cost of the cell
  /// under its centre decides. Used only by Smac Hybrid and Smac Lattice.
  std::vector<Vec2> footprint;
  /// Inflation cost at the circumscribed radius: cells of lower cost need no footprint check. <= 0:
  /// always checks.
  double circumscribedCost = -1.0;
  const base::StopFlag* stop = nullptr;  // a stop request throws base::Stopped
};

struct PlanResult {
  PlanError error = PlanError::None;
  Path path;           // to the goal, or as near as the tolerance allows; empty with an error
  int iterations = 0;  // cells or poses expanded
};

/// Equal requests give bit-identical results, independent of earlier requests (except for
/// `cache_obstacle_heuristic`, whose cache is kept). Not thread-safe.
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

/// `use_final_approach_orientation`: sets the last heading to the direction of the last segment, or
/// of the one before if it has no length; a single pose gets the start's heading.
void setFinalApproachHeading(Path& path, double startHeading);

/// The single pose of a path whose start and goal coincide.
Pose2 singlePose(const Pose2& start, const Pose2& goal, bool useFinalApproachOrientation);

}  // namespace sim2d::nav2
