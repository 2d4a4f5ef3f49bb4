#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "bt/engine/TreeState.h"
#include "bt/robot/NavigatorHost.h"

namespace bt {

/// Compiled trees that the nodes NavigateToPose and NavigateThroughPoses of a robot's tree request.
struct NavigatorTrees {
  std::map<std::string, std::shared_ptr<const Program>>
      byName;                                           // by value of the port behavior_tree
  std::shared_ptr<const Program> toPose, throughPoses;  // for an empty port

  /// Null: not loaded.
  std::shared_ptr<const Program> find(RobotAction action, const std::string& name) const;
};

/// Stores a waypoint list with all goals pending and returns its number.
std::int64_t addPendingWaypoints(NavigatorHost& host, const sim2d::nav2::Path& goals);

/// Codes of nav2_msgs/action/NavigateToPose; those of NavigateThroughPoses are larger by 100.
enum class NavigationError : std::uint16_t {
  None = 0,
  Unknown = 9000,
  FailedToLoadTree = 9001,
};
constexpr int navigationCode(RobotAction action, NavigationError error) {
  const int code = static_cast<int>(error);
  return code == 0 || action == RobotAction::NavigateToPose ? code : code + 100;
}

/// A navigation requested by a node of another tree: its own tree and blackboard on the servers of
/// the same host. Not synchronised.
class NestedNavigation {
 public:
  /// `goals`: a path of one or more poses. `waypoints`: their statuses.
  NestedNavigation(RobotAction action, std::shared_ptr<const Program> program, PathId goals,
                   std::int64_t waypoints);

  RobotAction action() const { return action_; }
  PathId goals() const { return goals_; }
  /// One step of `dt` [s]. Returns FAILURE also for a faulty tree.
  base::NodeStatus tick(NavigatorHost& host, double dt);
  void halt(NavigatorHost& host, double dt);
  /// The fault of the tree; empty: none.
  std::string fault() const;

 private:
  RobotAction action_;
  PathId goals_;
  TreeState tree_;
  std::int64_t step_ = 0;
};

}  // namespace bt
