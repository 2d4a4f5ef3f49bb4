#pragma once

#include <set>

#include "app/window/Workspace.h"
#include "editor/panels/PanelRegistry.h"

namespace app {

/// Property of the action of a panel that shows a count in each session: only its button shows it,
/// and keeps the space for it.
constexpr const char* kCountedProperty = "counted";
/// Property of the same action: the button also keeps the space for the icon of the worst problem.
constexpr const char* kMarkedProperty = "marked";

/// The dock panels around the canvas from a registry, and the timeline across the full width.
class Docks : public QObject {
  Q_OBJECT
 public:
  Docks(QMainWindow& window, Workspace& workspace, const editor::PanelRegistry& panels);

  editor::PanelContext& context() { return context_; }
  QDockWidget* dock(const QString& name) const;  // case-insensitive; null: unknown
  QStringList names() const;                     // lower case, in menu order
  const std::vector<QDockWidget*>& all() const { return docks_; }
  void show(const QStringList& names);  // closes all others
  void resetLayout();
  void setInitialSizes();  // sets the sizes after the window is sized
  /// The action that opens, raises or closes a panel; checked while the panel is visible.
  QAction* toggleOf(const QDockWidget& dock) const { return toggles_.at(&dock); }
  QList<QAction*> toggles() const;               // of all panels, in menu order
  QList<QAction*> bottomToggles() const;         // of the panels below the canvas
  QAction* mapOnly() const { return mapOnly_; }  // closes all panels; unchecking restores them
  /// Shows the behavior tree instead of the map, with node values beside it.
  QAction* treeMaximized() const { return treeLarge_; }
  void setShown(bool shown);  // all panels; for the start page and full screen
  /// The central widget, which is hidden while the tree is large. Null: none.
  void setCentre(QWidget* centre) { centre_ = centre; }
  template <class T>
  T& panel() const {
    return *window_.findChild<T*>();
  }

 private:
  void add(const editor::PanelRegistry::Entry& entry);
  void addToggle(QDockWidget& dock);
  QDockWidget* frontBeside(QDockWidget& dock) const;
  void ensureHeight(QDockWidget& dock, int initialHeight);
  void showMapOnly(bool on);
  void showTreeLarge(bool on);
  void showOnly(const std::vector<const QDockWidget*>& kept);
  void restoreDocks();
  void addTimeline();
  QWidget* makeScrubButtons();
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showCount(const QWidget* panel, int count, base::Severity worst);

  QMainWindow& window_;
  Workspace& workspace_;
  editor::PanelContext context_;
  std::vector<QDockWidget*> docks_;
  std::map<const QDockWidget*, QAction*> toggles_;
  std::vector<const QDockWidget*> open_;                        // open by default
  std::set<const QDockWidget*> hadRoom_;                        // got their initial height
  std::map<const QDockWidget*, QPointer<QDockWidget>> behind_;  // what each covered when opened
  QAction *mapOnly_, *treeLarge_;
  std::vector<QDockWidget*> openBeforeMaximized_;  // before mapOnly or treeMaximized
  QByteArray sizesBefore_;
  std::map<QDockWidget*, bool> shownBefore_;  // visibility before all were hidden
  QByteArray layoutBefore_;                   // dock state, saved when the window is shown
  QToolBar* timelineBar_;
  QAction* scrubButtons_ = nullptr;  // beside the timeline
  QWidget* centre_ = nullptr;
};

}  // namespace app
