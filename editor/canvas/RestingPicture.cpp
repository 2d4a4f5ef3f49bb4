#include "editor/canvas/RestingPicture.h"

#include <QPainter>

namespace editor {

namespace {

constexpr double kMostBlur = 1.6;  // scale of the window to that of the picture, and the inverse

}  // namespace

bool RestingPicture::fits(const MapScene& scene, const Window& window, bool exactly) const {
  if (pixmap_.isNull() || revision_ != scene.restingRevision() ||
      pixmap_.devicePixelRatio() != window.ratio || moving_ != scene.movingIds()) {
    return false;
  }
  if (exactly) {
    return window.fromScene * QTransform::fromTranslate(margin_, margin_) == fromScene_;
  }
  const double scale = window.fromScene.m11() / fromScene_.m11();
  const QRectF seen =
      (window.fromScene.inverted() * fromScene_).mapRect(QRectF(QPointF(), window.size));
  const QRectF whole(QPointF(), QSizeF(pixmap_.size()) / window.ratio);
  return scale < kMostBlur && scale > 1.0 / kMostBlur && whole.contains(seen);
}

void RestingPicture::take(MapScene& scene, const Window& window, int margin) {
  const QSize size = window.size + QSize(2 * margin, 2 * margin);
  margin_ = margin;
  revision_ = scene.restingRevision();
  moving_ = scene.movingIds();
  fromScene_ = window.fromScene * QTransform::fromTranslate(margin, margin);
  pixmap_ = QPixmap(size * window.ratio);
  pixmap_.setDevicePixelRatio(window.ratio);
  pixmap_.fill(scene.groundColor());
  QPainter painter(&pixmap_);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  painter.setTransform(fromScene_);
  scene.paintPart(painter, CanvasPart::Resting,
                  fromScene_.inverted().mapRect(QRectF(QPointF(), size)));
}

void RestingPicture::draw(QPainter& painter, const Window& window) const {
  const QTransform toWindow = fromScene_.inverted() * window.fromScene;
  painter.save();
  painter.setTransform(toWindow);
  painter.setRenderHint(QPainter::SmoothPixmapTransform, toWindow.type() > QTransform::TxTranslate);
  painter.drawPixmap(QPointF(), pixmap_);
  painter.restore();
}

}  // namespace editor
