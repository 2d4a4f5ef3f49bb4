#pragma once

#include <optional>
#include <string>
#include <vector>

#include "metrics/Report.h"
#include "sim2d/scenario/Scenario.h"

namespace app {

/// What of a run is measured, and how.
struct MetricsSetup {
  metrics::Selection selection;
  metrics::MetricParameters parameters;
  bool hasFile = false;  // the scenario names a metrics file
};

/// The metrics file that a scenario names, where it lies.
std::optional<std::string> metricsFileOf(const sim2d::Scenario& scenario,
                                         const std::string& scenarioPath);
/// The settings under `metrics` of a scenario; its file is relative to `scenarioPath`. Problems:
/// a file that cannot be read, a parameter that is unknown or out of its range, a wrong window.
base::Result<MetricsSetup> metricsSetupOf(const sim2d::Scenario& scenario,
                                          const std::string& scenarioPath);

/// The same of a record. Problems as above.
base::Diagnostics readMetricsSetup(const sim2d::TraceHeader& header, MetricsSetup& setup);
/// Puts what a metrics file of the scenario said into the header of the record (the world fills in
/// the rest), so that the record alone gives the same numbers.
void noteMetricsFile(const MetricsSetup& setup, sim2d::TraceHeader& header);

/// Id of the robot that a word means: its name, its number from 1 on, or its id (-1, -2 …).
base::Result<int> robotOfWord(const sim2d::TraceHeader& header, const std::string& word);

/// The words of the command line about metrics.
struct MetricsWords {
  std::string metrics;                // a file, or keys with commas; empty = what the scenario says
  std::string profile = "corrected";  // or "hunav2"
};
/// Puts the words over the setup. Returns the problems of the file; unknown keys are `wrongWords`.
base::Diagnostics chooseMetrics(const MetricsWords& words, MetricsSetup& setup,
                                base::Diagnostics& wrongWords);

}  // namespace app
