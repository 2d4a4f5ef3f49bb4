#pragma once

#include <QString>
#include <QWidget>

namespace app {

class Memory;

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
