#include "editor/document/Autosave.h"

#include <QCoreApplication>
#include <QDir>
#include <QUuid>

#include "editor/document/DocumentSnapshot.h"

namespace editor {

namespace {

constexpr const char* kLockFile = "lock";

QString lockOf(const QString& folder) {
  return QDir(folder).filePath(QString::fromLatin1(kLockFile));
}

}  // namespace

Autosave::Autosave(ScenarioDocument& document, QString root, QObject* parent)
    : QObject(parent), document_(document), root_(std::move(root)) {
  task_ = std::make_unique<LatestTask<base::Diagnostics>>([this](base::Diagnostics problems) {
    if (base::hasErrors(problems)) {
      Q_EMIT failed(problems);
    }
    if (!document_.isDirty()) {
      removeCopy();  // saved while it was being written
    }
  });
  timer_.setSingleShot(true);
  timer_.setInterval(kAutosaveMs);
  connect(&timer_, &QTimer::timeout, this, &Autosave::write);
  connect(&document_, &ScenarioDocument::changed, this, &Autosave::noteEdit);
  connect(&document_, &ScenarioDocument::mapChanged, this, &Autosave::noteEdit);
  connect(&document_, &ScenarioDocument::dirtyChanged, this, [this](bool dirty) {
    if (!dirty) {
      timer_.stop();
      removeCopy();
    } else {
      noteEdit();
    }
  });
}

Autosave::~Autosave() {
  document_.disconnect(this);
  task_->finish();
  removeCopy();
  lock_.reset();
  if (!folder_.isEmpty()) {
    QDir(folder_).removeRecursively();
  }
}

/// Not started anew by every edit: someone who never pauses is kept up with as well.
void Autosave::noteEdit() {
  if (!timer_.isActive()) {
    timer_.start();
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
  if (!document_.isDirty() || !makeFolder()) {
    return;
  }
  task_->start([snapshot = document_.snapshot(), folder = folder_] {
    return base::writeFilesTogether(snapshotFiles(snapshot, folder));
  });
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

QStringList Autosave::leftBehind(const QString& root) {
  QStringList found;
  const QDir all(root);
  for (const QString& name : all.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QString folder = all.filePath(name);
    QLockFile lock(lockOf(folder));
    lock.setStaleLockTime(0);  // only by its process, never by its age
    if (!lock.tryLock(0)) {
      continue;
    }
    lock.unlock();
    if (QFile::exists(QDir(folder).filePath(QString::fromLatin1(kNotesFile)))) {
      found << folder;
    } else {
      QDir(folder).removeRecursively();  // it had nothing unsaved
    }
  }
  return found;
}

void Autosave::discard(const QString& folder) {
  QDir(folder).removeRecursively();
}

}  // namespace editor
