#include "app/window/files/OpenFiles.h"

#include <algorithm>
#include <utility>

namespace app {

namespace {

constexpr const char* kSuffix = ".open";

/// Links and relative names of one file have the same key.
QString keyOf(const QString& path) {
  const QFileInfo file(path);
  const QString whole = file.exists() ? file.canonicalFilePath() : file.absoluteFilePath();
  return QString::fromLatin1(
      QCryptographicHash::hash(whole.toUtf8(), QCryptographicHash::Sha1).toHex());
}

}  // namespace

OpenFiles::OpenFiles(QString folder, QObject* parent)
    : QObject(parent), folder_(std::move(folder)) {
  if (!folder_.isEmpty() && QDir().mkpath(folder_)) {
    watcher_.addPath(folder_);
  }
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, &OpenFiles::changed);
}

OpenFiles::~OpenFiles() {
  watcher_.disconnect(this);
}

void OpenFiles::setFile(const QString& path) {
  const QString key = path.isEmpty() ? QString() : keyOf(path);
  if (key == key_) {
    return;
  }
  key_ = key;
  lock_.reset();
  if (key.isEmpty() || folder_.isEmpty()) {
    return;
  }
  const QString window = QUuid::createUuid().toString(QUuid::WithoutBraces).left(8);
  ownFile_ = QDir(folder_).filePath(key + QLatin1Char('-') + window + QLatin1String(kSuffix));
  lock_ = std::make_unique<QLockFile>(ownFile_);
  lock_->setStaleLockTime(0);  // stale only when its process has ended
  lock_->tryLock(0);           // a folder that cannot be written is no reason to refuse the file
}

bool OpenFiles::isOpenElsewhere() const {
  if (key_.isEmpty() || folder_.isEmpty()) {
    return false;
  }
  const QDir folder(folder_);
  const QStringList found = folder.entryList(
      {key_ + QLatin1Char('-') + QLatin1Char('*') + QLatin1String(kSuffix)}, QDir::Files);
  return std::any_of(found.begin(), found.end(), [&](const QString& name) {
    const QString file = folder.filePath(name);
    if (file == ownFile_) {
      return false;
    }
    QLockFile other(file);
    other.setStaleLockTime(0);
    if (!other.tryLock(0)) {
      return other.error() == QLockFile::LockFailedError;
    }
    return false;  // its process has ended; the lock is removed with `other`
  });
}

}  // namespace app
