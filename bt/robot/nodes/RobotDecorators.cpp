#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt/robot/RobotNodes.h"
#include "sim2d/base/Text.h"

/// Decorators of Nav2 (nav2_behavior_tree/plugins/decorator). Clocks are simulated time.
namespace bt {
namespace {

using base::NodeStatus;
using base::Vec2;

bool isStarting(const LeafContext& node) {
  return node.before() == NodeStatus::Idle;
}

/// Memory of decorators that tick their child at first, while it runs, and when it is due.
struct GateMemory {
  std::int64_t since;  // step
  double x, y;         // [m], where the child last succeeded
  double period;       // [s]
  PathId goal, goals;
  bool isFirst;    // the child has not been ticked yet
  bool childRuns;  // it last returned RUNNING
};

NodeStatus tickGated(ParentContext& node, GateMemory& memory) {
  memory.isFirst = false;
  const NodeStatus status = node.tickChild();
  memory.childRuns = status == NodeStatus::Running;
  return status;
}

/// Called on a halt while RUNNING: the child no longer runs.
void closeGate(ParentContext& node) {
  node.memory<GateMemory>().childRuns = false;
}

void setOut(GateMemory& memory, const LeafContext& node) {
  memory.since = node.step();
  const Vec2 place = robotOf(node).pose().position;
  memory.x = place.x();
  memory.y = place.y();
}

/// Port 0: rate [Hz].
NodeStatus rateController(ParentContext& node) {
  auto& memory = node.memory<GateMemory>();
  if (isStarting(node)) {
    memory.since = node.step();
    memory.isFirst = true;
  }
  const double rate = node.require<double>(0);
  const bool isDue = rate > 0.0 && node.hasElapsed(memory.since, 1.0 / rate);
  if (!memory.isFirst && !memory.childRuns && !isDue) {
    return NodeStatus::Running;
  }
  const NodeStatus status = tickGated(node, memory);
  if (status == NodeStatus::Success) {
    memory.since = node.step();
  }
  return status;
}

/// Port 0: distance [m].
NodeStatus distanceController(ParentContext& node) {
  auto& memory = node.memory<GateMemory>();
  if (isStarting(node)) {
    setOut(memory, node);
    memory.isFirst = true;
  }
  const Vec2 place = robotOf(node).pose().position;
  const double travelled = (place - Vec2(memory.x, memory.y)).norm();
  if (!memory.isFirst && !memory.childRuns && travelled < node.require<double>(0)) {
    return NodeStatus::Running;
  }
  const NodeStatus status = tickGated(node, memory);
  if (status == NodeStatus::Success) {
    setOut(memory, node);
  }
  return status;
}

/// Whether the goals of the blackboard differ from the stored ones; stores them.
template <class Memory>
bool takeNewGoal(const LeafContext& node, Memory& memory, int goalPort) {
  const PathId goal = pathOf(node, goalPort), goals = pathOf(node, goalPort + 1);
  const bool isNew = goal != memory.goal || goals != memory.goals;
  memory.goal = goal;
  memory.goals = goals;
  return isNew;
}

/// Ports 0 to 3: minimum and maximum rate [Hz] and speed [m/s]; 4, 5: goal, goals. The child is
/// ticked more often at higher speed.
double speedPeriod(ParentContext& node) {
  const double leastRate = node.require<double>(0), mostRate = node.require<double>(1);
  const double leastSpeed = node.require<double>(2), mostSpeed = node.require<double>(3);
  const double share = (robotOf(node).speed() - leastSpeed) / (mostSpeed - leastSpeed);
  const double rate = share * (mostRate - leastRate) + leastRate;
  return 1.0 / std::clamp(rate, std::min(leastRate, mostRate), std::max(leastRate, mostRate));
}

NodeStatus speedController(ParentContext& node) {
  auto& memory = node.memory<GateMemory>();
  const double mostRate = node.require<double>(1);
  if (!(node.require<double>(0) > 0.0 && mostRate > 0.0 &&
        node.require<double>(3) > node.require<double>(2))) {
    return node.fault("rates must be above 0 and max_speed above min_speed");
  }
  const bool isNew = takeNewGoal(node, memory, 4);
  if (isStarting(node) || isNew) {
    memory.since = node.step();
    memory.period = 1.0 / mostRate;
    memory.isFirst = true;
  }
  const bool isDue = node.hasElapsed(memory.since, memory.period);
  if (!memory.isFirst && !memory.childRuns && !isDue) {
    return NodeStatus::Running;
  }
  if (isDue) {
    memory.period = speedPeriod(node);
    memory.since = node.step();
  }
  return tickGated(node, memory);
}

/// Ports 0, 1: goal, goals.
NodeStatus goalUpdatedController(ParentContext& node) {
  auto& memory = node.memory<GateMemory>();
  const bool isNew = takeNewGoal(node, memory, 0);
  memory.isFirst = memory.isFirst || isNew || isStarting(node);
  if (!memory.isFirst && !memory.childRuns) {
    return NodeStatus::Running;
  }
  return tickGated(node, memory);
}

struct UpdaterMemory {
  PathId goal, goals;       // inputs
  double since;             // time of the goals [s]
  PathId newest, newestOf;  // last outputs for goal and goals
};

/// "x y" or "x y heading" [m], [rad]; several separated by ','. Empty: invalid.
sim2d::nav2::Path posesOf(const std::string& text) {
  sim2d::nav2::Path poses;
  for (const std::string& one : base::split(text, ',')) {
    std::vector<double> numbers;
    for (const std::string& word : base::split(one, ' ')) {
      const std::optional<double> number = base::parseDouble(word);
      if (!word.empty() && !number) {
        return {};
      }
      if (number) {
        numbers.push_back(*number);
      }
    }
    if (numbers.size() < 2 || numbers.size() > 3) {
      return {};
    }
    poses.push_back({{numbers[0], numbers[1]}, numbers.size() == 3 ? numbers[2] : 0.0});
  }
  return poses;
}

/// The message of a topic published since the goals were given, otherwise the given goals.
PathId updatedBy(const ParentContext& node, const std::string& topic, double since, PathId given,
                 PathId& last) {
  const TopicMessage message = robotOf(node).lastMessage(topic);
  if (message.number == 0 || message.time < since) {
    return given;
  }
  sim2d::nav2::Path poses = posesOf(message.text);
  if (poses.empty()) {
    return given;
  }
  last = robotOf(node).paths().addUnlessEqual(std::move(poses), last);
  return last;
}

/// Ports 0: goal, 1: goal to use, 2: goals, 3: goals to use. The newest goals apply: messages of
/// the topics goal_update and goals_update that are newer than the given goals, as in Nav2, and the
/// robot's own goal, which may move.
NodeStatus goalUpdater(ParentContext& node) {
  auto& memory = node.memory<UpdaterMemory>();
  const NavigatorHost& robot = robotOf(node);
  const PathId goal = pathOf(node, 0), goals = pathOf(node, 2);
  if (goal != memory.goal || goals != memory.goals) {
    memory = {goal, goals, robot.time(), memory.newest, memory.newestOf};
  }
  const PathId own = robot.newestGoal() != 0 ? robot.newestGoal() : goal;
  const PathId newest = updatedBy(node, "goal_update", memory.since, own, memory.newest);
  node.set<int>(1, static_cast<int>(newest));
  node.set<int>(
      3, static_cast<int>(updatedBy(node, "goals_update", memory.since, goals, memory.newestOf)));
  return node.tickChild();
}

struct OnApproachMemory {
  PathId old;
  bool isFirst;
};

bool hasSameEnd(const sim2d::nav2::Path& a, const sim2d::nav2::Path& b) {
  return !a.empty() && !b.empty() && a.back().position == b.back().position &&
         a.back().heading == b.back().heading;
}

/// Ports 0: path, 1: length of the old path [m] below which it checks, 2: factor.
NodeStatus pathLongerOnApproach(ParentContext& node) {
  auto& memory = node.memory<OnApproachMemory>();
  const PathStore& paths = robotOf(node).paths();
  const PathId now = pathOf(node, 0);
  const sim2d::nav2::Path& path = paths.get(now);
  const sim2d::nav2::Path& old = paths.get(memory.old);
  const bool isSameGoal = hasSameEnd(path, old);
  memory.isFirst = memory.isFirst || isStarting(node) || !isSameGoal;
  const double before = lengthOf(old);
  const bool isLonger = now != memory.old && isSameGoal && before < node.require<double>(1) &&
                        lengthOf(path) > node.require<double>(2) * before;
  if (isLonger && !memory.isFirst) {
    const NodeStatus status = node.tickChild();
    if (status == NodeStatus::Success || status == NodeStatus::Failure) {
      memory.old = now;
    }
    return status;
  }
  memory.old = now;
  memory.isFirst = false;
  return NodeStatus::Success;
}

struct TriggerMemory {
  bool isUsed;
};

NodeStatus singleTrigger(ParentContext& node) {
  bool& isUsed = node.memory<TriggerMemory>().isUsed;
  isUsed = isUsed && !isStarting(node);
  if (isUsed) {
    return NodeStatus::Failure;
  }
  const NodeStatus status = node.tickChild();
  isUsed = status == NodeStatus::Success || status == NodeStatus::Failure;
  return status;
}

constexpr const char* kNodes = R"(
Decorator RateController|Navigation|Ticks the child at this maximum rate, and in each tick while it is running.
hz number default 10.0 unit Hz|Rate.
Decorator DistanceController|Navigation|Ticks the child each time the robot has travelled this distance, and in each tick while it is running.
distance length default 1.0|Straight-line distance from the position of the child's last success.
global_frame text default map|No effect: TF is not used.
robot_base_frame text default base_link|No effect: TF is not used.
Decorator SpeedController|Navigation|Ticks the child at a rate that increases with the robot's speed.
min_rate number default 0.1 unit Hz|Rate at the minimum speed.
max_rate number default 1.0 unit Hz|Rate at the maximum speed.
min_speed number default 0.0 unit m/s|Minimum speed.
max_speed number default 0.5 unit m/s|Maximum speed.
goal any default {goal}|Goal; after a change the maximum rate is used first.
goals any default {goals}|Several goals.
Decorator GoalUpdatedController|Navigation|Ticks the child first and whenever the goal changes.
goal goals
Decorator GoalUpdater|Navigation|Passes the latest goal of the topics goal_update and goals_update (nav2_topics of the robot) to the child.
input_goal any needed suggest {goal}|Given goal.
output_goal any output suggest {updated_goal}|Latest goal.
input_goals any|Several goals (since Kilted).
output_goals any output|Latest goals (since Kilted).
Decorator PathLongerOnApproach|Navigation|Near the goal, ticks the child if a new path to the same goal is much longer.
path any needed suggest {path}|Path.
prox_len length default 3.0|Length of the old path below which paths are compared.
length_factor number default 2.0|Ratio of the path lengths above which the new path is much longer.
Decorator SingleTrigger|Navigation|Runs the child once, then fails until it is halted.
)";

}  // namespace

void addRobotDecorators(NodeLibrary& to);
void addRobotDecorators(NodeLibrary& to) {
  const NodeCatalogue nodes = parseNodeCatalogue(kNodes, NodeOrigin::Ours);
  to.addDecorator<GateMemory>(*nodes.find("RateController"), {rateController, closeGate});
  to.addDecorator<GateMemory>(*nodes.find("DistanceController"), {distanceController, closeGate});
  to.addDecorator<GateMemory>(*nodes.find("SpeedController"), {speedController, closeGate});
  to.addDecorator<GateMemory>(*nodes.find("GoalUpdatedController"),
                              {goalUpdatedController, closeGate});
  to.addDecorator<UpdaterMemory>(*nodes.find("GoalUpdater"), {goalUpdater, nullptr});
  to.addDecorator<OnApproachMemory>(*nodes.find("PathLongerOnApproach"),
                                    {pathLongerOnApproach, nullptr});
  to.addDecorator<TriggerMemory>(*nodes.find("SingleTrigger"), {singleTrigger, nullptr});
}

}  // namespace bt
