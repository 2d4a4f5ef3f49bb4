#pragma once

#include <string>
#include <vector>

#include "app/Preparation.h"
#include "metrics/Report.h"
#include "sim2d/trace/Trace.h"
#include "sim2d/world/Runner.h"

namespace app {

/// All that is known after a run.
struct FinishedRun {
  sim2d::Trace trace;
  std::string treesCsv;
  sim2d::RunResult result;
  base::Result<metrics::Evaluation> evaluation;
  std::string effectsCsv;  // of the run without robots; empty = there was none
};

/// The files of a run (FORMAT.md), each written beside and renamed. Files of a former run of the
/// same names are replaced; metrics files are removed when this run could not be evaluated.
base::Diagnostics writeRunFolder(const std::string& folder, const FinishedRun& run,
                                 const Preparation& preparation,
                                 const std::vector<std::string>& commandLine);

}  // namespace app
