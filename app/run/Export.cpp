#include "app/run/Export.h"

#include <filesystem>
#include <set>

#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "bt/human/HumanNodes.h"
#include "bt/human/TreeExport.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Problems.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapFiles.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

namespace fs = std::filesystem;

/// A map that every wrapper reads as it is: its image beside it, thresholds of the original.
bool isPlainMap(const sim2d::MapDescription& map) {
  return map.mode == sim2d::MapMode::Trinary && !map.negate && map.occupiedThreshold == 0.65 &&
         map.freeThreshold == 0.196 && map.image.find('/') == std::string::npos;
}

/// Puts the files of one export together.
class Planner {
 public:
  Planner(const ExportSource& source, const ExportRequest& request)
      : source_(source), request_(request), library_(bt::humanNodes()) {}

  ExportPlan run() {
    const sim2d::TargetInfo& target = *sim2d::exportTarget(request_.target);
    base_ = baseName();
    checkSource();
    if (base::hasErrors(plan_.report)) {
      return std::move(plan_);
    }
    isNative_ = target.target == sim2d::ExportTarget::Native;
    sim2d::ExportOptions options;
    options.target = target.target;
    options.dialect = request_.dialect;
    options.baseName = base_;
    options.mapName = mapName();
    exported_ = sim2d::exportScenario(source_.scenario, options);
    plan_.startCommand = exported_.startCommand;
    base::append(plan_.report, exported_.report);
    addFile("scenarios/" + base_ + ".yaml", exported_.text);
    addTrees();
    addMap(options.mapName);
    checkNotOverSource();
    for (base::Diagnostic& problem : plan_.report) {
      problem.file = problem.file.empty() ? source_.path : problem.file;
    }
    return std::move(plan_);
  }

 private:
  void warn(const sim2d::Human& human, base::Diagnostic said) {
    said.entity = human.key;
    plan_.report.push_back(base::within(human.name, std::move(said)));
  }

  std::string baseName() const {
    if (!request_.baseName.empty()) {
      return request_.baseName;
    }
    const std::string stem = fs::path(source_.path).stem().string();
    return source_.scenario.yamlBaseName.value_or(stem.empty() ? "scenario" : stem);
  }

  std::string mapName() const {
    if (source_.map == nullptr || source_.map->isEmpty()) {
      return {};
    }
    const std::string named = sim2d::mapBaseName(source_.scenario.map.value_or(""));
    const std::string stem = fs::path(source_.mapPath).stem().string();
    return !named.empty() ? named : !stem.empty() ? stem : base_ + "_map";
  }

  void checkSource() {
    if (base_.empty() || base_ == "." || base_ == ".." || base_.find('/') != std::string::npos ||
        base_.find('\0') != std::string::npos) {
      plan_.report.push_back(base::error("option.bad-base-name", {base_}, source_.path));
    }
    if (source_.comments > 0) {
      plan_.report.push_back(base::warning(
          "export.comments-lost",
          {std::to_string(source_.comments) + (source_.comments == 1 ? " comment" : " comments")},
          source_.path));
    }
    for (base::Diagnostic problem : source_.problems) {
      problem.severity = base::Severity::Warning;
      problem.line = problem.column = 0;
      problem.entity = {};
      plan_.report.push_back(std::move(problem));
    }
    const base::Diagnostics meaning = sim2d::checkScenario(
        source_.scenario, sim2d::makeSurroundings(source_.scenario, {}), source_.path);
    for (const base::Diagnostic& problem : meaning) {
      if (problem.severity == base::Severity::Error) {
        plan_.report.push_back(problem);
      }
    }
  }

  void addFile(const std::string& name, std::string content) {
    const std::string path = (fs::path(request_.folder) / name).lexically_normal().string();
    if (!paths_.insert(path).second) {
      return;
    }
    const base::Result<std::string> present = base::readTextFile(path);
    std::error_code ignored;
    const ExportPlan::State state = !present && !fs::exists(path, ignored) ? ExportPlan::State::New
                                    : present && *present == content ? ExportPlan::State::Unchanged
                                                                     : ExportPlan::State::Replaced;
    plan_.files.push_back({{path, std::move(content)}, state});
  }

  void addTrees() {
    const bt::NodeCatalogue& catalogue = library_.catalogue();
    for (std::size_t i = 0; i < source_.scenario.humans.size(); ++i) {
      const sim2d::Human& before = source_.scenario.humans[i];
      const sim2d::Human& human = exported_.scenario.humans[i];
      if (!human.listed) {
        continue;
      }
      const std::string file = "behavior_trees/" + bt::treeFileName(base_, human.id);
      const auto own = source_.trees.find(before.name);
      if (own == source_.trees.end()) {
        addFile(file, bt::makeTreeText(exported_.scenario, human, request_.style, catalogue));
      } else {
        copyTree(file, before, own->second);
      }
    }
    const std::string included = std::string("behavior_trees/") + bt::kRegularNavFile;
    std::error_code ignored;
    if (!fs::exists(fs::path(request_.folder) / included, ignored)) {
      addFile(included, bt::regularNavText(catalogue));
    }
  }

  void copyTree(const std::string& file, const sim2d::Human& human,
                const ExportSource::Tree& tree) {
    const base::Result<bt::TreeFile> read = bt::readTreeText(tree.text, tree.path);
    base::append(plan_.report, read.diagnostics());
    if (!read) {
      return;
    }
    int changed = 0;
    addFile(file, bt::renumbered(*read, tree.text, {exported_.goals, exported_.people},
                                 library_.catalogue(), changed));
    if (changed > 0) {
      warn(human, base::warning("export.tree-renumbered", {changed}, tree.path));
    }
    for (const std::string& node : bt::ownNodes(*read, library_.catalogue())) {
      if (!isNative_) {
        warn(human, base::warning("export.own-node", {node}, tree.path));
      }
    }
    copyIncluded(*read, tree);
  }

  void copyIncluded(const bt::TreeFile& tree, const ExportSource::Tree& source) {
    for (const bt::Include& include : tree.includes) {
      if (include.path.empty() || include.path == bt::kRegularNavFile || source.path.empty()) {
        continue;
      }
      const base::Result<std::string> text =
          base::readTextFile((fs::path(source.path).parent_path() / include.path).string());
      if (!text || include.path.find('/') != std::string::npos) {
        plan_.report.push_back(
            base::warning("export.include-not-copied", {include.path}, source.path));
        continue;
      }
      addFile("behavior_trees/" + include.path, *text);
    }
  }

  void addMap(const std::string& name) {
    if (name.empty()) {
      return;
    }
    if (!source_.mapPath.empty() && copyMap(name)) {
      return;
    }
    const std::string yaml = (fs::path(request_.folder) / "maps" / (name + ".yaml")).string();
    const base::Result<std::vector<base::FileContent>> files =
        sim2d::mapFileContents(*source_.map, yaml);
    base::append(plan_.report, files.diagnostics());
    if (files) {
      for (const base::FileContent& file : *files) {
        addFile("maps/" + fs::path(file.path).filename().string(), file.content);
      }
    }
  }

  bool copyMap(const std::string& name) {
    const base::Result<std::string> yaml = base::readTextFile(source_.mapPath);
    if (!yaml) {
      return false;
    }
    const base::Result<sim2d::MapDescription> map =
        sim2d::parseMapDescription(*yaml, source_.mapPath);
    if (!map || !isPlainMap(*map)) {
      return false;
    }
    const base::Result<std::string> image =
        base::readTextFile((fs::path(source_.mapPath).parent_path() / map->image).string());
    if (!image) {
      return false;
    }
    addFile("maps/" + name + ".yaml", *yaml);
    addFile("maps/" + map->image, *image);
    return true;
  }

  /// The file that is converted is not replaced by something else.
  void checkNotOverSource() {
    for (const ExportPlan::File& file : plan_.files) {
      std::error_code ignored;
      const bool isSource = file.state == ExportPlan::State::Replaced && !source_.path.empty() &&
                            fs::equivalent(file.content.path, source_.path, ignored);
      if (isSource) {
        plan_.report.push_back(base::error("export.over-source", {}, file.content.path));
      }
    }
  }

  const ExportSource& source_;
  const ExportRequest& request_;
  bt::NodeLibrary library_;
  ExportPlan plan_;
  sim2d::ExportedScenario exported_;
  std::string base_;
  bool isNative_ = false;
  std::set<std::string> paths_;
};

}  // namespace

const char* stateName(ExportPlan::State state) {
  switch (state) {
    case ExportPlan::State::New:
      return "written";
    case ExportPlan::State::Replaced:
      return "replaced";
    case ExportPlan::State::Unchanged:
      break;
  }
  return "unchanged";
}

ExportPlan planExport(const ExportSource& source, const ExportRequest& request) {
  return Planner(source, request).run();
}

base::Diagnostics writeExport(const ExportPlan& plan) {
  std::vector<base::FileContent> files;
  for (const ExportPlan::File& file : plan.files) {
    if (file.state != ExportPlan::State::Unchanged) {
      files.push_back(file.content);
    }
  }
  return base::writeFilesTogether(files);
}

base::Result<ExportSource> readExportSource(const std::string& scenario, const std::string& map,
                                            const std::string& trees,
                                            const sim2d::ImageLoader& loader) {
  sim2d::ScenarioReading reading = sim2d::readScenario(scenario);
  base::Diagnostics problems = reading.diagnostics;
  if (!reading.ok()) {
    return problems;
  }
  ExportSource source;
  source.path = scenario;
  source.comments = reading.commentCount;
  source.scenario = std::move(reading.scenario);
  const sim2d::FilePlaces places{scenario, map, trees, shippedMapsFolder()};
  // without its map a scenario can still be handed on; one that was asked for must be there
  const auto addMapProblems = [&](const base::Diagnostics& found) {
    for (base::Diagnostic problem : found) {
      problem.severity = map.empty() ? base::Severity::Warning : problem.severity;
      problems.push_back(std::move(problem));
    }
  };
  const base::Result<std::string> mapPath = sim2d::findMap(source.scenario, places);
  if (mapPath && !mapPath->empty()) {
    base::Result<sim2d::MapFile> file =
        readMapFile(*mapPath, source.scenario.desktop.mapRule.value_or("humble"), loader);
    addMapProblems(file.diagnostics());
    if (file) {
      source.mapPath = file->path;
      source.map = std::make_shared<sim2d::OccupancyGrid>(std::move(file->grid));
    }
  } else {
    addMapProblems(mapPath.diagnostics());
  }
  for (const sim2d::Human& human : source.scenario.humans) {
    const std::string path = sim2d::findTree(source.scenario, human, places);
    if (!path.empty() && human.listed) {
      const base::Result<std::string> text = base::readTextFile(path);
      base::append(problems, text.diagnostics());
      if (text) {
        source.trees[human.name] = {*text, path};
      }
    }
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::move(source), std::move(problems)};
}

}  // namespace app
