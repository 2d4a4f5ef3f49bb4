#pragma once

#include <memory>

#include <QtWidgets>

#include "app/window/NoticeBar.h"
#include "app/window/files/FileCommands.h"
#include "editor/document/Autosave.h"

namespace app {

/// Protects unsaved work and reports file problems as notices: copies for crash recovery, changes
/// of files by other programs, files that could be read only partly or not be written, missing
/// maps.
class DocumentGuard : public QObject {
  Q_OBJECT
 public:
  /// `recoveryFolder` empty: no copies are kept.
  DocumentGuard(Workspace& workspace, FileCommands& files, NoticeBar& notices,
                const QString& recoveryFolder, QObject* parent = nullptr);
  editor::Autosave* autosave() const { return autosave_.get(); }
  void checkFiles();  // checks the files on disk
  void reportUnreadable(
      const base::Diagnostics& problems);  // reports a file that could not be opened

 Q_SIGNALS:
  void scenarioFileChanged();  // the scenario file was removed or restored

 private:
  void watchFiles();
  void offerRecovery();
  void restore(const QString& folder);
  void reportChanged(const QStringList& changed);
  void reportRemoved();
  void reportReadOnly();
  void reportMapProblem();
  void reportExported(const QString& folder, int files);
  void reportNotSaved(const QString& name, const base::Diagnostics& problems);

  Workspace& workspace_;
  editor::ScenarioDocument& document_;
  FileCommands& files_;
  NoticeBar& notices_;
  QString recoveryFolder_;
  QFileSystemWatcher watcher_;
  QTimer pause_;         // waits for a program that writes several files
  bool isThere_ = true;  // whether the scenario file exists
  std::unique_ptr<editor::Autosave> autosave_;
};

}  // namespace app
