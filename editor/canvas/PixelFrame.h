#pragma once

#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <QWidget>

namespace editor {

inline double pixelsPerMetreOf(const QPainter& painter) {
  return QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter.worldTransform());
}

/// Pixels per point of the screen.
inline double pixelRatioOf(const QPainter& painter) {
  return painter.device()->devicePixelRatioF();
}

/// Lets the width of a pen count points of the screen, whatever the zoom. Qt takes that of a
/// cosmetic pen for pixels, which would make hairlines of all lines on dense screens.
inline void makeCosmetic(QPen& pen, const QPainter& painter) {
  pen.setCosmetic(true);
  pen.setWidthF(pen.widthF() * pixelRatioOf(painter));
}

/// A pen of that width on the screen, with sharp corners.
inline QPen screenPen(const QPainter& painter, const QColor& color, double widthPx,
                      Qt::PenStyle style = Qt::SolidLine, Qt::PenCapStyle cap = Qt::FlatCap) {
  QPen pen(color, widthPx, style, cap, Qt::MiterJoin);
  makeCosmetic(pen, painter);
  return pen;
}

/// The part of the scene that the window shows, whole even when only some of it is painted anew.
/// Without a widget it is what a picture shows.
inline QRectF shownRect(const QPainter& painter, const QStyleOptionGraphicsItem& option,
                        const QWidget* widget) {
  return widget == nullptr ? option.exposedRect
                           : painter.worldTransform().inverted().mapRect(QRectF(widget->rect()));
}

/// What lines are drawn with, and what fills what they enclose.
inline void setInk(QPainter& painter, const QPen& pen, const QBrush& fill = Qt::NoBrush) {
  painter.setPen(pen);
  painter.setBrush(fill);
}

/// A ring of that pen, and nothing in it.
inline void paintRing(QPainter& painter, const QPen& pen, double radius,
                      const QPointF& centre = {}) {
  setInk(painter, pen);
  painter.drawEllipse(centre, radius, radius);
}

/// While it lives, the painter's unit is one pixel and its origin a point of the scene: for what
/// keeps its size on the screen.
class PixelFrame {
 public:
  PixelFrame(QPainter& painter, const QPointF& sceneOrigin) : painter_(painter) {
    const double scale = 1.0 / pixelsPerMetreOf(painter);
    painter_.save();
    painter_.translate(sceneOrigin);
    painter_.scale(scale, scale);
  }
  ~PixelFrame() { painter_.restore(); }
  Q_DISABLE_COPY_MOVE(PixelFrame)

 private:
  QPainter& painter_;
};

}  // namespace editor
