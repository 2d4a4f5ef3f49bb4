#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "bt/robot/RobotNodes.h"
#include "sim2d/base/Math.h"

/// Actions of Nav2 that truncate paths.
namespace bt {
namespace {

using base::NodeStatus;
using base::Pose2;
using base::Vec2;
using sim2d::nav2::Path;

/// Ports 0: distance [m], 1: path, 2: result. Removes poses within the straight-line distance of
/// the end; the new end faces the old one.
NodeStatus truncatePath(LeafContext& leaf) {
  Path path = robotOf(leaf).paths().get(pathOf(leaf, 1));
  if (path.empty()) {
    return setPathOutput(leaf, 2, {});
  }
  const double distance = leaf.require<double>(0);
  const Vec2 end = path.back().position;
  while (path.size() > 2 && (path.back().position - end).norm() < distance) {
    path.pop_back();
  }
  const Vec2 towards = end - path.back().position;
  path.back().heading = base::atan2(towards.y(), towards.x());
  return setPathOutput(leaf, 2, std::move(path));
}

/// Ports 0: path, 1: result, 2, 3: length kept ahead and behind [m], 4: pose, 5: weight of angles,
/// 6: length of the path on which the robot is searched [m].
Path sectionAround(LeafContext& leaf, const Path& path, const Pose2& pose) {
  const double ahead = leaf.getOr<double>(2, 8.0), behind = leaf.getOr<double>(3, 4.0);
  const double weight = leaf.getOr<double>(5, 0.0);
  const double search = leaf.getOr<double>(6, std::numeric_limits<double>::infinity());
  const auto distanceTo = [&](const Pose2& at) {
    const double turn = weight * base::wrapToPi(at.heading - pose.heading);
    return std::sqrt((at.position - pose.position).squaredNorm() + turn * turn);
  };
  std::size_t nearest = 0;
  double way = 0.0;  // [m] from the start
  for (std::size_t i = 1; i < path.size(); ++i) {
    way += (path[i].position - path[i - 1].position).norm();
    if (way > search) {
      break;
    }
    nearest = distanceTo(path[i]) < distanceTo(path[nearest]) ? i : nearest;
  }
  std::size_t first = nearest, end = nearest + 1;
  for (double length = 0.0; end < path.size(); ++end) {
    length += (path[end].position - path[end - 1].position).norm();
    if (length > ahead) {
      break;
    }
  }
  for (double length = 0.0; first > 0; --first) {
    length += (path[first].position - path[first - 1].position).norm();
    if (length > behind) {
      break;
    }
  }
  return Path(path.begin() + static_cast<std::ptrdiff_t>(first),
              path.begin() + static_cast<std::ptrdiff_t>(end));
}

NodeStatus truncatePathLocal(LeafContext& leaf) {
  const NavigatorHost& robot = robotOf(leaf);
  const Path& path = robot.paths().get(pathOf(leaf, 0));
  if (path.empty()) {
    return NodeStatus::Failure;
  }
  const Path& given = robot.paths().get(pathOf(leaf, 4));
  const Pose2 pose = given.empty() ? robot.pose() : given.front();
  return setPathOutput(leaf, 1, sectionAround(leaf, path, pose));
}

constexpr const char* kNodes = R"(
Action TruncatePath|Navigation|Removes the end of a path.
distance length default 1.0|Straight-line distance to the end.
input_path any needed suggest {path}|Path.
output_path any output suggest {truncated_path}|Truncated path.
Action TruncatePathLocal|Navigation|Keeps the part of a path around the robot.
input_path any needed suggest {path}|Path.
output_path any output suggest {truncated_path}|Truncated path.
distance_forward number default 8.0 unit m|Length kept ahead.
distance_backward number default 4.0 unit m|Length kept behind.
pose any|Pose that replaces the robot's pose.
angular_distance_weight number default 0.0|Weight of heading differences relative to distances.
max_robot_pose_search_dist number unit m|Length of the path that is searched for the robot; absent: the whole path.
transform_tolerance number default 0.2|No effect: the pose is always current.
robot_frame text default base_link|No effect (until Kilted).
robot_base_frame text default base_link|No effect (since Lyrical).
)";

}  // namespace

void addRobotPaths(NodeLibrary& to) {
  to.add(parseNodeCatalogue(kNodes, NodeOrigin::Ours),
         {{"TruncatePath", synchronous<OutputMemory>(truncatePath)},
          {"TruncatePathLocal", synchronous<OutputMemory>(truncatePathLocal)}});
}

}  // namespace bt
