#pragma once

#include <QLabel>
#include <QStatusBar>

#include "app/window/Workspace.h"
#include "editor/look/Form.h"

namespace app {

/// The status bar: state, what a click does; place of the cursor, zoom, seed, speed.
class StatusLine : public QObject {
  Q_OBJECT
 public:
  StatusLine(QStatusBar& bar, Workspace& workspace);
  void setTheme() { showState(); }
  void setIdle(bool idle);                         // nothing is open
  void addPanels(const QList<QAction*>& toggles);  // of panels that are closed at first

 protected:
  /// What a menu entry does is said in the place of what a click does; nothing moves.
  bool eventFilter(QObject* window, QEvent* event) override;

 private:
  void showState();
  QString watched() const;
  void showPlace(const base::Vec2& world);
  void showPlaceOfMouse();  // none while it is elsewhere
  void showNumbers();
  QLabel* addRight(int width);

  QStatusBar& bar_;
  Workspace& workspace_;
  bool idle_ = false;
  QString tip_;         // of the menu entry or button under the mouse
  QString runEnd_;      // of the run that goes on, as it began
  bool isRun_ = false;  // not editing
  QLabel *dot_, *state_;
  editor::ElidedLabel* hint_;
  QWidget* panels_ = nullptr;
  QLabel *x_, *y_, *ground_, *zoom_, *seed_, *speed_;
};

}  // namespace app
