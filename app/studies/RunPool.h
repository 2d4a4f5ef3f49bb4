#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/run/BundleReader.h"
#include "app/run/ResultRow.h"
#include "app/run/RunSpec.h"
#include "sim2d/base/Files.h"
#include "sim2d/base/Result.h"

namespace app {

/// A run that a study requests. Equal requests have equal results.
struct RunRequest {
  std::string scenario;  // path of the scenario file
  long long seed = 1;
  RunSpec spec;  // options of the run, `set` included; scenario and seed are taken from above
};

/// All options of the run.
RunSpec specOf(const RunRequest& request);

struct RunPoolOptions {
  int jobs = 1;                                                // maximum number of worker processes
  double timeLimit = std::numeric_limits<double>::infinity();  // of a run [s], wall-clock time
  bool allowCode = false;           // external programs and libraries of scenarios may start
  bool keepsTrees = false;          // rows have the results of behaviour trees (ResultRow::trees)
  sim2d::ImageLoader loader;        // reads map images other than PGM
  std::string journal;              // file that keeps the results; empty: none
  std::function<bool()> wantsStop;  // called often; empty: never
  /// Requested runs with a result, those in the journal included, and those of them that this pool
  /// has executed. May be empty.
  std::function<void(std::size_t finished, std::size_t executed)> showProgress;
};

/// Executes requested runs in worker processes (app/run/Batch.h) and keeps their results by the
/// content of the request. A study is a deterministic function of the results that it requested:
/// resuming it is repeating it with a journal that already has them. Results do not depend on
/// `jobs`. One thread; there must be no other thread while runs are executed.
///
/// The journal is a text file with one JSON object per line: the program that wrote it, then a
/// result per line. It is written as soon as a run has ended; an incomplete last line is discarded.
/// Results whose input files have changed since are executed again, as are runs that the machine
/// ended (FailedBy::Machine), which are not stored.
class RunPool {
 public:
  /// Reads the journal, or creates it. Errors: it cannot be read or written, is another file, or
  /// was written by another version of the program.
  static base::Result<std::unique_ptr<RunPool>> open(RunPoolOptions options);

  /// Reports what would prevent these runs from starting: errors of scenarios and options with
  /// their locations, and external code unless it is allowed. Reads the files of every request.
  base::Diagnostics check(const std::vector<RunRequest>& requests);

  /// Results in the order of the requests; a failed run is a row. Equal requests are executed once.
  /// Errors: the stop was requested (`study.stopped`), the journal cannot be written, or an input
  /// file changed during the study.
  base::Result<std::vector<ResultRow>> run(const std::vector<RunRequest>& requests);

  std::size_t executed() const { return executed_; }    // runs that were not in the journal
  std::size_t requested() const { return requested_; }  // different runs requested so far

  /// Files that runs have read so far in this process, as they were at first use; for manifests.
  const std::vector<InputHash>& inputs() const { return reader_.inputs(); }

 private:
  explicit RunPool(RunPoolOptions options);

  base::Diagnostics readJournal();
  base::Diagnostics createJournal();
  void addLine(const std::string& line, std::map<std::string, std::string>& hashes);
  base::Diagnostics store(const std::string& key, const ResultRow& row);
  std::string keyOf(const RunSpec& spec) const;
  void warmUp(const RunSpec& spec);
  base::Diagnostics execute(const std::vector<std::pair<std::string, RunSpec>>& missing);
  void showProgress() const;

  RunPoolOptions options_;
  BundleReader reader_;
  std::set<std::string> warm_;              // scenarios whose shared data is in memory
  std::map<std::string, ResultRow> known_;  // results by key
  std::set<std::string> requests_;          // keys requested so far
  base::FileDescriptor journal_;
  std::size_t executed_ = 0, requested_ = 0, finished_ = 0;
};

}  // namespace app
