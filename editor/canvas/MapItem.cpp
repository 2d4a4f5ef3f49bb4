#include <algorithm>
#include <array>

#include "editor/canvas/Layers.h"
#include "editor/canvas/PixelFrame.h"

namespace editor {

namespace {

/// Colours of cells that are summed up channel by channel.
struct Shades {
  explicit Shades(const Theme& theme)
      : free(theme.color(Role::MapFree)),
        wall(theme.color(Role::MapOccupied)),
        unknown(theme.color(Role::MapUnknown)) {}

  /// Of cells whose known values have that sum.
  QRgb mean(int count, int unknowns, int sum) const {
    const double known = count - unknowns;
    const double walls = sum / 100.0;
    const auto channel = [&](int a, int b, int c) {
      return qRound(((known - walls) * a + walls * b + unknowns * c) / count);
    };
    return qRgb(channel(free.red(), wall.red(), unknown.red()),
                channel(free.green(), wall.green(), unknown.green()),
                channel(free.blue(), wall.blue(), unknown.blue()));
  }

  QColor free, wall, unknown;
};

/// One pixel for each square of `side` cells; those of the last row and column may hold fewer.
QImage meanImage(const sim2d::OccupancyGrid& grid, const Theme& theme, int side) {
  const Shades shades(theme);
  const int width = grid.width();
  const int height = grid.height();
  QImage image((width + side - 1) / side, (height + side - 1) / side, QImage::Format_RGB32);
  for (int row = 0; row < image.height(); ++row) {
    const int top = height - 1 - row * side;
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (int column = 0; column < image.width(); ++column) {
      const int end = std::min((column + 1) * side, width);
      int count = 0, unknowns = 0, sum = 0;
      for (int y = std::max(0, top - side + 1); y <= top; ++y) {
        const std::int8_t* cells = grid.cells().data() + static_cast<std::ptrdiff_t>(y) * width;
        for (int x = column * side; x < end; ++x, ++count) {
          sum += std::max<int>(cells[x], 0);
          unknowns += cells[x] < 0 ? 1 : 0;
        }
      }
      line[column] = shades.mean(count, unknowns, sum);
    }
  }
  return image;
}

}  // namespace

QImage mapImage(const sim2d::OccupancyGrid& grid, const Theme& theme) {
  const Shades shades(theme);
  std::array<QRgb, 256> colors{};  // by the bits of the value
  for (int value = -128; value <= 127; ++value) {
    colors[static_cast<std::uint8_t>(value)] =
        shades.mean(1, value < 0 ? 1 : 0, std::clamp(value, 0, 100));
  }
  QImage image(grid.width(), grid.height(), QImage::Format_RGB32);
  const auto width = static_cast<std::size_t>(grid.width());
  for (int row = 0; row < grid.height(); ++row) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(grid.height() - 1 - row));
    const std::int8_t* cells = grid.cells().data() + static_cast<std::size_t>(row) * width;
    for (std::size_t column = 0; column < width; ++column) {
      line[column] = colors[static_cast<std::uint8_t>(cells[column])];
    }
  }
  return image;
}

void MapItem::refresh() {
  prepareGeometryChange();
  levels_.clear();
  bounds_ = QRectF();
  if (mapScene().isOpenPlane()) {
    return;
  }
  const sim2d::OccupancyGrid& grid = *document().map();
  const double width = grid.width();
  const double height = grid.height();
  const QPointF topLeft = toScene(grid.cornerToWorld(0.0, height));
  const QPointF topRight = toScene(grid.cornerToWorld(width, height));
  const QPointF bottomLeft = toScene(grid.cornerToWorld(0.0, 0.0));
  const QPointF right = (topRight - topLeft) / width;
  const QPointF down = (bottomLeft - topLeft) / height;
  sceneFromPixel_ = QTransform(right.x(), right.y(), down.x(), down.y(), topLeft.x(), topLeft.y());
  bounds_ = sceneFromPixel_.mapRect(QRectF(0.0, 0.0, width, height));
}

/// Made when it is first seen: one cell per pixel takes much memory and time for a large map.
const QPixmap& MapItem::levelOf(int side) {
  const auto [level, isNew] = levels_.try_emplace(side);
  if (isNew) {
    const sim2d::OccupancyGrid& grid = *document().map();
    level->second =
        QPixmap::fromImage(side == 1 ? mapImage(grid, theme()) : meanImage(grid, theme(), side));
  }
  return level->second;
}

void MapItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (mapScene().isOpenPlane()) {
    return;
  }
  const sim2d::OccupancyGrid& grid = *document().map();
  const double pixelsPerCell = pixelsPerMetreOf(*painter) * grid.resolution();
  int side = 1;
  while (pixelsPerCell * side < 0.5 && side < std::max(grid.width(), grid.height())) {
    side *= 2;
  }
  const QPixmap& level = levelOf(side);
  painter->save();
  painter->setRenderHint(QPainter::SmoothPixmapTransform, pixelsPerCell < 1.0);
  painter->setRenderHint(QPainter::Antialiasing, false);
  painter->setTransform(sceneFromPixel_, true);
  const QRectF whole(QPointF(), QSizeF(level.size()));
  painter->drawPixmap(QRectF(QPointF(), whole.size() * side), level, whole);
  painter->restore();
}

}  // namespace editor
