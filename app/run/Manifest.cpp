#include "app/run/Manifest.h"

#include <cmath>
#include <filesystem>
#include <set>
#include <type_traits>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "app/run/DataPaths.h"
#include "app/run/InputJson.h"
#include "bt/tree/TreeXml.h"

namespace app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const char* statusName(sim2d::RunStatus status) {
  switch (status) {
    case sim2d::RunStatus::Finished:
      return "finished";
    case sim2d::RunStatus::Failed:
      return "failed";
    case sim2d::RunStatus::Interrupted:
      return "interrupted";
  }
  return "";
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

}  // namespace

std::string runManifest(const Bundle& bundle, const sim2d::TraceHeader& header,
                        const sim2d::RunResult& result, const metrics::PlanningTime& planning,
                        const std::vector<std::string>& commandLine) {
  const double simulated = static_cast<double>(result.steps) * header.dt;
  const sim2d::DesktopSettings& desktop = bundle.scenario->desktop;
  Json json;
  json["program"] = {{"version", programVersion()}, {"commit", programCommit()}};
  json["command_line"] = commandLine;
  json["status"] = statusName(result.status);
  json["reason"] = result.reason;
  json["inputs"] = Json::array();
  for (const std::string& path : allInputs(bundle)) {
    json["inputs"].push_back(inputJson(path));
  }
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
  for (const metrics::MetricResult& time : planning.results()) {
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

base::Diagnostics checkWritableFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    return {
        base::error("file.cannot-make-folder", {error ? error.message() : std::string()}, folder)};
  }
  if (access(folder.c_str(), W_OK) != 0) {
    return {base::error("file.no-permission", {}, folder)};
  }
  return {};
}

}  // namespace app
