#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/trace/Recording.h"
#include "sim2d/world/World.h"

namespace sim2d {

enum class RunStatus { Finished, Failed, Interrupted };

/// Result of a robot. Timeout: time limit of the run; Failed, Interrupted: result of the run, for
/// unfinished robots. NavigationFailed: the planner gave up a goal. GoalMissed: the planner
/// reported success too far from a goal (kGoalReachedTolerance).
enum class NavigationOutcome {
  Arrived,
  Collision,
  Stuck,
  Timeout,
  Failed,
  Interrupted,
  NavigationFailed,
  GoalMissed
};
const char* navigationOutcomeName(NavigationOutcome end);  // "arrived" …

struct RobotResult {
  int id = -1;
  std::string name;
  std::optional<NavigationOutcome> result;  // none: it had no goal
  double time = 0.0;                        // time at which the robot finished [s]
  bool decidesGoalEnd = false;              // the planner decides when a goal is over
  std::vector<GoalResult> goalResults{};    // results of that planner, oldest first
};

struct RunResult {
  RunStatus status = RunStatus::Finished;
  /// "duration", "arrived", "interrupted", "collision: robot1 with anna", "stuck: robot1 and
  /// robot2", "navigation_failed: robot1, planner NO_VALID_PATH (208)", "goal_missed: robot1, 1.2 m
  /// from the goal", or the failure.
  std::string reason;
  std::int64_t steps = 0;
  double stepSeconds = 0.0;  // wall time of World::step only
  std::vector<RobotResult> robots;
};

/// Maximum number of steps, or 1 s after all robots have arrived or their planners have ended the
/// last goals. A run also ends with a contact selected by `stopOnCollision` of a robot with a goal
/// between start and arrival, and when each robot has arrived or is stuck, at least one of them the
/// latter (World::robotStatuses).
struct StopRule {
  std::int64_t maximumSteps = 2400;
  bool stopOnArrival = true;
  StopOnCollision stopOnCollision = StopOnCollision::None;
};
/// Rule of a scenario: a given duration is run completely; otherwise arrival + 1 s, at most 120 s;
/// 60 s without a moving robot.
StopRule stopRuleOf(const Environment& scenario);

/// Steps until the rule applies, `wantsStop` returns true, or the world fails. The sink receives
/// every state from step 0 on, each when the next one is available; the last one contains the event
/// `stop`. `takeInputs` is called before each step for external inputs.
RunResult run(World& world, const StopRule& rule, FrameSink& sink,
              const std::function<bool(const Frame&)>& wantsStop = {},
              const std::function<StepInputs()>& takeInputs = {});

}  // namespace sim2d
