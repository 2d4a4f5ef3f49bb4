#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "app/run/RunBranch.h"
#include "app/run/Session.h"
#include "sim2d/world/Runner.h"

namespace editor {

using app::RecordingPtr;
using sim2d::FramePtr;

/// A run to be started.
struct RunRequest {
  app::WorldFactory makeWorld;    // Called in the worker thread, so it holds copies of all inputs.
  app::Session::StepHook change;  // Null: the run does not change.
  std::shared_ptr<base::StopFlag> left = std::make_shared<base::StopFlag>();  // Stops all waiting.
  sim2d::StopRule rule;
  int recordEvery = 1;
  std::function<RunRequest()> again;  // Creates the same run again; null: not possible.
  /// The inputs of the run; null: unknown, so that it cannot be branched.
  std::shared_ptr<const app::Bundle> bundle;
  std::vector<app::RunBranch> branches;
};

/// A run of the bundle with these branches.
RunRequest requestFor(app::Bundle bundle, std::vector<app::RunBranch> branches = {});

/// A re-run that diverges from the original from a step on.
struct BranchRequest {
  RunRequest request;
  sim2d::StepInputs moves;  // Inputs of the following step.
};
/// `run`: a new, unstarted request. Changes after `at` and inputs from then on are not repeated.
/// Errors: changes that are impossible during a run; changes of a run whose inputs are unknown.
base::Result<BranchRequest> branchRequestFor(const RunRequest& run, std::int64_t at,
                                             const app::RunSpec& changes,
                                             const sim2d::TraceHeader& header);

/// The first run or a branch, as stored by the runner.
struct RunnerBranch {
  int number = 0;  // 0: the first run.
  QString name;
  int from = -1;            // Number of the run from which it branched; -1: none.
  double branchTime = 0.0;  // Branch time [s].
  QString changed;          // Description of the changes; empty: none.
  // For branches that are not shown
  RecordingPtr recording;  // Null: not started yet.
  FramePtr newest;
  bool isFinished = false, isRecorded = false;
  std::optional<sim2d::RunResult> result;
  std::function<RunRequest()> again;
};

}  // namespace editor
