#pragma once

#include <string>
#include <vector>

#include "app/run/Batch.h"
#include "app/run/Bundle.h"
#include "app/run/RunWriter.h"
#include "metrics/PlanningTime.h"
#include "metrics/Report.h"
#include "sim2d/trace/Trace.h"
#include "sim2d/world/Runner.h"

namespace app {

/// All that is known after a run, beside the files that were written while it went on.
struct FinishedRun {
  sim2d::TraceHeader header;
  sim2d::RunResult result;
  metrics::PlanningTime planning;
  base::Result<metrics::Evaluation> evaluation;
  std::string effectsCsv;   // of the run without robots; empty = there was none
  bool totalsOnly = false;  // nothing per step is written
};

/// The files of a run (FORMAT.md), each written beside and renamed; those of `writer` are put in
/// their places. Files of a former run of the same names are replaced; metrics files are removed
/// when this run could not be evaluated. manifest.json and trace.json are taken away first and come
/// last, only when all others were written: files of two runs never pass for one.
base::Diagnostics writeRunFolder(const std::string& path, const FinishedRun& run, RunWriter& writer,
                                 const Bundle& bundle, const std::vector<std::string>& commandLine);

/// manifest.json of a batch; nothing of it depends on the number of jobs or the clock.
std::string batchManifest(const Experiment& experiment, const BatchRows& rows);

/// Makes the folder; an error if it cannot be made or written to.
base::Diagnostics checkWritableFolder(const std::string& folder);

}  // namespace app
