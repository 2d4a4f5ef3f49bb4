#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/run/RunBranch.h"
#include "app/run/RunFolder.h"
#include "app/run/Session.h"

namespace app {

/// The inputs of a recorded run and its branches, to replay it.
struct RunProvenance {
  Bundle bundle;                    // of its beginning
  std::vector<RunBranch> branches;  // by rising step
  std::vector<std::string>
      folders;          // of the runs that it continues, the first one first, and its own
  std::string version;  // of the program that made it
};

/// The provenance of the run in a folder, by its manifest and those of the runs that it continues.
/// Errors: a manifest does not contain it, or files that were read have changed since.
base::Result<RunProvenance> provenanceOf(const std::string& folder,
                                         const sim2d::ImageLoader& loader);

/// A warning when another version of the program made the folder.
base::Diagnostics otherProgramWarning(const std::string& folder);

/// A recorded run that is repeated up to a moment and continues from there with other options. Up
/// to the moment each state is compared with the recorded one. Without changes it is the recorded
/// run. One thread.
class RunReplay {
 public:
  /// `spec`: with `from`. Errors of the folder and of inputs that have changed since; those of the
  /// scenario and of the changes are in the verdict.
  static base::Result<std::unique_ptr<RunReplay>> prepare(const RunSpec& spec,
                                                          const sim2d::ImageLoader& loader,
                                                          const base::StopFlagPtr& stop);

  const Bundle& bundle() const { return run_->bundle(); }  // as the run ends
  /// Of that bundle; its world is the one to run.
  Verdict& verdict() { return run_->verdict(); }
  const sim2d::TraceHeader& header() const { return run_->header(); }  // as the run ends
  RunOrigin origin() const { return {moment_.folder, moment_.time, from_, run_->seed()}; }
  /// Of the runs that it continues.
  const std::vector<std::string>& folders() const { return folders_; }

  /// To be called with each state before the next step: changes the world, adds the inputs of that
  /// step, and stops the session when the run diverges from the recording.
  void observe(const sim2d::Frame& frame, sim2d::World& world, Session& session);
  /// After the run: errors when it diverged or ended before the moment.
  base::Diagnostics problems(const sim2d::RunResult& result) const;

 private:
  RunReplay() = default;
  base::Diagnostics readRecord();
  bool isAsRecorded(const sim2d::Frame& frame) const;

  RunMoment moment_;
  std::int64_t from_ = 0;  // step of the moment
  RecordingPtr recording_;
  sim2d::RecordedInputs inputs_;  // of the whole record
  std::unique_ptr<BranchedRun> run_;
  sim2d::StepInputs moves_;
  std::vector<std::string> folders_;
  std::string version_;               // of the program that made the recording
  std::optional<double> divergedAt_;  // [s]
};

}  // namespace app
