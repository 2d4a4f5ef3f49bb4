#include "app/studies/FailureScenario.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/run/Batch.h"
#include "app/run/BundleReader.h"
#include "app/run/DataPaths.h"
#include "app/run/ManifestFiles.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

namespace fs = std::filesystem;

/// The path of a file relative to the folder of another one.
std::string pathFromScenario(const std::string& scenarioPath, const std::string& file) {
  const fs::path folder = fs::path(absolutePath(scenarioPath)).parent_path();
  std::error_code none;
  const fs::path relative = fs::relative(absolutePath(file), folder, none);
  return none || relative.empty() ? absolutePath(file) : relative.string();
}

template <class T>
void removeUnlisted(std::vector<T>& all) {
  all.erase(std::remove_if(all.begin(), all.end(), [](const T& each) { return !each.listed; }),
            all.end());
}

void removeUnused(sim2d::Scenario& scenario) {
  removeUnlisted(scenario.humans);
  removeUnlisted(scenario.robots);
  removeUnlisted(scenario.obstacles);
  removeUnlisted(scenario.doors);
  removeUnlisted(scenario.areas);
  removeUnlisted(scenario.docks);
  for (const sim2d::GlobalGoal& unused : sim2d::unusedGoals(scenario)) {
    const bool isOfRobot =
        std::any_of(scenario.robots.begin(), scenario.robots.end(), [&](const sim2d::Robot& robot) {
          const std::vector<int>& goals = robot.goal.goals;
          return std::find(goals.begin(), goals.end(), unused.id) != goals.end();
        });
    if (!isOfRobot) {
      scenario.goals.erase(
          std::remove_if(scenario.goals.begin(), scenario.goals.end(),
                         [&](const sim2d::GlobalGoal& goal) { return goal.id == unused.id; }),
          scenario.goals.end());
    }
  }
}

/// Paths of a scenario file that are relative to its folder, moved to a new folder.
class Relocation {
 public:
  Relocation(std::string from, std::string to) : from_(std::move(from)), to_(std::move(to)) {}

  void move(sim2d::Scenario& scenario, const Bundle& bundle) const {
    moveMap(scenario, bundle);
    for (sim2d::Human& human : scenario.humans) {
      const auto tree = bundle.trees.find(human.name);
      if (tree != bundle.trees.end() && !tree->second.path.empty()) {
        human.ours.tree = pathFromScenario(to_, tree->second.path);
      }
    }
    for (sim2d::Robot& robot : scenario.robots) {
      std::for_each(robot.nav2Params.begin(), robot.nav2Params.end(),
                    [this](std::string& entry) { moveIfFile(entry); });
      if (robot.nav2Tree) {
        moveIfFile(*robot.nav2Tree);
      }
      for (auto& [key, yaml] : robot.plannerParameters) {
        if (key == "file") {
          std::string file = base::scalarText(yaml);
          moveIfFile(file);
          yaml = base::emitYaml(base::stringNode(file));
        }
      }
    }
    if (scenario.desktop.metrics.file) {
      moveIfFile(*scenario.desktop.metrics.file);
    }
  }

 private:
  /// Leaves the key out where the search for maps finds the same file.
  void moveMap(sim2d::Scenario& scenario, const Bundle& bundle) const {
    if (bundle.mapPath.empty()) {
      scenario.desktop.mapFile = "none";
      return;
    }
    scenario.desktop.mapFile.reset();
    const base::Result<std::string> found =
        sim2d::findMap(scenario, {to_, {}, {}, shippedMapsFolder()});
    std::error_code none;
    if (!found || found->empty() || !fs::equivalent(*found, bundle.mapPath, none)) {
      scenario.desktop.mapFile = pathFromScenario(to_, bundle.mapPath);
    }
  }

  /// Names of shipped files and single values are no files beside the scenario.
  void moveIfFile(std::string& file) const {
    const fs::path place = fs::path(from_).parent_path() / file;
    std::error_code none;
    if (fs::is_regular_file(place, none)) {
      file = pathFromScenario(to_, place.string());
    }
  }

  std::string from_, to_;
};

}  // namespace

base::Result<sim2d::Scenario> standaloneScenario(const RunRequest& request, const std::string& path,
                                                 const sim2d::ImageLoader& loader) {
  const RunSpec spec = specOf(request);
  const base::Result<RunSettings> settings = runSettingsOf(spec);
  if (!settings) {
    return settings.diagnostics();
  }
  const Bundle bundle = readBundle(spec, *settings, loader);
  base::Diagnostics errors = errorsOf(bundle.wrongOptions);
  base::append(errors, errorsOf(bundle.remarks));
  if (!errors.empty()) {
    return errors;
  }
  sim2d::Scenario scenario = *bundle.scenario;
  removeUnused(scenario);
  Relocation(spec.scenario, path).move(scenario, bundle);
  scenario.desktop.seed = request.seed;
  scenario.yamlBaseName = fs::path(path).stem().string();
  return scenario;
}

base::Result<ResultRow> runOfScenarioText(const std::string& text, const std::string& path,
                                          const RunRequest& request,
                                          const sim2d::ImageLoader& loader) {
  RunSpec spec;
  spec.scenario = path;
  spec.metrics = request.spec.metrics;
  spec.metricsProfile = request.spec.metricsProfile;
  spec.exact = request.spec.exact;
  spec.compat = request.spec.compat;
  base::Result<RunSettings> settings = runSettingsOf(spec);
  if (!settings) {
    return settings.diagnostics();
  }
  settings->code = request.spec.allowCode ? sim2d::ExternalCodePolicy::Allowed
                                          : sim2d::ExternalCodePolicy::Refused;
  std::optional<ResultRow> result;
  BatchJob job;
  job.runs = {0};
  job.execute = [&](std::size_t /*run*/, const BatchJob::ReportInputs& /*report*/) {
    FileCache files(loader);
    files.setScenario(path, sim2d::readScenarioText(text, path));
    return base::Result<ResultRow>(measureRun(readBundle(spec, *settings, files)));
  };
  job.storeRow = [&](std::size_t /*run*/, const ResultRow& row) {
    result = row;
    return base::Diagnostics();
  };
  job.wantsStop = [] { return false; };
  base::Diagnostics problems = runBatch(job);
  return result ? base::Result<ResultRow>(*result) : base::Result<ResultRow>(std::move(problems));
}

bool areEqualRuns(const ResultRow& a, const ResultRow& b) {
  return a.ok == b.ok && a.reason == b.reason && a.simulated == b.simulated && a.fields == b.fields;
}

}  // namespace app
