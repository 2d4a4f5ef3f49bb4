#pragma once

#include "app/window/Docks.h"
#include "app/window/KeyRules.h"
#include "app/window/StartPage.h"
#include "app/window/StatusLine.h"
#include "app/window/WindowActions.h"
#include "app/window/Workspace.h"
#include "app/window/files/FileCommands.h"
#include "app/window/study/StudyPanel.h"

namespace editor {
class TextViewer;
}  // namespace editor

namespace app {

class DocumentGuard;
class NoticeBar;

struct WindowSetup {
  editor::Theme theme = editor::Theme::light();
  bool followsSystem = true;   // its colour scheme
  bool storesSettings = true;  // store layout and recent files; off for tests
  QString shippedMaps;
  std::vector<ShippedScenario> demos;
  RunSpec options;
  sim2d::Compatibility compatibility;  // set by the options
  editor::ToolRegistry tools = editor::standardTools();
  editor::PanelRegistry panels = windowPanels();
  QString recoveryFolder;  // for copies of unsaved work; empty: none
};

/// The main window: connects all parts and asks before changes are lost. A closed window keeps its
/// document until it is destroyed.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(const WindowSetup& setup, QWidget* parent = nullptr);
  ~MainWindow() override;
  Q_DISABLE_COPY_MOVE(MainWindow)
  /// The initial size if the screen is large enough, and the size of pictures.
  static QSize defaultSize() { return {1280, 800}; }

  Workspace& workspace() { return workspace_; }
  Docks& docks() { return *docks_; }
  FileCommands& files() { return *files_; }
  WindowActions& actions() { return *actions_; }
  editor::TextViewer* viewer() const { return viewer_; }  // null until first used
  NoticeBar& notices() { return *notices_; }
  DocumentGuard& guard() { return *guard_; }
  bool open(const QString& path) { return files_->openFile(path); }
  void setTheme(const editor::Theme& theme);
  bool isOnStartPage() const { return centre_->currentWidget() == startPage_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void placeParts(const WindowSetup& setup);
  void connectFiles();
  void connectView();
  void connectRun();
  void showStart(bool start);
  void showTitle();
  void showDock(const QString& name);
  void updateActions();
  void showSideBySide(QWidget* view, int columns);
  void showBreakpoint(const sim2d::TreeBreakpointHit& at);
  void showFullScreenMap(bool on);
  void showAbout();
  void showShortcuts();
  void showFile(const QString& file, int line);
  void saveLayout();
  void saveTheme();

  Workspace workspace_;
  UserSettings userSettings_;
  bool followsSystem_;
  bool placed_ = false;
  WindowActions* actions_ = new WindowActions(workspace_, this);
  KeyRules* keys_ = new KeyRules(*this, workspace_);
  NoticeBar* notices_;
  QStackedWidget* centre_ = new QStackedWidget(this);
  QSplitter* canvas_ = new QSplitter(Qt::Horizontal, this);  // the map and views beside it
  StartPage* startPage_ = nullptr;
  Docks* docks_;
  FileCommands* files_;
  DocumentGuard* guard_;
  StatusLine* status_ = new StatusLine(*statusBar(), workspace_);
  QToolBar* toolBar_;
  QMenu* recent_ = nullptr;
  QLabel* saved_ = new QLabel(this);
  editor::TextViewer* viewer_ = nullptr;
  QPointer<QDialog> keysDialog_;
};

}  // namespace app
