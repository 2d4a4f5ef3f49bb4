#include "app/window/DockTitle.h"

#include <algorithm>

#include <QMainWindow>
#include <QPainter>

namespace app {

namespace {

constexpr int kHeight = 32;

}  // namespace

DockTitle::DockTitle(QDockWidget& dock) : QWidget(&dock), dock_(dock) {
  connect(&dock_, &QDockWidget::topLevelChanged, this, &DockTitle::follow);
  connect(&dock_, &QDockWidget::dockLocationChanged, this, &DockTitle::follow);
  connect(&dock_, &QDockWidget::visibilityChanged, this, &DockTitle::follow);
}

void DockTitle::follow() {
  updateGeometry();
  update();
}

bool DockTitle::isNeeded() const {
  const auto* window = qobject_cast<QMainWindow*>(dock_.parentWidget());
  if (dock_.isFloating() || window == nullptr) {
    return true;
  }
  // Docks that are closed keep their place among the tabs but have none.
  const QList<QDockWidget*> others = window->tabifiedDockWidgets(&dock_);
  return std::all_of(others.begin(), others.end(),
                     [](const QDockWidget* other) { return other->isHidden(); });
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
