#include "app/window/ScaleView.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QPainter>

namespace app {

using editor::Role;

namespace {

constexpr double kReach = 10.0;   // of a point that can be dragged [px]
constexpr double kMargin = 12.0;  // around the image: a point on its edge is seen whole [px]

}  // namespace

ScaleView::ScaleView(QImage image, const editor::Theme& theme, QWidget* parent)
    : QWidget(parent), image_(std::move(image)), theme_(theme) {
  setMinimumSize(320, 240);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setCursor(Qt::CrossCursor);
  setAccessibleName(tr("Image of the map"));
}

void ScaleView::setPoints(std::vector<QPointF> points) {
  points_ = std::move(points);
  update();
  Q_EMIT pointsChanged();
}

QRectF ScaleView::imageRect() const {
  const QSizeF room = QSizeF(this->size()) - QSizeF(2.0 * kMargin, 2.0 * kMargin);
  const QSizeF size = QSizeF(image_.size()).scaled(room, Qt::KeepAspectRatio);
  return {QPointF((width() - size.width()) / 2.0, (height() - size.height()) / 2.0), size};
}

QPointF ScaleView::toImage(const QPointF& widget) const {
  const QRectF rect = imageRect();
  return {(widget.x() - rect.left()) / rect.width() * image_.width(),
          (rect.bottom() - widget.y()) / rect.height() * image_.height()};
}

QPointF ScaleView::toWidget(const QPointF& image) const {
  const QRectF rect = imageRect();
  return {rect.left() + image.x() / image_.width() * rect.width(),
          rect.bottom() - image.y() / image_.height() * rect.height()};
}

void ScaleView::mousePressEvent(QMouseEvent* event) {
  held_ = -1;
  if (event->button() != Qt::LeftButton) {
    return;
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const QPointF away = toWidget(points_[i]) - event->localPos();
    if (std::hypot(away.x(), away.y()) <= kReach) {
      held_ = static_cast<int>(i);
      return;
    }
  }
  if (imageRect().contains(event->localPos())) {
    std::vector<QPointF> points = points_.size() == 2 ? std::vector<QPointF>() : points_;
    points.push_back(toImage(event->localPos()));
    held_ = static_cast<int>(points.size()) - 1;
    setPoints(std::move(points));
  }
}

void ScaleView::mouseMoveEvent(QMouseEvent* event) {
  if (held_ >= 0 && event->buttons().testFlag(Qt::LeftButton)) {
    const QRectF rect = imageRect();
    const QPointF inside(std::clamp(event->localPos().x(), rect.left(), rect.right()),
                         std::clamp(event->localPos().y(), rect.top(), rect.bottom()));
    std::vector<QPointF> points = points_;
    points[static_cast<std::size_t>(held_)] = toImage(inside);
    setPoints(std::move(points));
  }
}

void ScaleView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme_.color(Role::CanvasOutside));
  painter.setRenderHint(QPainter::SmoothPixmapTransform, imageRect().width() < image_.width());
  painter.drawImage(imageRect(), image_);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor accent = theme_.color(Role::Accent);
  if (points_.size() == 2) {
    painter.setPen(QPen(Qt::white, 4.0));
    painter.drawLine(toWidget(points_[0]), toWidget(points_[1]));
    painter.setPen(QPen(accent, 2.0));
    painter.drawLine(toWidget(points_[0]), toWidget(points_[1]));
  }
  int number = 1;
  for (const QPointF& point : points_) {
    const QPointF at = toWidget(point);
    painter.setPen(QPen(Qt::white, 2.0));
    painter.setBrush(accent);
    painter.drawEllipse(at, 8.0, 8.0);
    painter.setFont(theme_.font(8.0, QFont::Bold));
    painter.drawText(QRectF(at - QPointF(8, 8), QSizeF(16, 16)), Qt::AlignCenter,
                     QString::number(number++));
  }
}

}  // namespace app
