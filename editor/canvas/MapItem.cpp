#include "editor/canvas/MapItem.h"

#include <cmath>

#include <QPainter>
#include <QStyleOptionGraphicsItem>

#include "editor/canvas/MapScene.h"

namespace editor {

namespace {

/// Mean of the channels of four pixels, two at a time.
QRgb meanOf(QRgb a, QRgb b, QRgb c, QRgb d) {
  constexpr QRgb kOdd = 0x00ff00ff;
  const QRgb low = ((a & kOdd) + (b & kOdd) + (c & kOdd) + (d & kOdd)) >> 2;
  const QRgb high = ((a >> 8 & kOdd) + (b >> 8 & kOdd) + (c >> 8 & kOdd) + (d >> 8 & kOdd)) >> 2;
  return (low & kOdd) | (high & kOdd) << 8;
}

/// Half as wide and high, each pixel the mean of four; a last odd row or column is left out.
QImage halved(const QImage& image) {
  QImage half(image.width() / 2, image.height() / 2, QImage::Format_RGB32);
  for (int row = 0; row < half.height(); ++row) {
    const auto* upper = reinterpret_cast<const QRgb*>(image.constScanLine(2 * row));
    const auto* lower = reinterpret_cast<const QRgb*>(image.constScanLine(2 * row + 1));
    auto* line = reinterpret_cast<QRgb*>(half.scanLine(row));
    for (int column = 0; column < half.width(); ++column) {
      const int at = 2 * column;
      line[column] = meanOf(upper[at], upper[at + 1], lower[at], lower[at + 1]);
    }
  }
  return half;
}

}  // namespace

QImage mapImage(const sim2d::OccupancyGrid& grid, const Theme& theme) {
  const QRgb unknown = theme.color(Role::MapUnknown).rgb();
  const QColor free = theme.color(Role::MapFree);
  const QColor wall = theme.color(Role::MapOccupied);
  std::array<QRgb, 101> shades{};
  for (int value = 0; value <= 100; ++value) {
    const double part = value / 100.0;
    const auto channel = [part](int a, int b) { return qRound(a + (b - a) * part); };
    shades[static_cast<std::size_t>(value)] =
        qRgb(channel(free.red(), wall.red()), channel(free.green(), wall.green()),
             channel(free.blue(), wall.blue()));
  }
  QImage image(grid.width(), grid.height(), QImage::Format_RGB32);
  const auto width = static_cast<std::size_t>(grid.width());
  for (int row = 0; row < grid.height(); ++row) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(grid.height() - 1 - row));
    for (std::size_t column = 0; column < width; ++column) {
      const std::int8_t value = grid.cells()[static_cast<std::size_t>(row) * width + column];
      line[column] = value < 0 ? unknown : shades[std::min<std::size_t>(std::uint8_t(value), 100)];
    }
  }
  return image;
}

void MapItem::set(std::shared_ptr<const sim2d::OccupancyGrid> grid, const Theme& theme) {
  prepareGeometryChange();
  grid_ = std::move(grid);
  levels_.clear();
  image_ = QImage();
  bounds_ = QRectF();
  if (isOpenPlane()) {
    return;
  }
  const double width = grid_->width();
  const double height = grid_->height();
  const QPointF topLeft = MapScene::sceneFromWorld(grid_->cornerToWorld(0.0, height));
  const QPointF topRight = MapScene::sceneFromWorld(grid_->cornerToWorld(width, height));
  const QPointF bottomLeft = MapScene::sceneFromWorld(grid_->cornerToWorld(0.0, 0.0));
  const QPointF right = (topRight - topLeft) / width;
  const QPointF down = (bottomLeft - topLeft) / height;
  sceneFromPixel_ = QTransform(right.x(), right.y(), down.x(), down.y(), topLeft.x(), topLeft.y());
  bounds_ = sceneFromPixel_.mapRect(QRectF(0.0, 0.0, width, height));
  image_ = mapImage(*grid_, theme);
  levels_.push_back(QPixmap::fromImage(image_));
}

const QPixmap& MapItem::levelFor(double pixelsPerCell) {
  std::size_t level = 0;
  while (std::ldexp(pixelsPerCell, static_cast<int>(level)) < 0.5) {
    ++level;
  }
  while (levels_.size() <= level && levels_.back().width() > 1 && levels_.back().height() > 1) {
    image_ = halved(image_);
    levels_.push_back(QPixmap::fromImage(image_));
  }
  return levels_[std::min(level, levels_.size() - 1)];
}

void MapItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (isOpenPlane()) {
    return;
  }
  const double pixelsPerMetre =
      QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter->worldTransform());
  const double pixelsPerCell = pixelsPerMetre * grid_->resolution();
  const QPixmap& level = levelFor(pixelsPerCell);
  painter->save();
  painter->setRenderHint(QPainter::SmoothPixmapTransform, pixelsPerCell < 1.0);
  painter->setRenderHint(QPainter::Antialiasing, false);
  painter->setTransform(sceneFromPixel_, true);
  painter->drawPixmap(QRectF(0.0, 0.0, grid_->width(), grid_->height()), level,
                      QRectF(QPointF(), QSizeF(level.size())));
  painter->restore();
}

}  // namespace editor
