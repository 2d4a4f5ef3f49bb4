#pragma once

#include <map>
#include <vector>

#include <QDockWidget>
#include <QMainWindow>
#include <QToolBar>

#include "app/window/Workspace.h"
#include "editor/panels/PanelRegistry.h"

namespace app {

/// The panels around the canvas: those of a registry, and the timeline over the whole width.
class Docks : public QObject {
  Q_OBJECT
 public:
  Docks(QMainWindow& window, Workspace& workspace, const editor::PanelRegistry& panels);

  editor::PanelContext& context() { return context_; }
  QDockWidget* dock(const QString& name) const;  // any case; null when there is none
  QStringList names() const;                     // lower case, in order of the menu
  const std::vector<QDockWidget*>& all() const { return docks_; }
  void show(const QStringList& names);  // exactly these
  void resetLayout();
  void placeFirst();  // sizes, once the window has its own
  /// Opens a panel, brings it before the others of its place, or closes it; checked while it is
  /// seen.
  QAction* toggleOf(const QDockWidget& dock) const { return toggles_.at(&dock); }
  QList<QAction*> toggles() const;               // of all panels, in order of the menu
  QList<QAction*> togglesBelow() const;          // of those below the canvas
  QAction* mapOnly() const { return mapOnly_; }  // all panels close, and come back as they were
  /// The tree takes the place of the map, with the values of its nodes beside it.
  QAction* treeLarge() const { return treeLarge_; }
  void setShown(bool shown);  // all of them, for the start page and the full screen
  /// What lies in the middle of the window, which gives way to a large tree; null: nothing does.
  void setCentre(QWidget* centre) { centre_ = centre; }
  template <class T>
  T& panel() const {
    return *window_.findChild<T*>();
  }

 private:
  void add(const editor::PanelRegistry::Entry& entry);
  void addToggle(QDockWidget& dock);
  void giveRoom(QDockWidget& dock, int room);
  void showMapOnly(bool on);
  void showTreeLarge(bool on);
  void keepOpen(const std::vector<const QDockWidget*>& kept);
  void bringBack();
  void addTimeline();
  QWidget* makeScrubButtons();
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showCount(const QWidget* panel, int count, base::Severity worst);

  QMainWindow& window_;
  Workspace& workspace_;
  editor::PanelContext context_;
  std::vector<QDockWidget*> docks_;
  std::map<const QDockWidget*, QAction*> toggles_;
  std::vector<const QDockWidget*> open_;  // at first
  QAction *mapOnly_, *treeLarge_;
  std::vector<QDockWidget*> openBefore_;  // mapOnly, treeLarge
  QByteArray sizesBefore_;
  std::map<QDockWidget*, bool> shownBefore_;  // while all are hidden
  QByteArray layoutBefore_;                   // with their sizes, once the window is seen
  QToolBar* timelineBar_;
  QAction* scrubButtons_ = nullptr;  // beside the timeline
  QWidget* centre_ = nullptr;
};

}  // namespace app
