#pragma once

#include <memory>

#include "app/window/FileCommands.h"
#include "app/window/FileWatch.h"
#include "app/window/NoticeBar.h"
#include "editor/document/Autosave.h"

namespace app {

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
