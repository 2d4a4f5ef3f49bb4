#include "app/run/RunFolder.h"

#include <filesystem>

#include "app/run/Manifest.h"
#include "metrics/ReportFiles.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

namespace fs = std::filesystem;

class Folder {
 public:
  explicit Folder(const std::string& path) : path_(path) {}

  std::string file(const char* name) const { return (path_ / name).string(); }
  void write(const char* name, const std::string& content) {
    note(base::writeFileAtomically(file(name), content));
  }
  void remove(const std::vector<const char*>& names) {
    for (const char* name : names) {
      std::error_code error;
      fs::remove(path_ / name, error);  // no error when it is not there
      if (error) {
        note({base::error("file.cannot-remove", {error.message()}, file(name))});
      }
    }
  }
  /// Without content there is no such file.
  void writeOrRemove(const char* name, const std::string& content) {
    content.empty() ? remove({name}) : write(name, content);
  }
  void note(const base::Diagnostics& problems) { base::append(problems_, problems); }
  bool isWhole() const { return !base::hasErrors(problems_); }
  const base::Diagnostics& problems() const { return problems_; }

 private:
  fs::path path_;
  base::Diagnostics problems_;
};

/// All but trace.json and manifest.json, which make the folder that of a run.
void writeParts(Folder& folder, const FinishedRun& run, RunWriter& writer) {
  const bool hasInputs = writer.hasInputs();
  folder.note(writer.finish());
  if (run.totalsOnly) {
    folder.remove({"trajectory.csv", "events.csv", "trees.csv"});
  }
  if (!hasInputs) {
    folder.remove({"inputs.csv"});
  }
  folder.writeOrRemove("metrics.json", run.evaluation ? metrics::toJson(*run.evaluation) : "");
  if (run.evaluation && !run.totalsOnly) {
    folder.write("metrics.csv", metrics::metricsCsv(*run.evaluation));
    folder.note(writer.writeSteps(folder.file("steps.csv"), run.evaluation->times));
  } else {
    folder.remove({"metrics.csv", "steps.csv"});
  }
  folder.writeOrRemove("counterfactual.csv", run.effectsCsv);
}

}  // namespace

base::Diagnostics writeRunFolder(const std::string& path, const FinishedRun& run, RunWriter& writer,
                                 const Bundle& bundle,
                                 const std::vector<std::string>& commandLine) {
  Folder folder(path);
  folder.note(writer.complete());
  if (folder.isWhole()) {  // until here a former run stays as it is
    folder.remove({"manifest.json", "trace.json"});
  }
  if (folder.isWhole()) {
    writeParts(folder, run, writer);
  }
  if (folder.isWhole() && !run.totalsOnly) {
    folder.write("trace.json", sim2d::traceJson(run.header));
  }
  if (folder.isWhole()) {
    folder.write("manifest.json",
                 runManifest(bundle, run.header, run.result, run.planning, commandLine));
  }
  return folder.problems();
}

}  // namespace app
