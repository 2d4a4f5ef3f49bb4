#include "sim2d/world/Runner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "sim2d/trace/Arrival.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {
namespace {

constexpr double kAfterArrival = 1.0;   // [s]
constexpr double kWithRobot = 120.0;    // [s], at most
constexpr double kWithoutRobot = 60.0;  // [s]
constexpr const char* kInterrupted = "interrupted";
constexpr const char* kDuration = "duration";

bool moves(const Robot& robot) {
  return robot.listed && (robot.goal.point || !robot.goal.goals.empty());
}

bool isOver(const RobotOnWay& robot) {
  return robot.arrived || robot.ended;
}

/// Between setting off and arriving, or the end of its last goal; that step is included.
bool isOnWay(const RobotOnWay& robot, double time) {
  const std::optional<double> end = robot.arrived ? robot.arrived : robot.ended;
  return robot.hasGoal && time >= robot.setsOff - kTick && (!end || time <= *end + kTick);
}

bool endsNavigation(const Event& event) {
  return event.kind == EventKind::NavigationSucceeded || event.kind == EventKind::NavigationFailed;
}

bool isFailed(const GoalEnd& end) {
  return !end.isOrder && !end.result.hasSucceeded;
}

/// Of a robot that has ended its last goal without an arrival.
WayEnd endOf(const RobotOnWay& robot) {
  const bool hasFailed = std::any_of(robot.goalEnds.begin(), robot.goalEnds.end(), isFailed);
  return hasFailed ? WayEnd::NavigationFailed : WayEnd::GoalMissed;
}

/// Why it has not arrived: its first goal that was given up, else the first one that was missed.
std::string reasonOf(const RobotOnWay& robot) {
  const GoalEnd* first = nullptr;
  for (const GoalEnd& end : robot.goalEnds) {
    if (!end.isOrder && !end.isReached &&
        (first == nullptr || (!isFailed(*first) && isFailed(end)))) {
      first = &end;
    }
  }
  return first == nullptr ? robot.name : robot.name + ", " + goalEndReason(*first);
}

/// Follows the ways of the robots to what ends them.
class WayEnds {
 public:
  WayEnds(const World& world, const StopRule& rule) : world_(world), rule_(rule) {}

  /// Why the ways end the run with this state; empty: they do not.
  std::string reasonToStop() {
    const std::vector<Event>& events = world_.frame().events;
    noteArrivals(events);
    const auto has = [&events](EventKind kind) {
      return std::any_of(events.begin(), events.end(),
                         [kind](const Event& event) { return event.kind == kind; });
    };
    if (rule_.stopOnCollision != StopOnCollision::None && has(EventKind::Contact)) {
      if (std::string reason = collision(); !reason.empty()) {
        return reason;
      }
    }
    const bool isAnyOver = has(EventKind::Stuck) || has(EventKind::Arrived) ||
                           std::any_of(events.begin(), events.end(), endsNavigation);
    return isAnyOver ? standstill() : std::string();
  }

  /// Why the run ends when all robots are over and not all have arrived.
  std::string reasonOfEnds() const {
    WayEnd worst = WayEnd::GoalMissed;
    std::string reasons;
    for (const RobotOnWay& robot : world_.robotsOnWay()) {
      if (robot.ended) {
        worst = endOf(robot) == WayEnd::NavigationFailed ? WayEnd::NavigationFailed : worst;
        reasons += (reasons.empty() ? "" : "; ") + reasonOf(robot);
      }
    }
    return std::string(wayEndName(worst)) + ": " + reasons;
  }

  std::vector<RobotResult> results(const RunResult& run) const {
    const std::vector<RobotOnWay> robots = world_.robotsOnWay();
    std::vector<RobotResult> results;
    results.reserve(robots.size());
    for (const RobotOnWay& robot : robots) {
      results.push_back({robot.id, robot.name, {}, world_.time(), robot.endsGoals, robot.goalEnds});
      RobotResult& result = results.back();
      if (isCollided(robot.id)) {
        result.result = WayEnd::Collision;
      } else if (const std::optional<double> arrived = arrivalAtGoals(robot)) {
        result.result = WayEnd::Arrived;
        result.time = *arrived;
      } else if (robot.ended && atOrder_.count(robot.id) == 0) {
        result.result = endOf(robot);
        result.time = *robot.ended;
      } else if (robot.stuck) {
        result.result = WayEnd::Stuck;
        result.time = *robot.stuck;
      } else if (robot.hasGoal && !(isOver(robot) && hasNoGoalOfItsOwn(robot.id))) {
        result.result = endWith(run);
      }
    }
    return results;
  }

  /// Whether an order from outside is over, by arrival or given up: more of them may come.
  bool isAnyAtOrder() const { return !atOrder_.empty(); }

 private:
  void noteArrivals(const std::vector<Event>& events) {
    for (const Event& event : events) {
      if (isRobotsArrival(event, event.id) && event.id < 0) {
        atGoals_.emplace(event.id, world_.time());
        atOrder_.erase(event.id);
      } else if (event.kind == EventKind::Arrived && event.hasId && event.id < 0) {
        atOrder_.insert(event.id);
      } else if (endsNavigation(event) && event.hasId && event.id < 0) {
        noteNavigationEnd(event.id);
      }
    }
  }
  void noteNavigationEnd(int id) {
    for (const RobotOnWay& robot : world_.robotsOnWay()) {
      if (robot.id != id || robot.goalEnds.empty() || !robot.ended) {
        continue;
      }
      if (robot.goalEnds.back().isOrder) {
        atOrder_.insert(id);
      } else {
        atOrder_.erase(id);
      }
    }
  }
  /// Includes arrivals before the run began, for a world that continues another one.
  std::optional<double> arrivalAtGoals(const RobotOnWay& robot) const {
    const auto found = atGoals_.find(robot.id);
    if (found != atGoals_.end()) {
      return found->second;
    }
    return atOrder_.count(robot.id) > 0 ? std::nullopt : robot.arrived;
  }
  bool hasNoGoalOfItsOwn(int id) const {
    const std::vector<TraceRobot> robots = world_.header().robots;
    return std::any_of(robots.begin(), robots.end(), [id](const TraceRobot& robot) {
      return robot.id == id && robot.goals.empty();
    });
  }
  bool isCollided(int id) const {
    return std::find(collided_.begin(), collided_.end(), id) != collided_.end();
  }

  static WayEnd endWith(const RunResult& run) {
    if (run.status == RunStatus::Failed) {
      return WayEnd::Failed;
    }
    return run.reason == kDuration ? WayEnd::Timeout : WayEnd::Interrupted;
  }

  std::string nameOf(int id) const {
    for (const RobotOnWay& robot : world_.robotsOnWay()) {
      if (robot.id == id) {
        return robot.name;
      }
    }
    const WorldView& view = world_.view();
    for (int human = 0; human < view.humanCount(); ++human) {
      if (view.constants(human).id == id) {
        return view.constants(human).name;
      }
    }
    return std::to_string(id);
  }

  bool counts(const Event& event) const {
    return rule_.stopOnCollision == StopOnCollision::Any || (event.hasOther && event.other >= 0);
  }

  std::string collision() {
    std::string reason;
    for (const RobotOnWay& robot : world_.robotsOnWay()) {
      for (const Event& event : world_.frame().events) {
        const bool isIts = event.id == robot.id || (event.hasOther && event.other == robot.id);
        if (event.kind != EventKind::Contact || !isIts || !counts(event) ||
            !isOnWay(robot, world_.time())) {
          continue;
        }
        collided_.push_back(robot.id);
        const int other = event.id == robot.id ? event.other : event.id;
        if (reason.empty()) {
          reason = "collision: " + robot.name + " with " +
                   (event.hasOther ? nameOf(other) : std::string("an obstacle"));
        }
      }
    }
    return reason;
  }

  /// Nobody gets on any more, and not because all have arrived.
  std::string standstill() const {
    std::string names;
    for (const RobotOnWay& robot : world_.robotsOnWay()) {
      if (robot.stuck) {
        names += (names.empty() ? "stuck: " : " and ") + robot.name;
      } else if ((robot.hasGoal && !isOver(robot)) || atOrder_.count(robot.id) > 0) {
        return {};
      }
    }
    return names;
  }

  const World& world_;
  const StopRule& rule_;
  std::vector<int> collided_;      // ids of robots
  std::map<int, double> atGoals_;  // when robots arrived at their own goals [s], by id
  std::set<int> atOrder_;          // ids of robots whose last goal was an order from outside
};

/// Why the run ends with this state; empty: it goes on.
std::string reasonToStop(const World& world, const StopRule& rule, WayEnds& ways,
                         const std::function<bool(const Frame&)>& wantsStop) {
  if (std::string reason = ways.reasonToStop(); !reason.empty()) {
    return reason;
  }
  const std::optional<double> finishedAt = world.finishedAt();
  const bool isFinished = finishedAt && !ways.isAnyAtOrder();
  if (rule.stopOnArrival && isFinished && world.time() >= *finishedAt + kAfterArrival - kTick) {
    return world.arrivedAt() ? wayEndName(WayEnd::Arrived) : ways.reasonOfEnds();
  }
  if (world.stepIndex() >= rule.maximumSteps) {
    return kDuration;
  }
  return wantsStop && wantsStop(world.frame()) ? kInterrupted : "";
}

/// None: it was told to stop while it waited for a planner; the world stays as it was.
std::optional<bool> stepUnlessStopped(World& world, const StepInputs& inputs) {
  try {
    return world.step(inputs);
  } catch (const base::Stopped&) {
    return std::nullopt;
  }
}

}  // namespace

const char* wayEndName(WayEnd end) {
  static constexpr std::array<const char*, 8> kNames = {
      "arrived",     "collision",         "stuck",      "timeout", "failed",
      "interrupted", "navigation_failed", "goal_missed"};
  return kNames.at(static_cast<std::size_t>(end));
}

StopRule stopRuleOf(const Environment& scenario) {
  const double dt = scenario.desktop.dt.value_or(0.05);
  const bool hasMovingRobot = std::any_of(scenario.robots.begin(), scenario.robots.end(), moves);
  StopRule rule;
  rule.maximumSteps = std::llround(
      scenario.desktop.duration.value_or(hasMovingRobot ? kWithRobot : kWithoutRobot) / dt);
  rule.stopOnArrival = hasMovingRobot && !scenario.desktop.duration;
  rule.stopOnCollision = scenario.desktop.stopOnCollision.value_or(rule.stopOnCollision);
  return rule;
}

RunResult run(World& world, const StopRule& rule, FrameSink& sink,
              const std::function<bool(const Frame&)>& wantsStop,
              const std::function<StepInputs()>& takeInputs) {
  RunResult result;
  Frame last = world.frame();
  WayEnds ways(world, rule);
  result.reason = reasonToStop(world, rule, ways, wantsStop);
  while (result.reason.empty()) {
    const StepInputs inputs = takeInputs ? takeInputs() : StepInputs();
    const double begin = secondsBy(StepClock::Wall);
    const std::optional<bool> isFine = stepUnlessStopped(world, inputs);
    result.steppingSeconds += secondsBy(StepClock::Wall) - begin;
    if (!isFine) {
      result.reason = kInterrupted;
      break;
    }
    if (!*isFine) {
      result.status = RunStatus::Failed;
      result.reason = world.failure();
      break;
    }
    sink.append(last);
    last = world.frame();
    result.reason = reasonToStop(world, rule, ways, wantsStop);
  }
  if (result.reason == kInterrupted) {
    result.status = RunStatus::Interrupted;
  }
  result.steps = world.stepIndex();
  result.robots = ways.results(result);
  last.events.push_back({EventKind::Stop, 0, false, 0, false, result.reason});
  sink.append(last);
  return result;
}

}  // namespace sim2d
