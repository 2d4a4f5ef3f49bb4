#include "app/window/MainWindow.h"
#include "app/window/settings/PreferencesDialog.h"
#include "app/window/settings/ShortcutsPage.h"
#include "editor/document/MapEdit.h"
#include "editor/look/DeferredActions.h"
#include "editor/panels/IssuesPanel.h"

namespace app {

void MainWindow::addHelp(const WindowSetup& setup) {
  keyMap_ = new KeyMap(*menuBar(), userSettings_, this);
  preferences_ = new Preferences(workspace_, userSettings_, guard_->autosave(), this);
  help_ = new WindowHelp(*this, workspace_, *actions_, setup.manual);
  tour_ = new GuidedTour(*this, workspace_, *actions_, *docks_);
  connect(tour_, &GuidedTour::manualRequested, help_, &WindowHelp::showPage);
}

void MainWindow::showAbout() {
  QMessageBox::about(this, tr("About HuNavSim Desktop"),
                     tr("<b>HuNavSim Desktop %1</b><br>Scenarios for human-aware navigation: draw, "
                        "simulate, measure.")
                         .arg(QApplication::applicationVersion()));
}

void MainWindow::showShortcuts() {
  if (keysDialog_ == nullptr) {
    keysDialog_ = new ShortcutsDialog(*keyMap_, this);
    editor::deleteWhenClosed(*keysDialog_);
  }
  keysDialog_->show();  // non-modal, so that keys can be tried
  keysDialog_->raise();
  keysDialog_->activateWindow();
}

void MainWindow::showPreferences() {
  if (preferencesDialog_ == nullptr) {
    preferencesDialog_ = new PreferencesDialog(*preferences_, *actions_, *keyMap_, workspace_,
                                               files_->folder(), this);
    editor::deleteWhenClosed(*preferencesDialog_);
  }
  preferencesDialog_->show();
  preferencesDialog_->raise();
  preferencesDialog_->activateWindow();
}

/// In a new room, so that nothing of the user is changed.
void MainWindow::startTour() {
  constexpr double kWidth = 10.0, kDepth = 7.0;  // [m]
  if (files_->maybeSave()) {
    files_->newOnMap(editor::emptyRoom(kWidth, kDepth));
    tour_->start();
  }
}

/// A file name without a folder is relative to the scenario.
void MainWindow::showFile(const QString& file, int line) {
  if (viewer_ == nullptr) {
    viewer_ = new editor::TextViewer(workspace_.theme(), this);
  }
  const QFileInfo scenario(workspace_.document().path());
  const bool there = QFileInfo::exists(file) || scenario.path().isEmpty();
  const QString problem =
      viewer_->showFile(there ? file : scenario.absoluteDir().filePath(file), line);
  if (!problem.isEmpty()) {
    statusBar()->showMessage(problem, kMessageMs);
  }
}

}  // namespace app
