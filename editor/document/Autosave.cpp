#include "editor/document/Autosave.h"

#include "editor/document/DocumentDiskState.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"

namespace editor {

namespace {

constexpr const char* kScenarioFile = "scenario.yaml";
constexpr const char* kMapFile = "map.yaml";
constexpr const char* kNotesFile = "recovery.json";  // Marks a folder that contains a snapshot.
constexpr const char* kLockFile = "lock";
constexpr const char* kCrashKey = "is_from_crash";

QString lockOf(const QString& folder) {
  return QDir(folder).filePath(QString::fromLatin1(kLockFile));
}

std::string in(const QString& folder, const std::string& name) {
  return QDir(folder).filePath(QString::fromStdString(name)).toStdString();
}

std::string treeFile(int number) {
  return "tree_" + std::to_string(number) + ".xml";
}

/// People in the order of the file.
std::vector<const sim2d::Human*> peopleInFileOrder(const sim2d::Scenario& scenario) {
  std::vector<const sim2d::Human*> people;
  for (const sim2d::Human& human : scenario.humans) {
    people.push_back(&human);
  }
  std::stable_partition(people.begin(), people.end(),
                        [](const sim2d::Human* human) { return human->listed; });
  return people;
}

base::Result<MapState> readMapOf(const QString& folder, const QJsonObject& notes) {
  MapState state;
  state.grid = std::make_shared<sim2d::OccupancyGrid>();
  state.path = notes[QStringLiteral("map_path")].toString();
  state.isMissing = notes[QStringLiteral("map_is_missing")].toBool();
  if (notes[QStringLiteral("map_is_in_file")].toBool(true)) {
    return state;
  }
  base::Result<sim2d::MapFile> map = sim2d::readMap(in(folder, kMapFile), {});
  if (!map) {
    return map.diagnostics();
  }
  state.grid = std::make_shared<sim2d::OccupancyGrid>(std::move(map->grid));
  return state;
}

}  // namespace

std::vector<base::FileContent> snapshotFiles(const DocumentSnapshot& snapshot,
                                             const QString& folder) {
  std::vector<base::FileContent> files = {
      {in(folder, kScenarioFile), sim2d::writeScenario(snapshot.scenario)}};
  QJsonArray trees;
  int number = 0;
  for (const sim2d::Human* human : peopleInFileOrder(snapshot.scenario)) {
    const auto tree = snapshot.trees.find(human->key);
    if (tree != snapshot.trees.end()) {
      files.push_back({in(folder, treeFile(number)), tree->second});
      trees.append(number);
    }
    ++number;
  }
  if (!snapshot.mapIsInFile) {
    if (auto map = sim2d::mapFileContents(*snapshot.map.grid, in(folder, kMapFile))) {
      files.insert(files.end(), map->begin(), map->end());
    }
  }
  const QJsonObject notes = {{QStringLiteral("path"), snapshot.path},
                             {QStringLiteral("map_path"), snapshot.map.path},
                             {QStringLiteral("map_is_in_file"), snapshot.mapIsInFile},
                             {QStringLiteral("map_is_missing"), snapshot.map.isMissing},
                             {QStringLiteral("read_only"), snapshot.readOnly},
                             {QStringLiteral("trees"), trees},
                             {QLatin1String(kCrashKey), snapshot.isFromCrash},
                             {QStringLiteral("when"), snapshot.when.toString(Qt::ISODateWithMs)}};
  files.push_back({in(folder, kNotesFile), QJsonDocument(notes).toJson().toStdString()});
  return files;
}

base::Result<DocumentSnapshot> readSnapshot(const QString& folder) {
  const base::Result<std::string> text = base::readTextFile(in(folder, kNotesFile));
  if (!text) {
    return text.diagnostics();
  }
  const QJsonObject notes = QJsonDocument::fromJson(QByteArray::fromStdString(*text)).object();
  sim2d::ScenarioReading reading = sim2d::readScenario(in(folder, kScenarioFile));
  base::Result<MapState> map = readMapOf(folder, notes);
  base::Diagnostics problems = map.diagnostics();
  if (!map) {
    return problems;
  }
  for (const base::Diagnostic& found : reading.diagnostics) {
    if (found.severity == base::Severity::Error) {  // Others concern a file unknown to the user.
      base::append(problems, downgradedToWarnings({found}));
    }
  }
  const auto note = [&notes](const char* key) { return notes[QLatin1String(key)]; };
  DocumentSnapshot result{std::move(reading.scenario),
                          {},
                          *std::move(map),
                          note("map_is_in_file").toBool(true),
                          note("path").toString(),
                          note("read_only").toBool(),
                          QDateTime::fromString(note("when").toString(), Qt::ISODateWithMs),
                          note(kCrashKey).toBool(true)};
  for (const auto& value : notes[QStringLiteral("trees")].toArray()) {
    const int number = value.toInt(-1);
    base::Result<std::string> tree = base::readTextFile(in(folder, treeFile(number)));
    if (!tree || number < 0 || number >= static_cast<int>(result.scenario.humans.size())) {
      base::append(problems, tree.diagnostics());
      continue;
    }
    result.trees[result.scenario.humans[static_cast<std::size_t>(number)].key] = *std::move(tree);
  }
  return {std::move(result), std::move(problems)};
}

Autosave::Autosave(ScenarioDocument& document, QString root, QObject* parent)
    : QObject(parent), document_(document), root_(std::move(root)) {
  task_ =
      std::make_unique<LatestTask<base::Diagnostics>>([this](const base::Diagnostics& problems) {
        if (base::hasErrors(problems)) {
          Q_EMIT failed(problems);
        }
        if (!document_.isDirty()) {
          removeCopy();  // The document was saved during the write.
        }
      });
  timer_.setSingleShot(true);
  timer_.setInterval(kAutosaveMs);
  connect(&timer_, &QTimer::timeout, this, &Autosave::write);
  connect(&document_, &ScenarioDocument::changed, this, &Autosave::scheduleWrite);
  connect(&document_, &ScenarioDocument::mapChanged, this, &Autosave::scheduleWrite);
  connect(&document_, &ScenarioDocument::dirtyChanged, this, [this](bool dirty) {
    if (!dirty) {
      timer_.stop();
      removeCopy();
    } else {
      scheduleWrite();
    }
  });
}

Autosave::~Autosave() {
  document_.disconnect(this);
  task_->abandon();
  if (!isKept_) {
    removeCopy();
  }
  lock_.reset();
  if (!folder_.isEmpty() && !isKept_) {
    QDir(folder_).removeRecursively();
  }
}

void Autosave::setDelay(std::optional<int> milliseconds) {
  isEnabled_ = milliseconds.has_value();
  timer_.stop();
  if (!milliseconds) {
    task_->finish();
    removeCopy();
    return;
  }
  timer_.setInterval(*milliseconds);
  if (document_.isDirty()) {
    scheduleWrite();
  }
}

bool Autosave::makeFolder() {
  if (!folder_.isEmpty()) {
    return true;
  }
  const QString folder =
      QDir(root_).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces).left(8));
  if (!QDir().mkpath(folder)) {
    Q_EMIT failed({base::warning("document.no-crash-copy", {}, folder.toStdString())});
    return false;
  }
  folder_ = folder;
  lock_ = std::make_unique<QLockFile>(lockOf(folder));
  lock_->setStaleLockTime(0);
  lock_->tryLock(0);
  return true;
}

void Autosave::write() {
  if (isKept_ || !document_.isDirty() || !makeFolder()) {
    return;
  }
  task_->start([snapshot = document_.snapshot(), folder = folder_] {
    return base::writeFilesAtomically(snapshotFiles(snapshot, folder));
  });
}

bool Autosave::keepForNextSession() {
  timer_.stop();
  task_->finish();
  if (!document_.isDirty() || !makeFolder()) {
    return false;
  }
  DocumentSnapshot snapshot = document_.snapshot();
  snapshot.isFromCrash = false;
  isKept_ = !base::hasErrors(base::writeFilesAtomically(snapshotFiles(snapshot, folder_)));
  return isKept_;
}

void Autosave::writeNow() {
  timer_.stop();
  write();
  task_->finish();
}

void Autosave::removeCopy() {
  if (folder_.isEmpty() || task_->isBusy()) {
    return;
  }
  const QDir folder(folder_);
  for (const QString& file : folder.entryList(QDir::Files | QDir::Hidden)) {
    if (file != QLatin1String(kLockFile)) {
      QFile::remove(folder.filePath(file));
    }
  }
}

QStringList Autosave::orphanedFolders(const QString& root) {
  QStringList found;
  const QDir all(root);
  for (const QString& name : all.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QString folder = all.filePath(name);
    QLockFile lock(lockOf(folder));
    lock.setStaleLockTime(0);  // The lock becomes stale only when its process ends, not by age.
    if (!lock.tryLock(0)) {
      continue;
    }
    lock.unlock();
    if (QFile::exists(QDir(folder).filePath(QString::fromLatin1(kNotesFile)))) {
      found << folder;
    } else {
      QDir(folder).removeRecursively();  // The folder contains no unsaved work.
    }
  }
  return found;
}

}  // namespace editor
