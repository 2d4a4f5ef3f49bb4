#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/report/Results.h"

namespace report {

/// What is asked for on the command line.
struct Wishes {
  std::string folder;                // of the batch
  std::vector<std::string> metrics;  // keys to show; empty = a choice of those measured
  std::string compare;               // value path, or "scenario"; empty = the one with most to say
  std::string paretoX, paretoY;      // keys; empty = the usual two
  std::vector<std::pair<std::string, double>> weights;  // of a composite; empty = none
  double level = 0.95;                                  // of intervals
  int resamples = 2000;                                 // of the bootstrap
};

/// What is known of a metric.
struct Metric {
  std::string key;
  std::string name;  // for people
  std::string unit;  // "" = none
  bool isRate = false;
  int sense = 0;  // 1: higher is better, -1: lower, 0: neither
};

/// Results as one comparison: options side by side, everything else the same.
struct Study {
  std::string folder;                // as given
  std::string title;                 // "Planners compared"
  std::string compared;              // value path or "scenario"; empty = there is one option only
  std::vector<std::string> options;  // values compared, in the order of the file; one at least
  /// What else differs but the seed and what is drawn by it: "cafe", "cafe, *.max_vel 1.4".
  std::vector<std::string> cases;
  std::vector<std::size_t> optionOf, caseOf;  // per run
  Results results;
  std::vector<Metric> metrics;     // per key of the results
  std::vector<std::size_t> shown;  // places of the metrics in the page, in order
  std::optional<std::pair<std::size_t, std::size_t>> pareto;  // metrics
  double level = 0.95;
  int resamples = 2000;

  /// From manifest.json; empty when it is not known.
  struct Input {
    std::string path, sha256;
  };
  std::string version, commit, resultsHash;
  std::vector<Input> inputs;
  std::vector<std::string> drawn;  // value paths that are drawn for each scenario and seed
  std::string shard;               // "1/3"; empty = the whole study
  bool allowsCode = false;
  std::optional<double> timeLimit;    // of one run [s], by the wall clock
  std::vector<std::string> runWords;  // options of `run` that the experiment sets for all
  bool knowsRunWords = false;         // the experiment file is still the one that was run
  bool lacksFile = false;             // that is there and cannot be read
  std::string status;                 // "finished", "interrupted"; empty = not known

  std::size_t sharedFolder = 0;  // characters of the folder in which all scenarios lie

  std::size_t runCount() const { return results.runs.size(); }
  /// The scenario of a run, without the folder that all share.
  std::string scenarioName(std::size_t run) const;
  const Numbers& valuesOf(std::size_t metric) const { return results.metrics[metric]; }
  /// Folder of a run, if it was kept.
  std::optional<std::string> runFolder(std::size_t run) const;
  /// Of a run without success, by its reason or its metrics: "ran into a person".
  std::string whatHappened(std::size_t run) const;
  /// The command that makes the study again, as far as the manifest tells it.
  std::vector<std::string> batchWords() const;
  /// The command that shows a run in the window.
  std::string replayCommand(std::size_t run) const;
};

/// Reads results.csv and manifest.json of the folder. All problems; a missing manifest is a
/// warning.
base::Result<Study> readStudy(const Wishes& wishes);

/// Words for a shell: what it would change is quoted.
std::string shellText(const std::vector<std::string>& words);

}  // namespace report
