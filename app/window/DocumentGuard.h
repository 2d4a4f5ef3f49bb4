#pragma once

#include <memory>

#include <QFileSystemWatcher>
#include <QTimer>

#include "app/window/FileCommands.h"
#include "app/window/NoticeBar.h"
#include "editor/document/Autosave.h"

namespace app {

/// Notices when another program changes a file of the document; the program's own saving is none.
class FileWatch : public QObject {
  Q_OBJECT
 public:
  explicit FileWatch(editor::ScenarioDocument& document, QObject* parent = nullptr);
  void lookNow();

 Q_SIGNALS:
  void changedOnDisk(const QStringList& files);
  void scenarioThere(bool isThere);  // its file has gone, or is back

 private:
  void watch();

  editor::ScenarioDocument& document_;
  QFileSystemWatcher watcher_;
  bool isThere_ = true;
  QTimer pause_;  // until a program that writes several files is through
};

/// Keeps work from being lost: copies for a crash, what another program does to the files, files
/// that could be read only in part or not be written, maps that are not there. Tells by notices.
class DocumentGuard : public QObject {
  Q_OBJECT
 public:
  /// `recoveryFolder` empty: no copies are kept.
  DocumentGuard(Workspace& workspace, FileCommands& files, NoticeBar& notices,
                const QString& recoveryFolder, QObject* parent = nullptr);
  editor::Autosave* autosave() const { return autosave_.get(); }
  FileWatch& watch() { return watch_; }
  void tellUnread(const base::Diagnostics& problems);  // of a file that was to be opened

 private:
  void offerRecovery();
  void restore(const QString& folder);
  void tellChanged(const QStringList& changed);
  void tellGone(bool isThere);
  void tellReadOnly();
  void tellMap();
  void tellExported(const QString& folder, int files);
  void tellNotExported(const base::Diagnostics& problems);
  void tellNotSaved(const QString& name, const base::Diagnostics& problems);

  Workspace& workspace_;
  editor::ScenarioDocument& document_;
  FileCommands& files_;
  NoticeBar& notices_;
  QString recoveryFolder_;
  FileWatch watch_;
  std::unique_ptr<editor::Autosave> autosave_;
};

}  // namespace app
