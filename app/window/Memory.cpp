#include <QFileInfo>

#include "app/window/FileCommands.h"

namespace app {

namespace {

constexpr int kRecentFiles = 8;
constexpr const char* kRecentKey = "files/recent";
constexpr const char* kNotedKey = "files/noted";  // when, by file

}  // namespace

Memory::Memory(bool remembers) {
  if (remembers) {
    store_ = std::make_unique<QSettings>(QStringLiteral("hunavsim"), QStringLiteral("desktop"));
  }
}

QVariant Memory::value(const char* key) const {
  return store_ ? store_->value(QString::fromLatin1(key)) : QVariant();
}

void Memory::setValue(const char* key, const QVariant& value) {
  if (store_) {
    store_->setValue(QString::fromLatin1(key), value);
  }
}

QStringList Memory::recentFiles() const {
  return value(kRecentKey).toStringList();
}

void Memory::noteFile(const QString& path) {
  QStringList files = recentFiles();
  const QString whole = QFileInfo(path).absoluteFilePath();
  files.removeAll(whole);
  files.prepend(whole);
  while (files.size() > kRecentFiles) {
    files.removeLast();
  }
  setValue(kRecentKey, files);
  const QVariantMap before = value(kNotedKey).toMap();
  QVariantMap noted;
  for (const QString& file : files) {
    noted[file] = file == whole ? QDateTime::currentDateTime() : before.value(file);
  }
  setValue(kNotedKey, noted);
}

QDateTime Memory::noted(const QString& path) const {
  return value(kNotedKey).toMap().value(path).toDateTime();
}

void Memory::clearRecent() {
  setValue(kRecentKey, QStringList());
}

}  // namespace app
