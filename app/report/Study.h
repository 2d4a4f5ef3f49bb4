#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/run/Design.h"
#include "app/run/ManifestFiles.h"
#include "app/run/TreeCoverage.h"
#include "app/studies/ContactReport.h"
#include "sim2d/base/Result.h"
#include "sim2d/map/MapReader.h"

namespace report {

using Numbers = std::vector<double>;

/// The contents of results.csv of a batch.
struct Results {
  struct Run {
    long long number = 0;
    std::string scenario;
    long long seed = 0;
    std::vector<std::string> values;  // one per path
    bool ok = true;
    std::string reason;  // failure reason
  };

  std::vector<std::string> paths;  // dimensions of the experiment (--set paths)
  std::vector<std::string> keys;   // metric keys
  std::vector<Run> runs;
  std::vector<Numbers> metrics;  // per key and run; NaN: undefined; true: 1, false: 0
  std::vector<bool> isBoolean;   // per key: all values are True or False

  /// The index of a key, or keys.size().
  std::size_t keyAt(const std::string& key) const;
};

/// Parses results.csv. Reports every problem with its position: missing columns, rows of a
/// different width, invalid numbers, duplicate runs. `file` is used in the messages.
base::Result<Results> parseResults(const std::string& text, const std::string& file);

/// The command line options of a report.
struct StudyOptions {
  std::string folder;                // batch folder
  std::vector<std::string> metrics;  // metric keys to display; empty: automatic
  std::string compare;               // value path or "scenario"; empty: automatic
  std::string paretoX, paretoY;      // metric keys; empty: default
  std::vector<std::pair<std::string, double>> weights;  // of the composite; empty: none
  double level = 0.95;                                  // confidence level
  int resamples = 2000;                                 // bootstrap resamples
  sim2d::ImageLoader loader;  // of map images, to check the inputs; empty: they are not checked
};

/// A metric.
struct Metric {
  std::string key;
  std::string name;  // display name
  std::string unit;  // empty: none
  bool isRate = false;
  int sense = 0;  // 1: higher is better, -1: lower is better, 0: neutral
};

/// Batch results as a comparison of options with everything else equal.
struct Study {
  std::string folder;                // as given
  std::string title;                 // "Planners compared"
  std::string compared;              // value path or "scenario"; empty: a single option
  std::vector<std::string> options;  // compared values, in file order; at least one
  /// Combinations of the other varied values, without the seed and values drawn by it: "cafe",
  /// "cafe, *.max_vel 1.4".
  std::vector<std::string> cases;
  std::vector<std::size_t> optionOf, caseOf;  // per run
  Results results;
  std::vector<Metric> metrics;     // one per key of results
  std::vector<std::size_t> shown;  // indices of the displayed metrics, in order
  bool hasChosenMetrics = false;   // the user has chosen `shown`
  std::optional<std::pair<std::size_t, std::size_t>> pareto;  // metrics
  double level = 0.95;
  int resamples = 2000;

  /// From manifest.json; empty if unknown.
  std::string version, commit, resultsHash;
  std::vector<app::InputHash> inputs;
  std::vector<std::string> changedInputs;  // paths of those with other content than in the runs
  base::Diagnostics inputWarnings;         // those of `check` for the unchanged inputs
  std::vector<std::string> drawn;          // value paths drawn per scenario and seed
  std::string shard;                       // "1/3"; empty: complete study
  bool allowsCode = false;
  std::optional<double> timeLimit;      // [s], wall clock time per run
  std::vector<std::string> runOptions;  // `run` options set by the experiment
  bool hasRunOptions = false;           // the experiment file is unchanged
  bool isExperimentUnreadable = false;  // the experiment file exists but cannot be read
  std::string until;                    // condition of the stopping rule; empty: none, or not met
  long long enoughSeeds = 0;            // number of seeds after which it was met
  std::string status;                   // "finished", "interrupted"; empty: unknown

  /// The design of a sensitivity analysis: values with a range, at points that are a dimension of
  /// the experiment.
  struct Factor {
    std::string path;
    double from = 0.0, to = 1.0;
  };
  struct Sensitivity {
    app::Design design;
    std::vector<Factor> factors;
  };
  std::optional<Sensitivity> sensitivity;  // from manifest.json
  std::vector<app::CoveredTree> trees;     // coverage, if the batch has it
  /// Of the completed runs, if they were analysed for the report (app/studies/BatchContacts.h).
  std::optional<std::vector<app::ContactReport>> contacts;

  std::size_t commonPrefixLength = 0;  // length of the common folder of all scenarios

  std::size_t runCount() const { return results.runs.size(); }
  /// The scenario of a run without the common folder.
  std::string scenarioName(std::size_t run) const;
  const Numbers& valuesOf(std::size_t metric) const { return results.metrics[metric]; }
  /// The folder of a run, if it was kept.
  std::optional<std::string> runFolder(std::size_t run) const;
  /// The outcome of a run without success, from its reason or metrics: "ran into a person".
  std::string outcomeText(std::size_t run) const;
  /// The command line that repeats the study, as far as the manifest contains it.
  std::vector<std::string> batchCommand() const;
  /// The command line that shows a run in the window.
  std::string replayCommand(std::size_t run) const;
};

/// Reads results.csv and manifest.json of the folder and reports all problems. A missing manifest
/// is a warning.
base::Result<Study> readStudy(const StudyOptions& studyOptions);

/// Selects the compared options, cases and metrics: sets all members of `study` that follow from
/// its results, the drawn values and the command line options. Errors: invalid options.
base::Diagnostics selectCompared(const StudyOptions& studyOptions, Study& study);

/// Joins arguments to a shell command with quoting.
std::string shellText(const std::vector<std::string>& words);

}  // namespace report
