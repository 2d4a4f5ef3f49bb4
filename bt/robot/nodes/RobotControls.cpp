#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt/robot/RobotNodes.h"
#include "sim2d/base/Text.h"

/// Control nodes and decorators of Nav2 (nav2_behavior_tree/plugins/control and /decorator). Clocks
/// are simulated time.
namespace bt {
namespace {

using base::NodeStatus;
using base::Vec2;
using sim2d::nav2::Distro;

struct PipelineMemory {
  int farthest;  // last running child
};

/// Ticks all children from the first one in every tick; children before the running one run again.
NodeStatus pipeline(ParentContext& node) {
  int& farthest = node.memory<PipelineMemory>().farthest;
  int skipped = 0;
  for (int child = 0; child < node.childCount(); ++child) {
    const NodeStatus status = node.tickChild(child);
    if (status == NodeStatus::Failure) {
      farthest = 0;
      return status;
    }
    if (status == NodeStatus::Running && child >= farthest) {
      farthest = child;
      return status;
    }
    if (status == NodeStatus::Idle) {
      return status;
    }
    skipped += status == NodeStatus::Skipped ? 1 : 0;
  }
  farthest = 0;
  return skipped == node.childCount() ? NodeStatus::Skipped : NodeStatus::Success;
}

struct RecoveryMemory {
  int retries;
  bool recovers;  // the second child is running
};

/// Ends the node and resets its counts.
NodeStatus endRecovery(RecoveryMemory& memory, NodeStatus status) {
  memory = {};
  return status;
}

/// Ticks one child: returns the node's status, or IDLE if it continues with the other child.
NodeStatus recoveryStep(ParentContext& node, RecoveryMemory& memory, int most) {
  const NodeStatus status = node.tickChild(memory.recovers ? 1 : 0);
  if (status == NodeStatus::Running) {
    return status;
  }
  if (memory.recovers) {
    if (status != NodeStatus::Success) {
      return endRecovery(memory, NodeStatus::Failure);
    }
    node.resetChild(1);
    ++memory.retries;
    memory.recovers = false;
    return NodeStatus::Idle;
  }
  if (status != NodeStatus::Failure || memory.retries >= most) {
    return endRecovery(memory, status);
  }
  node.resetChild(0);
  memory.recovers = true;
  return NodeStatus::Idle;
}

/// Runs the first child; on failure the second, then the first again, all within one tick.
NodeStatus recovery(ParentContext& node) {
  auto& memory = node.memory<RecoveryMemory>();
  const int most = node.getOr<int>(0, 1);
  NodeStatus status = NodeStatus::Idle;
  while (status == NodeStatus::Idle && memory.retries <= most) {
    status = recoveryStep(node, memory, most);
  }
  return status == NodeStatus::Idle ? endRecovery(memory, NodeStatus::Failure) : status;
}

struct RoundMemory {
  int current;
  int failed;  // in a row
};

/// Ticks the next child each time. Since Lyrical it restarts after the last child only if
/// configured.
NodeStatus roundRobin(ParentContext& node) {
  auto& memory = node.memory<RoundMemory>();
  const int children = node.childCount();
  const bool wraps = robotOf(node).distro() < Distro::Lyrical || node.getOr<bool>(0, false);
  int skipped = 0;
  while (memory.failed + skipped < children) {
    const NodeStatus status = node.tickChild(memory.current);
    if (status == NodeStatus::Running || status == NodeStatus::Idle) {
      return status;
    }
    ++memory.current;
    if (memory.current == children && !wraps) {
      break;
    }
    memory.current %= children;
    if (status == NodeStatus::Success) {
      memory.failed = 0;
      return status;
    }
    ++(status == NodeStatus::Failure ? memory.failed : skipped);
  }
  memory = {};
  return skipped == children ? NodeStatus::Skipped : NodeStatus::Failure;
}

/// Ticks all children in every tick, regardless of preceding statuses.
NodeStatus nonblocking(ParentContext& node) {
  int succeeded = 0, skipped = 0;
  for (int child = 0; child < node.childCount(); ++child) {
    const NodeStatus status = node.tickChild(child);
    if (status == NodeStatus::Failure || status == NodeStatus::Idle) {
      return status;
    }
    succeeded += status == NodeStatus::Success ? 1 : 0;
    skipped += status == NodeStatus::Skipped ? 1 : 0;
  }
  if (skipped == node.childCount()) {
    return NodeStatus::Skipped;
  }
  return succeeded + skipped == node.childCount() ? NodeStatus::Success : NodeStatus::Running;
}

/// ReactiveSequence (`stop` = FAILURE) and ReactiveFallback (SUCCESS). BehaviorTree.CPP 4 resets
/// every other child while one is running. Here children before it keep their status, as in version
/// 3; otherwise Nav2's conditions and PathLongerOnApproach would restart in each tick and never
/// detect a change.
template <NodeStatus stop>
NodeStatus reactive(ParentContext& node) {
  int skipped = 0;
  for (int child = 0; child < node.childCount(); ++child) {
    const NodeStatus status = node.tickChild(child);
    if (status == NodeStatus::Running) {
      for (int later = child + 1; later < node.childCount(); ++later) {
        node.resetChild(later);
      }
      return status;
    }
    if (status == stop || status == NodeStatus::Idle) {
      return status;
    }
    skipped += status == NodeStatus::Skipped ? 1 : 0;
  }
  constexpr NodeStatus kPasses =
      stop == NodeStatus::Failure ? NodeStatus::Success : NodeStatus::Failure;
  return skipped == node.childCount() ? NodeStatus::Skipped : kPasses;
}

template <class Memory>
void resetMemory(ParentContext& node) {
  node.memory<Memory>() = {};
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

/// Ports 0: distance [m], 1: frame.
NodeStatus distanceController(ParentContext& node) {
  auto& memory = node.memory<GateMemory>();
  const Vec2 place = robotOf(node).poseIn(textOf(node, 1)).position;
  const auto setOut = [&] {
    memory.x = place.x();
    memory.y = place.y();
  };
  if (isStarting(node)) {
    setOut();
    memory.isFirst = true;
  }
  const double travelled = (place - Vec2(memory.x, memory.y)).norm();
  if (!memory.isFirst && !memory.childRuns && travelled < node.require<double>(0)) {
    return NodeStatus::Running;
  }
  const NodeStatus status = tickGated(node, memory);
  if (status == NodeStatus::Success) {
    setOut();
  }
  return status;
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

/// Ports 0: goal, 1: goal to use, 2: goals, 3: goals to use. Messages of the topics goal_update and
/// goals_update that are newer than the given goals replace them, as in Nav2.
NodeStatus goalUpdater(ParentContext& node) {
  auto& memory = node.memory<UpdaterMemory>();
  const PathId goal = pathOf(node, 0), goals = pathOf(node, 2);
  if (goal != memory.goal || goals != memory.goals) {
    memory = {goal, goals, robotOf(node).time(), memory.newest, memory.newestOf};
  }
  setNumber(node, 1, updatedBy(node, "goal_update", memory.since, goal, memory.newest));
  setNumber(node, 3, updatedBy(node, "goals_update", memory.since, goals, memory.newestOf));
  return node.tickChild();
}

struct OnApproachMemory {
  PathId old;
  bool isFirst;
};

bool hasSameEnd(const sim2d::nav2::Path& a, const sim2d::nav2::Path& b) {
  return !a.empty() && !b.empty() && a.back() == b.back();
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
    if (isDone(status)) {
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
  isUsed = isDone(status);
  return status;
}

constexpr const char* kNodes = R"(
Control PipelineSequence|Navigation|Ticks all children from the first one to the running one; the children before it are executed again.
Control RecoveryNode children 2 2|Navigation|Runs the first child; if it fails, runs the second child and then the first one again.
number_of_retries int default 1|Maximum number of retries.
Control RoundRobin|Navigation|Runs the next child each time; fails if all have failed in sequence.
wrap_around bool default false|Restarts at the first child after the last one (Main; earlier branches always do).
Control NonblockingSequence|Navigation|Ticks all children in every time step until one fails or all have succeeded.
Decorator RateController|Navigation|Ticks the child at this maximum rate, and in each tick while it is running.
hz number default 10.0 unit Hz|Rate.
Decorator DistanceController|Navigation|Ticks the child each time the robot has travelled this distance, and in each tick while it is running.
distance length default 1.0|Straight-line distance from the position of the child's last success.
global_frame text default map|Frame in which the distance is measured: that of the map or of the odometry.
robot_base_frame text default base_link|No effect: the pose is that of the robot's centre.
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

void addRobotControls(NodeLibrary& to) {
  to.add(parseNodeCatalogue(kNodes, NodeOrigin::Ours),
         {{"PipelineSequence", control<PipelineMemory>({pipeline, resetMemory<PipelineMemory>})},
          {"RecoveryNode", control<RecoveryMemory>({recovery, resetMemory<RecoveryMemory>})},
          {"RoundRobin", control<RoundMemory>({roundRobin, resetMemory<RoundMemory>})},
          {"NonblockingSequence", control({nonblocking, nullptr})},
          {"RateController", decorator<GateMemory>({rateController, closeGate})},
          {"DistanceController", decorator<GateMemory>({distanceController, closeGate})},
          {"SpeedController", decorator<GateMemory>({speedController, closeGate})},
          {"GoalUpdatedController", decorator<GateMemory>({goalUpdatedController, closeGate})},
          {"GoalUpdater", decorator<UpdaterMemory>({goalUpdater})},
          {"PathLongerOnApproach", decorator<OnApproachMemory>({pathLongerOnApproach})},
          {"SingleTrigger", decorator<TriggerMemory>({singleTrigger})}});
  to.add(*to.catalogue().find("ReactiveSequence"), control({reactive<NodeStatus::Failure>}));
  to.add(*to.catalogue().find("ReactiveFallback"), control({reactive<NodeStatus::Success>}));
}

}  // namespace bt
