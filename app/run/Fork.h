#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/run/Bundle.h"

namespace app {

/// From this step on a run goes on with other options: those of `run --from` (planners, goals and
/// limits of robots by `set`, another end, the seed of what is drawn). People who are put elsewhere
/// (`moves`) are inputs of the run, not of the stage.
struct ForkStage {
  std::int64_t step = 0;  // the state that is the last in common
  RunOptions options;
};

/// The same scenario as the options have it. Errors: words that do not fit, or that change what
/// stays as it is while a run goes on.
base::Result<Bundle> goingOnAs(const Bundle& was, const RunOptions& options);
/// Of the last of the stages.
base::Result<Bundle> goingOnAs(const Bundle& was, const std::vector<ForkStage>& stages);

/// Who is put where when a run goes on. Errors: words that are no move, names of nobody.
base::Result<sim2d::StepInputs> inputsOfMoves(const std::vector<std::string>& moves,
                                              const sim2d::TraceHeader& header);

/// What the options change, for people: "robot1.planner = dwa, seed 7"; empty: nothing.
std::string changesText(const RunOptions& options);

/// A world that is stepped from its beginning and goes on as the stages say, each at its step.
class StagedRun {
 public:
  /// `remarks` of the world are warnings of the result; errors: those of the bundles.
  static base::Result<std::shared_ptr<StagedRun>> make(const Bundle& bundle,
                                                       const std::vector<ForkStage>& stages);
  std::unique_ptr<sim2d::World> takeWorld() { return std::move(world_); }  // once
  /// With each state before the next step, in rising order.
  void look(const sim2d::Frame& frame, sim2d::World& world);

 private:
  struct Change {
    std::int64_t step = 0;
    std::unique_ptr<sim2d::World> as;
    std::uint64_t seed = 1;  // of what is drawn
  };
  StagedRun() = default;
  std::unique_ptr<sim2d::World> world_;
  std::vector<Change> changes_;  // by step
};

}  // namespace app
