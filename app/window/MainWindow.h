#pragma once

#include "app/window/Docks.h"
#include "app/window/KeyRules.h"
#include "app/window/StartPage.h"
#include "app/window/StatusLine.h"
#include "app/window/WindowActions.h"
#include "app/window/Workspace.h"
#include "app/window/files/FileCommands.h"
#include "app/window/help/WindowHelp.h"
#include "app/window/settings/KeyMap.h"
#include "app/window/settings/Preferences.h"
#include "app/window/study/StudyPanel.h"
#include "app/window/tour/GuidedTour.h"

namespace editor {
class TextViewer;
}  // namespace editor

namespace app {

class DocumentGuard;
class NoticeBar;
class RunExportCommands;

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
  QString recoveryFolder;   // for copies of unsaved work; empty: none
  QString openFilesFolder;  // shared by all windows of the user; empty: none
  QString thumbnailFolder;  // for pictures of scenarios; empty: not kept
  ManualFolders manual;
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
  StartPage& startPage() { return *startPage_; }
  WindowHelp& help() { return *help_; }
  KeyMap& keyMap() { return *keyMap_; }
  Preferences& preferences() { return *preferences_; }
  GuidedTour& tour() { return *tour_; }
  bool open(const QString& path) { return files_->openFile(path); }
  void setTheme(const editor::Theme& theme);
  /// Ends the program without questions, as at logout. Unsaved work is kept for the next session.
  void endSession();
  bool isOnStartPage() const { return centre_->currentWidget() == startPage_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  static constexpr int kMessageMs = 8000;  // of the status bar
  void placeParts(const WindowSetup& setup);
  void connectFiles();
  void connectView();
  void connectRun();
  void addHelp(const WindowSetup& setup);
  void showStart(bool start);
  void showTitle();
  void showDock(const QString& name);
  void updateActions();
  void showSideBySide(QWidget* view, int columns);
  void showBreakpoint(const sim2d::TreeBreakpointHit& at);
  void showFullScreenMap(bool on);
  void showAbout();
  void showShortcuts();
  void showPreferences();
  void startTour();
  void showFile(const QString& file, int line);
  void saveLayout();
  void reportOptions();
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
  QLabel* paneTitle_ = new QLabel(this);  // of the run on the map, while views are beside it
  StartPage* startPage_ = nullptr;
  Docks* docks_;
  FileCommands* files_;
  DocumentGuard* guard_;
  RunExportCommands* exports_;
  StatusLine* status_ = new StatusLine(*statusBar(), workspace_);
  QToolBar* toolBar_;
  QMenu* recent_ = nullptr;
  QLabel* saved_ = new QLabel(this);
  editor::TextViewer* viewer_ = nullptr;
  KeyMap* keyMap_ = nullptr;
  Preferences* preferences_ = nullptr;
  WindowHelp* help_ = nullptr;
  GuidedTour* tour_ = nullptr;
  QPointer<QDialog> keysDialog_, preferencesDialog_;
};

}  // namespace app
