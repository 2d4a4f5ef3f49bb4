#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/studies/EliteArchive.h"
#include "app/studies/Gate.h"
#include "app/studies/Tune.h"
#include "metrics/statistics/Summary.h"
#include "sim2d/base/Result.h"

/// The results of `tune`, `gate`, `sensitivity` and `search`, read from the JSON files in their
/// output folders. Undefined numbers are NaN.
namespace report {

/// tune.json and changes.diff.
struct TuneOutput {
  app::TuneVerdict verdict = app::TuneVerdict::NoCandidate;
  std::string file;                     // that was tuned
  std::vector<std::string> objectives;  // keys of metrics
  struct Parameter {
    std::string name;
    double low = 0.0, high = 0.0;  // range of the search
    bool isLogarithmic = false;
    std::string before;
    std::optional<std::string> chosen;  // none: the search has chosen no candidate
  };
  std::vector<Parameter> parameters;
  /// The contribution of a changed value.
  struct Effect {
    std::string parameter, value;
    double score = 0.0;  // that is lost without the change, as a share
    bool isKept = true;
    std::vector<app::TuneDifference> objectives;  // with the change - without it
  };
  std::vector<Effect> effects;
  /// After - before, on the runs that the search has not seen.
  struct Evaluation {
    std::string scenario;  // path; empty: all
    app::TuneDifference success;
    std::vector<app::TuneDifference> objectives;
  };
  std::vector<Evaluation> evaluations;         // all scenarios first; empty: there was none
  std::vector<std::string> withoutSeedEffect;  // scenarios whose runs are equal for all seeds
  struct Candidate {
    std::vector<std::string> values;  // per parameter
    bool isBefore = false, isChosen = false, isOnFront = false;
    std::vector<double> ratios;  // per objective, see TuneScore::ratios
  };
  std::vector<Candidate> candidates;  // that were scored with all runs of the search
  std::size_t tried = 0;              // all candidates without the values before
  std::size_t searchRuns = 0, evaluationRuns = 0;
  std::string diff;
};

/// gate.json.
struct GateOutput {
  app::GateVerdict verdict = app::GateVerdict::Undecided;
  std::string base, candidate;  // as on the command line
  std::size_t pairs = 0;
  struct Metric {
    std::string label;  // "success", "robot_on_person_collision>0"
    app::GateVerdict verdict = app::GateVerdict::Undecided;
    bool isMeasured = false;
    std::size_t pairs = 0;  // when it was decided
    double base = 0.0, candidate = 0.0;
    std::string unit;         // of base and candidate; "share": a rate
    double difference = 0.0;  // candidate - base
    statistics::Interval interval;
    double margin = 0.0;         // > 0
    std::string differenceUnit;  // of difference, interval and margin: "points", "%", "m"
  };
  std::vector<Metric> metrics;
  std::vector<std::string> remarks;
  /// A pair of runs in which the candidate is worse.
  struct Finding {
    std::string scenario;  // name
    long long seed = 1;
    std::string what;
    std::string playCandidate, playBase;  // command lines that open the run in the window
  };
  std::vector<Finding> findings;
};

/// sensitivity.json.
struct SensitivityOutput {
  bool isMorris = true;
  std::size_t points = 0;  // trajectories or base points
  std::size_t runs = 0, seeds = 0;
  double level = 0.95;
  struct Factor {
    std::string path;
    double from = 0.0, to = 0.0;
    double importance = 0.0;  // mu* or total index
    statistics::Interval importanceInterval;
    double mean = 0.0, deviation = 0.0;  // Morris: mu, sigma
    double effects = 0.0;                // Morris: number of elementary effects
    double first = 0.0;                  // Sobol: first-order index
    statistics::Interval firstInterval;
    double orderShare = 0.0;  // of the resamples in which it is before the next one
  };
  struct Result {
    std::string metric;  // key
    std::string of;      // the case: scenario and listed values
    bool varies = false;
    std::size_t undefinedPoints = 0;
    double seedShare = 0.0;
    std::vector<std::string> wide;  // paths whose interval is wider than their index
    std::vector<std::pair<std::string, std::string>> unordered;  // neighbours, order not certain
    double required = 0.0;                                       // number of points
    std::vector<Factor> factors;                                 // by rank
  };
  std::vector<Result> results;               // by metric, then case
  std::vector<std::string> constantMetrics;  // keys
};

/// archive.json of `search --until-failure` and `--worst`.
struct SearchOutput {
  std::string worstMetric;  // key; empty: the search was for failures
  std::size_t runs = 0, notSimulated = 0, unavoidable = 0;
  struct Failure {
    std::string kind;      // name of the FailureKind; empty: the worst run
    std::string file;      // of the scenario that repeats it, in the folder
    std::string scenario;  // in which it was found
    long long seed = 1;
    std::string reason;  // of its end
    double end = 0.0;    // [s]
    std::size_t people = 0, peopleBefore = 0;
    std::vector<std::string> changes;  // that remain, without the lists of what is switched off
    bool isMinimal = true;             // false: the limit of runs was reached
    bool isRepeated = false;           // the file gives the same end and metrics
  };
  std::vector<Failure> failures;
  std::optional<Failure> worst;
  double worstValue = 0.0;
  std::vector<app::Descriptor> descriptors;  // two
  struct Cell {
    app::EliteArchive::Cell at;
    double fitness = 0.0;
    std::string kind;  // empty: no failure
    std::string scenario;
    long long seed = 1;
    std::string reason;
  };
  std::vector<Cell> cells;
};

/// archive.json of `search --cover`.
struct CoverOutput {
  std::size_t runs = 0, notSimulated = 0;
  std::size_t nodes = 0, reached = 0, unreachable = 0;  // of all trees
  struct Tree {
    std::size_t number = 0;  // from 1
    std::string owners;      // people and robots that have it
    std::vector<std::string> scenarios;
    std::size_t runs = 0, nodes = 0, reached = 0;
    std::vector<std::string> neverReached, unreachable;  // paths of nodes
  };
  std::vector<Tree> trees;
  /// A run that reached nodes first.
  struct Run {
    std::size_t number = 0;
    std::string scenario;
    long long seed = 1;
    std::string reason;              // of its end
    std::vector<std::string> nodes;  // "1: path of the node"
    std::string play;                // command line that opens the run in the window
  };
  std::vector<Run> coveringRuns;
};

using StudyOutput =
    std::variant<TuneOutput, GateOutput, SensitivityOutput, SearchOutput, CoverOutput>;

/// The JSON file in an output folder of these commands, or this file itself, beside its
/// manifest.json; nullopt: the path is neither.
std::optional<std::string> studyOutputFile(const std::string& path);
/// The page in the folder of the results: "report.html" or "gate.html".
std::string studyOutputPage(const StudyOutput& output);
/// Reads the results of a file returned by studyOutputFile(). Errors: it cannot be read, or
/// `study.bad-output`.
base::Result<StudyOutput> readStudyOutput(const std::string& file);

}  // namespace report
