#include "app/RunFolder.h"

#include <filesystem>

#include "app/Manifest.h"
#include "metrics/ReportFiles.h"
#include "sim2d/base/Text.h"

namespace app {

base::Diagnostics writeRunFolder(const std::string& folder, const FinishedRun& run,
                                 RunWriter& writer, const Preparation& preparation,
                                 const std::vector<std::string>& commandLine) {
  namespace fs = std::filesystem;
  base::Diagnostics problems = writer.finish();
  const auto write = [&](const char* name, const std::string& content) {
    base::append(problems, base::writeFileAtomically((fs::path(folder) / name).string(), content));
  };
  const auto remove = [&](const std::vector<const char*>& names) {
    for (const char* name : names) {
      std::error_code ignored;  // not there: fine
      fs::remove(fs::path(folder) / name, ignored);
    }
  };
  if (run.evaluation) {
    write("metrics.json", metrics::toJson(*run.evaluation));
  } else {
    remove({"metrics.json"});
  }
  if (!run.totalsOnly) {
    write("trace.json", sim2d::traceJson(run.header));
  } else {
    remove({"trajectory.csv", "events.csv", "trees.csv", "trace.json"});
  }
  if (run.evaluation && !run.totalsOnly) {
    write("metrics.csv", metrics::metricsCsv(*run.evaluation));
    base::append(problems, writer.writeSteps((fs::path(folder) / "steps.csv").string(),
                                             run.evaluation->times));
  } else {
    remove({"metrics.csv", "steps.csv"});
  }
  if (!run.effectsCsv.empty()) {
    write("counterfactual.csv", run.effectsCsv);
  } else {
    remove({"counterfactual.csv"});
  }
  write("manifest.json",
        runManifest(preparation, run.header, run.result, run.planning, commandLine));
  return problems;
}

}  // namespace app
