#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/run/Bundle.h"
#include "app/run/RunFolder.h"
#include "app/run/RunStages.h"
#include "app/run/Session.h"

namespace app {

/// Files that were read for the recorded run in `folder` and are others by now than these SHA-256.
base::Diagnostics changedInputs(const Bundle& bundle, const std::vector<std::string>& hashes,
                                const std::string& folder);

/// A recorded run that is made again up to a moment and goes on from there with other options:
/// planners, goals and limits of robots, another seed of what is drawn, people put elsewhere,
/// another end. Up to the moment each state is compared with the recorded one. A run may go on from
/// one that went on from another. With nothing changed it is the recorded run. One thread.
class RunAgain {
 public:
  /// `options`: with `from`. Errors of the folder, of inputs that have changed since, of what
  /// cannot change on the way; those of the scenario are in the verdict.
  static base::Result<std::unique_ptr<RunAgain>> prepare(const RunOptions& options,
                                                         const RunWordsReader& readWords,
                                                         const sim2d::ImageLoader& loader,
                                                         const base::StopFlagPtr& left);

  const Bundle& bundle() const { return bundle_; }  // as the run ends
  /// Of that bundle; its world is the one to run.
  Verdict& verdict() { return verdict_; }
  const sim2d::TraceHeader& header() const { return header_; }  // as the run ends
  RunBefore before() const { return {moment_.folder, moment_.time, from_, seed_}; }

  /// Of the runs that it goes on from, also those further back.
  std::vector<std::string> folders() const { return folders_; }

  /// With each state before the next step: changes the world, adds the inputs of that step, and
  /// stops the session when the run goes another way than it did.
  void look(const sim2d::Frame& frame, sim2d::World& world, Session& session);
  /// After the run: it went another way, or ended before the moment.
  base::Diagnostics trouble(const sim2d::RunResult& result) const;

 private:
  struct Change {
    std::int64_t step = 0;
    std::unique_ptr<sim2d::World> as;
    std::uint64_t seed = 1;
  };

  RunAgain() = default;
  base::Diagnostics readRecord();
  base::Diagnostics makeWorlds(const std::vector<RunStage>& stages,
                               const sim2d::ImageLoader& loader, const base::StopFlagPtr& left);
  base::Diagnostics addMoves(const std::vector<std::string>& words);
  bool isAsRecorded(const sim2d::Frame& frame) const;

  RunMoment moment_;
  std::int64_t from_ = 0;   // step of the moment
  std::uint64_t seed_ = 1;  // of what is drawn in the end
  RecordingPtr recording_;
  sim2d::RecordedInputs inputs_;  // of the whole record
  Bundle bundle_;
  Verdict verdict_;
  sim2d::TraceHeader header_;
  std::vector<Change> changes_;  // by step
  std::vector<sim2d::Input> moves_;
  std::vector<std::string> folders_;
  std::string madeBy_;                   // version of the program
  std::optional<double> goesElsewhere_;  // since then [s]
};

}  // namespace app
