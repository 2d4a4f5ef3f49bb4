#include "app/window/FileWatch.h"

#include <utility>

#include <QFileInfo>

namespace app {

namespace {

constexpr int kPauseMs = 400;

}  // namespace

FileWatch::FileWatch(editor::ScenarioDocument& document, QObject* parent)
    : QObject(parent), document_(document) {
  pause_.setSingleShot(true);
  pause_.setInterval(kPauseMs);
  connect(&watcher_, &QFileSystemWatcher::fileChanged, &pause_, qOverload<>(&QTimer::start));
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, &pause_, qOverload<>(&QTimer::start));
  connect(&pause_, &QTimer::timeout, this, &FileWatch::lookNow);
  connect(&document_, &editor::ScenarioDocument::pathChanged, this, [this] {
    isThere_ = true;
    watch();
  });
  connect(&document_, &editor::ScenarioDocument::mapChanged, this, &FileWatch::watch);
}

/// Folders too: a file that is replaced by renaming is another one for the system.
void FileWatch::watch() {
  const QStringList before = watcher_.files() + watcher_.directories();
  if (!before.isEmpty()) {
    watcher_.removePaths(before);
  }
  QStringList paths;
  for (const QString& file : document_.files()) {
    for (const QString& path : {file, QFileInfo(file).absolutePath()}) {
      if (QFileInfo::exists(path) && !paths.contains(path)) {
        paths << path;
      }
    }
  }
  if (!paths.isEmpty()) {
    watcher_.addPaths(paths);
  }
}

void FileWatch::lookNow() {
  const QStringList changed = document_.changedOnDisk();
  watch();
  const bool isThere = document_.path().isEmpty() || QFileInfo::exists(document_.path());
  if (std::exchange(isThere_, isThere) != isThere) {
    Q_EMIT scenarioThere(isThere);
  }
  if (!changed.isEmpty()) {
    Q_EMIT changedOnDisk(changed);
  }
}

}  // namespace app
