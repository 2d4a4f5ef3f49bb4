#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "bt/engine/TreeState.h"
#include "bt/robot/NavigatorHost.h"

namespace bt {

/// Trees that the nodes NavigateToPose and NavigateThroughPoses of a robot's tree ask for,
/// compiled.
struct NavigatorTrees {
  std::map<std::string, std::shared_ptr<const Program>>
      byName;                                           // as the port behavior_tree has them
  std::shared_ptr<const Program> toPose, throughPoses;  // where the port is empty

  /// Null: it was not loaded.
  std::shared_ptr<const Program> find(RobotAction action, const std::string& name) const;
};

/// The number of a list with each of these goals pending.
std::int64_t addPending(NavigatorHost& host, const sim2d::nav2::Path& goals);

/// Codes of nav2_msgs/action/NavigateToPose; those of NavigateThroughPoses are 100 more.
enum class NavigationError : std::uint16_t {
  None = 0,
  Unknown = 9000,
  FailedToLoadTree = 9001,
};
constexpr int navigationCode(RobotAction action, NavigationError error) {
  const int code = static_cast<int>(error);
  return code == 0 || action == RobotAction::NavigateToPose ? code : code + 100;
}

/// A navigation that a node of another tree has asked for: its own tree with its own blackboard, on
/// the servers of the same host. One tree, one thread.
class SubNavigation {
 public:
  /// `goals`: a path of one pose, or of several. `waypoints`: their statuses.
  SubNavigation(RobotAction action, std::shared_ptr<const Program> program, PathId goals,
                std::int64_t waypoints);

  RobotAction action() const { return action_; }
  PathId goals() const { return goals_; }
  /// One step of `dt` [s]. FAILURE also when the tree is faulty.
  base::NodeStatus tick(NavigatorHost& host, double dt);
  void halt(NavigatorHost& host, double dt);
  /// Why the tree is faulty; empty: it is not.
  std::string fault() const;

 private:
  RobotAction action_;
  PathId goals_;
  TreeState tree_;
  std::int64_t step_ = 0;
};

}  // namespace bt
