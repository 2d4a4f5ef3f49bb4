#include "editor/document/DocumentDiskState.h"

#include <filesystem>
#include <unistd.h>

#include "app/run/Bundle.h"
#include "editor/document/MapEdit.h"
#include "editor/document/PersonTree.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace editor {

QByteArray hashOfFile(const QString& file) {
  QFile opened(file);
  QCryptographicHash hash(QCryptographicHash::Sha1);
  return opened.open(QIODevice::ReadOnly) && hash.addData(&opened) ? hash.result() : QByteArray();
}

void DocumentDiskState::note(const QString& file, const std::string& content) {
  hashes[QFileInfo(file).absoluteFilePath()] =
      QCryptographicHash::hash(QByteArray::fromStdString(content), QCryptographicHash::Sha1);
}

void DocumentDiskState::recordFile(const QString& file) {
  hashes[QFileInfo(file).absoluteFilePath()] = hashOfFile(file);
}

base::Result<MapState> DocumentDiskState::readMap(const QString& yamlPath,
                                                  const std::optional<std::string>& rule) {
  const QString path = QFileInfo(yamlPath).absoluteFilePath();
  base::Result<sim2d::MapFile> map =
      app::readMapFile(path.toStdString(), rule.value_or(std::string()), loadMapImage);
  if (!map) {
    return map.diagnostics();
  }
  MapState state{std::make_shared<sim2d::OccupancyGrid>(std::move(map->grid)), path, false,
                 map.diagnostics()};
  maps[path] = state.grid;
  mapImage = QFileInfo(QString::fromStdString(map->imagePath)).absoluteFilePath();
  recordFile(path);
  recordFile(mapImage);
  return {std::move(state), map.diagnostics()};
}

bool DocumentDiskState::holds(const MapState& map) const {
  const auto onDisk = maps.find(map.path);
  return !map.path.isEmpty() &&
         (onDisk == maps.end() || onDisk->second == map.grid || *onDisk->second == *map.grid);
}

void DocumentDiskState::recordMapFiles(const SavePlan& plan, const DocumentDiskState& before) {
  if (plan.mapFiles.empty()) {
    mapImage = before.mapImage;
    for (const QString& file : {plan.mapPath, before.mapImage}) {
      const auto known = before.hashes.find(file);
      if (known != before.hashes.end()) {
        hashes.insert(*known);
      }
    }
  } else {
    mapImage = QString::fromStdString(plan.mapFiles.front().path);
    for (const base::FileContent& file : plan.mapFiles) {
      note(QString::fromStdString(file.path), file.content);
    }
  }
}

void DocumentDiskState::recordTree(const PlannedTree& written, bool isCustom, std::string generated,
                                   const TreeFileState* before) {
  note(QString::fromStdString(written.path), written.content);
  if (isCustom) {
    bases[written.human] = generated;
  }
  std::optional<bt::TreeStyle> style;
  if (!isCustom) {
    style = written.content == generated || before == nullptr ? bt::TreeStyle::Corrected
                                                              : before->style;
  }
  trees[written.human] = {written.path, written.content, style, std::move(generated)};
}

std::map<EntityId, int> linesOf(const sim2d::Scenario& scenario,
                                const sim2d::ScenarioReading& reading) {
  std::map<EntityId, int> result;
  const auto settings = reading.lines.find(kSettingsId);
  if (settings != reading.lines.end()) {
    result.insert(*settings);
  }
  forEachList(scenario, [&](EntityKind /*kind*/, const auto& list) {
    using Value = typename std::decay_t<decltype(list)>::value_type;
    const std::vector<Value>& asRead = listOf<Value>(reading.scenario);
    for (std::size_t i = 0; i < list.size() && i < asRead.size(); ++i) {
      const auto found = reading.lines.find(asRead[i].key);
      if (found != reading.lines.end()) {
        result[list[i].key] = found->second;
      }
    }
  });
  return result;
}

std::string baseNameOf(const QString& path) {
  return QFileInfo(path).completeBaseName().toStdString();
}

base::Diagnostics downgradedToWarnings(base::Diagnostics found) {
  for (base::Diagnostic& diagnostic : found) {
    if (diagnostic.severity == base::Severity::Error) {
      diagnostic.severity = base::Severity::Warning;
    }
  }
  return found;
}

namespace {

namespace fs = std::filesystem;

std::string relativeTo(const QString& scenarioPath, const QString& file) {
  const QDir folder = QFileInfo(scenarioPath).absoluteDir();
  return folder.relativeFilePath(QFileInfo(file).absoluteFilePath()).toStdString();
}

/// The path to the same file relative to the new folder. Unchanged if the file is missing but the
/// new folder contains a file with this name.
std::string relocatedPath(const std::string& path, const QDir& old, const QString& to) {
  const QString name = QString::fromStdString(path);
  const QString target = old.absoluteFilePath(name);
  const bool isBesideNew = QFileInfo(QFileInfo(to).absoluteDir(), name).exists();
  return !QFileInfo::exists(target) && isBesideNew ? path : relativeTo(to, target);
}

/// Adjusts paths that are relative to the scenario file to the new location.
void moveRelativePaths(sim2d::Scenario& scenario, const QString& from, const QString& to) {
  if (from.isEmpty() || QFileInfo(from).absoluteDir() == QFileInfo(to).absoluteDir()) {
    return;
  }
  const QDir old = QFileInfo(from).absoluteDir();
  if (scenario.desktop.mapFile && scenario.desktop.mapFile != "none") {
    scenario.desktop.mapFile = relocatedPath(*scenario.desktop.mapFile, old, to);
  }
  for (sim2d::Human& human : scenario.humans) {
    if (human.ours.tree) {
      human.ours.tree = relocatedPath(*human.ours.tree, old, to);
    }
  }
}

bool isSameFile(const QString& a, const QString& b) {
  return !a.isEmpty() && !b.isEmpty() &&
         QFileInfo(a).canonicalFilePath() == QFileInfo(b).canonicalFilePath();
}

/// The folder of the scenario, or ../maps if the folder is called scenarios.
QString mapFolderOf(const QString& scenario) {
  const QDir folder = QFileInfo(scenario).absoluteDir();
  return folder.dirName() == QLatin1String("scenarios")
             ? QDir::cleanPath(folder.filePath(QStringLiteral("../maps")))
             : folder.path();
}

std::string stemOf(const SavePlan& plan) {
  const std::string name = plan.scenario.yamlBaseName.value_or("");
  return name.empty() || name.find('/') != std::string::npos ? baseNameOf(plan.path) : name;
}

std::string treePathOf(const SavePlan& plan, const sim2d::Human& human) {
  const fs::path scenario = plan.path.toStdString();
  const fs::path file = human.ours.tree ? scenario.parent_path() / *human.ours.tree
                                        : fs::path(treeFolderOf(scenario.string())) /
                                              bt::treeFileName(stemOf(plan), human.id);
  return file.lexically_normal().string();
}

const PlannedTree* plannedAt(const SavePlan& plan, const std::string& path) {
  const auto found = std::find_if(plan.trees.begin(), plan.trees.end(),
                                  [&](const PlannedTree& tree) { return tree.path == path; });
  return found == plan.trees.end() ? nullptr : &*found;
}

bool isUnreadable(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && ::access(path.c_str(), R_OK) != 0;
}

/// Returns true if the tree is the one generated for the person in the scenario file on disk; such
/// a tree may be replaced without asking.
bool isGeneratedOnDisk(const std::string& xml, const sim2d::Scenario& onDisk, int humanId) {
  const sim2d::Human* human = onDisk.humanById(humanId);
  return human != nullptr && generatedStyle(xml, onDisk, *human).has_value();
}

}  // namespace

std::optional<std::string> textAt(const std::string& path) {
  base::Result<std::string> text = base::readTextFile(path);
  return text ? std::make_optional(*std::move(text)) : std::nullopt;
}

namespace {

bool isThere(const QString& file) {
  return file.isEmpty() || QFileInfo::exists(file);
}

}  // namespace

void ScenarioDocument::planMap(SavePlan& plan) const {
  if (map_.isMissing) {
    return;
  }
  const bool isInFile = disk_->holds(map_) && isThere(map_.path) && isThere(disk_->mapImage);
  if (isInFile && disk_->isMapFileChanged(scenario_)) {
    return;
  }
  if (!map_.grid->isEmpty() && !isInFile) {  // Drawn here, or the file is gone: gets a new file.
    const std::string name = baseNameOf(plan.path) + "_map";
    plan.mapPath = QDir(mapFolderOf(plan.path)).filePath(QString::fromStdString(name + ".yaml"));
    base::Result<std::vector<base::FileContent>> files =
        sim2d::mapFileContents(*map_.grid, plan.mapPath.toStdString());
    base::append(plan.problems, files.diagnostics());
    if (files) {
      plan.mapFiles = *std::move(files);
    }
    plan.scenario.map = name;
  }
  const bool isPlanned = !plan.mapFiles.empty();
  const sim2d::FileSearchPaths places{plan.path.toStdString(), {}, {}, search_.shippedMaps};
  for (const bool withFile : {true, false}) {
    if (!withFile) {
      plan.scenario.desktop.mapFile.reset();
    }
    const base::Result<std::string> found = sim2d::findMap(plan.scenario, places);
    const bool isOpenPlane = found && found->empty() && map_.grid->isEmpty();
    if (isOpenPlane || (found && isSameFile(QString::fromStdString(*found), plan.mapPath)) ||
        (isPlanned && !withFile && !found)) {  // No other file has this name: found after the save.
      return;
    }
  }
  plan.scenario.desktop.mapFile =
      map_.grid->isEmpty() ? "none" : relativeTo(plan.path, plan.mapPath);
}

void ScenarioDocument::planTrees(SavePlan& plan) const {
  for (sim2d::Human& human : plan.scenario.humans) {
    const bool isNamedOnly =
        human.ours.tree && !tree(human.key) && disk_->known(human.key) == nullptr;
    if (!human.listed || isNamedOnly) {
      continue;
    }
    const std::string text = effectiveTree(plan.scenario, human);
    std::string path = treePathOf(plan, human);
    const PlannedTree* same = plannedAt(plan, path);
    if (same != nullptr && same->content != text && human.ours.tree) {
      human.ours.tree.reset();  // The tree no longer equals that of the other person.
      path = treePathOf(plan, human);
      same = plannedAt(plan, path);
    }
    if (isUnreadable(path)) {
      const auto severity = tree(human.key) ? base::Severity::Error : base::Severity::Warning;
      plan.problems.push_back(base::withContext(
          human.name, base::problem(severity, "document.tree-unreadable", {}, path)));
      plan.unreadableTrees.insert(human.key);
    } else if (same == nullptr) {
      plan.trees.push_back({human.key, path, text});
    } else if (same->content != text) {
      plan.problems.push_back(
          base::withContext(human.name, base::warning("document.tree-not-saved", {}, path)));
    }
  }
}

std::string ScenarioDocument::effectiveTree(const sim2d::Scenario& scenario,
                                            const sim2d::Human& human) const {
  if (std::optional<std::string> own = tree(human.key)) {
    return *std::move(own);
  }
  const TreeFileState* known = disk_->known(human.key);
  std::string generated = generatedTree(scenario, human);
  if (known == nullptr || !known->style) {
    return generated;
  }
  if (known->generated == generated) {
    return known->content;  // Keeps the layout and style of the file.
  }
  return *known->style == bt::TreeStyle::Corrected ? generated
                                                   : generatedTree(scenario, human, *known->style);
}

SavePlan ScenarioDocument::planSave(const QString& path) const {
  SavePlan plan;
  plan.path = QFileInfo(path).absoluteFilePath();
  plan.scenario = scenario_;
  plan.mapPath = map_.path;
  if (isReadOnly() && plan.path == path_) {
    plan.problems.push_back(base::error("document.read-in-part", {}, path.toStdString()));
    return plan;
  }
  moveRelativePaths(plan.scenario, path_, plan.path);
  if (plan.path != path_) {
    plan.scenario.yamlBaseName = baseNameOf(plan.path);
  }
  planMap(plan);
  planTrees(plan);
  return plan;
}

std::vector<TreeConflict> ScenarioDocument::treeConflicts(const QString& path) const {
  const SavePlan plan = planSave(path);
  std::vector<TreeConflict> questions;
  std::optional<sim2d::ScenarioReading> there;
  for (const PlannedTree& planned : plan.trees) {
    const auto& human = plan.scenario.humans[static_cast<std::size_t>(indexOf(planned.human))];
    const std::optional<std::string> onDisk = textAt(planned.path);
    const TreeFileState* known = disk_->known(planned.human);
    const bool wasRead = known != nullptr && known->path == planned.path;
    const bool isKnown = wasRead && onDisk == known->content;
    TreeConflict question{human.key, human.name, planned.path, {}, planned.content};
    if (onDisk && *onDisk != planned.content && !isKnown) {
      if (!there) {
        there = sim2d::readScenario(plan.path.toStdString());
      }
      // A file that has changed since it was read contains an external edit, even if only a comment
      // differs.
      if (wasRead || (!generatedStyle(*onDisk, plan.scenario, human) &&
                      !isGeneratedOnDisk(*onDisk, there->scenario, human.id))) {
        question.mine = *onDisk;
        questions.push_back(std::move(question));
        continue;
      }
    }
    if (isTreeOutdated(planned.human)) {
      question.mine = planned.content;
      question.replacement = generatedTree(plan.scenario, human);
      question.why = TreeConflict::Why::BehaviourChanged;
      questions.push_back(std::move(question));
    }
  }
  return questions;
}

}  // namespace editor
