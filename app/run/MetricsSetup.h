#pragma once

#include <optional>
#include <string>
#include <vector>

#include "metrics/Report.h"
#include "sim2d/scenario/Scenario.h"

namespace app {

/// The metrics of a run and their parameters.
struct MetricsSetup {
  metrics::Selection selection;
  metrics::MetricParameters parameters;
  bool hasFile = false;  // the scenario names a metrics file
};

/// The path of the metrics file that a scenario names.
std::optional<std::string> metricsFileOf(const sim2d::Scenario& scenario,
                                         const std::string& scenarioPath);
/// The settings under `metrics` of a scenario; its file is relative to `scenarioPath`. Problems: an
/// unreadable file, an unknown or out-of-range parameter, an invalid window.
base::Result<MetricsSetup> metricsSetupOf(const sim2d::Scenario& scenario,
                                          const std::string& scenarioPath);

/// The same for a recording, with the same problems.
base::Diagnostics readMetricsSetup(const sim2d::TraceHeader& header, MetricsSetup& setup);
/// Stores the selection of the scenario's metrics file in the header of the recording (the world
/// sets the rest), so that the recording alone reproduces the metrics.
void storeMetricsSelection(const MetricsSetup& setup, sim2d::TraceHeader& header);

/// The id of the robot given by name, number (from 1) or id (-1, -2 …).
base::Result<int> robotIdOf(const sim2d::TraceHeader& header, const std::string& word);

/// Command-line options for metrics.
struct MetricsOptions {
  std::string metrics;  // a file, or keys separated by commas; empty = as in the scenario
  std::string metricsProfile = "corrected";  // or "hunav2"
};
/// Applies the options to the setup. Returns the problems of the file; unknown keys are
/// `wrongOptions`.
base::Diagnostics applyMetricsOptions(const MetricsOptions& options, MetricsSetup& setup,
                                      base::Diagnostics& wrongOptions);

/// Removes from the selection what is not written: series per sample without files, results per
/// behaviour type unless they are shown.
void skipUnwrittenMetrics(bool hasFiles, bool showsBehaviors, metrics::Selection& selection);

}  // namespace app
