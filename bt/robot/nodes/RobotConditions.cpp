#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bt/robot/RobotNodes.h"
#include "sim2d/base/Text.h"

/// Conditions of Nav2, and nodes that check paths against the costmap, the robot's motion and its
/// tracking error (nav2_behavior_tree/plugins/condition and /action).
namespace bt {
namespace {

using base::NodeStatus;
using base::Pose2;
using base::Vec2;

// IsPathValid until Kilted, ValidatePath since Lyrical. Ports 0: path, 1: maximum cost, 2: unknown
// counts as an obstacle; for ValidatePath 4: length ahead, 5: layer, 6: footprint, 7: stops at the
// first collision, 8: collisions (out).

PathCheck checkOf(LeafContext& leaf) {
  PathCheck check;
  check.path = pathOf(leaf, 0);
  check.maxCost = leaf.getOr<int>(1, check.maxCost);
  check.unknownBlocks = leaf.getOr<bool>(2, false);
  return check;
}

NodeStatus isPathValid(LeafContext& leaf) {
  return successIf(robotOf(leaf).checkPath(checkOf(leaf)).isValid);
}

NodeStatus validatePath(LeafContext& leaf) {
  PathCheck check = checkOf(leaf);
  check.lookahead = leaf.getOr<double>(4, -1.0);
  check.layer = textOf(leaf, 5);
  check.footprint = textOf(leaf, 6);
  check.stopsAtFirst = leaf.getOr<bool>(7, true);
  NavigatorHost& robot = robotOf(leaf);
  PathCheckResult result = robot.checkPath(check);
  setNumber(leaf, 8,
            result.collisions.empty() ? 0 : robot.paths().add(std::move(result.collisions)));
  return successIf(result.isValid);
}

// IsStopped (Kilted) and CheckStopStatus (since Lyrical). Ports 0: speed, 1: time [ms].

struct StopMemory {
  std::int64_t since;  // step in which it stopped; 0: it moves
};

bool isSlow(const sim2d::BodyTwist& motion, double threshold) {
  return std::fabs(motion.linear) < threshold && std::fabs(motion.lateral) < threshold &&
         std::fabs(motion.angular) < threshold;
}

NodeStatus checkStop(LeafContext& leaf) {
  constexpr double kMilliseconds = 1e-3;  // [s]
  std::int64_t& since = leaf.memory<StopMemory>().since;
  if (!isSlow(robotOf(leaf).motion(), leaf.require<double>(0))) {
    since = 0;
    return NodeStatus::Failure;
  }
  since = since == 0 ? leaf.step() : since;
  if (!leaf.hasElapsed(since, kMilliseconds * leaf.getOr<int>(1, 1000))) {
    return NodeStatus::Running;
  }
  since = 0;
  return NodeStatus::Success;
}

/// Ports 0: tracking feedback, 1, 2: maximum distance to the left and right [m], 3: maximum heading
/// difference [rad]. Fails without feedback, as in Nav2.
NodeStatus isWithinBounds(LeafContext& leaf) {
  const sim2d::nav2::TrackingFeedback tracking = robotOf(leaf).tracking();
  if (leaf.getOr<int>(0, 0) == 0 || tracking.number == 0) {
    return NodeStatus::Failure;
  }
  const double most =
      tracking.positionError > 0.0 ? leaf.require<double>(1) : leaf.require<double>(2);
  return successIf(std::fabs(tracking.positionError) <= most &&
                   std::fabs(tracking.headingError) <= leaf.require<double>(3));
}

/// Ports 0: service, 1: on. The service sets the switch even if the file has no collision monitor.
NodeStatus toggleMonitor(LeafContext& leaf) {
  robotOf(leaf).enableCollisionMonitor(leaf.require<bool>(1));
  return NodeStatus::Success;
}

struct GoalMemory {
  PathId goal, goals;
  bool hasLooked;
};

NodeStatus goalUpdated(LeafContext& leaf) {
  const bool isNew = takeNewGoal(leaf, leaf.memory<GoalMemory>(), 0);
  return successIf(isNew && !isStarting(leaf));
}

/// Keeps its memory over halts; the first call succeeds.
NodeStatus globalUpdatedGoal(LeafContext& leaf) {
  auto& memory = leaf.memory<GoalMemory>();
  const bool isFirst = !memory.hasLooked;
  memory.hasLooked = true;
  return successIf(takeNewGoal(leaf, memory, 0) || isFirst);
}

struct ClockMemory {
  std::int64_t since;  // step
  PathId path;
  bool hasLooked;
};

/// Port 0: time [s].
NodeStatus timeExpired(LeafContext& leaf) {
  auto& memory = leaf.memory<ClockMemory>();
  const bool isOver = !isStarting(leaf) && leaf.hasElapsed(memory.since, leaf.require<double>(0));
  if (isStarting(leaf) || isOver) {
    memory.since = leaf.step();
  }
  return successIf(isOver);
}

/// Ports 0: time [s], 1: path. The first call is detected only once, regardless of halts.
NodeStatus pathExpiringTimer(LeafContext& leaf) {
  auto& memory = leaf.memory<ClockMemory>();
  const PathId path = pathOf(leaf, 1);
  const bool isOther = !memory.hasLooked || path != memory.path;
  const bool isOver = !isOther && leaf.hasElapsed(memory.since, leaf.require<double>(0));
  memory.path = path;
  memory.hasLooked = true;
  if (isOther || isOver) {
    memory.since = leaf.step();
  }
  return successIf(isOver);
}

struct PlaceMemory {
  double x, y;  // [m]
};

/// Ports 0: distance [m], 1: frame.
NodeStatus distanceTraveled(LeafContext& leaf) {
  auto& memory = leaf.memory<PlaceMemory>();
  const Vec2 place = robotOf(leaf).poseIn(textOf(leaf, 1)).position;
  const double travelled = (place - Vec2(memory.x, memory.y)).norm();
  const bool isFar = !isStarting(leaf) && travelled >= leaf.require<double>(0);
  if (isStarting(leaf) || isFar) {
    memory = {place.x(), place.y()};
  }
  return successIf(isFar);
}

/// The last pose of a path; empty: the path is empty.
std::optional<Pose2> endOf(const LeafContext& leaf, int port) {
  const sim2d::nav2::Path& path = robotOf(leaf).paths().get(pathOf(leaf, port));
  return path.empty() ? std::nullopt : std::optional<Pose2>(path.back());
}

/// Port 0: goal.
NodeStatus goalReached(LeafContext& leaf) {
  const std::optional<Pose2> goal = endOf(leaf, 0);
  const NavigatorHost& robot = robotOf(leaf);
  return successIf(goal &&
                   (goal->position - robot.pose().position).norm() <= robot.goalReachedTolerance());
}

/// Detects a deceleration above 10 m/s², as in a collision.
NodeStatus isStuck(LeafContext& leaf) {
  constexpr double kHardest = -10.0;  // [m/s2]
  return successIf(robotOf(leaf).acceleration() < kHardest);
}

std::vector<int> numbersOf(std::string text) {
  std::replace(text.begin(), text.end(), ',', ';');
  std::vector<int> numbers;
  for (const std::string& word : base::split(text, ';')) {
    if (const auto number = base::parseInt(base::trimmed(word))) {
      numbers.push_back(static_cast<int>(*number));
    }
  }
  return numbers;
}

template <class Codes>
bool isAmong(int code, const Codes& codes) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

/// Ports 0: code, 1: codes.
NodeStatus errorCodesPresent(LeafContext& leaf) {
  return successIf(isAmong(leaf.getOr<int>(0, 0), numbersOf(leaf.text(1).value_or(""))));
}

// Codes of Nav2's actions for which a recovery may help: unknown, patience exceeded, no progress,
// no valid control; unknown, timeout, no valid path (to a pose, through poses); unknown, timeout,
// in collision, failed; unknown, no valid route, timeout.
constexpr std::array<int, 4> kOfController = {100, 104, 105, 106};
constexpr std::array<int, 6> kOfPlanner = {200, 207, 208, 300, 307, 308};
constexpr std::array<int, 4> kOfSmoother = {500, 502, 503, 504};
constexpr std::array<int, 3> kOfRoute = {400, 404, 405};

template <const auto& codes>
NodeStatus recoveryHelps(LeafContext& leaf) {
  return successIf(isAmong(leaf.getOr<int>(0, 0), codes));
}

/// Ports 0, 1: poses, 2: tolerance [m].
NodeStatus posesNear(LeafContext& leaf) {
  const std::optional<Pose2> from = endOf(leaf, 0), to = endOf(leaf, 1);
  return successIf(from && to && (from->position - to->position).norm() <= leaf.require<double>(2));
}

/// Length of a path from the pose nearest to the robot [m]. The nearest pose is searched on the
/// first `search` metres of the path; < 0: on all of it.
double restOf(const sim2d::nav2::Path& path, const Vec2& robot, double search) {
  std::size_t nearest = 0;
  double way = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    way += (path[i].position - path[i - 1].position).norm();
    if (search >= 0.0 && way > search) {
      break;
    }
    const bool isNearer =
        (path[i].position - robot).squaredNorm() < (path[nearest].position - robot).squaredNorm();
    nearest = isNearer ? i : nearest;
  }
  const auto first = path.begin() + static_cast<std::ptrdiff_t>(nearest);
  return lengthOf(sim2d::nav2::Path(first, path.end()));
}

/// Ports 0: path, 1: distance [m], 2: length of the path on which the robot is searched [m].
NodeStatus goalNearby(LeafContext& leaf) {
  const NavigatorHost& robot = robotOf(leaf);
  const sim2d::nav2::Path& path = robot.paths().get(pathOf(leaf, 0));
  const double search = leaf.getOr<double>(2, -1.0);
  return successIf(!path.empty() &&
                   restOf(path, robot.pose().position, search) < leaf.require<double>(1));
}

constexpr const char* kNodes = R"(
Condition IsPathValid|Navigation|No obstacle of the global costmap is on the remaining path (until Kilted).
path any needed suggest {path}|Path.
max_cost int default 254|Minimum cost of an obstacle (since Kilted).
consider_unknown_as_obstacle bool default false|Unknown cells are obstacles (since Kilted).
server_timeout int default 20|No effect: the service responds immediately.
Action ValidatePath|Navigation|No obstacle of the global costmap is on the remaining path (since Lyrical).
path max_cost consider_unknown_as_obstacle server_timeout
max_lookahead_distance number default -1.0 unit m|Length of the path that is checked, from the robot; below 0: the whole path.
layer_name text default|Layer of the global costmap that is checked; empty: all layers combined.
footprint text default|Footprint of the robot, [[x, y], ...]; empty: that of the costmap.
stop_at_first_collision bool default true|Stops at the first collision.
collision_poses any output suggest {collision_poses}|Poses of the path in collision.
service_name text default is_path_valid|No effect: there is a single service.
Condition IsStopped|Navigation|The robot has stood still for this time; RUNNING until then (Kilted).
velocity_threshold number default 0.01 unit m/s|Speed below which the robot stands, also for the turn rate [rad/s].
duration_stopped int default 1000 unit ms|Duration.
Action CheckStopStatus|Navigation|The robot has stood still for this time; RUNNING until then (since Lyrical).
velocity_threshold duration_stopped
Condition IsWithinPathTrackingBounds|Navigation|The robot is near the path that it follows (since Lyrical).
tracking_feedback any needed suggest {tracking_feedback}|Deviation from the path, an output of FollowPath.
max_error_left length default 0.5|Maximum distance to the left of the path.
max_error_right length default 0.5|Maximum distance to the right of the path.
max_error_heading number default 3.1415927 unit rad|Maximum difference between the robot's heading and the path's direction.
Action ToggleCollisionMonitor|Navigation|Switches the collision monitor on or off (since Lyrical).
service_name text default collision_monitor/toggle|No effect: there is a single collision monitor.
enable bool default true|Whether the collision monitor is on.
server_timeout
Condition GoalUpdated|Navigation|The goal has changed since the first tick.
goal any default {goal}|Goal.
goals any default {goals}|Several goals.
Condition GlobalUpdatedGoal|Navigation|The goal has changed since the last tick; succeeds in the first tick.
goal goals
Condition TimeExpired|Navigation|This time has passed since the last success.
seconds number default 1.0 unit s|Duration.
Condition PathExpiringTimer|Navigation|This time has passed since the last success or change of the path.
seconds
path any needed suggest {path}|Path.
Condition DistanceTraveled|Navigation|The robot has travelled this distance since the last success.
distance length default 1.0|Straight-line distance.
global_frame text default map|Frame in which the distance is measured: that of the map or of the odometry.
robot_base_frame text default base_link|No effect: the pose is that of the robot's centre.
Condition GoalReached|Navigation|The robot is at the goal (goal_reached_tol).
goal any needed suggest {goal}|Goal.
robot_base_frame
global_frame text default map|No effect: distances to poses are the same in every frame.
Condition IsStuck|Navigation|The robot was stopped abruptly.
Condition AreErrorCodesPresent|Navigation|The error code is in the list.
error_code int default {error_code}|Error code.
error_codes_to_check text needed suggest 0|Error codes, separated by ';'.
Condition WouldAControllerRecoveryHelp|Navigation|The controller failed with an error for which a recovery can help.
error_code
error_codes_to_check text|No effect, as in Nav2: the codes are fixed.
Condition WouldAPlannerRecoveryHelp|Navigation|The planner failed with an error for which a recovery can help.
error_code error_codes_to_check
Condition WouldASmootherRecoveryHelp|Navigation|The smoother failed with an error for which a recovery can help.
error_code error_codes_to_check
Condition WouldARouteRecoveryHelp|Navigation|The route server failed with an error for which a recovery can help (since Kilted).
error_code error_codes_to_check
Condition ArePosesNear|Navigation|Two poses are near each other.
ref_pose any needed suggest {goal}|First pose.
target_pose any needed suggest {goal}|Second pose.
tolerance length default 0.5|Maximum distance.
global_frame
Condition IsGoalNearby|Navigation|The remaining path is short.
path
proximity_threshold length default 3.0|Length of the remaining path below which the goal is nearby.
max_robot_pose_search_dist number default -1.0 unit m|Length of the path that is searched for the robot; below 0: the whole path.
global_frame robot_base_frame
)";

}  // namespace

void addRobotConditions(NodeLibrary& to) {
  to.add(parseNodeCatalogue(kNodes, NodeOrigin::Ours),
         {{"IsPathValid", synchronous(isPathValid)},
          {"ValidatePath", synchronous(validatePath)},
          {"IsStopped", stateful<StopMemory>({checkStop, checkStop, nullptr})},
          {"CheckStopStatus", stateful<StopMemory>({checkStop, checkStop, nullptr})},
          {"IsWithinPathTrackingBounds", synchronous(isWithinBounds)},
          {"ToggleCollisionMonitor", synchronous(toggleMonitor)},
          {"GoalUpdated", synchronousWithStatus<GoalMemory>(goalUpdated)},
          {"GlobalUpdatedGoal", synchronousWithStatus<GoalMemory>(globalUpdatedGoal)},
          {"TimeExpired", synchronousWithStatus<ClockMemory>(timeExpired)},
          {"PathExpiringTimer", synchronousWithStatus<ClockMemory>(pathExpiringTimer)},
          {"DistanceTraveled", synchronousWithStatus<PlaceMemory>(distanceTraveled)},
          {"GoalReached", synchronous(goalReached)},
          {"IsStuck", synchronous(isStuck)},
          {"AreErrorCodesPresent", synchronous(errorCodesPresent)},
          {"WouldAControllerRecoveryHelp", synchronous(recoveryHelps<kOfController>)},
          {"WouldAPlannerRecoveryHelp", synchronous(recoveryHelps<kOfPlanner>)},
          {"WouldASmootherRecoveryHelp", synchronous(recoveryHelps<kOfSmoother>)},
          {"WouldARouteRecoveryHelp", synchronous(recoveryHelps<kOfRoute>)},
          {"ArePosesNear", synchronous(posesNear)},
          {"IsGoalNearby", synchronous(goalNearby)}});
}

}  // namespace bt
