#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "app/run/Fork.h"
#include "app/run/Session.h"
#include "sim2d/world/Runner.h"

namespace editor {

using app::RecordingPtr;
using sim2d::FramePtr;

/// A run to be started.
struct RunRequest {
  app::WorldMaker makeWorld;     // called in the worker thread, so it holds copies of all it needs
  app::Session::Changer change;  // null: nothing changes on the way
  std::shared_ptr<base::StopFlag> left = std::make_shared<base::StopFlag>();  // ends all waiting
  sim2d::StopRule rule;
  int recordEvery = 1;
  std::function<RunRequest()> again;  // the same run once more; null: there is none
  /// What it is made of; null: not known, so that it can go on in no other way.
  std::shared_ptr<const app::Bundle> bundle;
  std::vector<app::ForkStage> stages;
};

/// A run of the bundle that goes on as the stages say.
RunRequest requestOf(app::Bundle bundle, std::vector<app::ForkStage> stages = {});

/// A run made again that goes on another way from a step on.
struct Fork {
  RunRequest request;
  sim2d::StepInputs moves;  // of the step after that
};
/// `run`: made anew, not begun yet. What was changed later than `at`, and inputs from then on, are
/// not repeated. Errors: what cannot change on the way; changes of a run of which it is not known
/// what it is made of.
base::Result<Fork> forkOf(const RunRequest& run, std::int64_t at, const app::RunOptions& changes,
                          const sim2d::TraceHeader& header);

/// A run that went on from another one, or the first, as the runner keeps it.
struct RunBranch {
  int number = 0;  // 0: the first
  QString name;
  int from = -1;        // number of the run that it left; -1: none
  double leftAt = 0.0;  // [s]
  QString changed;      // in words; empty: nothing
  // of a branch that is not the one that is shown
  RecordingPtr recording;  // null: it has not begun yet
  FramePtr newest;
  bool isFinished = false, isRecorded = false;
  std::optional<sim2d::RunResult> result;
  std::function<RunRequest()> again;
};

}  // namespace editor
