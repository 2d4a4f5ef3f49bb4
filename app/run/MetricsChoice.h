#pragma once

#include <string>

#include "app/run/MetricsSetup.h"

namespace app {

/// The words of the command line about metrics.
struct MetricsWords {
  std::string metrics;                // a file, or keys with commas; empty = what the scenario says
  std::string profile = "corrected";  // or "hunav2"
};

/// Puts the words over the setup. Returns the problems of the file; unknown keys are `wrongWords`.
base::Diagnostics chooseMetrics(const MetricsWords& words, MetricsSetup& setup,
                                base::Diagnostics& wrongWords);

}  // namespace app
