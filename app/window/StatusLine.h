#pragma once

#include "app/window/Workspace.h"
#include "editor/look/Form.h"

namespace app {

/// The status bar: state and hint; cursor position, zoom, seed, speed.
class StatusLine : public QObject {
  Q_OBJECT
 public:
  StatusLine(QStatusBar& bar, Workspace& workspace);
  void setTheme() { showState(); }
  void setIdle(bool idle);                         // whether nothing is open
  void addPanels(const QList<QAction*>& toggles);  // adds panels that are closed by default

 protected:
  /// Shows the status tip of a menu entry instead of the hint, after the reason of a stop.
  bool eventFilter(QObject* window, QEvent* event) override;

 private:
  void showState();
  QString watchedName() const;
  void showPosition(const base::Vec2& world);
  void showMousePosition();  // empty if the mouse is not over the map
  void showNumbers();
  QLabel* addRight(int width);

  QStatusBar& bar_;
  Workspace& workspace_;
  bool idle_ = false;
  QString tip_;         // status tip of the hovered menu entry or button
  QString runEnd_;      // end condition of the run, when it started
  bool isRun_ = false;  // a run is displayed
  QLabel *dot_ = new QLabel, *state_ = new QLabel;
  editor::ElidedLabel* hint_ = new editor::ElidedLabel(nullptr, Qt::ElideRight);
  QWidget* panels_ = nullptr;
  QLabel *position_, *zoom_, *seed_, *speed_;
};

}  // namespace app
