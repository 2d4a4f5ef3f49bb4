#include "app/window/DockTitle.h"

#include <QMainWindow>
#include <QPainter>

namespace app {

namespace {

constexpr int kHeight = 32;

}  // namespace

DockTitle::DockTitle(QDockWidget& dock) : QWidget(&dock), dock_(dock) {
  const auto follow = [this] {
    updateGeometry();
    update();
  };
  connect(&dock_, &QDockWidget::topLevelChanged, this, follow);
  connect(&dock_, &QDockWidget::dockLocationChanged, this, follow);
  connect(&dock_, &QDockWidget::visibilityChanged, this, follow);
}

bool DockTitle::isNeeded() const {
  const auto* window = qobject_cast<QMainWindow*>(dock_.parentWidget());
  return dock_.isFloating() || window == nullptr || window->tabifiedDockWidgets(&dock_).isEmpty();
}

QSize DockTitle::sizeHint() const {
  return {80, isNeeded() ? kHeight : 0};
}

void DockTitle::paintEvent(QPaintEvent*) {
  if (!isNeeded()) {
    return;
  }
  QPainter painter(this);
  QFont bold = font();
  bold.setPointSizeF(9.5);
  bold.setWeight(QFont::DemiBold);
  painter.setFont(bold);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(rect().adjusted(12, 0, -12, 0), Qt::AlignLeft | Qt::AlignVCenter,
                   dock_.windowTitle());
}

}  // namespace app
