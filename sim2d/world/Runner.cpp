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

/// Between setting off and arriving, the step of the arrival included.
bool isOnWay(const RobotOnWay& robot, double time) {
  return robot.hasGoal && time >= robot.setsOff - kTick &&
         (!robot.arrived || time <= *robot.arrived + kTick);
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
    return has(EventKind::Stuck) || has(EventKind::Arrived) ? standstill() : std::string();
  }

  std::vector<RobotResult> results(const RunResult& run) const {
    const std::vector<RobotOnWay> robots = world_.robotsOnWay();
    std::vector<RobotResult> results;
    results.reserve(robots.size());
    for (const RobotOnWay& robot : robots) {
      results.push_back({robot.id, robot.name, {}, world_.time()});
      RobotResult& result = results.back();
      if (isCollided(robot.id)) {
        result.result = WayEnd::Collision;
      } else if (const std::optional<double> arrived = arrivalAtGoals(robot)) {
        result.result = WayEnd::Arrived;
        result.time = *arrived;
      } else if (robot.stuck) {
        result.result = WayEnd::Stuck;
        result.time = *robot.stuck;
      } else if (robot.hasGoal && !(robot.arrived && hasNoGoalOfItsOwn(robot.id))) {
        result.result = endWith(run);
      }
    }
    return results;
  }

  /// Whether a robot has arrived where it was sent from outside: more orders may come.
  bool isAnyAtOrder() const { return !atOrder_.empty(); }

 private:
  void noteArrivals(const std::vector<Event>& events) {
    for (const Event& event : events) {
      if (isRobotsArrival(event, event.id) && event.id < 0) {
        atGoals_.emplace(event.id, world_.time());
        atOrder_.erase(event.id);
      } else if (event.kind == EventKind::Arrived && event.hasId && event.id < 0) {
        atOrder_.insert(event.id);
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
      } else if ((robot.hasGoal && !robot.arrived) || atOrder_.count(robot.id) > 0) {
        return {};
      }
    }
    return names;
  }

  const World& world_;
  const StopRule& rule_;
  std::vector<int> collided_;      // ids of robots
  std::map<int, double> atGoals_;  // when robots arrived at their own goals [s], by id
  std::set<int> atOrder_;          // ids of robots whose last arrival was at an order from outside
};

/// Why the run ends with this state; empty: it goes on.
std::string reasonToStop(const World& world, const StopRule& rule, WayEnds& ways,
                         const std::function<bool(const Frame&)>& wantsStop) {
  if (std::string reason = ways.reasonToStop(); !reason.empty()) {
    return reason;
  }
  const std::optional<double> arrivedAt = world.arrivedAt();
  const bool isOver = arrivedAt && !ways.isAnyAtOrder();
  if (rule.stopOnArrival && isOver && world.time() >= *arrivedAt + kAfterArrival - kTick) {
    return "arrived";
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
  static constexpr std::array<const char*, 6> kNames = {"arrived", "collision", "stuck",
                                                        "timeout", "failed",    "interrupted"};
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
