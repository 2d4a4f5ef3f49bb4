#include "app/run/Bundle.h"
#include "editor/document/Autosave.h"
#include "editor/document/DocumentDiskState.h"
#include "editor/document/EditCommands.h"
#include "editor/document/MapEdit.h"
#include "editor/document/PersonTree.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace editor {

namespace {

/// Returns true if the file exists and its name has a YAML suffix.
bool isYaml(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  return QFileInfo(path).isReadable() &&
         (suffix == QLatin1String("yaml") || suffix == QLatin1String("yml"));
}

/// Replaces the problems of the opened file by those of the saved file.
void replaceFirst(base::Diagnostics& problems, std::size_t count, const base::Diagnostics& fresh) {
  const auto begin = problems.begin();
  problems.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  problems.insert(problems.begin(), fresh.begin(), fresh.end());
}

}  // namespace

void ScenarioDocument::emitFileSignals() {
  Q_EMIT pathChanged();
  Q_EMIT dirtyChanged(isDirty());
  Q_EMIT issuesChanged(issues());
}

sim2d::FileSearchPaths ScenarioDocument::places() const {
  sim2d::FileSearchPaths places = search_;
  places.scenarioPath = path_.toStdString();
  return places;
}

base::Diagnostics ScenarioDocument::open(const QString& path) {
  sim2d::ScenarioReading reading = sim2d::readScenario(path.toStdString());
  const bool isBeginning = !reading.ok() && isBlank(reading.scenario);
  if (isBeginning) {
    reading = sim2d::readValidPart(path.toStdString());
    const bool isEmpty = isBlank(scenario_) && !isDirty();
    if (isBlank(reading.scenario) && !(isEmpty && isYaml(path))) {
      return reading.diagnostics;
    }
  }
  const bool isWhole = reading.ok();
  resetScenario(std::move(reading.scenario));
  path_ = QFileInfo(path).absoluteFilePath();
  neverSaved_ = false;
  commentCount_ = reading.commentCount;
  disk_->recordFile(path_);
  disk_->mapFile = scenario_.desktop.mapFile;
  disk_->lines = std::move(reading.lines);
  disk_->readOnly = !isWhole;
  disk_->isBeginning = isBeginning;
  loadDiagnostics_ = std::move(reading.diagnostics);
  disk_->readProblemCount = loadDiagnostics_.size();
  if (isWhole || !isBlank(scenario_)) {
    loadMap();
  } else {
    setMap(std::make_shared<sim2d::OccupancyGrid>());  // One problem is enough.
  }
  base::append(loadDiagnostics_, loadTrees());
  base::Diagnostics told = loadDiagnostics_;
  // A scenario can be edited without its map, but a map that was requested explicitly must exist.
  base::append(told,
               search_.mapOption.empty() ? downgradedToWarnings(map_.problems) : map_.problems);
  replaced();
  emitFileSignals();
  return told;
}

/// Also reports why the map is missing, as `check` does.
void ScenarioDocument::loadMap() {
  const base::Result<std::string> found = sim2d::findMap(scenario_, places());
  MapState map{std::make_shared<sim2d::OccupancyGrid>(), {}, !found, found.diagnostics()};
  sim2d::addMapLocation(map.problems, path_.toStdString());
  if (found && !found->empty()) {
    base::Result<MapState> read =
        disk_->readMap(QString::fromStdString(*found), scenario_.desktop.mapRule);
    if (read) {
      map = *std::move(read);
    } else {
      map.isMissing = true;
      map.problems = read.diagnostics();
    }
  }
  exchangeMap(std::move(map));
}

base::Diagnostics ScenarioDocument::openMap(const QString& yamlPath) {
  base::Result<MapState> map = disk_->readMap(yamlPath, scenario_.desktop.mapRule);
  base::Diagnostics problems = map.diagnostics();
  if (map) {
    putMap(*std::move(map));
  }
  return problems;
}

base::Diagnostics ScenarioDocument::newOnMap(const QString& yamlPath) {
  DocumentDiskState read;
  base::Result<MapState> map = read.readMap(yamlPath, {});
  base::Diagnostics problems = map.diagnostics();
  if (map) {
    clear();
    *disk_ = std::move(read);
    putMap(*std::move(map));
    undoStack_.clear();  // The user has changed nothing.
  }
  return problems;
}

void ScenarioDocument::putMap(MapState map) {
  ScenarioSettings settings = std::get<ScenarioSettings>(*entity(kSettingsId));
  settings.map = baseNameOf(map.path);
  settings.desktop.mapFile.reset();
  pushMap(*this, std::move(map), std::move(settings), tr("Change map"));
}

MapState ScenarioDocument::exchangeMap(MapState map) {
  Q_ASSERT(map.grid != nullptr);
  MapState old = std::exchange(map_, std::move(map));
  if (map_.grid != old.grid) {
    stopMapTasks();
  }
  Q_EMIT mapChanged();
  if (!map_.problems.empty() || !old.problems.empty()) {
    Q_EMIT issuesChanged(issues());
  }
  return old;
}

base::Diagnostics ScenarioDocument::loadTrees() {
  base::Diagnostics problems;
  for (const sim2d::Human& human : scenario_.humans) {
    const std::string file = sim2d::findTree(scenario_, human, places());
    if (file.empty()) {
      continue;
    }
    const base::Result<std::string> text = base::readTextFile(file);
    if (!text) {
      disk_->unreadableTrees.insert(human.key);
      base::append(problems, human.listed ? base::Diagnostics() : text.diagnostics());
      continue;  // The live check reports missing trees of active people until the file exists.
    }
    disk_->note(QString::fromStdString(file), *text);
    TreeFileState known{file, *text, bt::TreeStyle::Corrected, generatedTree(scenario_, human)};
    if (*text != known.generated) {  // Otherwise unchanged since the save; the style is known.
      known.style = generatedStyle(*text, scenario_, human);
    }
    if (!known.style) {
      trees_[human.key] = *text;
      disk_->bases[human.key] = known.generated;
    }
    disk_->trees[human.key] = std::move(known);
  }
  return downgradedToWarnings(std::move(problems));
}

DocumentSnapshot ScenarioDocument::snapshot() const {
  const bool mapIsInFile =
      map_.grid->isEmpty() || (disk_->maps.count(map_.path) > 0 && disk_->holds(map_));
  return {
      scenario_, trees_, map_, mapIsInFile, path_, isReadOnly(), QDateTime::currentDateTimeUtc()};
}

void ScenarioDocument::restoreMap(const DocumentSnapshot& snapshot) {
  if (snapshot.map.isMissing) {
    loadMap();  // The file may exist by now.
    return;
  }
  exchangeMap(snapshot.map);
  if (snapshot.map.path.isEmpty()) {
    return;
  }
  base::Result<MapState> onDisk = disk_->readMap(snapshot.map.path, scenario_.desktop.mapRule);
  if (!snapshot.mapIsInFile) {
    map_.path = onDisk ? map_.path : QString();  // The file is gone: it gets a new one.
  } else if (onDisk) {
    exchangeMap(*std::move(onDisk));
  } else {
    exchangeMap({std::make_shared<sim2d::OccupancyGrid>(), {}, true, onDisk.diagnostics()});
  }
}

void ScenarioDocument::restore(DocumentSnapshot snapshot, bool isSaved) {
  resetScenario(std::move(snapshot.scenario));
  path_ = snapshot.path;
  neverSaved_ = !isSaved;
  disk_->readOnly = snapshot.readOnly;
  restoreMap(snapshot);
  if (!path_.isEmpty()) {
    disk_->recordFile(path_);
    loadDiagnostics_ = loadTrees();
  }
  trees_ = std::move(snapshot.trees);
  for (const auto& [id, text] : trees_) {
    if (const sim2d::Human* person = human(id)) {
      disk_->bases[id] = generatedTree(scenario_, *person);
    }
  }
  replaced();
  emitFileSignals();
}

/// The decisions about trees can be undone like any other edit.
void ScenarioDocument::applyTreeAnswers(const QString& path, const TreeReplacements& replaced) {
  for (const TreeConflict& question : treeConflicts(path)) {
    const bool keeps = replaced.count(question.human) == 0;
    if (question.why == TreeConflict::Why::ChangedOnDisk && keeps) {
      pushTrees(*this, {{question.human, question.mine}},
                tr("Keep the tree file of %1").arg(QString::fromStdString(question.name)));
    } else if (question.why == TreeConflict::Why::BehaviourChanged && !keeps) {
      pushTrees(*this, {{question.human, std::nullopt}},
                tr("Use the generated tree of %1").arg(QString::fromStdString(question.name)));
    }
  }
}

base::Diagnostics ScenarioDocument::save(const QString& path, const TreeReplacements& replaced) {
  applyTreeAnswers(path, replaced);
  SavePlan plan = planSave(path);
  if (base::hasErrors(plan.problems)) {
    return plan.problems;
  }
  std::vector<base::FileContent> files = plan.mapFiles;
  for (const PlannedTree& tree : plan.trees) {
    files.push_back({tree.path, tree.content});
  }
  if (!plan.scenario.humans.empty()) {
    if (auto included = missingIncludedTree(treeFolderOf(plan.path.toStdString()))) {
      files.push_back(*std::move(included));
    }
  }
  files.push_back({plan.path.toStdString(), sim2d::writeScenario(plan.scenario)});
  files.erase(std::remove_if(
                  files.begin(), files.end(),
                  [](const base::FileContent& file) { return textAt(file.path) == file.content; }),
              files.end());
  base::append(plan.problems, base::writeFilesAtomically(files));
  base::Diagnostics problems = plan.problems;
  if (!base::hasErrors(problems)) {
    adoptSaved(std::move(plan));
  }
  return problems;
}

void ScenarioDocument::adoptSaved(SavePlan plan) {
  const bool isChanged = !(plan.scenario == scenario_);
  const bool keepsMapFile = disk_->holds(map_) && disk_->isMapFileChanged(scenario_);
  scenario_ = std::move(plan.scenario);
  path_ = plan.path;
  map_.path = plan.mapPath;
  neverSaved_ = false;
  commentCount_ = 0;
  const DocumentDiskState before = std::exchange(*disk_, {});
  disk_->mapFile = keepsMapFile ? before.mapFile : scenario_.desktop.mapFile;
  const std::string text = sim2d::writeScenario(scenario_);
  disk_->note(path_, text);
  const sim2d::ScenarioReading reading = sim2d::readScenarioText(text, path_.toStdString());
  disk_->lines = linesOf(scenario_, reading);
  replaceFirst(loadDiagnostics_, before.readProblemCount, reading.diagnostics);
  disk_->readProblemCount = reading.diagnostics.size();
  if (!map_.path.isEmpty()) {
    disk_->maps[map_.path] = map_.grid;
  }
  disk_->recordMapFiles(plan, before);
  for (const PlannedTree& written : plan.trees) {
    disk_->recordTree(written, tree(written.human).has_value(),
                      generatedTree(scenario_, *human(written.human)), before.known(written.human));
  }
  disk_->unreadableTrees = plan.unreadableTrees;
  undoStack_.setClean();
  if (map_.isMissing) {
    loadMap();  // The file may be beside the new location, and lines have moved.
  }
  if (isChanged) {
    replaced();
  }
  emitFileSignals();
  checkTimer_.start();
}

std::optional<std::string> ScenarioDocument::treeToRun(EntityId id) const {
  constexpr auto kOurs =
      bt::TreeStyle::Corrected;  // Has the same meaning in a file as the generator's style.
  const TreeFileState* known = disk_->known(id);
  const sim2d::Human* person = human(id);
  const bool isOther = known != nullptr && known->style.value_or(kOurs) != kOurs;
  return person != nullptr && isOther ? effectiveTree(scenario_, *person) : tree(id);
}

bool ScenarioDocument::isTreeOutdated(EntityId id) const {
  const sim2d::Human* person = human(id);
  const auto basis = disk_->bases.find(id);
  return person != nullptr && tree(id) && basis != disk_->bases.end() &&
         basis->second != generatedTree(scenario_, *person);
}

app::Bundle ScenarioDocument::bundle() const {
  app::Bundle bundle;
  bundle.path = path_.toStdString();
  bundle.scenario = std::make_shared<const sim2d::Scenario>(scenario_);
  bundle.isWhole = !disk_->readOnly;
  bundle.isBeginning = disk_->isBeginning;
  bundle.map = map_.isMissing ? nullptr : map_.grid;
  bundle.known = surroundings_;
  bundle.stop = mapStopFlag_;
  bundle.lines = disk_->lines;
  bundle.remarks = loadDiagnostics_;
  base::append(bundle.remarks, reportedMapProblems());
  if (isReadOnly() && !base::hasErrors(bundle.remarks)) {  // Load problems are no longer reported.
    bundle.remarks.push_back(base::error("document.run-in-part", {}, bundle.path));
  }
  const std::string folder = path_.isEmpty() ? std::string() : treeFolderOf(bundle.path);
  for (const sim2d::Human& human : scenario_.humans) {
    const TreeFileState* known = disk_->known(human.key);
    if (std::optional<std::string> text = treeToRun(human.key)) {
      bundle.trees[human.name] = {*std::move(text), known ? known->path : std::string(), folder};
    } else if (known == nullptr &&
               (human.ours.tree || disk_->unreadableTrees.count(human.key) > 0)) {
      bundle.trees[human.name] = sim2d::findTree(scenario_, human, places());
    }
  }
  return bundle;
}

bool ScenarioDocument::isShipped(const QString& file) const {
  const QString folder =
      QFileInfo(QString::fromStdString(search_.shippedMaps)).absoluteFilePath() + QLatin1Char('/');
  return !search_.shippedMaps.empty() && QFileInfo(file).absoluteFilePath().startsWith(folder);
}

bool ScenarioDocument::isReadOnly() const {
  return disk_->readOnly;
}

QStringList ScenarioDocument::files() const {
  QStringList files;
  for (const auto& [file, hash] : disk_->hashes) {
    files << file;
  }
  return files;
}

QStringList ScenarioDocument::changedOnDisk() const {
  QStringList changed;
  for (const auto& [file, hash] : disk_->hashes) {
    const QByteArray now = hashOfFile(file);
    if (!now.isEmpty() && now != hash) {  // Saving restores a file that has been deleted.
      changed << file;
    }
  }
  return changed;
}

void ScenarioDocument::acceptDiskChanges() {
  for (const QString& file : changedOnDisk()) {
    disk_->recordFile(file);
  }
}

}  // namespace editor
