#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/run/Experiment.h"
#include "app/run/OutputFolder.h"
#include "app/run/ResultStore.h"

namespace app {

/// The study of an experiment. `inputs`: the files that its runs read. Error: one of them cannot be
/// read.
base::Result<Study> studyOf(const Experiment& experiment, const std::vector<InputHash>& inputs,
                            const Shard& shard);
/// The differences between two studies, with their locations; empty if their runs can be combined.
/// Compares only files that both have used.
base::Diagnostics studyDifferences(const Study& was, const Study& now);

/// The handling of an unfinished batch that is already in the folder. `Resume` executes the missing
/// runs and those with FailedBy::Machine; `Retry` also repeats all failed runs.
enum class ExistingBatch { Refuse, Resume, Retry, Replace };

/// The folder of a batch: `results.sqlite` during the batch, `results.csv` and `manifest.json`
/// generated from it at the end, and `runs/`. One process at a time.
class BatchFolder {
 public:
  /// Creates the folder. Replaces a finished batch unless it is resumed. Errors: in use, not
  /// writable, contains files that hunavsim did not create, or the batch to resume belongs to
  /// another study; nothing is changed then.
  static base::Result<std::unique_ptr<BatchFolder>> open(const std::string& folder,
                                                         const Study& study, ExistingBatch earlier);

  std::string runsFolder() const;
  std::string resultsFile() const;
  const ResultStore& store() const { return *store_; }
  std::vector<std::size_t> missing() const;  // runs, by index

  base::Diagnostics add(const StoredRun& run) { return store_->add(run); }
  base::Diagnostics setEnoughSeeds(std::size_t seeds) { return store_->setEnoughSeeds(seeds); }
  /// Writes results.csv and manifest.json of the stored runs and removes incomplete run folders.
  /// Call once, at the end.
  base::Diagnostics finish();
  std::string manifest() const;  // its text, after finish()
  /// The cells of SeedEffect that do not depend on the seed, after finish().
  const std::vector<std::string>& constantCells() const { return constantCells_; }

 private:
  explicit BatchFolder(std::unique_ptr<OutputFolder> output) : output_(std::move(output)) {}
  base::Diagnostics resumeExisting(const Study& study, ExistingBatch earlier);
  base::Diagnostics begin(const Study& study);
  base::Diagnostics removeIncompleteRuns() const;

  std::unique_ptr<OutputFolder> output_;
  std::unique_ptr<ResultStore> store_;  // declared after the folder: closed before its lock
  std::vector<std::string> constantCells_;
};

/// The results in a batch folder that this process has locked.
struct LockedResults {
  std::unique_ptr<FolderLock> lock;
  std::unique_ptr<ResultStore> store;  // declared after the lock: closed before it
};
/// Opens the results of a batch folder for reading. Errors: none, damaged, or in use.
base::Result<LockedResults> readResults(const std::string& folder);

/// The experiment file of a batch, absolute. `named`: as the batch was given it; a relative path is
/// looked for in the current folder, in `folder` with the results and beside it. nullopt: it is not
/// there.
std::optional<std::string> experimentFileOf(const std::string& named, const std::string& folder);

/// Joins the folders of all shards of one study in `output`: results.csv is identical to that of a
/// batch without shards; kept run folders are copied. Errors, all of them at a time: shards of
/// different studies, duplicated, missing or incomplete.
base::Result<std::unique_ptr<BatchFolder>> mergeShards(const std::string& output,
                                                       const std::vector<std::string>& shards,
                                                       ExistingBatch earlier);

/// A study that is split over several processes or machines.
struct ClusterJob {
  std::string program, experiment, output;  // absolute paths, the same on all machines
  std::size_t chunks = 1;                   // number of shards
  bool allowCode = false;                   // external programs of scenarios may start
  bool retryFailed = false;                 // a restarted shard repeats failed runs
  double timeLimit = 0.0;                   // of a run [s]; 0 = none
};

/// A bash script that submits the shards to Slurm as an array job and a dependent job that merges
/// them. Each shard starts with --resume: it can be stopped and requeued at any time.
std::string slurmScript(const ClusterJob& job);
/// The same with GNU parallel, on this machine or those of the variable MACHINES (--sshlogin).
std::string parallelScript(const ClusterJob& job);

}  // namespace app
