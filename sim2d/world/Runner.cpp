#include "sim2d/world/Runner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "sim2d/trace/Frame.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {
namespace {

constexpr double kTimeAfterArrival = 1.0;       // [s]
constexpr double kDurationWithRobot = 120.0;    // [s], at most
constexpr double kDurationWithoutRobot = 60.0;  // [s]
constexpr const char* kInterrupted = "interrupted";
constexpr const char* kDuration = "duration";

bool moves(const Robot& robot) {
  return robot.listed && (robot.goal.point || !robot.goal.goals.empty());
}

bool isOver(const RobotStatus& robot) {
  return robot.arrived || robot.ended;
}

/// Between start and arrival, or the end of its last goal, including that step.
bool isUnderWay(const RobotStatus& robot, double time) {
  const std::optional<double> end = robot.arrived ? robot.arrived : robot.ended;
  return robot.hasGoal && time >= robot.startTime - kTimeTolerance &&
         (!end || time <= *end + kTimeTolerance);
}

bool endsNavigation(const Event& event) {
  return event.kind == EventKind::NavigationSucceeded || event.kind == EventKind::NavigationFailed;
}

bool isFailed(const GoalResult& end) {
  return !end.isExternal && !end.result.hasSucceeded;
}

/// Result of a robot that ended its last goal without an arrival.
NavigationOutcome endOf(const RobotStatus& robot) {
  const bool hasFailed = std::any_of(robot.goalResults.begin(), robot.goalResults.end(), isFailed);
  return hasFailed ? NavigationOutcome::NavigationFailed : NavigationOutcome::GoalMissed;
}

/// Why it has not arrived: its first abandoned goal, else the first missed one.
std::string reasonOf(const RobotStatus& robot) {
  const GoalResult* first = nullptr;
  for (const GoalResult& end : robot.goalResults) {
    if (!end.isExternal && !end.isReached &&
        (first == nullptr || (!isFailed(*first) && isFailed(end)))) {
      first = &end;
    }
  }
  return first == nullptr ? robot.name : robot.name + ", " + goalResultReason(*first);
}

/// Tracks the robots until their runs end.
class OutcomeTracker {
 public:
  OutcomeTracker(const World& world, const StopRule& rule) : world_(world), rule_(rule) {}

  /// Reason for which the robots end the run in this state; empty: none.
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

  /// Reason for the end when all robots are done and not all have arrived.
  std::string outcomeReason() const {
    NavigationOutcome worst = NavigationOutcome::GoalMissed;
    std::string reasons;
    for (const RobotStatus& robot : world_.robotStatuses()) {
      if (robot.ended) {
        worst = endOf(robot) == NavigationOutcome::NavigationFailed
                    ? NavigationOutcome::NavigationFailed
                    : worst;
        reasons += (reasons.empty() ? "" : "; ") + reasonOf(robot);
      }
    }
    return std::string(navigationOutcomeName(worst)) + ": " + reasons;
  }

  std::vector<RobotResult> results(const RunResult& run) const {
    const std::vector<RobotStatus> robots = world_.robotStatuses();
    std::vector<RobotResult> results;
    results.reserve(robots.size());
    for (const RobotStatus& robot : robots) {
      results.push_back(
          {robot.id, robot.name, {}, world_.time(), robot.decidesGoalEnd, robot.goalResults});
      RobotResult& result = results.back();
      if (isCollided(robot.id)) {
        result.result = NavigationOutcome::Collision;
      } else if (const std::optional<double> arrived = arrivalAtGoals(robot)) {
        result.result = NavigationOutcome::Arrived;
        result.time = *arrived;
      } else if (robot.ended && atExternalGoal_.count(robot.id) == 0) {
        result.result = endOf(robot);
        result.time = *robot.ended;
      } else if (robot.stuck) {
        result.result = NavigationOutcome::Stuck;
        result.time = *robot.stuck;
      } else if (robot.hasGoal && !(isOver(robot) && hasNoGoalOfItsOwn(robot.id))) {
        result.result = endWith(run);
      }
    }
    return results;
  }

  /// Whether an external goal has ended, by arrival or failure; more of them may follow.
  bool isAnyAtExternalGoal() const { return !atExternalGoal_.empty(); }

 private:
  void noteArrivals(const std::vector<Event>& events) {
    for (const Event& event : events) {
      if (isRobotArrival(event, event.id) && event.id < 0) {
        atGoals_.emplace(event.id, world_.time());
        atExternalGoal_.erase(event.id);
      } else if (event.kind == EventKind::Arrived && event.hasId && event.id < 0) {
        atExternalGoal_.insert(event.id);
      } else if (endsNavigation(event) && event.hasId && event.id < 0) {
        noteNavigationEnd(event.id);
      }
    }
  }
  void noteNavigationEnd(int id) {
    for (const RobotStatus& robot : world_.robotStatuses()) {
      if (robot.id != id || robot.goalResults.empty() || !robot.ended) {
        continue;
      }
      if (robot.goalResults.back().isExternal) {
        atExternalGoal_.insert(id);
      } else {
        atExternalGoal_.erase(id);
      }
    }
  }
  /// Includes arrivals before the run began, for a world that continues another one.
  std::optional<double> arrivalAtGoals(const RobotStatus& robot) const {
    const auto found = atGoals_.find(robot.id);
    if (found != atGoals_.end()) {
      return found->second;
    }
    return atExternalGoal_.count(robot.id) > 0 ? std::nullopt : robot.arrived;
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

  static NavigationOutcome endWith(const RunResult& run) {
    if (run.status == RunStatus::Failed) {
      return NavigationOutcome::Failed;
    }
    return run.reason == kDuration ? NavigationOutcome::Timeout : NavigationOutcome::Interrupted;
  }

  std::string nameOf(int id) const {
    for (const RobotStatus& robot : world_.robotStatuses()) {
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
    for (const RobotStatus& robot : world_.robotStatuses()) {
      for (const Event& event : world_.frame().events) {
        const bool isIts = event.id == robot.id || (event.hasOther && event.other == robot.id);
        if (event.kind != EventKind::Contact || !isIts || !counts(event) ||
            !isUnderWay(robot, world_.time())) {
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

  /// Names of the stuck robots if no robot can progress further and not all have arrived.
  std::string standstill() const {
    std::string names;
    for (const RobotStatus& robot : world_.robotStatuses()) {
      if (robot.stuck) {
        names += (names.empty() ? "stuck: " : " and ") + robot.name;
      } else if ((robot.hasGoal && !isOver(robot)) || atExternalGoal_.count(robot.id) > 0) {
        return {};
      }
    }
    return names;
  }

  const World& world_;
  const StopRule& rule_;
  std::vector<int> collided_;      // ids of robots
  std::map<int, double> atGoals_;  // arrival times at the robots' own goals [s], by id
  std::set<int> atExternalGoal_;   // ids of robots whose last goal was external
};

/// Reason for which the run ends in this state; empty: continue.
std::string reasonToStop(const World& world, const StopRule& rule, OutcomeTracker& ways,
                         const std::function<bool(const Frame&)>& wantsStop) {
  if (std::string reason = ways.reasonToStop(); !reason.empty()) {
    return reason;
  }
  const std::optional<double> finishedAt = world.finishedAt();
  const bool isFinished = finishedAt && !ways.isAnyAtExternalGoal();
  if (rule.stopOnArrival && isFinished &&
      world.time() >= *finishedAt + kTimeAfterArrival - kTimeTolerance) {
    return world.arrivedAt() ? navigationOutcomeName(NavigationOutcome::Arrived)
                             : ways.outcomeReason();
  }
  if (world.stepIndex() >= rule.maximumSteps) {
    return kDuration;
  }
  return wantsStop && wantsStop(world.frame()) ? kInterrupted : "";
}

/// None: stopped while waiting for a planner; the world is unchanged.
std::optional<bool> stepUnlessStopped(World& world, const StepInputs& inputs) {
  try {
    return world.step(inputs);
  } catch (const base::Stopped&) {
    return std::nullopt;
  }
}

}  // namespace

const char* navigationOutcomeName(NavigationOutcome end) {
  static constexpr std::array<const char*, 8> kNames = {
      "arrived",     "collision",         "stuck",      "timeout", "failed",
      "interrupted", "navigation_failed", "goal_missed"};
  return kNames.at(static_cast<std::size_t>(end));
}

StopRule stopRuleOf(const Environment& scenario) {
  const double dt = scenario.desktop.dt.value_or(0.05);
  const bool hasMovingRobot = std::any_of(scenario.robots.begin(), scenario.robots.end(), moves);
  StopRule rule;
  rule.maximumSteps =
      std::llround(scenario.desktop.duration.value_or(hasMovingRobot ? kDurationWithRobot
                                                                     : kDurationWithoutRobot) /
                   dt);
  rule.stopOnArrival = hasMovingRobot && !scenario.desktop.duration;
  rule.stopOnCollision = scenario.desktop.stopOnCollision.value_or(rule.stopOnCollision);
  return rule;
}

RunResult run(World& world, const StopRule& rule, FrameSink& sink,
              const std::function<bool(const Frame&)>& wantsStop,
              const std::function<StepInputs()>& takeInputs) {
  RunResult result;
  Frame last = world.frame();
  OutcomeTracker ways(world, rule);
  result.reason = reasonToStop(world, rule, ways, wantsStop);
  while (result.reason.empty()) {
    const StepInputs inputs = takeInputs ? takeInputs() : StepInputs();
    const double begin = clockSeconds(StepClock::Wall);
    const std::optional<bool> isFine = stepUnlessStopped(world, inputs);
    result.stepSeconds += clockSeconds(StepClock::Wall) - begin;
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
