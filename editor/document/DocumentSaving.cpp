#include <algorithm>
#include <filesystem>

#include <QDir>
#include <QFileInfo>

#include "editor/document/DocumentDisk.h"
#include "editor/document/EditCommands.h"
#include "editor/document/TreeFiles.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapFiles.h"

namespace editor {

namespace {

namespace fs = std::filesystem;

bool isSameFile(const QString& a, const QString& b) {
  return !a.isEmpty() && !b.isEmpty() &&
         QFileInfo(a).canonicalFilePath() == QFileInfo(b).canonicalFilePath();
}

/// Beside the scenario, or in ../maps of a folder called scenarios.
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
                                              treeFileName(stemOf(plan), human.id);
  return file.lexically_normal().string();
}

const PlannedTree* plannedAt(const SavePlan& plan, const std::string& path) {
  const auto found = std::find_if(plan.trees.begin(), plan.trees.end(),
                                  [&](const PlannedTree& tree) { return tree.path == path; });
  return found == plan.trees.end() ? nullptr : &*found;
}

std::optional<std::string> textAt(const std::string& path) {
  base::Result<std::string> text = base::readTextFile(path);
  return text ? std::make_optional(*std::move(text)) : std::nullopt;
}

/// The person of the scenario file that is there now: its generated trees are nobody's work.
bool isGeneratedForDisk(const std::string& xml, const sim2d::Scenario& onDisk, int humanId) {
  const sim2d::Human* human = onDisk.humanById(humanId);
  return human != nullptr && isGeneratedTree(xml, onDisk, *human);
}

/// What was wrong with the file that was opened is not wrong with the one that was saved.
void replaceFirst(base::Diagnostics& problems, std::size_t count, const base::Diagnostics& fresh) {
  const auto begin = problems.begin();
  problems.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  problems.insert(problems.begin(), fresh.begin(), fresh.end());
}

bool isMapInFile(const DocumentDisk& disk, const MapState& map) {
  const auto onDisk = disk.maps.find(map.path);
  return !map.path.isEmpty() &&
         (onDisk == disk.maps.end() || onDisk->second == map.grid || *onDisk->second == *map.grid);
}

/// Somebody has written the name of another file into the settings.
bool wantsOtherMap(const DocumentDisk& disk, const sim2d::Scenario& scenario) {
  return scenario.desktop.mapFile && scenario.desktop.mapFile != disk.mapFile;
}

}  // namespace

void ScenarioDocument::placeMap(SavePlan& plan) const {
  if (mapIsMissing_) {
    return;
  }
  const bool isInFile = isMapInFile(*disk_, mapState());
  if (isInFile && wantsOtherMap(*disk_, scenario_)) {
    return;
  }
  if (!map_->isEmpty() && !isInFile) {  // drawn here: it gets files of its own
    const std::string name = baseNameOf(plan.path) + "_map";
    plan.mapPath = QDir(mapFolderOf(plan.path)).filePath(QString::fromStdString(name + ".yaml"));
    base::Result<std::vector<base::FileContent>> files =
        sim2d::mapFileContents(*map_, plan.mapPath.toStdString());
    base::append(plan.problems, files.diagnostics());
    if (files) {
      plan.mapFiles = *std::move(files);
    }
    plan.scenario.map = name;
  }
  const bool isPlanned = !plan.mapFiles.empty();
  const sim2d::FilePlaces places{plan.path.toStdString(), {}, {}, shippedMaps_.toStdString()};
  for (const bool withFile : {true, false}) {
    if (!withFile) {
      plan.scenario.desktop.mapFile.reset();
    }
    const base::Result<std::string> found = sim2d::findMap(plan.scenario, places);
    const bool isOpenPlane = found && found->empty() && map_->isEmpty();
    if (isOpenPlane || (found && isSameFile(QString::fromStdString(*found), plan.mapPath)) ||
        (isPlanned && !withFile && !found)) {  // nothing else by this name: found once written
      return;
    }
  }
  plan.scenario.desktop.mapFile = map_->isEmpty() ? "none" : relativeTo(plan.path, plan.mapPath);
}

void ScenarioDocument::planTrees(SavePlan& plan) const {
  for (sim2d::Human& human : plan.scenario.humans) {
    const bool isNamedOnly =
        human.ours.tree && !tree(human.key) && disk_->known(human.key) == nullptr;
    if (!human.listed || isNamedOnly) {
      continue;
    }
    const std::string text = wantedTree(plan.scenario, human);
    std::string path = treePathOf(plan, human);
    const PlannedTree* same = plannedAt(plan, path);
    if (same != nullptr && same->content != text && human.ours.tree) {
      human.ours.tree.reset();  // no longer the same as that of the other person
      path = treePathOf(plan, human);
      same = plannedAt(plan, path);
    }
    if (same == nullptr) {
      plan.trees.push_back({human.key, path, text});
    } else if (same->content != text) {
      plan.problems.push_back(base::makeWarning(
          human.name + ": the tree is not saved, another person has the same id", path));
    }
  }
}

SavePlan ScenarioDocument::planSaving(const QString& path) const {
  SavePlan plan;
  plan.path = QFileInfo(path).absoluteFilePath();
  plan.scenario = scenario_;
  plan.mapPath = mapPath_;
  if (isReadOnly() && plan.path == path_) {
    plan.problems.push_back(base::makeError(
        "the file could only be read in part and will not be overwritten (save under another name)",
        path.toStdString()));
    return plan;
  }
  moveRelativePaths(plan.scenario, path_, plan.path);
  if (plan.path != path_) {
    plan.scenario.yamlBaseName = baseNameOf(plan.path);
  }
  placeMap(plan);
  planTrees(plan);
  return plan;
}

std::vector<TreeQuestion> ScenarioDocument::treeQuestions(const QString& path) const {
  const SavePlan plan = planSaving(path);
  std::vector<TreeQuestion> questions;
  std::optional<sim2d::ScenarioReading> there;
  for (const PlannedTree& planned : plan.trees) {
    const auto& human = plan.scenario.humans[static_cast<std::size_t>(indexOf(planned.human))];
    const std::optional<std::string> onDisk = textAt(planned.path);
    const KnownTree* known = disk_->known(planned.human);
    const bool wasRead = known != nullptr && known->path == planned.path;
    const bool isKnown = wasRead && onDisk == known->content;
    TreeQuestion question{human.key, human.name, planned.path, {}, planned.content};
    if (onDisk && *onDisk != planned.content && !isKnown) {
      if (!there) {
        there = sim2d::readScenario(plan.path.toStdString());
      }
      // A file that was read and has changed since was changed by somebody, if only a comment.
      if (wasRead || (!isGeneratedTree(*onDisk, plan.scenario, human) &&
                      !isGeneratedForDisk(*onDisk, there->scenario, human.id))) {
        question.mine = *onDisk;
        questions.push_back(std::move(question));
        continue;
      }
    }
    const auto basis = disk_->bases.find(planned.human);
    std::string generated = generatedTree(plan.scenario, human);
    if (tree(planned.human) && basis != disk_->bases.end() && basis->second != generated) {
      question.mine = planned.content;
      question.replacement = std::move(generated);
      question.why = TreeQuestion::Why::BehaviourChanged;
      questions.push_back(std::move(question));
    }
  }
  return questions;
}

/// What is decided about trees can be undone like any other edit.
void ScenarioDocument::answerTrees(const QString& path, const TreeAnswers& answers) {
  for (const TreeQuestion& question : treeQuestions(path)) {
    const auto answer = answers.find(question.human);
    const bool keeps = answer == answers.end() || answer->second == TreeAnswer::KeepMine;
    if (question.why == TreeQuestion::Why::ChangedOnDisk && keeps) {
      undoStack_.push(new EditTree(*this, question.human, question.mine,
                                   tr("Keep the tree of %1 that is in its file")
                                       .arg(QString::fromStdString(question.name))));
    } else if (question.why == TreeQuestion::Why::BehaviourChanged && !keeps) {
      undoStack_.push(new EditTree(
          *this, question.human, std::nullopt,
          tr("Take the generated tree of %1").arg(QString::fromStdString(question.name))));
    }
  }
}

base::Diagnostics ScenarioDocument::save(const QString& path, const TreeAnswers& answers) {
  answerTrees(path, answers);
  SavePlan plan = planSaving(path);
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
  const base::Diagnostics problems = plan.problems;
  if (!base::hasErrors(problems)) {
    takeSaved(std::move(plan));
  }
  return problems;
}

void ScenarioDocument::takeSaved(SavePlan plan) {
  const bool isChanged = !(plan.scenario == scenario_);
  const bool keepsMapFile = isMapInFile(*disk_, mapState()) && wantsOtherMap(*disk_, scenario_);
  scenario_ = std::move(plan.scenario);
  path_ = plan.path;
  mapPath_ = plan.mapPath;
  neverSaved_ = false;
  commentCount_ = 0;
  const DocumentDisk before = *disk_;
  disk_->forgetFiles();
  disk_->mapFile = keepsMapFile ? before.mapFile : scenario_.desktop.mapFile;
  const std::string text = sim2d::writeScenario(scenario_);
  disk_->note(path_, text);
  const sim2d::ScenarioReading reading = sim2d::readScenarioText(text, path_.toStdString());
  disk_->lines = linesOf(scenario_, reading);
  replaceFirst(loadDiagnostics_, before.readCount, reading.diagnostics);
  disk_->readCount = reading.diagnostics.size();
  if (!mapPath_.isEmpty()) {
    disk_->maps[mapPath_] = map_;
  }
  if (plan.mapFiles.empty()) {
    disk_->mapImage = before.mapImage;
    for (const QString& file : {mapPath_, before.mapImage}) {
      const auto known = before.hashes.find(file);
      if (known != before.hashes.end()) {
        disk_->hashes.insert(*known);
      }
    }
  } else {
    disk_->mapImage = QString::fromStdString(plan.mapFiles.front().path);
    for (const base::FileContent& file : plan.mapFiles) {
      disk_->note(QString::fromStdString(file.path), file.content);
    }
  }
  for (const PlannedTree& written : plan.trees) {
    const sim2d::Human& human = *this->human(written.human);
    const bool isOwn = tree(human.key).has_value();
    std::string generated = generatedTree(scenario_, human);
    disk_->note(QString::fromStdString(written.path), written.content);
    if (isOwn) {
      disk_->bases[human.key] = generated;
    }
    std::optional<bt::TreeStyle> style;
    if (!isOwn) {
      const KnownTree* known = before.known(human.key);
      style = written.content == generated || known == nullptr ? bt::TreeStyle::Corrected
                                                               : known->style;
    }
    disk_->trees[human.key] = {written.path, written.content, style, std::move(generated)};
  }
  undoStack_.setClean();
  if (mapIsMissing_) {
    loadMap();  // it may be beside the new place, and lines have moved
  }
  if (isChanged) {
    replaced();
  }
  Q_EMIT pathChanged();
  Q_EMIT dirtyChanged(false);
  Q_EMIT issuesChanged(issues());
  checkTimer_.start();
}

}  // namespace editor
