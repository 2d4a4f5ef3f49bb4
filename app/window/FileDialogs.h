#pragma once

#include <memory>

#include <QDateTime>
#include <QSettings>
#include <QStringList>
#include <QVariant>
#include <QWidget>

namespace app {

/// Recent files and what else is remembered between sessions. Without a store (pictures, tests)
/// nothing is read or written.
class Memory {
 public:
  explicit Memory(bool remembers);
  QStringList recentFiles() const;
  void noteFile(const QString& path);          // opened or saved just now
  QDateTime noted(const QString& path) const;  // when; invalid: not known
  void clearRecent();
  QVariant value(const char* key) const;
  void setValue(const char* key, const QVariant& value);

 private:
  std::unique_ptr<QSettings> store_;
};

/// Questions for files and folders; empty = cancelled. Large enough for names and dates the first
/// time, then as they were left.
class FileDialogs {
 public:
  FileDialogs(Memory& memory, QWidget& window) : memory_(memory), window_(window) {}

  QString openFile(const QString& title, const QString& folder, const QString& filter) const;
  QString openFolder(const QString& title, const QString& folder) const;
  /// `proposed`: a whole path. Asks before a file is replaced; a name without an ending gets
  /// `suffix`.
  QString saveFile(const QString& title, const QString& proposed, const QString& filter,
                   const QString& suffix) const;

 private:
  Memory& memory_;
  QWidget& window_;
};

}  // namespace app
