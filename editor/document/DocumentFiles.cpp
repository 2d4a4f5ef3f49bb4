#include <algorithm>
#include <utility>

#include <QFileInfo>

#include "app/run/Bundle.h"
#include "editor/document/Autosave.h"
#include "editor/document/DocumentDisk.h"
#include "editor/document/EditCommands.h"
#include "editor/document/EntityLists.h"
#include "editor/document/MapEdit.h"
#include "editor/document/TreeFiles.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace editor {

namespace {

/// By its name, of one that is there.
bool isYaml(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  return QFileInfo(path).isReadable() &&
         (suffix == QLatin1String("yaml") || suffix == QLatin1String("yml"));
}

/// What was wrong with the file that was opened is not wrong with the one that was saved.
void replaceFirst(base::Diagnostics& problems, std::size_t count, const base::Diagnostics& fresh) {
  const auto begin = problems.begin();
  problems.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  problems.insert(problems.begin(), fresh.begin(), fresh.end());
}

}  // namespace

void ScenarioDocument::tellOfFile() {
  Q_EMIT pathChanged();
  Q_EMIT dirtyChanged(isDirty());
  Q_EMIT issuesChanged(issues());
}

sim2d::FilePlaces ScenarioDocument::places() const {
  sim2d::FilePlaces places = search_;
  places.scenarioPath = path_.toStdString();
  return places;
}

base::Diagnostics ScenarioDocument::open(const QString& path) {
  sim2d::ScenarioReading reading = sim2d::readScenario(path.toStdString());
  const bool isBeginning = !reading.ok() && isBlank(reading.scenario);
  if (isBeginning) {
    reading = sim2d::readBeginning(path.toStdString());
    const bool isEmpty = isBlank(scenario_) && !isDirty();
    if (isBlank(reading.scenario) && !(isEmpty && isYaml(path))) {
      return reading.diagnostics;
    }
  }
  const bool isWhole = reading.ok();
  replaceAll(std::move(reading.scenario));
  path_ = QFileInfo(path).absoluteFilePath();
  neverSaved_ = false;
  commentCount_ = reading.commentCount;
  disk_->noteFile(path_);
  disk_->mapFile = scenario_.desktop.mapFile;
  disk_->lines = std::move(reading.lines);
  disk_->readOnly = !isWhole;
  disk_->isBeginning = isBeginning;
  loadDiagnostics_ = std::move(reading.diagnostics);
  disk_->readCount = loadDiagnostics_.size();
  if (isWhole || !isBlank(scenario_)) {
    loadMap();
  } else {
    setMap(std::make_shared<sim2d::OccupancyGrid>());  // one problem is enough
  }
  base::append(loadDiagnostics_, loadTrees());
  base::Diagnostics told = loadDiagnostics_;
  // without its map a scenario can still be edited; one that was asked for must be there
  base::append(told, search_.mapOption.empty() ? asWarnings(map_.problems) : map_.problems);
  replaced();
  tellOfFile();
  return told;
}

/// Also tells what keeps it from being there, as `check` does.
void ScenarioDocument::loadMap() {
  const base::Result<std::string> found = sim2d::findMap(scenario_, places());
  MapState map{std::make_shared<sim2d::OccupancyGrid>(), {}, !found, found.diagnostics()};
  sim2d::addPlaceOfMap(map.problems, path_.toStdString());
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
  DocumentDisk read;
  base::Result<MapState> map = read.readMap(yamlPath, {});
  base::Diagnostics problems = map.diagnostics();
  if (map) {
    clear();
    *disk_ = std::move(read);
    putMap(*std::move(map));
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
    stopMapWork();
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
      disk_->unreadTrees.insert(human.key);
      base::append(problems, human.listed ? base::Diagnostics() : text.diagnostics());
      continue;  // that of someone who takes part is told by the live check, until it is there
    }
    disk_->note(QString::fromStdString(file), *text);
    KnownTree known{file, *text, bt::TreeStyle::Corrected, generatedTree(scenario_, human)};
    if (*text != known.generated) {  // else as it was saved here: nothing to find out
      known.style = generatedStyle(*text, scenario_, human);
    }
    if (!known.style) {
      trees_[human.key] = *text;
      disk_->bases[human.key] = known.generated;
    }
    disk_->trees[human.key] = std::move(known);
  }
  return asWarnings(std::move(problems));
}

DocumentSnapshot ScenarioDocument::snapshot() const {
  const bool mapIsInFile =
      map_.grid->isEmpty() || (disk_->maps.count(map_.path) > 0 && disk_->holds(map_));
  return {
      scenario_, trees_, map_, mapIsInFile, path_, isReadOnly(), QDateTime::currentDateTimeUtc()};
}

void ScenarioDocument::restoreMap(const DocumentSnapshot& snapshot) {
  if (snapshot.map.isMissing) {
    loadMap();  // it may be there by now
    return;
  }
  exchangeMap(snapshot.map);
  if (snapshot.map.path.isEmpty()) {
    return;
  }
  base::Result<MapState> onDisk = disk_->readMap(snapshot.map.path, scenario_.desktop.mapRule);
  if (!snapshot.mapIsInFile) {
    map_.path = onDisk ? map_.path : QString();  // what was under the paint is gone: its own file
  } else if (onDisk) {
    exchangeMap(*std::move(onDisk));
  } else {
    exchangeMap({std::make_shared<sim2d::OccupancyGrid>(), {}, true, onDisk.diagnostics()});
  }
}

void ScenarioDocument::restore(DocumentSnapshot snapshot, bool isSaved) {
  replaceAll(std::move(snapshot.scenario));
  path_ = snapshot.path;
  neverSaved_ = !isSaved;
  disk_->readOnly = snapshot.readOnly;
  restoreMap(snapshot);
  if (!path_.isEmpty()) {
    disk_->noteFile(path_);
    loadDiagnostics_ = loadTrees();
  }
  trees_ = std::move(snapshot.trees);
  for (const auto& [id, text] : trees_) {
    if (const sim2d::Human* person = human(id)) {
      disk_->bases[id] = generatedTree(scenario_, *person);
    }
  }
  replaced();
  tellOfFile();
}

/// What is decided about trees can be undone like any other edit.
void ScenarioDocument::answerTrees(const QString& path, const TreesToReplace& replaced) {
  for (const TreeQuestion& question : treeQuestions(path)) {
    const bool keeps = replaced.count(question.human) == 0;
    if (question.why == TreeQuestion::Why::ChangedOnDisk && keeps) {
      pushTrees(
          *this, {{question.human, question.mine}},
          tr("Keep the tree of %1 that is in its file").arg(QString::fromStdString(question.name)));
    } else if (question.why == TreeQuestion::Why::BehaviourChanged && !keeps) {
      pushTrees(*this, {{question.human, std::nullopt}},
                tr("Take the generated tree of %1").arg(QString::fromStdString(question.name)));
    }
  }
}

base::Diagnostics ScenarioDocument::save(const QString& path, const TreesToReplace& replaced) {
  answerTrees(path, replaced);
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
  base::append(plan.problems, base::writeFilesTogether(files));
  base::Diagnostics problems = plan.problems;
  if (!base::hasErrors(problems)) {
    takeSaved(std::move(plan));
  }
  return problems;
}

void ScenarioDocument::takeSaved(SavePlan plan) {
  const bool isChanged = !(plan.scenario == scenario_);
  const bool keepsMapFile = disk_->holds(map_) && disk_->isOtherMapWanted(scenario_);
  scenario_ = std::move(plan.scenario);
  path_ = plan.path;
  map_.path = plan.mapPath;
  neverSaved_ = false;
  commentCount_ = 0;
  const DocumentDisk before = std::exchange(*disk_, {});
  disk_->mapFile = keepsMapFile ? before.mapFile : scenario_.desktop.mapFile;
  const std::string text = sim2d::writeScenario(scenario_);
  disk_->note(path_, text);
  const sim2d::ScenarioReading reading = sim2d::readScenarioText(text, path_.toStdString());
  disk_->lines = linesOf(scenario_, reading);
  replaceFirst(loadDiagnostics_, before.readCount, reading.diagnostics);
  disk_->readCount = reading.diagnostics.size();
  if (!map_.path.isEmpty()) {
    disk_->maps[map_.path] = map_.grid;
  }
  disk_->noteMapFiles(plan, before);
  for (const PlannedTree& written : plan.trees) {
    disk_->noteTree(written, tree(written.human).has_value(),
                    generatedTree(scenario_, *human(written.human)), before.known(written.human));
  }
  disk_->unreadTrees = plan.unreadTrees;
  undoStack_.setClean();
  if (map_.isMissing) {
    loadMap();  // it may be beside the new place, and lines have moved
  }
  if (isChanged) {
    replaced();
  }
  tellOfFile();
  checkTimer_.start();
}

std::optional<std::string> ScenarioDocument::treeToRun(EntityId id) const {
  constexpr auto kOurs =
      bt::TreeStyle::Corrected;  // in a file it means the same as the generator's
  const KnownTree* known = disk_->known(id);
  const sim2d::Human* person = human(id);
  const bool isOther = known != nullptr && known->style.value_or(kOurs) != kOurs;
  return person != nullptr && isOther ? wantedTree(scenario_, *person) : tree(id);
}

bool ScenarioDocument::isTreeBehind(EntityId id) const {
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
  bundle.stop = mapWork_;
  bundle.lines = disk_->lines;
  bundle.remarks = loadDiagnostics_;
  base::append(bundle.remarks, mapProblemsToTell());
  if (isReadOnly() && !base::hasErrors(bundle.remarks)) {  // what was wrong is told no more
    bundle.remarks.push_back(base::error("document.run-in-part", {}, bundle.path));
  }
  const std::string folder = path_.isEmpty() ? std::string() : treeFolderOf(bundle.path);
  for (const sim2d::Human& human : scenario_.humans) {
    const KnownTree* known = disk_->known(human.key);
    if (std::optional<std::string> text = treeToRun(human.key)) {
      bundle.trees[human.name] = {*std::move(text), known ? known->path : std::string(), folder};
    } else if (known == nullptr && (human.ours.tree || disk_->unreadTrees.count(human.key) > 0)) {
      bundle.trees[human.name] = sim2d::findTree(scenario_, human, places());
    }
  }
  return bundle;
}

void ScenarioDocument::setSearch(const QString& map, const QString& trees) {
  search_.mapOption = map.toStdString();
  search_.treesOption = trees.toStdString();
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
    if (!now.isEmpty() && now != hash) {  // a file that is gone comes back by saving
      changed << file;
    }
  }
  return changed;
}

void ScenarioDocument::acceptDisk() {
  for (const QString& file : changedOnDisk()) {
    disk_->noteFile(file);
  }
}

}  // namespace editor
