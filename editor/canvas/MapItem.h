#pragma once

#include <memory>
#include <vector>

#include <QGraphicsItem>
#include <QPixmap>

#include "editor/look/Theme.h"
#include "sim2d/map/OccupancyGrid.h"

namespace editor {

/// The map in the colours of the theme: cells with sharp edges when near, smaller copies of it when
/// far so that thin walls stay visible.
class MapItem : public QGraphicsItem {
 public:
  void set(std::shared_ptr<const sim2d::OccupancyGrid> grid, const Theme& theme);
  bool isOpenPlane() const { return grid_ == nullptr || grid_->isEmpty(); }

  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  const QPixmap& levelFor(double pixelsPerCell);

  std::shared_ptr<const sim2d::OccupancyGrid> grid_;
  QRectF bounds_;
  QTransform sceneFromPixel_;
  QImage image_;                 // one pixel per cell, first row on top
  std::vector<QPixmap> levels_;  // each half the size of the one before
};

/// An image with one pixel per cell; also for thumbnails.
QImage mapImage(const sim2d::OccupancyGrid& grid, const Theme& theme);

}  // namespace editor
