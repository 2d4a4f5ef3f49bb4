#pragma once

#include <QDockWidget>
#include <QLabel>

namespace app {

/// The heading of a dock; gives way to the tab when the dock is one of several.
class DockTitle : public QWidget {
  Q_OBJECT
 public:
  explicit DockTitle(QDockWidget& dock);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }
  bool isNeeded() const;
  void follow();  // after docks beside it came or went

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QDockWidget& dock_;
};

}  // namespace app
