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
  void placeFirst();          // sizes, once the window has its own
  void setShown(bool shown);  // all of them, for the start page and the full screen
  template <class T>
  T& panel() const {
    return *window_.findChild<T*>();
  }

 private:
  void add(const editor::PanelRegistry::Entry& entry);
  void addTimeline();
  void showCount(const QWidget* panel, int count);
  void grow(editor::SimulationRunner::State state);  // at the first run

  QMainWindow& window_;
  Workspace& workspace_;
  editor::PanelContext context_;
  std::vector<QDockWidget*> docks_;
  std::map<QDockWidget*, bool> shownBefore_;  // while all are hidden
  QByteArray layoutBefore_;                   // with their sizes, once the window is seen
  QToolBar* timelineBar_;
  bool grown_ = false;
};

}  // namespace app
