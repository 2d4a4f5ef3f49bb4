#pragma once

#include <map>
#include <memory>

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
  const QPixmap& levelOf(int side);

  std::shared_ptr<const sim2d::OccupancyGrid> grid_;
  QRectF bounds_;
  QTransform sceneFromPixel_;
  Theme theme_ = Theme::light();
  std::map<int, QPixmap> levels_;  // by the cells along the side of a pixel
};

/// An image with one pixel per cell; also for thumbnails.
QImage mapImage(const sim2d::OccupancyGrid& grid, const Theme& theme);

}  // namespace editor
