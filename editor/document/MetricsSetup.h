#pragma once

#include <string>

#include "metrics/Report.h"
#include "sim2d/scenario/Scenario.h"

namespace editor {

/// What of a run is measured, and how.
struct MetricsSetup {
  metrics::Selection selection;
  metrics::MetricParameters parameters;
};

/// The settings under `metrics` of a scenario; its file is relative to `scenarioPath`. Problems:
/// a file that cannot be read, an unknown parameter, a wrong window.
base::Result<MetricsSetup> metricsSetupOf(const sim2d::Scenario& scenario,
                                          const std::string& scenarioPath);

}  // namespace editor
