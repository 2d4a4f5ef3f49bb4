#pragma once

#include <memory>

#include <QFileSystemWatcher>
#include <QTimer>

#include "app/window/FileCommands.h"
#include "app/window/NoticeBar.h"
#include "editor/document/Autosave.h"

namespace app {

/// Keeps work from being lost: copies for a crash, what another program does to the files (the
/// program's own saving is nothing to tell), files that could be read only in part or not be
/// written, maps that are not there. Tells by notices.
class DocumentGuard : public QObject {
  Q_OBJECT
 public:
  /// `recoveryFolder` empty: no copies are kept.
  DocumentGuard(Workspace& workspace, FileCommands& files, NoticeBar& notices,
                const QString& recoveryFolder, QObject* parent = nullptr);
  editor::Autosave* autosave() const { return autosave_.get(); }
  void lookNow();                                      // what has become of the files
  void tellUnread(const base::Diagnostics& problems);  // of a file that was to be opened

 Q_SIGNALS:
  void scenarioThere();  // the file of the scenario has gone, or is back

 private:
  void watchFiles();
  void offerRecovery();
  void restore(const QString& folder);
  void tellChanged(const QStringList& changed);
  void tellGone();
  void tellReadOnly();
  void tellMap();
  void tellExported(const QString& folder, int files);
  void tellNotSaved(const QString& name, const base::Diagnostics& problems);

  Workspace& workspace_;
  editor::ScenarioDocument& document_;
  FileCommands& files_;
  NoticeBar& notices_;
  QString recoveryFolder_;
  QFileSystemWatcher watcher_;
  QTimer pause_;         // until a program that writes several files is through
  bool isThere_ = true;  // the file of the scenario
  std::unique_ptr<editor::Autosave> autosave_;
};

}  // namespace app
