#include <QPaintEvent>
#include <QPainter>

#include "editor/canvas/GroupLayer.h"
#include "editor/canvas/MapView.h"
#include "editor/canvas/Overlays.h"

// How MapView paints.
namespace editor {

namespace {

constexpr int kStateLinePx = 3;
constexpr int kPictureMargin = 160;  // [px]

}  // namespace

/// The view moves: crowded scenes are shown by a picture for so long.
void MapView::glide() {
  settle_.start();
}

void MapView::paintEvent(QPaintEvent* event) {
  const bool glides = settle_.isActive();
  const bool usesPicture = scene_.isCrowded() && !scene_.isRunMode();
  if (!usesPicture) {
    picture_.clear();
    QGraphicsView::paintEvent(event);
    return;
  }
  const RestingPicture::Window window{viewportTransform(), viewport()->size(),
                                      viewport()->devicePixelRatioF()};
  if (!picture_.fits(scene_, window, !glides)) {
    picture_.take(scene_, window, glides ? kPictureMargin : 0);
  }
  QPainter painter(viewport());
  painter.setRenderHints(renderHints());
  picture_.draw(painter, window);
  const QRectF seen = mapToScene(viewport()->rect()).boundingRect();
  painter.setTransform(viewportTransform());
  scene_.paintPart(painter, CanvasPart::Moving, seen);
  painter.resetTransform();
  drawForeground(&painter, seen);
}

void MapView::drawBackground(QPainter* painter, const QRectF& rect) {
  painter->fillRect(rect, scene_.groundColor());
}

void MapView::drawForeground(QPainter* painter, const QRectF&) {
  painter->save();
  painter->resetTransform();
  const QRectF window = viewport()->rect();
  const OverlayContext context{scene_, window, viewportTransform(), pixelsPerMetre(),
                               legendCorner_};
  if (scene_.options().rulers) {
    paintRulers(*painter, context);
  }
  paintScaleBar(*painter, context);
  legendCorner_ = paintGroupLegend(*painter, context);
  paintForceLegend(*painter, context);
  if (state_ != CanvasState::Editing) {
    const Role role = state_ == CanvasState::Running  ? Role::Ok
                      : state_ == CanvasState::Paused ? Role::WarningMark
                                                      : Role::Past;
    painter->fillRect(QRectF(0.0, 0.0, window.width(), kStateLinePx), scene_.theme().color(role));
  }
  painter->restore();
}

}  // namespace editor
