#pragma once

#include "editor/look/FigurePainter.h"

namespace editor {

inline double pixelsPerMetreOf(const QPainter& painter) {
  return QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter.worldTransform());
}

/// Device pixels per point.
inline double pixelRatioOf(const QPainter& painter) {
  return painter.device()->devicePixelRatioF();
}

/// The pen with a width in points that is independent of the zoom. Qt interprets the width of a
/// cosmetic pen as device pixels, which makes lines too thin on high-density screens.
inline QPen cosmetic(QPen pen, const QPainter& painter) {
  pen.setCosmetic(true);
  pen.setWidthF(pen.widthF() * pixelRatioOf(painter));
  return pen;
}

/// A pen with a constant width on the screen and sharp corners.
inline QPen screenPen(const QPainter& painter, const QColor& color, double widthPx,
                      Qt::PenStyle style = Qt::SolidLine, Qt::PenCapStyle cap = Qt::FlatCap) {
  return cosmetic(QPen(color, widthPx, style, cap, Qt::MiterJoin), painter);
}

/// A pen with dashes; `dashes`: lengths of dashes and gaps in line widths.
inline QPen dashedPen(const QColor& color, double width, const QVector<qreal>& dashes,
                      Qt::PenCapStyle cap = Qt::FlatCap) {
  QPen pen(color, width, Qt::CustomDashLine, cap);
  pen.setDashPattern(dashes);
  return pen;
}

/// The part of the scene visible in the window, even if only some of it is repainted. Without a
/// widget it is the exposed area of a picture.
inline QRectF shownRect(const QPainter& painter, const QStyleOptionGraphicsItem& option,
                        const QWidget* widget) {
  return widget == nullptr ? option.exposedRect
                           : painter.worldTransform().inverted().mapRect(QRectF(widget->rect()));
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
