#pragma once

#include "app/window/WindowActions.h"
#include "app/window/help/ManualPages.h"

namespace app {

class CommandPalette;
class ManualViewer;

/// Help in the window: F1 opens the manual page of what has the focus, also in dialogs; *What's
/// this?* explains what is clicked; the command palette.
class WindowHelp : public QObject {
  Q_OBJECT
 public:
  WindowHelp(QMainWindow& window, Workspace& workspace, const WindowActions& actions,
             ManualFolders manual);
  ~WindowHelp() override;
  Q_DISABLE_COPY_MOVE(WindowHelp)

  /// Opens a page in the desktop's browser if its HTML is installed, otherwise in a window of the
  /// program.
  void showPage(const QString& page);
  ManualViewer* viewer() const;  // null until first used
  CommandPalette& palette();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showPageOfFocus();
  bool explains(QWidget& widget, QEvent& event);

  QMainWindow& window_;
  Workspace& workspace_;
  const WindowActions& actions_;
  ManualFolders manual_;
  QPointer<ManualViewer> viewer_;
  CommandPalette* palette_ = nullptr;
};

}  // namespace app
