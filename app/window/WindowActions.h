#pragma once

#include "app/window/Docks.h"
#include "app/window/Workspace.h"
#include "app/window/files/FileDialogs.h"
#include "editor/panels/LayersPanel.h"

namespace app {

/// The commands of the window, except tools and playback, with icon, shortcut and text. Commands
/// for the map and the selection are connected here, the others by the window.
class WindowActions : public QObject {
  Q_OBJECT
 public:
  static constexpr const char* kNameProperty = "name";  // property of commands with changing text
  explicit WindowActions(Workspace& workspace, QObject* parent = nullptr);
  void setTheme(const editor::Theme& theme);

  QAction *newOpenPlane, *newFromMap, *open, *openRun, *save, *saveAs, *exportTo, *savePicture,
      *saveFilm, *close, *quit;
  QAction *newEmptyRoom, *copyFigure, *copyPlot, *savePlot;
  QAction *undo, *redo, *cut, *copy, *paste, *duplicate, *rename, *remove, *selectAll, *deselect;
  QAction *next, *previous;  // person, or entity of the selected kind
  QAction *zoomIn, *zoomOut, *zoomFit, *fullScreen, *resetLayout, *switchTheme, *systemTheme;
  QAction *openMap, *assignGoals, *settings, *history, *importTracks;
  QAction *palette, *preferences, *tour, *manual, *whatsThis, *shortcuts, *about;
  QAction *publishFoxglove, *publishRos2;  // checkable
  QAction *names, *routes, *grid, *rings, *forces, *snapToPoints, *lidar, *detections, *candidates;
  /// Checkable: what the canvas shows, also of a run only, and what drawing snaps to.
  QList<QAction*> overlays, layers, runOverlays, snapping;
  /// The layers of the map in the groups of menu and panel.
  struct LayerGroup {
    QString title;
    std::vector<editor::MapLayer> layers;
  };
  const std::vector<LayerGroup>& layerGroups() const { return layerGroups_; }
  /// The names of overlays on the command line, and their selection.
  static std::vector<std::string> overlayNames();
  void showOverlays(const std::vector<std::string>& names);
  void fillArrangeMenu(QMenu& menu) const;
  /// Pastes with the centre at this position [m]; none: at the copied position.
  void pasteAt(const std::optional<base::Vec2>& place);
  /// Restores and stores the display options of the map.
  void restoreAndStore(UserSettings& userSettings);
  void storeOpacities(UserSettings& userSettings) const;

 private:
  QAction* make(const QString& text, const QString& description, const QKeySequence& shortcut = {},
                const char* icon = nullptr);
  struct Toggle;
  QList<QAction*> togglesOf(const std::vector<Toggle>& rows);
  void makeFileActions();
  void makeHelpActions();
  void makeEditActions();
  void makeViewActions();
  void makeToggles();
  void makeOverlays();
  void makeLayers();
  void makeSnapping();
  void makeRunOverlays();
  void makeLayerGroups();
  void restoreOpacities(const UserSettings& userSettings);
  QAction* actionOf(bool editor::CanvasOptions::*option) const;
  void makeArranging();
  void connectEditing();
  void updateEnabled();
  void connectClipboard();
  void copySelection();
  void selectNext(int by);

  Workspace& workspace_;
  std::vector<std::pair<QAction*, const char*>> icons_;
  std::vector<std::pair<QAction*, const char*>> stored_;  // with the key of their state
  std::map<QAction*, bool editor::CanvasOptions::*> optionOf_;
  std::vector<LayerGroup> layerGroups_;
  std::vector<std::pair<QAction*, std::size_t>> arranging_;  // with the minimum selection size
};

/// The tool bar: file, undo | tools | run | view.
QToolBar* makeToolBar(QMainWindow& window, Workspace& workspace, WindowActions& actions,
                      const Docks& docks);

/// Creates the menus with all commands. Returns the menu for recent files, which the caller fills.
QMenu* makeMenus(QMainWindow& window, Workspace& workspace, WindowActions& actions, Docks& docks);

/// The context menu of the map while the select tool is active; other tools end their lines with
/// the right button.
void connectCanvasMenu(Workspace& workspace, WindowActions& actions, const Docks& docks);

}  // namespace app
