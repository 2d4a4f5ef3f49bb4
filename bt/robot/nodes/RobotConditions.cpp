#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "bt/robot/RobotNodes.h"
#include "sim2d/base/Text.h"

/// Conditions of Nav2 (nav2_behavior_tree/plugins/condition).
namespace bt {
namespace {

using base::NodeStatus;
using base::Pose2;
using base::Vec2;

NodeStatus whether(bool holds) {
  return holds ? NodeStatus::Success : NodeStatus::Failure;
}

bool isStarting(const LeafContext& leaf) {
  return leaf.before() == NodeStatus::Idle;
}

template <NodeStatus answer>
NodeStatus constant(LeafContext& /*leaf*/) {
  return answer;
}

struct GoalMemory {
  PathId goal, goals;
  bool hasLooked;
};

bool takeNewGoal(const LeafContext& leaf, GoalMemory& memory) {
  const PathId goal = pathOf(leaf, 0), goals = pathOf(leaf, 1);
  const bool isNew = goal != memory.goal || goals != memory.goals;
  memory.goal = goal;
  memory.goals = goals;
  return isNew;
}

NodeStatus goalUpdated(LeafContext& leaf) {
  const bool isNew = takeNewGoal(leaf, leaf.memory<GoalMemory>());
  return whether(isNew && !isStarting(leaf));
}

/// Keeps its memory over halts; the first call succeeds.
NodeStatus globalUpdatedGoal(LeafContext& leaf) {
  auto& memory = leaf.memory<GoalMemory>();
  const bool isFirst = !memory.hasLooked;
  memory.hasLooked = true;
  return whether(takeNewGoal(leaf, memory) || isFirst);
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
  return whether(isOver);
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
  return whether(isOver);
}

struct PlaceMemory {
  double x, y;  // [m]
};

/// Port 0: distance [m].
NodeStatus distanceTraveled(LeafContext& leaf) {
  auto& memory = leaf.memory<PlaceMemory>();
  const Vec2 place = robotOf(leaf).pose().position;
  const double travelled = (place - Vec2(memory.x, memory.y)).norm();
  const bool isFar = !isStarting(leaf) && travelled >= leaf.require<double>(0);
  if (isStarting(leaf) || isFar) {
    memory = {place.x(), place.y()};
  }
  return whether(isFar);
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
  return whether(goal &&
                 (goal->position - robot.pose().position).norm() <= robot.goalReachedTolerance());
}

/// Detects a deceleration above 10 m/s², as in a collision.
NodeStatus isStuck(LeafContext& leaf) {
  constexpr double kHardest = -10.0;  // [m/s2]
  return whether(robotOf(leaf).acceleration() < kHardest);
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

bool isAmong(int code, const std::vector<int>& codes) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

/// Ports 0: code, 1: codes.
NodeStatus errorCodesPresent(LeafContext& leaf) {
  return whether(isAmong(leaf.getOr<int>(0, 0), numbersOf(leaf.text(1).value_or(""))));
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
  const int code = leaf.getOr<int>(0, 0);
  return whether(std::find(codes.begin(), codes.end(), code) != codes.end());
}

/// Ports 0, 1: poses, 2: tolerance [m].
NodeStatus posesNear(LeafContext& leaf) {
  const std::optional<Pose2> from = endOf(leaf, 0), to = endOf(leaf, 1);
  return whether(from && to && (from->position - to->position).norm() <= leaf.require<double>(2));
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
  return whether(!path.empty() &&
                 restOf(path, robot.pose().position, search) < leaf.require<double>(1));
}

constexpr const char* kNodes = R"(
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
global_frame text default map|No effect: TF is not used.
robot_base_frame text default base_link|No effect: TF is not used.
Condition GoalReached|Navigation|The robot is at the goal (goal_reached_tol).
goal any needed suggest {goal}|Goal.
robot_base_frame global_frame
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

void addRobotConditions(NodeLibrary& to);
void addRobotConditions(NodeLibrary& to) {
  const NodeCatalogue nodes = parseNodeCatalogue(kNodes, NodeOrigin::Ours);
  const auto manifest = [&nodes](const char* id) { return *nodes.find(id); };
  to.addSynchronousWithStatus<GoalMemory>(manifest("GoalUpdated"), goalUpdated);
  to.addSynchronousWithStatus<GoalMemory>(manifest("GlobalUpdatedGoal"), globalUpdatedGoal);
  to.addSynchronousWithStatus<ClockMemory>(manifest("TimeExpired"), timeExpired);
  to.addSynchronousWithStatus<ClockMemory>(manifest("PathExpiringTimer"), pathExpiringTimer);
  to.addSynchronousWithStatus<PlaceMemory>(manifest("DistanceTraveled"), distanceTraveled);
  to.addCondition(manifest("GoalReached"), goalReached);
  to.addCondition(manifest("IsStuck"), isStuck);
  to.addCondition(manifest("AreErrorCodesPresent"), errorCodesPresent);
  to.addCondition(manifest("WouldAControllerRecoveryHelp"), recoveryHelps<kOfController>);
  to.addCondition(manifest("WouldAPlannerRecoveryHelp"), recoveryHelps<kOfPlanner>);
  to.addCondition(manifest("WouldASmootherRecoveryHelp"), recoveryHelps<kOfSmoother>);
  to.addCondition(manifest("WouldARouteRecoveryHelp"), recoveryHelps<kOfRoute>);
  to.addCondition(manifest("ArePosesNear"), posesNear);
  to.addCondition(manifest("IsGoalNearby"), goalNearby);
}

}  // namespace bt
