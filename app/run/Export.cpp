#include "app/run/Export.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "app/run/Nav2Robots.h"
#include "app/run/PlannerFiles.h"
#include "bt/engine/Program.h"
#include "bt/human/TreeBehavior.h"
#include "bt/human/TreeExport.h"
#include "bt/human/TreeLoader.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/world/Registries.h"

namespace app {

namespace {

namespace fs = std::filesystem;

/// A map that every wrapper reads unchanged: the image is in the same folder and the thresholds are
/// the original ones.
bool isPlainMap(const sim2d::MapDescription& map) {
  return map.mode == sim2d::MapMode::Trinary && !map.negate && map.occupiedThreshold == 0.65 &&
         map.freeThreshold == 0.196 && map.image.find('/') == std::string::npos;
}

/// Assembles the files of one export.
class ExportPlanBuilder {
 public:
  ExportPlanBuilder(const Bundle& source, const ExportRequest& request)
      : source_(source), request_(request), library_(bt::humanNodes()) {}

  ExportPlan run() {
    const sim2d::TargetInfo& target = *sim2d::exportTarget(request_.target);
    base_ = sim2d::baseName(*source_.scenario, source_.path);
    checkSource();
    if (base::hasErrors(plan_.report)) {
      return std::move(plan_);
    }
    isNative_ = target.target == sim2d::ExportTarget::Native;
    sim2d::ExportOptions options;
    options.dialect = request_.dialect;
    options.baseName = base_;
    options.mapName = mapName();
    exported_ = sim2d::exportScenario(*source_.scenario, target, options);
    plan_.startCommand = exported_.startCommand;
    base::append(plan_.report, exported_.report);
    addFile("scenarios/" + base_ + ".yaml", exported_.text);
    addTrees();
    addMap(options.mapName);
    if (isNative_) {
      addPlannerFiles();
    }
    checkSourceNotOverwritten();
    for (base::Diagnostic& problem : plan_.report) {
      problem.file = problem.file.empty() ? source_.path : problem.file;
    }
    return std::move(plan_);
  }

 private:
  void warn(const sim2d::Human& human, base::Diagnostic diagnostic) {
    diagnostic.entity = human.key;
    plan_.report.push_back(base::withContext(human.name, std::move(diagnostic)));
  }

  std::string mapName() const {
    if (source_.map == nullptr || source_.map->isEmpty()) {
      return {};
    }
    const std::string named = sim2d::mapBaseName(source_.scenario->map.value_or(""));
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
    for (base::Diagnostic problem : source_.remarks) {
      problem.severity = base::Severity::Warning;
      problem.line = problem.column = 0;
      problem.entity = {};
      plan_.report.push_back(std::move(problem));
    }
    const base::Diagnostics meaning =
        sim2d::checkScenario(*source_.scenario, sim2d::makeSurroundings(*source_.scenario, {}),
                             source_.path, sim2d::knownNames(builtinRegistries()));
    base::append(plan_.report, errorsOf(meaning));
  }

  void addFile(const std::string& name, std::string content) {
    const std::string path = (fs::path(request_.folder) / name).lexically_normal().string();
    if (!paths_.insert(path).second) {
      return;
    }
    const ExportPlan::State state = fileStateOf(path, content);
    plan_.files.push_back({name, {path, std::move(content)}, state});
  }

  void addTrees() {
    const bt::NodeCatalogue& catalogue = library_.catalogue();
    for (std::size_t i = 0; i < source_.scenario->humans.size(); ++i) {
      const sim2d::Human& before = source_.scenario->humans[i];
      const sim2d::Human& human = exported_.scenario.humans[i];
      if (!human.listed) {
        continue;
      }
      const std::string file = "behavior_trees/" + bt::treeFileName(base_, human.id);
      const auto own = source_.trees.find(before.name);
      if (own == source_.trees.end() || own->second.isGenerated()) {
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

  void copyTree(const std::string& file, const sim2d::Human& human, const bt::TreeSource& tree) {
    const base::Result<bt::TreeFile> read = bt::readTreeText(*tree.text, tree.path);
    base::append(plan_.report, read.diagnostics());
    if (!read) {
      return;
    }
    const int changed = addRenumbered(file, *read, *tree.text);
    if (changed > 0) {
      warn(human, base::warning("export.tree-renumbered", {changed}, tree.path));
    }
    for (const std::string& node : bt::desktopOnlyNodes(*read, library_.catalogue())) {
      if (!isNative_) {
        warn(human, base::warning("export.own-node", {node}, tree.path));
      }
    }
    copyIncluded(*read, tree.path);
  }

  /// Adds a tree with the ids of the export; returns how many have changed.
  int addRenumbered(const std::string& file, const bt::TreeFile& tree, const std::string& text) {
    int changed = 0;
    addFile(file, bt::renumbered(tree, text, {exported_.goals, exported_.people},
                                 library_.catalogue(), changed));
    return changed;
  }

  /// Copies the files that a tree includes, recursively, with the ids of the export.
  void copyIncluded(const bt::TreeFile& tree, const std::string& treePath) {
    for (const bt::Include& include : tree.includes) {
      if (include.path.empty() || include.path == bt::kRegularNavFile || treePath.empty() ||
          !included_.insert(include.path).second) {
        continue;
      }
      const std::string path = (fs::path(treePath).parent_path() / include.path).string();
      const base::Result<std::string> text = base::readTextFile(path);
      if (!text || include.path.find('/') != std::string::npos) {
        plan_.report.push_back(
            base::warning("export.include-not-copied", {include.path}, treePath));
        continue;
      }
      const base::Result<bt::TreeFile> inner = bt::readTreeText(*text, path);
      base::append(plan_.report, inner.diagnostics());
      if (inner) {
        addRenumbered("behavior_trees/" + include.path, *inner, *text);
        copyIncluded(*inner, path);
      }
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
    const base::Result<std::string> image = base::readTextFile(
        (fs::path(source_.mapPath).parent_path() / map->image).string(), base::kMaxRecord);
    if (!image) {
      return false;
    }
    addFile("maps/" + name + ".yaml", *yaml);
    addFile("maps/" + map->image, *image);
    return true;
  }

  /// Copies the files of planners below the scenario's folder to the same places beside the
  /// exported scenario. Absolute paths and shipped files need no copy.
  void addPlannerFiles() {
    const fs::path folder = plannerFolderOf(source_.path);
    std::vector<std::string> files = filesThatPlannersRead(*source_.scenario, source_.path);
    for (std::string& file : nav2FilesOf(*source_.scenario, source_.path)) {
      files.push_back(std::move(file));
    }
    for (const ExternalCode& code : externalCodeOf(*source_.scenario)) {
      if (const auto file = codeFileOf(code, source_.path); file && code.key != kCommandKey) {
        files.push_back(*file);
      }
    }
    for (const std::string& file : files) {
      const fs::path place = fs::path(file).lexically_relative(folder);
      if (!place.empty() && *place.begin() != "..") {
        copyPlannerFile(file, place);
      }
    }
    sim2d::forEachListed(source_.scenario->robots, [&](const sim2d::Robot& robot) {
      for (const std::string& file : filesNamedBy(robot)) {
        if (base::startsWith(fs::path(file).lexically_normal().string(), "../")) {
          reportNotCopied(robot, file);
        }
      }
    });
  }

  void copyPlannerFile(const std::string& file, const fs::path& place) {
    const base::Result<std::string> content = base::readTextFile(file, base::kMaxRecord);
    if (content) {
      addFile((fs::path("scenarios") / place).string(), *content);
      return;
    }
    for (base::Diagnostic problem : content.diagnostics()) {
      problem.severity = base::Severity::Warning;  // the scenario itself can be exported
      plan_.report.push_back(std::move(problem));
    }
  }

  void reportNotCopied(const sim2d::Robot& robot, const std::string& file) {
    base::Diagnostic problem = base::warning("export.file-not-copied", {robot.name, file});
    problem.entity = robot.key;
    plan_.report.push_back(std::move(problem));
  }

  /// Refuses to overwrite the scenario that is exported.
  void checkSourceNotOverwritten() {
    for (const ExportPlan::File& file : plan_.files) {
      std::error_code ignored;
      const bool isSource = file.state == ExportPlan::State::Replaced && !source_.path.empty() &&
                            fs::equivalent(file.content.path, source_.path, ignored);
      if (isSource) {
        plan_.report.push_back(base::error("export.over-source", {}, file.content.path));
      }
    }
  }

  const Bundle& source_;
  const ExportRequest& request_;
  bt::NodeLibrary library_;
  ExportPlan plan_;
  sim2d::ExportedScenario exported_;
  std::string base_;
  bool isNative_ = false;
  std::set<std::string> paths_;
  std::set<std::string> included_;  // paths as in the trees
};

}  // namespace

ExportPlan::State fileStateOf(const std::string& path, const std::string& content) {
  const base::Result<std::string> present = base::readTextFile(path);
  std::error_code ignored;
  return !present && !fs::exists(path, ignored) ? ExportPlan::State::New
         : present && *present == content       ? ExportPlan::State::Unchanged
                                                : ExportPlan::State::Replaced;
}

const char* fileStateName(ExportPlan::State state) {
  constexpr const char* kNames[] = {"written", "replaced", "unchanged"};
  return kNames[static_cast<int>(state)];
}

base::Diagnostics treeCompatibilityNotes(const Bundle& source) {
  base::Diagnostics notes;
  std::set<std::string> seen;  // several agents may share a file
  const bt::NodeLibrary library = bt::humanNodes();
  for (const sim2d::Human& human : source.scenario->humans) {
    const auto file = source.trees.find(human.name);
    const bool isOwn = human.listed && file != source.trees.end() && !file->second.isGenerated();
    if (!isOwn || (!file->second.path.empty() && !seen.insert(file->second.path).second)) {
      continue;
    }
    if (const base::Result<bt::TreeTable> table =
            bt::treeOf(human, source.trees, *source.scenario)) {
      base::append(notes, bt::differencesFromBtCpp(*table, library));
    }
  }
  return notes;
}

ExportPlan planExport(const Bundle& source, const ExportRequest& request) {
  ExportPlan plan = ExportPlanBuilder(source, request).run();
  base::append(plan.report, treeCompatibilityNotes(source));
  return plan;
}

base::Diagnostics writeExport(const ExportPlan& plan) {
  std::vector<base::FileContent> files;
  for (const ExportPlan::File& file : plan.files) {
    if (file.state != ExportPlan::State::Unchanged) {
      files.push_back(file.content);
    }
  }
  return base::writeFilesAtomically(files);
}

base::Result<Bundle> readExportSource(const RunSpec& spec, const sim2d::ImageLoader& loader) {
  Bundle bundle = readBundle(spec, {}, loader);
  base::Diagnostics reported;
  for (base::Diagnostic remark : std::exchange(bundle.remarks, {})) {
    // A scenario can be exported without its map, but a map given as option must exist.
    const bool isOfMap = bundle.isWhole && remark.code != "option.no-trees-folder";
    if (isOfMap && spec.map.empty() && remark.severity == base::Severity::Error) {
      remark.severity = base::Severity::Warning;
    }
    if (remark.code != "run.no-tree-files") {  // the export generates them
      reported.push_back(std::move(remark));
    }
  }
  // The export itself reports the remaining warnings.
  base::append(reported, errorsOf(check(bundle, CheckDepth::Meaning).problems));
  if (base::hasErrors(reported)) {
    return reported;
  }
  for (auto& [person, tree] : bundle.trees) {
    if (tree.isGenerated()) {
      continue;
    }
    const base::Result<std::string> text = base::readTextFile(tree.path);
    if (!text) {
      return text.diagnostics();
    }
    tree.text = *text;
  }
  return {std::move(bundle), std::move(reported)};
}

std::vector<GroupedDiagnostic> groupedByAgents(const base::Diagnostics& report) {
  std::vector<GroupedDiagnostic> lines;
  using MessageKey =
      std::tuple<base::Severity, std::string_view, decltype(base::Diagnostic::values)>;
  std::map<MessageKey, std::size_t> known;  // messages about agents, without the agent's name
  for (const base::Diagnostic& diagnostic : report) {
    const std::string name = diagnostic.value("where");
    if (diagnostic.entity.kind != base::EntityKind::Human || name.empty()) {
      lines.push_back({diagnostic, {}});
      continue;
    }
    const auto [place, isNew] = known.try_emplace(
        {diagnostic.severity, diagnostic.code, base::withNewContext({}, diagnostic).values},
        lines.size());
    if (isNew) {
      lines.push_back({diagnostic, {}});
    }
    std::vector<std::string>& people = lines[place->second].people;
    if (std::find(people.begin(), people.end(), name) == people.end()) {
      people.push_back(name);
    }
  }
  for (GroupedDiagnostic& line : lines) {
    if (line.people.size() < 2) {
      line.people.clear();
      continue;
    }
    line.diagnostic =
        base::withNewContext(std::to_string(line.people.size()) + " people", line.diagnostic);
    line.diagnostic.entity = {};
  }
  return lines;
}

}  // namespace app
