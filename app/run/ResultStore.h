#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/run/ManifestFiles.h"
#include "app/run/ResultRow.h"

struct sqlite3;

namespace app {

struct SqlStatement;

/// Part `number` (from 1) of `count`: the runs with index % count == number - 1.
struct Shard {
  std::size_t number = 1, count = 1;
  bool contains(std::size_t run) const { return run % count == number - 1; }
  std::size_t runCount(std::size_t all) const {
    return all / count + (all % count >= number ? 1 : 0);
  }
  std::string text() const { return std::to_string(number) + "/" + std::to_string(count); }
};

/// The experiment that the results of a batch belong to.
struct Study {
  std::string version, commit;             // of the program
  std::string experimentPath, experiment;  // path and text of the experiment file
  std::vector<InputHash> inputs;           // the experiment first, then the input files of the runs
  std::vector<std::string> paths;          // of the values, in column order
  std::vector<std::string> drawn;          // the paths whose values are drawn per scenario and seed
  /// The design of a sensitivity analysis as JSON: {"method", "points", "seed", "factors":
  /// [{"path", "from", "to"}]}; empty: another design or none. The points are a dimension of the
  /// experiment.
  std::string design;
  std::size_t runs = 0;  // of the experiment, over all shards
  Shard shard;
  bool allowsCode = false;      // external programs of scenarios may start
  double timeLimit = 0.0;       // of one run [s], wall-clock time; 0 = none
  std::string until;            // the condition of the stopping rule, as text; empty: none
  std::size_t enoughSeeds = 0;  // number after which it was met; 0: not yet
};

/// The result of a run with its position in the experiment.
struct StoredRun {
  std::size_t run = 0;
  std::string scenario;  // as the experiment names it
  long long seed = 1;
  std::vector<std::string> values;  // one per path
  ResultRow row;
};

/// The results of a batch in an SQLite database. A result is durable when add() returns, however
/// the process ends. One process and thread at a time (FolderLock). Never throws; problems name the
/// file.
class ResultStore {
 public:
  /// Creates a database; `path` must not exist.
  static base::Result<std::unique_ptr<ResultStore>> create(const std::string& path,
                                                           const Study& study);
  /// Errors: damaged, not a result database, or written by a newer program; the file is not changed
  /// then.
  static base::Result<std::unique_ptr<ResultStore>> open(const std::string& path);
  /// Whether a file has the header of a result database.
  static bool isResultDatabase(const std::string& path);
  ~ResultStore();
  ResultStore(const ResultStore&) = delete;
  ResultStore& operator=(const ResultStore&) = delete;
  ResultStore(ResultStore&&) = delete;
  ResultStore& operator=(ResultStore&&) = delete;

  const Study& study() const { return study_; }
  std::size_t finished() const { return finished_; }
  std::size_t failed() const { return failed_; }
  std::size_t failedByMachine() const { return machineFailures_.size(); }  // among failed()
  struct Failure {
    std::size_t run = 0;
    std::string reason;
  };
  const std::optional<Failure>& firstFailure() const { return firstFailure_; }  // by index
  bool isComplete() const {
    return finished_ == study_.shard.runCount(study_.runs) || study_.enoughSeeds > 0;
  }
  bool has(std::size_t run) const { return has_[run]; }

  /// Adds the run and its inputs. Error: an input differs from the one of the study; the run is not
  /// added then.
  base::Diagnostics add(const StoredRun& run);
  /// Removes failed runs so that they count as missing: all of them, or those with
  /// FailedBy::Machine.
  base::Diagnostics removeFailed(bool all);
  /// Applies to the missing runs.
  base::Diagnostics setTimeLimit(double seconds);
  /// The batch is complete with its first `seeds` seeds.
  base::Diagnostics setEnoughSeeds(std::size_t seeds);
  /// Visits all stored runs by index.
  base::Diagnostics forEach(const std::function<void(const StoredRun&)>& visit) const;
  /// Replaces the paths of the experiment and its inputs, and paths in the reasons of runs.
  /// `replaced`: the text that takes the place of another.
  base::Diagnostics replacePaths(const std::function<std::string(const std::string&)>& replaced);
  /// Merges the write-ahead log into one file that other programs can read.
  base::Diagnostics close();

 private:
  explicit ResultStore(std::string path);
  base::Diagnostics connect(bool isNew);
  base::Diagnostics check();
  base::Diagnostics makeTables(const Study& study);
  base::Diagnostics readStudy();
  base::Diagnostics readRuns();
  /// Counts a stored run. `isMarked`: it was ended by the machine.
  void count(const StoredRun& run, bool isMarked);
  void noteFailure(std::size_t run, const std::string& reason);
  base::Diagnostics readMachineFailures();
  bool addTrees(const StoredRun& run) const;
  std::vector<TreeRow> treesOf(std::size_t run) const;
  base::Diagnostics addInputs(const std::vector<InputHash>& inputs);
  bool run(const char* sql) const;
  base::Diagnostics sqliteError(const char* code) const;
  base::Diagnostics endOfRows() const;  // an error if a query ended before its last row

  const std::string path_;
  sqlite3* database_ = nullptr;
  std::unique_ptr<SqlStatement> insertion_;
  Study study_;
  std::map<std::string, std::string> hashes_;  // of inputs, by path
  std::vector<bool> has_;                      // by run
  std::size_t finished_ = 0, failed_ = 0;
  std::optional<Failure> firstFailure_;
  std::set<std::size_t> machineFailures_;  // runs with FailedBy::Machine
};

/// Writes results.csv from the store, one row per run by index. Columns after the common ones:
/// metrics in registry order, then others by first occurrence. The bytes do not depend on the
/// number of processes, their order, interruptions, shards or the clock.
base::Diagnostics writeResults(const ResultStore& store, const std::string& path);

/// A row as one line of JSON without line end: {"run", "scenario", "seed", "values": {path: text},
/// "status", "reason", "metrics": {column: number, true, false, text or null}}.
std::string rowJson(const Study& study, const StoredRun& run);

/// The message before the rows: {"runs", "finished"} of the shard.
std::string headerJson(const ResultStore& store);

/// manifest.json of a batch, without its output files: the program, input files, run counts, and
/// drawn values per scenario and seed.
base::Result<std::string> batchManifest(const ResultStore& store);
/// The manifest before any run. `former`: number of runs of the batch that is replaced in this
/// folder.
std::string emptyManifest(const Study& study, std::size_t former);

}  // namespace app
