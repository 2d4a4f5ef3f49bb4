#include "editor/document/DocumentDisk.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "editor/document/SavePlan.h"
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
  unreadTrees.clear();
  bases.clear();
  hashes.clear();
  maps.clear();
  mapImage.clear();
  mapFile.reset();
  lines.clear();
  readCount = 0;
  readOnly = false;
  isBeginning = false;
}

const KnownTree* DocumentDisk::known(EntityId human) const {
  const auto found = trees.find(human);
  return found == trees.end() ? nullptr : &found->second;
}

bool DocumentDisk::holds(const MapState& map) const {
  const auto onDisk = maps.find(map.path);
  return !map.path.isEmpty() &&
         (onDisk == maps.end() || onDisk->second == map.grid || *onDisk->second == *map.grid);
}

bool DocumentDisk::isOtherMapWanted(const sim2d::Scenario& scenario) const {
  return scenario.desktop.mapFile && scenario.desktop.mapFile != mapFile;
}

void DocumentDisk::noteMapFiles(const SavePlan& plan, const DocumentDisk& before) {
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

void DocumentDisk::noteTree(const PlannedTree& written, bool isOwn, std::string generated,
                            const KnownTree* before) {
  note(QString::fromStdString(written.path), written.content);
  if (isOwn) {
    bases[written.human] = generated;
  }
  std::optional<bt::TreeStyle> style;
  if (!isOwn) {
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

}  // namespace editor
