#pragma once

#include <functional>
#include <string>

#include "sim2d/trace/Recording.h"
#include "sim2d/world/World.h"

namespace sim2d {

enum class RunStatus { Finished, Failed, Interrupted };

struct RunResult {
  RunStatus status = RunStatus::Finished;
  std::string reason;  // "duration", "arrived", "interrupted", or what failed
  std::int64_t steps = 0;
  double steppingSeconds = 0.0;  // wall time of World::step alone
};

/// Number of steps of a run, or until the robots have arrived plus 1 s.
struct StopRule {
  std::int64_t maximumSteps = 2400;
  bool stopOnArrival = true;
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
