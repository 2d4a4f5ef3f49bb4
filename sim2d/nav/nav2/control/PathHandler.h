#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

/// Selects the part of a path near the robot and within the local costmap.
namespace sim2d::nav2 {

struct ControlInput;

/// Sum of the distances between consecutive poses [m].
double pathLength(const Path& path);
/// Index of the first pose after more than `distance` [m] along the path from `begin`; the size of
/// the path if there is none.
std::size_t firstAfterDistance(const Path& path, std::size_t begin, double distance);
/// Index of the first pose after the first cusp (consecutive segments with a negative dot product);
/// the size of the path if there is none.
std::size_t firstAfterInversion(const Path& path);
/// Half the larger side [m], from the edge to the last cell centre as in Nav2.
double halfExtent(const Costmap& costmap);

/// How a path is pruned. Until Jazzy each controller has its own rule, main has one for all.
struct PathPruning {
  enum class Rule {
    Pursuit,    // RPP, Graceful: nearest pose, Euclidean distance
    Dwb,        // first near pose, Euclidean distance
    AlongPath,  // MPPI; FeasiblePathHandler: nearest pose, distance along the path
  };
  Rule rule = Rule::AlongPath;
  double searchDistance = 0.0;         // max_robot_pose_search_dist [m]; < 0: all, 0: half the map
  double pruneDistance = 2.0;          // [m]
  double forwardPruneDistance = 2.0;   // [m], Dwb
  bool prunesPlan = true;              // Dwb: prune_plan
  bool shortensPlan = true;            // Dwb: shorten_transformed_plan
  bool keepsLastTwo = false;           // does not start at the last pose, keeps the one before
  bool enforcesInversion = false;      // ends at the first cusp until the robot reaches it
  bool enforcesRotation = false;       // the same for turns in place (main)
  double minimumRotation = 0.785;      // [rad], minimum of such a turn
  double inversionXyTolerance = 0.2;   // [m]
  double inversionYawTolerance = 0.4;  // [rad]
  bool rejectsUnitPath = false;        // rejects a path of one pose
};

/// Main: keys of nav2_controller::FeasiblePathHandler, for which `keepsLastTwo` is set.
const std::vector<Nav2Key<PathPruning>>& feasiblePathHandlerKeys();

/// The pruned path, or why it is invalid (InvalidPath) in Nav2's words.
struct LocalPlan {
  Path poses;
  const char* problem = nullptr;
};

/// Stores the path and prunes it; erases passed poses.
class PathHandler {
 public:
  explicit PathHandler(const PathPruning& pruning) : pruning_(pruning) {}

  void setPlan(const Path& plan);
  const Path& plan() const { return plan_; }  // remaining path
  /// Robot, costmap and result are in one frame; `planFrame` is the frame of the plan in it.
  LocalPlan localPlan(const Pose2& robot, const Costmap& costmap, const Pose2& planFrame = {});
  /// The same for a controller; in main the server has already pruned the path.
  LocalPlan localPlan(const ControlInput& input);

 private:
  std::size_t nearest(const Pose2& robot, const Costmap& costmap) const;
  LocalPlan pursuitPlan(const Pose2& robot, const Costmap& costmap);
  LocalPlan dwbPlan(const Pose2& robot, const Costmap& costmap);
  LocalPlan alongPathPlan(const Pose2& robot, const Costmap& costmap, const Pose2& planFrame);
  void truncateAtConstraint();
  bool isAtConstraint(const Pose2& robot) const;

  PathPruning pruning_;
  Path plan_;                   // up to the first cusp if inversions are enforced
  Path remainingPlan_;          // complete remaining path
  std::size_t constraint_ = 0;  // first pose of `remainingPlan_` after the cusp; 0: none
};

/// Deviation of a robot from its path (nav2_msgs/TrackingFeedback of the controller server, since
/// Lyrical).
struct TrackingFeedback {
  int number = 0;               // number of controller cycles; 0: none yet
  double positionError = 0.0;   // distance to the path [m]; positive: the robot is to its left
  double headingError = 0.0;    // from the robot's heading to the path direction [rad]
  std::size_t index = 0;        // pose at which the nearest segment begins
  double distanceToGoal = 0.0;  // Euclidean distance to the end of the path [m]
  double remaining = 0.0;       // path length from the nearest point [m]
};

/// Finds the nearest segment of the path, starting at segment `first`, within `window` metres of
/// path length (negative: to the end). Leaves `number` at 0. The direction of a segment of zero
/// length is the heading of its first pose. A path of one pose is compared with that pose; an empty
/// path gives zeros.
TrackingFeedback trackingError(const Path& path, const Pose2& robot, std::size_t first,
                               double window);

}  // namespace sim2d::nav2
