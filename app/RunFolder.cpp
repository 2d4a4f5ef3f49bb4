#include "app/RunFolder.h"

#include <filesystem>

#include "app/Manifest.h"
#include "metrics/ReportFiles.h"
#include "sim2d/base/Text.h"

namespace app {

base::Diagnostics writeRunFolder(const std::string& folder, const FinishedRun& run,
                                 const Preparation& preparation,
                                 const std::vector<std::string>& commandLine) {
  namespace fs = std::filesystem;
  base::Diagnostics problems;
  const auto write = [&](const char* name, const std::string& content) {
    base::append(problems, base::writeFileAtomically((fs::path(folder) / name).string(), content));
  };
  write("trajectory.csv", sim2d::trajectoryCsv(run.trace));
  write("events.csv", sim2d::eventsCsv(run.trace));
  write("trees.csv", run.treesCsv);
  write("trace.json", sim2d::traceJson(run.trace.header));
  if (run.evaluation) {
    write("metrics.json", metrics::toJson(*run.evaluation));
    write("metrics.csv", metrics::metricsCsv(*run.evaluation));
    write("steps.csv", metrics::stepsCsv(*run.evaluation));
  } else {
    for (const char* name : {"metrics.json", "metrics.csv", "steps.csv"}) {
      std::error_code ignored;  // not there: fine
      fs::remove(fs::path(folder) / name, ignored);
    }
  }
  if (!run.effectsCsv.empty()) {
    write("counterfactual.csv", run.effectsCsv);
  } else {
    std::error_code ignored;  // not there: fine
    fs::remove(fs::path(folder) / "counterfactual.csv", ignored);
  }
  write("manifest.json", runManifest(preparation, run.trace.header, run.result, commandLine));
  return problems;
}

}  // namespace app
