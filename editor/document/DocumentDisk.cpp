#include "editor/document/DocumentDisk.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "app/run/Bundle.h"
#include "editor/document/TreeFiles.h"

namespace editor {

namespace {

QByteArray hashOf(const std::string& content) {
  QCryptographicHash hash(QCryptographicHash::Sha1);
  hash.addData(content.data(), static_cast<int>(content.size()));
  return hash.result();
}

template <class T>
void addLines(const std::vector<T>& list, const std::vector<T>& asRead,
              const std::map<EntityId, int>& lines, std::map<EntityId, int>& result) {
  for (std::size_t i = 0; i < list.size() && i < asRead.size(); ++i) {
    const auto found = lines.find(asRead[i].key);
    if (found != lines.end()) {
      result[list[i].key] = found->second;
    }
  }
}

}  // namespace

QByteArray hashOfFile(const QString& file) {
  QFile opened(file);
  QCryptographicHash hash(QCryptographicHash::Sha1);
  return opened.open(QIODevice::ReadOnly) && hash.addData(&opened) ? hash.result() : QByteArray();
}

void DocumentDisk::note(const QString& file, const std::string& content) {
  hashes[QFileInfo(file).absoluteFilePath()] = hashOf(content);
}

void DocumentDisk::noteFile(const QString& file) {
  hashes[QFileInfo(file).absoluteFilePath()] = hashOfFile(file);
}

void DocumentDisk::forgetFiles() {
  trees.clear();
  bases.clear();
  hashes.clear();
  maps.clear();
  mapImage.clear();
  mapFile.reset();
  lines.clear();
  readCount = 0;
  readOnly = false;
}

const KnownTree* DocumentDisk::known(EntityId human) const {
  const auto found = trees.find(human);
  return found == trees.end() ? nullptr : &found->second;
}

std::map<EntityId, int> linesOf(const sim2d::Scenario& scenario,
                                const sim2d::ScenarioReading& reading) {
  std::map<EntityId, int> result;
  const auto settings = reading.lines.find(kSettingsId);
  if (settings != reading.lines.end()) {
    result.insert(*settings);
  }
  const sim2d::Scenario& asRead = reading.scenario;
  addLines(scenario.humans, asRead.humans, reading.lines, result);
  addLines(scenario.goals, asRead.goals, reading.lines, result);
  addLines(scenario.robots, asRead.robots, reading.lines, result);
  addLines(scenario.obstacles, asRead.obstacles, reading.lines, result);
  addLines(scenario.doors, asRead.doors, reading.lines, result);
  addLines(scenario.areas, asRead.areas, reading.lines, result);
  return result;
}

std::string baseNameOf(const QString& path) {
  return QFileInfo(path).completeBaseName().toStdString();
}

std::string relativeTo(const QString& scenarioPath, const QString& file) {
  const QDir folder = QFileInfo(scenarioPath).absoluteDir();
  return folder.relativeFilePath(QFileInfo(file).absoluteFilePath()).toStdString();
}

base::Diagnostics asWarnings(base::Diagnostics found) {
  for (base::Diagnostic& diagnostic : found) {
    if (diagnostic.severity == base::Severity::Error) {
      diagnostic.severity = base::Severity::Warning;
    }
  }
  return found;
}

namespace {

/// The path to the same file from the new folder; as it is when the file is missing and one of this
/// name is there.
std::string movedPath(const std::string& path, const QDir& old, const QString& to) {
  const QString name = QString::fromStdString(path);
  const QString target = old.absoluteFilePath(name);
  const bool isBesideNew = QFileInfo(QFileInfo(to).absoluteDir(), name).exists();
  return !QFileInfo::exists(target) && isBesideNew ? path : relativeTo(to, target);
}

}  // namespace

void moveRelativePaths(sim2d::Scenario& scenario, const QString& from, const QString& to) {
  if (from.isEmpty() || QFileInfo(from).absoluteDir() == QFileInfo(to).absoluteDir()) {
    return;
  }
  const QDir old = QFileInfo(from).absoluteDir();
  if (scenario.desktop.mapFile && scenario.desktop.mapFile != "none") {
    scenario.desktop.mapFile = movedPath(*scenario.desktop.mapFile, old, to);
  }
  for (sim2d::Human& human : scenario.humans) {
    if (human.ours.tree) {
      human.ours.tree = movedPath(*human.ours.tree, old, to);
    }
  }
}

void ScenarioDocument::setSearch(const QString& map, const QString& trees) {
  disk_->mapOption = map.toStdString();
  disk_->treesOption = trees.toStdString();
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

std::string ScenarioDocument::wantedTree(const sim2d::Scenario& scenario,
                                         const sim2d::Human& human) const {
  if (std::optional<std::string> own = tree(human.key)) {
    return *std::move(own);
  }
  const KnownTree* known = disk_->known(human.key);
  std::string generated = generatedTree(scenario, human);
  if (known == nullptr || !known->style) {
    return generated;
  }
  if (known->generated == generated) {
    return known->content;  // layout and style as in the file
  }
  return *known->style == bt::TreeStyle::Corrected ? generated
                                                   : generatedTree(scenario, human, *known->style);
}

std::optional<std::string> ScenarioDocument::treeToRun(EntityId id) const {
  std::optional<std::string> own = tree(id);
  const KnownTree* known = disk_->known(id);
  const sim2d::Human* person = human(id);
  if (own || person == nullptr || known == nullptr || !known->style) {
    return own;
  }
  if (*known->style == bt::TreeStyle::Corrected) {
    return std::nullopt;  // means the same as the generator's
  }
  return wantedTree(scenario_, *person);
}

app::Bundle ScenarioDocument::bundle() const {
  app::Bundle bundle;
  bundle.path = path_.toStdString();
  bundle.scenario = std::make_shared<const sim2d::Scenario>(scenario_);
  bundle.isWhole = !disk_->readOnly;
  bundle.map = mapIsMissing_ ? nullptr : map_;
  bundle.lines = disk_->lines;
  bundle.remarks = loadDiagnostics_;
  base::append(bundle.remarks, mapProblems_);
  if (isReadOnly() && !base::hasErrors(bundle.remarks)) {  // what was wrong is told no more
    bundle.remarks.push_back(base::makeError(
        "the file could only be read in part: save it under another name to run what is there",
        bundle.path));
  }
  const std::string folder = path_.isEmpty() ? std::string() : treeFolderOf(bundle.path);
  const sim2d::FilePlaces places = disk_->places(path_, shippedMaps_);
  for (const sim2d::Human& human : scenario_.humans) {
    const KnownTree* known = disk_->known(human.key);
    if (std::optional<std::string> text = treeToRun(human.key)) {
      bundle.trees[human.name] = {*std::move(text), known ? known->path : std::string(), folder};
    } else if (human.ours.tree && known == nullptr) {  // it could not be read
      bundle.trees[human.name] = sim2d::findTree(scenario_, human, places);
    }
  }
  return bundle;
}

}  // namespace editor
