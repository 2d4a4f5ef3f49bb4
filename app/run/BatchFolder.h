#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/run/Experiment.h"
#include "app/run/FolderLock.h"
#include "app/run/ResultStore.h"

namespace app {

/// The study that an experiment is. `inputs`: the files that its runs read. Error: one of them
/// cannot be read.
base::Result<Study> studyOf(const Experiment& experiment, const std::vector<InputHash>& inputs,
                            const Shard& shard);
/// What of `now` is not as it `was`, with its places; empty: runs of both belong together. Of files
/// those that both have used.
base::Diagnostics differences(const Study& was, const Study& now);

/// What to do with an unfinished batch that is already in the folder. `Resume` executes the missing
/// runs and those that the machine ended (FailedBy); `Retry` also repeats all failed runs.
enum class Earlier { Refuse, Resume, Retry, Replace };

/// The folder of a batch: `results.sqlite` while it goes on, from it `results.csv` and
/// `manifest.json`, and `runs/`. One process at a time.
class BatchFolder {
 public:
  /// Makes the folder. A finished batch in it is replaced, unless it is to be resumed. Errors:
  /// it is in use, cannot be written, holds files of others, or another study to be resumed;
  /// nothing is changed then.
  static base::Result<std::unique_ptr<BatchFolder>> open(const std::string& folder,
                                                         const Study& study, Earlier earlier);

  std::string runsFolder() const;
  std::string resultsFile() const;
  const ResultStore& store() const { return *store_; }
  std::vector<std::size_t> missing() const;  // runs, by number

  base::Diagnostics add(const StoredRun& run) { return store_->add(run); }
  /// Writes results.csv and manifest.json of the runs that are there, and takes away what others
  /// left behind. Once, at the end.
  base::Diagnostics finish();
  std::string manifest() const { return manifest_; }  // after finish()

 private:
  BatchFolder(std::string folder, std::unique_ptr<FolderLock> lock)
      : folder_(std::move(folder)), lock_(std::move(lock)) {}
  base::Diagnostics takeEarlier(const Study& study, Earlier earlier);
  base::Diagnostics begin(const Study& study);
  base::Diagnostics removeRests() const;

  std::string folder_;
  std::unique_ptr<FolderLock> lock_;
  std::unique_ptr<ResultStore> store_;  // after the lock: closed before it
  std::string manifest_;
};

/// The store of a batch in a folder, to be read.
base::Result<std::unique_ptr<ResultStore>> readResults(const std::string& folder);

}  // namespace app
