#include <filesystem>

#include <QFileInfo>

#include "editor/document/DocumentDisk.h"
#include "editor/document/DocumentSnapshot.h"
#include "editor/document/EditCommands.h"
#include "editor/document/EntityLists.h"
#include "editor/document/MapEdit.h"
#include "editor/document/QtImageLoader.h"
#include "editor/document/TreeFiles.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/scenario/DamagedFile.h"
#include "sim2d/scenario/TextPlaces.h"

namespace editor {

namespace {

sim2d::MapRule mapRuleOf(const sim2d::Scenario& scenario) {
  return scenario.desktop.mapRule == "main" ? sim2d::MapRule::Main : sim2d::MapRule::Humble;
}

/// By its name, of one that is there.
bool isYaml(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  return QFileInfo(path).isReadable() &&
         (suffix == QLatin1String("yaml") || suffix == QLatin1String("yml"));
}

}  // namespace

base::Diagnostics ScenarioDocument::open(const QString& path) {
  sim2d::ScenarioReading reading = sim2d::readScenario(path.toStdString());
  if (!reading.ok() && isBlank(reading.scenario)) {
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
  base::append(told, disk_->mapOption.empty() ? asWarnings(mapProblems_) : mapProblems_);
  replaced();
  Q_EMIT pathChanged();
  Q_EMIT dirtyChanged(false);
  Q_EMIT issuesChanged(issues());
  return told;
}

/// Also tells what keeps it from being there, as `check` does.
void ScenarioDocument::loadMap() {
  const base::Result<std::string> found =
      sim2d::findMap(scenario_, disk_->places(path_, shippedMaps_));
  MapState map{std::make_shared<sim2d::OccupancyGrid>(), {}, !found, found.diagnostics()};
  sim2d::addPlaceOfMap(map.problems, path_.toStdString());
  if (found && !found->empty()) {
    base::Result<MapState> read =
        readMapFile(QString::fromStdString(*found), *disk_, mapRuleOf(scenario_));
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
  base::Result<MapState> map = readMapFile(yamlPath, *disk_, mapRuleOf(scenario_));
  const base::Diagnostics problems = map.diagnostics();
  if (map) {
    putMap(*std::move(map));
  }
  return problems;
}

base::Diagnostics ScenarioDocument::newOnMap(const QString& yamlPath) {
  DocumentDisk read;
  base::Result<MapState> map = readMapFile(yamlPath, read, sim2d::MapRule::Humble);
  const base::Diagnostics problems = map.diagnostics();
  if (map) {
    clear();
    disk_->maps = std::move(read.maps);
    disk_->hashes = std::move(read.hashes);
    disk_->mapImage = read.mapImage;
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

void ScenarioDocument::setMap(std::shared_ptr<const sim2d::OccupancyGrid> map,
                              const QString& path) {
  exchangeMap({std::move(map), path, false, {}});
}

MapState ScenarioDocument::exchangeMap(MapState map) {
  Q_ASSERT(map.grid != nullptr);
  MapState old = mapState();
  map_ = std::move(map.grid);
  mapPath_ = map.path;
  mapIsMissing_ = map.isMissing;
  mapProblems_ = std::move(map.problems);
  Q_EMIT mapChanged();
  if (!mapProblems_.empty() || !old.problems.empty()) {
    Q_EMIT issuesChanged(issues());
  }
  return old;
}

base::Diagnostics ScenarioDocument::loadTrees() {
  base::Diagnostics problems;
  const sim2d::FilePlaces places = disk_->places(path_, shippedMaps_);
  for (const sim2d::Human& human : scenario_.humans) {
    const std::string file = sim2d::findTree(scenario_, human, places);
    if (file.empty()) {
      continue;
    }
    const base::Result<std::string> text = base::readTextFile(file);
    if (!text) {
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
  DocumentSnapshot result;
  result.scenario = scenario_;
  result.trees = trees_;
  result.map = mapState();
  const auto onDisk = disk_->maps.find(mapPath_);
  result.mapIsInFile = map_->isEmpty() || (onDisk != disk_->maps.end() &&
                                           (onDisk->second == map_ || *onDisk->second == *map_));
  result.path = path_;
  result.readOnly = isReadOnly();
  result.when = QDateTime::currentDateTimeUtc();
  return result;
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
  base::Result<MapState> onDisk = readMapFile(snapshot.map.path, *disk_, mapRuleOf(scenario_));
  if (!snapshot.mapIsInFile) {
    mapPath_ =
        onDisk ? mapPath_ : QString();  // what was under the paint is gone: a file of its own
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
  Q_EMIT pathChanged();
  Q_EMIT dirtyChanged(!isSaved);
  Q_EMIT issuesChanged(issues());
}

}  // namespace editor
