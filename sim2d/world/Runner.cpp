#include "sim2d/world/Runner.h"

#include <algorithm>
#include <cmath>

namespace sim2d {
namespace {

constexpr double kAfterArrival = 1.0;   // [s]
constexpr double kWithRobot = 120.0;    // [s], at most
constexpr double kWithoutRobot = 60.0;  // [s]
constexpr const char* kInterrupted = "interrupted";

bool moves(const Robot& robot) {
  return robot.listed && (robot.goal.point || !robot.goal.goals.empty());
}

/// Why the run ends with this state; empty: it goes on.
std::string reasonToStop(const World& world, const StopRule& rule,
                         const std::function<bool(const Frame&)>& wantsStop) {
  const std::optional<double> arrivedAt = world.arrivedAt();
  if (rule.stopOnArrival && arrivedAt && world.time() >= *arrivedAt + kAfterArrival - 1e-9) {
    return "arrived";
  }
  if (world.stepIndex() >= rule.maximumSteps) {
    return "duration";
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

StopRule stopRuleOf(const Environment& scenario) {
  const double dt = scenario.desktop.dt.value_or(0.05);
  if (scenario.desktop.duration) {
    return {std::llround(*scenario.desktop.duration / dt), false};
  }
  const bool hasMovingRobot = std::any_of(scenario.robots.begin(), scenario.robots.end(), moves);
  return {std::llround((hasMovingRobot ? kWithRobot : kWithoutRobot) / dt), hasMovingRobot};
}

RunResult run(World& world, const StopRule& rule, FrameSink& sink,
              const std::function<bool(const Frame&)>& wantsStop,
              const std::function<StepInputs()>& takeInputs) {
  RunResult result;
  Frame last = world.frame();
  result.reason = reasonToStop(world, rule, wantsStop);
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
    result.reason = reasonToStop(world, rule, wantsStop);
  }
  if (result.reason == kInterrupted) {
    result.status = RunStatus::Interrupted;
  }
  result.steps = world.stepIndex();
  last.events.push_back({EventKind::Stop, 0, false, 0, false, result.reason});
  sink.append(last);
  return result;
}

}  // namespace sim2d
