#include "app/run/RunFolder.h"

#include <filesystem>
#include <set>
#include <type_traits>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "app/run/DataPaths.h"
#include "app/run/Sha256.h"
#include "bt/tree/TreeXml.h"
#include "metrics/ReportFiles.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kStatusNames[] = {"finished", "failed", "interrupted"};  // of RunStatus

Json programJson() {
  return {{"version", programVersion()}, {"commit", programCommit()}};
}

/// Files that were read, with their SHA-256.
Json inputsJson(const std::vector<std::string>& paths) {
  Json inputs = Json::array();
  for (const std::string& path : paths) {
    const std::optional<std::string> hash = sha256OfFile(path);
    inputs.push_back({{"path", path}, {"sha256", hash ? Json(*hash) : Json()}});
  }
  return inputs;
}

/// The files that were read, those that trees include too, each once.
std::vector<std::string> allInputs(const Bundle& bundle) {
  std::vector<std::string> inputs;
  std::set<fs::path> seen;
  const auto add = [&](const std::string& path) {
    std::error_code ignored;  // as it is named, if it is gone by now
    const fs::path real = fs::weakly_canonical(path, ignored);
    if (seen.insert(real.empty() ? fs::path(path) : real).second) {
      inputs.push_back(path);
    }
  };
  for (const std::string& path : bundle.inputs) {
    add(path);
  }
  for (const auto& [person, tree] : bundle.trees) {
    const base::Result<bt::TreeTable> trees =
        tree.path.empty() ? base::Result<bt::TreeTable>(bt::TreeTable()) : bt::loadTrees(tree.path);
    if (!trees) {
      continue;  // told when it was loaded for the run
    }
    for (const auto& [id, entry] : trees->entries) {
      add(fs::path(entry.file).lexically_normal().string());
    }
  }
  return inputs;
}

Json humanJson(const sim2d::TraceHuman& human) {
  Json json = {{"id", human.id}, {"name", human.name}, {"model", human.model}};
  for (const auto& [key, value] : human.parameters) {
    json[key] = value;
  }
  return json;
}

/// Its names and numbers.
Json robotJson(const sim2d::TraceRobot& robot) {
  Json json;
  sim2d::forEachMember(robot, [&json](const char* name, const auto& member) {
    using Member = std::decay_t<decltype(member)>;
    if constexpr (std::is_arithmetic_v<Member> || std::is_same_v<Member, std::string>) {
      json[name] = member;
    }
  });
  return json;
}

/// What it came from, what it was set to, how it ended.
std::string runManifest(const Bundle& bundle, const FinishedRun& run,
                        const std::vector<std::string>& commandLine) {
  const sim2d::TraceHeader& header = run.header;
  const sim2d::RunResult& result = run.result;
  const double simulated = static_cast<double>(result.steps) * header.dt;
  const sim2d::DesktopSettings& desktop = bundle.scenario->desktop;
  Json json;
  json["program"] = programJson();
  json["command_line"] = commandLine;
  json["status"] = kStatusNames[static_cast<int>(result.status)];
  json["reason"] = result.reason;
  json["inputs"] = inputsJson(allInputs(bundle));
  json["seed"] = header.seed;
  json["dt"] = header.dt;
  json["model"] = desktop.model.value_or("sfm");
  json["compat"] = bundle.settings.compatibility.names();
  json["record_every"] = header.recordEvery;
  json["steps"] = result.steps;
  json["simulated_seconds"] = simulated;
  json["wall_seconds"] = result.steppingSeconds;
  json["real_time_factor"] =
      result.steppingSeconds > 0.0 ? Json(simulated / result.steppingSeconds) : Json();
  for (const metrics::MetricResult& time : run.planning.results()) {
    json[time.info.key] = time.value.value ? Json(*time.value.value) : Json();
  }
  json["humans"] = Json::array();
  for (const sim2d::TraceHuman& human : header.humans) {
    json["humans"].push_back(humanJson(human));
  }
  json["robots"] = Json::array();
  for (const sim2d::TraceRobot& robot : header.robots) {
    json["robots"].push_back(robotJson(robot));
  }
  return json.dump(2) + "\n";
}

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
    folder.write("manifest.json", runManifest(bundle, run, commandLine));
  }
  return folder.problems();
}

std::string batchManifest(const Experiment& experiment, const BatchRows& rows) {
  const BatchCount count = countOf(rows);
  std::vector<std::string> inputs = {experiment.path};
  inputs.insert(inputs.end(), experiment.scenarioPaths.begin(), experiment.scenarioPaths.end());
  const Json json = {{"program", programJson()},
                     {"inputs", inputsJson(inputs)},
                     {"status", count.finished == rows.size() ? "finished" : "interrupted"},
                     {"runs", rows.size()},
                     {"finished", count.finished},
                     {"failed", count.failed}};
  return json.dump(2) + "\n";
}

base::Diagnostics checkWritableFolder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder)) {
    return {
        base::error("file.cannot-make-folder", {error ? error.message() : std::string()}, folder)};
  }
  if (access(folder.c_str(), W_OK) != 0) {
    return {base::error("file.no-permission", {}, folder)};
  }
  return {};
}

}  // namespace app
