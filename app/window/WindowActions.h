#pragma once

#include <utility>
#include <vector>

#include <QAction>
#include <QMenu>

#include "app/window/FileDialogs.h"
#include "app/window/OverlayActions.h"
#include "app/window/Workspace.h"

namespace app {

/// The commands of the window beside tools and playback, with icon, shortcut and words. Those about
/// the map and the selection work by themselves; the window connects the others.
class WindowActions : public QObject {
  Q_OBJECT
 public:
  static constexpr const char* kName = "name";  // property: of a command whose text changes
  explicit WindowActions(Workspace& workspace, QObject* parent = nullptr);
  void setTheme(const editor::Theme& theme);

  QAction *newRoom, *newFromMap, *open, *openRun, *save, *saveAs, *exportTo, *close, *quit;
  QAction *newWalledRoom, *copyFigure, *copyPlot;
  QAction *undo, *redo, *cut, *copy, *paste, *duplicate, *rename, *remove, *selectAll, *deselect;
  QAction *next, *previous;  // person, or thing of the kind that is selected
  QAction *zoomIn, *zoomOut, *zoomFit, *fullScreen, *resetLayout, *switchTheme, *systemTheme;
  QAction *openMap, *assignGoals, *settings, *history, *shortcuts, *about;
  QAction *watchLive, *onRos2;  // checkable
  QAction *names, *routes, *grid, *rulers, *trails, *rings, *forces, *snapToPoints;
  QAction *robotPath, *lidar, *detections, *candidates;
  /// What the canvas shows and what drawing snaps to, checkable.
  QList<QAction*> overlays, layers, snapping;
  OverlayActions* const ofRuns;
  void fillArrangeMenu(QMenu& menu) const;
  /// What the map shows beside its things is as it was left.
  void remember(Memory& memory);

 private:
  QAction* make(const QString& text, const QString& says, const QKeySequence& shortcut = {},
                const char* icon = nullptr);
  QAction* toggle(const QString& text, bool editor::CanvasOptions::*option,
                  const QKeySequence& shortcut = {}, const char* icon = nullptr,
                  const QString& says = {});
  void makeFileActions();
  void makeEditActions();
  void makeViewActions();
  void makeLayers();
  void makeArranging();
  void connectEditing();
  void followSelection();
  void connectClipboard();
  void copySelection();
  void selectNext(int by);

  Workspace& workspace_;
  std::vector<std::pair<QAction*, const char*>> icons_;
  std::vector<std::pair<QAction*, std::size_t>> arranging_;  // and how many things it needs
  int pastes_ = 0;  // of the same copy: each lands beside the one before
};

}  // namespace app
