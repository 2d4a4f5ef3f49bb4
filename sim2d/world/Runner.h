#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/trace/Recording.h"
#include "sim2d/world/World.h"

namespace sim2d {

enum class RunStatus { Finished, Failed, Interrupted };

/// How the way of a robot ended. Timeout: with the time of the run; Failed, Interrupted: with the
/// run, for what this robot has not done. NavigationFailed: its planner has given up a goal.
/// GoalMissed: its planner has reported success too far from a goal (kReachedBeyondRadius).
enum class WayEnd {
  Arrived,
  Collision,
  Stuck,
  Timeout,
  Failed,
  Interrupted,
  NavigationFailed,
  GoalMissed
};
const char* wayEndName(WayEnd end);  // "arrived" …

struct RobotResult {
  int id = -1;
  std::string name;
  std::optional<WayEnd> result;     // none: it had nowhere to go
  double time = 0.0;                // of the run, when its way ended [s]
  bool endsGoals = false;           // its planner decides when a goal is over
  std::vector<GoalEnd> goalEnds{};  // results of that planner, oldest first
};

struct RunResult {
  RunStatus status = RunStatus::Finished;
  /// "duration", "arrived", "interrupted", "collision: robot1 with anna", "stuck: robot1 and
  /// robot2", "navigation_failed: robot1, planner NO_VALID_PATH (208)", "goal_missed: robot1, 1.2 m
  /// from the goal", or what failed.
  std::string reason;
  std::int64_t steps = 0;
  double steppingSeconds = 0.0;  // wall time of World::step alone
  std::vector<RobotResult> robots;
};

/// Number of steps of a run, or until the robots have arrived, or their planners have ended their
/// last goals, plus 1 s. In either case a run ends
/// with a contact that `stopOnCollision` tells, of a robot with a goal between setting off and
/// arriving, and when each robot has arrived or is stuck, one at least the latter
/// (World::robotsOnWay).
struct StopRule {
  std::int64_t maximumSteps = 2400;
  bool stopOnArrival = true;
  StopOnCollision stopOnCollision = StopOnCollision::None;
};
/// The rule of a scenario: its duration is run to its end; else arrival + 1 s, at most 120 s; 60 s
/// without a robot that moves.
StopRule stopRuleOf(const Environment& scenario);

/// Steps until the rule holds, `wantsStop` says so, or the world fails. The sink gets every state
/// from step 0 on, each when the next one is there; the last one carries the event `stop`.
/// `takeInputs` is asked before each step for what comes from outside.
RunResult run(World& world, const StopRule& rule, FrameSink& sink,
              const std::function<bool(const Frame&)>& wantsStop = {},
              const std::function<StepInputs()>& takeInputs = {});

}  // namespace sim2d
