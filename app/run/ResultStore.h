#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/run/ResultRow.h"
#include "app/run/SeenFiles.h"

struct sqlite3;

namespace app {

struct SqlStatement;

/// Part `number` of `count`, from 1 on: the runs whose number leaves `number` - 1 over.
struct Shard {
  std::size_t number = 1, count = 1;
  bool holds(std::size_t run) const { return run % count == number - 1; }
  std::size_t runsOf(std::size_t all) const {
    return all / count + (all % count >= number ? 1 : 0);
  }
  std::string text() const { return std::to_string(number) + "/" + std::to_string(count); }
};

/// What the results of a batch are results of.
struct Study {
  std::string version, commit;             // of the program
  std::string experimentPath, experiment;  // where the experiment lies, and its text
  std::vector<InputHash> inputs;           // the experiment first, then what runs used
  std::vector<std::string> paths;          // of values, as they are columns
  std::vector<std::string> drawn;          // those of them that are drawn per scenario and seed
  std::size_t runs = 0;                    // of the experiment, over all shards
  Shard shard;
  bool allowsCode = false;  // programs that scenarios name may start
  double timeLimit = 0.0;   // of one run [s], by the wall clock; 0 = none
};

/// A run with its place in the experiment.
struct StoredRun {
  std::size_t run = 0;
  std::string scenario;  // as the experiment names it
  long long seed = 1;
  std::vector<std::string> values;  // one per path
  ResultRow row;
};

/// The results of a batch in an SQLite database, each in it for good when add() returns: whatever
/// ends the program takes nothing of it. One process and thread at a time (FolderLock). Nothing
/// here throws; problems name the file.
class ResultStore {
 public:
  /// A new database; there is none.
  static base::Result<std::unique_ptr<ResultStore>> create(const std::string& path,
                                                           const Study& study);
  /// Errors: it is damaged, of something else, or of a newer program; nothing is changed then.
  static base::Result<std::unique_ptr<ResultStore>> open(const std::string& path);
  /// A file that begins as a database of this program.
  static bool isStore(const std::string& path);
  ~ResultStore();
  ResultStore(const ResultStore&) = delete;
  ResultStore& operator=(const ResultStore&) = delete;
  ResultStore(ResultStore&&) = delete;
  ResultStore& operator=(ResultStore&&) = delete;

  const Study& study() const { return study_; }
  std::size_t finished() const { return finished_; }
  std::size_t failed() const { return failed_; }
  std::size_t failedByMachine() const { return byMachine_.size(); }  // of those
  struct Failure {
    std::size_t run = 0;
    std::string reason;
  };
  const std::optional<Failure>& firstFailure() const { return firstFailure_; }  // by number
  bool isComplete() const { return finished_ == study_.shard.runsOf(study_.runs); }
  bool has(std::size_t run) const { return has_[run]; }

  /// Inputs of the run belong to the study from then on. Errors: one of them is another file than
  /// for the study; the run is not added then.
  base::Diagnostics add(const StoredRun& run);
  /// Removes failed runs, so that they count as missing: those that the machine ended, or all.
  base::Diagnostics dropFailed(bool all);
  /// Of the runs that are missing.
  base::Diagnostics setTimeLimit(double seconds);
  /// All runs that are in it, by number.
  base::Diagnostics forEach(const std::function<void(const StoredRun&)>& visit) const;
  /// Into one plain file that others can read.
  base::Diagnostics close();

 private:
  explicit ResultStore(std::string path);
  base::Diagnostics connect(bool isNew);
  base::Diagnostics check();
  base::Diagnostics makeTables(const Study& study);
  base::Diagnostics readStudy();
  base::Diagnostics readRuns();
  void noteFailure(std::size_t run, const std::string& reason);
  base::Diagnostics readMachineFailures();
  base::Diagnostics addInputs(const std::vector<InputHash>& inputs);
  bool run(const char* sql) const;
  base::Diagnostics trouble(const char* code) const;

  const std::string path_;
  sqlite3* database_ = nullptr;
  std::unique_ptr<SqlStatement> insertion_;
  Study study_;
  std::map<std::string, std::string> hashes_;  // of inputs, by path
  std::vector<bool> has_;                      // by run
  std::size_t finished_ = 0, failed_ = 0;
  std::optional<Failure> firstFailure_;
  std::set<std::size_t> byMachine_;  // runs that the machine ended
};

}  // namespace app
