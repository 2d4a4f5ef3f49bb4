#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2Block.h"

/// Which part of a path counts: near the robot, within the local costmap.
namespace sim2d::nav2 {

struct ControlInput;

/// Sum of the straight distances between its poses [m].
double pathLength(const Path& path);
/// The first pose after more than `distance` [m] of way from `begin` on; the end when there is
/// none.
std::size_t firstAfterDistance(const Path& path, std::size_t begin, double distance);
/// The first pose after the first cusp (consecutive segments with a negative product); its size:
/// none.
std::size_t firstAfterInversion(const Path& path);
/// Half the larger side [m], from edge to last centre as Nav2 measures it.
double halfExtent(const Costmap& costmap);

/// How a path is cut. Until Jazzy each controller has its own way, main has one for all.
struct PathHandling {
  enum class Rule {
    Pursuit,  // RPP, Graceful: nearest pose, straight distance
    Dwb,      // first near pose, straight distance
    Way,      // MPPI; FeasiblePathHandler: nearest pose, distance along the path
  };
  Rule rule = Rule::Way;
  double searchDistance = 0.0;         // max_robot_pose_search_dist [m]; < 0: all, 0: half the map
  double pruneDistance = 2.0;          // [m]
  double forwardPruneDistance = 2.0;   // [m], Dwb
  bool prunesPlan = true;              // Dwb: prune_plan
  bool shortensPlan = true;            // Dwb: shorten_transformed_plan
  bool keepsTwo = false;               // the nearest is never the last alone
  bool enforcesInversion = false;      // ends at the first cusp until the robot is there
  bool enforcesRotation = false;       // the same at turns on the spot (main)
  double minimumRotation = 0.785;      // [rad], such a turn
  double inversionXyTolerance = 0.2;   // [m]
  double inversionYawTolerance = 0.4;  // [rad]
  bool rejectsUnitPath = false;        // one pose is no path
};

/// Main: nav2_controller::FeasiblePathHandler, keys of the controller server's block.
struct FeasiblePathHandlerParameters {
  double searchDistance = 0.0;  // max_robot_pose_search_dist [m]; < 0: all, 0: half the map
  double pruneDistance = 2.0;   // [m]
  bool enforcesInversion = false;
  bool enforcesRotation = false;
  double minimumRotation = 0.785;      // [rad]
  double inversionXyTolerance = 0.2;   // [m]
  double inversionYawTolerance = 0.4;  // [rad]
  bool rejectsUnitPath = false;
};
const std::vector<Nav2Key<FeasiblePathHandlerParameters>>& feasiblePathHandlerKeys();
PathHandling handlingOf(const FeasiblePathHandlerParameters& parameters);

/// The part that counts, or why there is none: InvalidPath in Nav2's words.
struct LocalPlan {
  Path poses;
  const char* problem = nullptr;
};

/// Holds the path and cuts it; passed poses are erased.
class PathHandler {
 public:
  explicit PathHandler(const PathHandling& handling) : handling_(handling) {}

  void setPlan(const Path& plan);
  const Path& plan() const { return plan_; }  // what is left of it
  /// Robot, costmap and result are in one frame, in which `planFrame` is the frame of the plan.
  LocalPlan localPlan(const Pose2& robot, const Costmap& costmap, const Pose2& planFrame = {});
  /// The same for a controller: in main the server has cut it already.
  LocalPlan localPlan(const ControlInput& input);

 private:
  std::size_t nearest(const Pose2& robot, const Costmap& costmap) const;
  LocalPlan pursuitPlan(const Pose2& robot, const Costmap& costmap);
  LocalPlan dwbPlan(const Pose2& robot, const Costmap& costmap);
  LocalPlan wayPlan(const Pose2& robot, const Costmap& costmap, const Pose2& planFrame);
  void cutAtConstraint();
  bool isAtConstraint(const Pose2& robot) const;

  PathHandling handling_;
  Path plan_;                   // up to the first cusp when those are enforced
  Path rest_;                   // the whole, from the last cusp passed
  std::size_t constraint_ = 0;  // first pose of `rest_` after the cusp; 0: none
};

}  // namespace sim2d::nav2
