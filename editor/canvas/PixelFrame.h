#pragma once

#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <QWidget>

namespace editor {

inline double pixelsPerMetreOf(const QPainter& painter) {
  return QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter.worldTransform());
}

/// Device pixels per point.
inline double pixelRatioOf(const QPainter& painter) {
  return painter.device()->devicePixelRatioF();
}

/// Makes the pen width independent of the zoom, in points. Qt interprets the width of a cosmetic
/// pen as device pixels, which makes lines too thin on high-density screens.
inline void makeCosmetic(QPen& pen, const QPainter& painter) {
  pen.setCosmetic(true);
  pen.setWidthF(pen.widthF() * pixelRatioOf(painter));
}

/// A pen with a constant width on the screen and sharp corners.
inline QPen screenPen(const QPainter& painter, const QColor& color, double widthPx,
                      Qt::PenStyle style = Qt::SolidLine, Qt::PenCapStyle cap = Qt::FlatCap) {
  QPen pen(color, widthPx, style, cap, Qt::MiterJoin);
  makeCosmetic(pen, painter);
  return pen;
}

/// The part of the scene visible in the window, even if only some of it is repainted. Without a
/// widget it is the exposed area of a picture.
inline QRectF shownRect(const QPainter& painter, const QStyleOptionGraphicsItem& option,
                        const QWidget* widget) {
  return widget == nullptr ? option.exposedRect
                           : painter.worldTransform().inverted().mapRect(QRectF(widget->rect()));
}

/// Sets pen and brush.
inline void setPenAndBrush(QPainter& painter, const QPen& pen, const QBrush& fill = Qt::NoBrush) {
  painter.setPen(pen);
  painter.setBrush(fill);
}

/// Draws an unfilled ring.
inline void paintRing(QPainter& painter, const QPen& pen, double radius,
                      const QPointF& centre = {}) {
  setPenAndBrush(painter, pen);
  painter.drawEllipse(centre, radius, radius);
}

/// Sets the painter to pixel units with the origin at a scene point until destroyed, for parts with
/// a constant size on the screen.
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
