#include <filesystem>

#include <QFileInfo>

#include "editor/document/DocumentDisk.h"
#include "editor/document/DocumentSnapshot.h"
#include "editor/document/EditCommands.h"
#include "editor/document/MapEdit.h"
#include "editor/document/QtImageLoader.h"
#include "editor/document/TreeFiles.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/scenario/DamagedFile.h"

namespace editor {

namespace {

sim2d::MapRule mapRuleOf(const sim2d::Scenario& scenario) {
  return scenario.desktop.mapRule == "main" ? sim2d::MapRule::Main : sim2d::MapRule::Humble;
}

bool isNothing(const sim2d::Scenario& scenario) {
  return scenario.humans.empty() && scenario.goals.empty() && scenario.robots.empty() &&
         scenario.obstacles.empty() && scenario.doors.empty() && scenario.areas.empty() &&
         !scenario.map && !scenario.desktop.mapFile;
}

}  // namespace

base::Diagnostics ScenarioDocument::open(const QString& path) {
  sim2d::ScenarioReading reading = sim2d::readScenario(path.toStdString());
  if (!reading.ok() && isNothing(reading.scenario)) {
    reading = sim2d::readBeginning(path.toStdString());
    if (isNothing(reading.scenario)) {
      return reading.diagnostics;
    }
  }
  const bool isWhole = reading.ok();
  replaceAll(std::move(reading.scenario));
  path_ = QFileInfo(path).absoluteFilePath();
  neverSaved_ = false;
  commentCount_ = reading.commentCount;
  disk_->noteFile(path_);
  disk_->lines = std::move(reading.lines);
  disk_->readOnly = !isWhole;
  loadDiagnostics_ = std::move(reading.diagnostics);
  disk_->readCount = loadDiagnostics_.size();
  const base::Diagnostics ofMap = loadMapOf(scenario_, path_);
  const base::Diagnostics ofTrees = loadTrees();
  base::Diagnostics told = loadDiagnostics_;
  for (const base::Diagnostics& more : {ofMap, ofTrees}) {
    base::append(loadDiagnostics_, more);
  }
  // a broken map is an error, but keeps no scenario shut; one that was asked for must be there
  base::append(told, disk_->mapOption.empty() ? asWarnings(ofMap) : ofMap);
  base::append(told, ofTrees);
  replaced();
  Q_EMIT pathChanged();
  Q_EMIT dirtyChanged(false);
  Q_EMIT issuesChanged(issues());
  return told;
}

base::Diagnostics ScenarioDocument::loadMapOf(const sim2d::Scenario& scenario,
                                              const QString& path) {
  const base::Result<std::string> found =
      sim2d::findMap(scenario, disk_->places(path, shippedMaps_));
  base::Diagnostics problems = found.diagnostics();
  if (found && found->empty()) {
    setMap(std::make_shared<sim2d::OccupancyGrid>());
    return problems;
  }
  if (found) {
    const base::Result<MapState> map =
        readMapFile(QString::fromStdString(*found), *disk_, mapRuleOf(scenario));
    base::append(problems, map.diagnostics());
    if (map) {
      exchangeMap(*map);
      return problems;
    }
  }
  exchangeMap({std::make_shared<sim2d::OccupancyGrid>(), {}, true});
  const bool isThere = bool(found);
  return isThere || !disk_->mapOption.empty() ? problems : asWarnings(std::move(problems));
}

base::Diagnostics ScenarioDocument::openMap(const QString& yamlPath) {
  const base::Result<MapState> map = readMapFile(yamlPath, *disk_, mapRuleOf(scenario_));
  if (!map) {
    return map.diagnostics();
  }
  ScenarioSettings settings = std::get<ScenarioSettings>(*entity(kSettingsId));
  settings.map = baseNameOf(yamlPath);
  settings.desktop.mapFile.reset();
  pushMap(*this, *map, std::move(settings), tr("Change map"));
  return map.diagnostics();
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

void ScenarioDocument::restore(DocumentSnapshot snapshot) {
  replaceAll(std::move(snapshot.scenario));
  path_ = snapshot.path;
  neverSaved_ = true;
  disk_->readOnly = snapshot.readOnly;
  exchangeMap(snapshot.map);
  if (!path_.isEmpty()) {
    disk_->noteFile(path_);
    loadDiagnostics_ = loadTrees();
  }
  if (!snapshot.map.path.isEmpty()) {
    const base::Result<MapState> onDisk =
        readMapFile(snapshot.map.path, *disk_, mapRuleOf(scenario_));
    if (snapshot.mapIsInFile) {
      base::append(loadDiagnostics_, asWarnings(onDisk.diagnostics()));
      exchangeMap(onDisk ? *onDisk : MapState{std::make_shared<sim2d::OccupancyGrid>(), {}, true});
    } else if (!onDisk) {
      mapPath_.clear();  // painted, and what was under the paint is gone: a file of its own
    }
  }
  trees_ = std::move(snapshot.trees);
  for (const auto& [id, text] : trees_) {
    if (const sim2d::Human* person = human(id)) {
      disk_->bases[id] = generatedTree(scenario_, *person);
    }
  }
  replaced();
  Q_EMIT pathChanged();
  Q_EMIT dirtyChanged(true);
  Q_EMIT issuesChanged(issues());
}

}  // namespace editor
