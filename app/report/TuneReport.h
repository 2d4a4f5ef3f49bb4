#pragma once

#include <string>
#include <vector>

#include "app/report/Page.h"
#include "app/studies/Tune.h"

/// The results of tuning as files. Deterministic.
namespace report {

/// Contents of the files of a tuning besides its results.
struct TuneContext {
  std::string outputName;              // of the tuned file: "nav2_params.yaml"
  std::vector<std::string> command;    // the command line
  std::vector<app::InputHash> inputs;  // files that the runs have read
};

struct TuneReport {
  std::string headline;  // "IMPROVED: time to reach goal −12.1 % [−15.0, −9.3]"
  std::string tuned;     // the tuned file; the current one without an improvement
  std::string diff;      // from the current file to the chosen values; empty: none chosen
  std::string html;      // self-contained page
  std::string json;
  std::vector<Table> tables;    // tables of the page
  std::vector<Figure> figures;  // figures of the page
};

TuneReport makeTuneReport(const app::TuneOptions& options, const app::TuneSubject& subject,
                          const app::TuneResult& result, const TuneContext& context);

// Parts of the page (TuneTables.cpp).

/// A share as a signed percentage: "−12.1 %". NaN: "–".
std::string signedPercent(double share);
/// A difference relative to the value before, with its interval: "−12.1 % [−15.0, −9.3]".
std::string relativeText(const app::TuneDifference& difference);
/// Success and objectives on the runs that the search has not seen.
Table tuneEvaluationTable(const app::TuneOptions& options, const app::TuneResult& result);
/// The same per scenario.
Table tuneScenarioTable(const app::TuneOptions& options, const app::TuneResult& result);
/// What each change contributes.
Table tuneEffectsTable(const app::TuneOptions& options, const app::TuneSubject& subject,
                       const app::TuneResult& result);
/// All parameters of the search with their ranges and values.
Table tuneParametersTable(const app::TuneSubject& subject, const app::TuneResult& result);
/// The effects of changes of single parameters in the search.
Table tuneProbeTable(const app::TuneOptions& options, const app::TuneSubject& subject,
                     const app::TuneResult& result);
/// The candidates on the front.
Table tuneFrontTable(const app::TuneOptions& options, const app::TuneSubject& subject,
                     const app::TuneResult& result);
/// Candidates by two objectives. Nothing with one objective.
std::optional<Figure> tuneFrontFigure(const app::TuneOptions& options,
                                      const app::TuneResult& result);

}  // namespace report
