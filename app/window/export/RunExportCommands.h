#pragma once

#include "app/window/Docks.h"
#include "app/window/WindowActions.h"
#include "app/window/Workspace.h"
#include "app/window/export/RunExportDialog.h"
#include "app/window/files/FileDialogs.h"

namespace app {

/// The commands that save the run, or a scenario that has not run, as a picture or film.
class RunExportCommands : public QObject {
  Q_OBJECT
 public:
  RunExportCommands(Workspace& workspace, Docks& docks, const WindowActions& actions,
                    UserSettings& userSettings, QWidget& window);

  /// Call when a document is opened or closed. `isOpen`: there is one.
  void setOpen(bool isOpen);

 Q_SIGNALS:
  void saved(const QString& file);

 private:
  void updateEnabled();
  void savePicture();
  void saveFilm();
  void run(RunExportDialog& dialog);
  ExportSource source() const;
  AskExportFile askFile(const QString& title);

  Workspace& workspace_;
  Docks& docks_;
  const WindowActions& actions_;
  UserSettings& userSettings_;
  QWidget& window_;
  bool isOpen_ = false;
};

}  // namespace app
