#pragma once

#include <string>
#include <utility>
#include <vector>

#include <QAction>
#include <QList>
#include <QMenu>

#include "app/window/FileDialogs.h"
#include "app/window/Workspace.h"

namespace app {

/// Connects a checkable action with an option of the map.
void bindOption(QAction& action, editor::MapScene& scene, bool editor::CanvasOptions::*option);

/// Checkable commands for the run overlays of the map, all off initially.
class OverlayActions : public QObject {
  Q_OBJECT
 public:
  OverlayActions(Workspace& workspace, QObject* parent);

  QAction *velocities, *gaussian, *sight, *density, *plans, *contacts, *thoughts, *speech,
      *localCosts, *globalCosts;
  QList<QAction*> all;
  void restoreAndStore(UserSettings& userSettings);  // restores and stores their states
  /// Their names on the command line, including "zones", "forces" and "ways".
  static std::vector<std::string> names();
  void show(const std::vector<std::string>& names);

 private:
  QAction* toggle(const QString& text, bool editor::CanvasOptions::*option, int letter,
                  const QString& description);

  Workspace& workspace_;
};

/// The commands of the window, except tools and playback, with icon, shortcut and text. Commands
/// for the map and the selection are connected here, the others by the window.
class WindowActions : public QObject {
  Q_OBJECT
 public:
  static constexpr const char* kNameProperty = "name";  // property of commands with changing text
  explicit WindowActions(Workspace& workspace, QObject* parent = nullptr);
  void setTheme(const editor::Theme& theme);

  QAction *newOpenPlane, *newFromMap, *open, *openRun, *save, *saveAs, *exportTo, *close, *quit;
  QAction *newEmptyRoom, *copyFigure, *copyPlot;
  QAction *undo, *redo, *cut, *copy, *paste, *duplicate, *rename, *remove, *selectAll, *deselect;
  QAction *next, *previous;  // person, or entity of the selected kind
  QAction *zoomIn, *zoomOut, *zoomFit, *fullScreen, *resetLayout, *switchTheme, *systemTheme;
  QAction *openMap, *assignGoals, *settings, *history, *shortcuts, *about;
  QAction *publishFoxglove, *publishRos2;  // checkable
  QAction *names, *routes, *grid, *rulers, *trails, *rings, *forces, *snapToPoints;
  QAction *robotPath, *lidar, *detections, *candidates;
  /// Checkable: what the canvas shows and what drawing snaps to.
  QList<QAction*> overlays, layers, snapping;
  OverlayActions* const runOverlays;
  void fillArrangeMenu(QMenu& menu) const;
  /// Restores and stores the display options of the map.
  void restoreAndStore(UserSettings& userSettings);

 private:
  QAction* make(const QString& text, const QString& description, const QKeySequence& shortcut = {},
                const char* icon = nullptr);
  QAction* toggle(const QString& text, bool editor::CanvasOptions::*option,
                  const QKeySequence& shortcut = {}, const char* icon = nullptr,
                  const QString& description = {});
  void makeFileActions();
  void makeEditActions();
  void makeViewActions();
  void makeLayers();
  void makeArranging();
  void connectEditing();
  void updateEnabled();
  void connectClipboard();
  void copySelection();
  void selectNext(int by);

  Workspace& workspace_;
  std::vector<std::pair<QAction*, const char*>> icons_;
  std::vector<std::pair<QAction*, std::size_t>> arranging_;  // with the minimum selection size
  int pastes_ = 0;  // of the same copy; each is offset from the previous one
};

}  // namespace app
