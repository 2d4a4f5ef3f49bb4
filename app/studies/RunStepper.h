#pragma once

#include <memory>
#include <string>

#include "app/studies/AvoidableContact.h"

namespace app {

/// Repeats a run step by step, with its branches and inputs. One thread; one at a time per process.
class RunStepper {
 public:
  /// Errors: those of the bundle and its branches.
  static base::Result<std::unique_ptr<RunStepper>> open(const RepeatableRun& run);

  sim2d::World& world() { return *world_; }
  const sim2d::Frame& frame() const { return world_->frame(); }
  std::int64_t step() const { return world_->stepIndex(); }
  /// Simulates the next step, with `more` inputs after those of the recording. False: the world
  /// has failed.
  bool advance(const sim2d::StepInputs& more = {});
  /// Whether the current state is the recorded one, as far as files of a run contain it.
  bool isAsRecorded() const;

 private:
  RunStepper() = default;

  RecordingPtr recording_;
  sim2d::RecordedInputs inputs_;
  std::unique_ptr<BranchedRun> run_;
  std::unique_ptr<sim2d::World> world_;
};

}  // namespace app
