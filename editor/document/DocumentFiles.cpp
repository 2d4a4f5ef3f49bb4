#include <filesystem>

#include <QDir>
#include <QFileInfo>

#include "editor/document/EditCommands.h"
#include "editor/document/QtImageLoader.h"
#include "editor/document/ScenarioDocument.h"
#include "editor/document/TreeFiles.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace editor {

namespace {

sim2d::MapRule mapRuleOf(const sim2d::Scenario& scenario) {
  return scenario.desktop.mapRule == "main" ? sim2d::MapRule::Main : sim2d::MapRule::Humble;
}

bool isSameFile(const QString& a, const QString& b) {
  return !a.isEmpty() && !b.isEmpty() &&
         QFileInfo(a).canonicalFilePath() == QFileInfo(b).canonicalFilePath();
}

std::string relativeTo(const QString& scenarioPath, const QString& file) {
  const QDir folder = QFileInfo(scenarioPath).absoluteDir();
  return folder.relativeFilePath(QFileInfo(file).absoluteFilePath()).toStdString();
}

std::string baseNameOf(const QString& path) {
  return QFileInfo(path).completeBaseName().toStdString();
}

/// Paths relative to the old scenario file stay right beside the new one.
void moveRelativePaths(sim2d::Scenario& scenario, const QString& from, const QString& to) {
  if (from.isEmpty() || QFileInfo(from).absoluteDir() == QFileInfo(to).absoluteDir()) {
    return;
  }
  const QDir old = QFileInfo(from).absoluteDir();
  for (sim2d::Human& human : scenario.humans) {
    if (human.ours.tree) {
      human.ours.tree =
          relativeTo(to, old.absoluteFilePath(QString::fromStdString(*human.ours.tree)));
    }
  }
}

/// A problem that does not keep the scenario from being edited.
base::Diagnostics asWarnings(base::Diagnostics found) {
  for (base::Diagnostic& diagnostic : found) {
    if (diagnostic.severity == base::Severity::Error) {
      diagnostic.severity = base::Severity::Warning;
    }
  }
  return found;
}

}  // namespace

base::Diagnostics ScenarioDocument::open(const QString& path) {
  sim2d::ScenarioReading reading = sim2d::readScenario(path.toStdString());
  if (!reading.ok()) {
    return reading.diagnostics;
  }
  replaceAll(std::move(reading.scenario));
  path_ = QFileInfo(path).absoluteFilePath();
  neverSaved_ = false;
  commentCount_ = reading.commentCount;
  loadDiagnostics_ = std::move(reading.diagnostics);
  base::append(loadDiagnostics_, loadMapOf(scenario_, path_));
  base::append(loadDiagnostics_, loadTrees());
  Q_EMIT changed({Change::What::Everything, {}});
  Q_EMIT pathChanged();
  Q_EMIT dirtyChanged(false);
  Q_EMIT issuesChanged(issues());
  return loadDiagnostics_;
}

base::Diagnostics ScenarioDocument::loadMapOf(const sim2d::Scenario& scenario,
                                              const QString& path) {
  const sim2d::FilePlaces places{path.toStdString(), {}, {}, shippedMaps_.toStdString()};
  const base::Result<std::string> found = sim2d::findMap(scenario, places);
  base::Diagnostics problems = found.diagnostics();
  if (found && found->empty()) {
    setMap(std::make_shared<sim2d::OccupancyGrid>());
    return problems;
  }
  if (found) {
    base::Result<sim2d::MapFile> map = sim2d::readMap(*found, loadMapImage, mapRuleOf(scenario));
    base::append(problems, map.diagnostics());
    if (map) {
      setMap(std::make_shared<sim2d::OccupancyGrid>(std::move(map->grid)),
             QString::fromStdString(*found));
      return problems;
    }
  }
  setMap(std::make_shared<sim2d::OccupancyGrid>());
  mapIsMissing_ = true;
  return asWarnings(std::move(problems));
}

base::Diagnostics ScenarioDocument::openMap(const QString& yamlPath) {
  base::Result<sim2d::MapFile> map =
      sim2d::readMap(yamlPath.toStdString(), loadMapImage, mapRuleOf(scenario_));
  if (!map) {
    return map.diagnostics();
  }
  setMap(std::make_shared<sim2d::OccupancyGrid>(std::move(map->grid)),
         QFileInfo(yamlPath).absoluteFilePath());
  pushChange<ScenarioSettings>(*this, kSettingsId, tr("Change map"),
                               [&](ScenarioSettings& settings) {
                                 settings.map = baseNameOf(yamlPath);
                                 settings.desktop.mapFile.reset();
                               });
  return map.diagnostics();
}

base::Diagnostics ScenarioDocument::loadTrees() {
  const sim2d::FilePlaces places{path_.toStdString(), {}, {}, {}};
  base::Diagnostics problems;
  for (const sim2d::Human& human : scenario_.humans) {
    const std::string file = sim2d::findTree(scenario_, human, places);
    if (file.empty()) {
      continue;
    }
    const base::Result<std::string> text = base::readTextFile(file);
    base::append(problems, text.diagnostics());
    if (text && !isGeneratedTree(*text, scenario_, human)) {
      trees_[human.key] = *text;
    }
  }
  return asWarnings(std::move(problems));
}

base::Diagnostics ScenarioDocument::placeMap(sim2d::Scenario& scenario, const QString& path) {
  if (mapIsMissing_) {
    return {};
  }
  if (!map_->isEmpty() && mapPath_.isEmpty()) {  // drawn here: it gets files of its own
    const std::string name = baseNameOf(path) + "_map";
    const QString file =
        QFileInfo(path).absoluteDir().filePath(QString::fromStdString(name + ".yaml"));
    base::Diagnostics problems = sim2d::writeMap(*map_, file.toStdString());
    if (base::hasErrors(problems)) {
      return problems;
    }
    mapPath_ = file;
    scenario.map = name;
  }
  const sim2d::FilePlaces places{path.toStdString(), {}, {}, shippedMaps_.toStdString()};
  for (const bool withFile : {true, false}) {
    if (!withFile) {
      scenario.desktop.mapFile.reset();
    }
    const base::Result<std::string> found = sim2d::findMap(scenario, places);
    const bool isOpenPlane = found && found->empty() && map_->isEmpty();
    if (isOpenPlane || (found && isSameFile(QString::fromStdString(*found), mapPath_))) {
      return {};
    }
  }
  scenario.desktop.mapFile = map_->isEmpty() ? "none" : relativeTo(path, mapPath_);
  return {};
}

base::Diagnostics ScenarioDocument::save(const QString& path) {
  const QString target = QFileInfo(path).absoluteFilePath();
  sim2d::Scenario scenario = scenario_;
  moveRelativePaths(scenario, path_, target);
  if (target != path_) {
    scenario.yamlBaseName = baseNameOf(target);
  }
  base::Diagnostics problems = placeMap(scenario, target);
  if (!base::hasErrors(problems)) {
    base::append(problems, writeTrees(scenario, target));
  }
  if (!base::hasErrors(problems)) {
    base::append(problems,
                 base::writeFileAtomically(target.toStdString(), sim2d::writeScenario(scenario)));
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  const bool isChanged = !(scenario == scenario_);
  scenario_ = std::move(scenario);
  path_ = target;
  neverSaved_ = false;
  commentCount_ = 0;
  undoStack_.setClean();
  if (isChanged) {
    Q_EMIT changed({Change::What::Everything, {}});
  }
  Q_EMIT pathChanged();
  Q_EMIT dirtyChanged(false);
  return problems;
}

base::Diagnostics ScenarioDocument::writeTrees(const sim2d::Scenario& scenario,
                                               const QString& path) const {
  const std::filesystem::path folder = treeFolderOf(path.toStdString());
  const std::string base = scenario.yamlBaseName.value_or(baseNameOf(path));
  base::Diagnostics problems;
  for (const sim2d::Human& human : scenario.humans) {
    if (!human.listed) {
      continue;
    }
    const std::string file =
        human.ours.tree
            ? (std::filesystem::path(path.toStdString()).parent_path() / *human.ours.tree).string()
            : (folder / treeFileName(base, human.id)).string();
    const std::optional<std::string> own = tree(human.key);
    if (own) {
      base::append(problems, base::writeFileAtomically(file, *own));
    } else if (!human.ours.tree) {
      base::append(problems, base::writeFileAtomically(file, generatedTree(scenario, human)));
    }
  }
  if (!scenario.humans.empty()) {
    base::append(problems, writeIncludedTrees(folder.string()));
  }
  return problems;
}

}  // namespace editor
