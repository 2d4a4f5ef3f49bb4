#pragma once

#include <vector>

#include <QAction>

#include "app/window/CanvasActions.h"
#include "app/window/Workspace.h"

namespace app {

/// The commands of the window beside tools and playback, with icon, shortcut and words. Those about
/// the map and the selection work by themselves; the window connects the others.
class WindowActions : public QObject {
  Q_OBJECT
 public:
  explicit WindowActions(Workspace& workspace, QObject* parent = nullptr);
  void setTheme(const editor::Theme& theme);

  QAction *newRoom, *newFromMap, *open, *openRun, *save, *saveAs, *exportTo, *close, *quit;
  QAction* newWalledRoom;
  QAction *undo, *redo, *cut, *copy, *paste, *duplicate, *rename, *remove, *selectAll, *deselect;
  QAction *next, *previous;  // person, or thing of the kind that is selected
  QAction *zoomIn, *zoomOut, *zoomFit, *fullScreen, *resetLayout, *switchTheme, *systemTheme;
  QAction *openMap, *assignGoals, *settings, *about;
  /// Overlays of the canvas, checkable.
  const std::vector<QAction*>& overlays() const { return overlays_; }
  CanvasActions* canvas;
  QAction *names, *routes, *grid, *rulers, *trails, *rings, *forces;

 private:
  QAction* make(const QString& text, const QString& icon, const QKeySequence& shortcut,
                const QString& says);
  QAction* overlay(const QString& text, const QString& icon, const QKeySequence& shortcut,
                   bool editor::CanvasOptions::*option, const QString& says = {});
  void makeFileActions();
  void makeEditActions();
  void makeViewActions();
  void connectEditing();
  void followSelection();
  void connectClipboard();
  void copySelection();
  void selectNext(int by);

  Workspace& workspace_;
  std::vector<std::pair<QAction*, QString>> icons_;
  std::vector<QAction*> overlays_;
  int pastes_ = 0;  // of the same copy: each lands beside the one before
};

}  // namespace app
