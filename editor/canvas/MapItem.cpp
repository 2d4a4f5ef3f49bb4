#include "editor/canvas/MapItem.h"

#include <algorithm>
#include <array>
#include <vector>

#include <QPainter>
#include <QStyleOptionGraphicsItem>

#include "editor/canvas/MapScene.h"

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

/// Sums of a row of pixels: of the known values, and how many are not known.
struct PixelRow {
  std::vector<int> sums, unknowns;

  void clear(int pixels) {
    sums.assign(static_cast<std::size_t>(pixels), 0);
    unknowns.assign(static_cast<std::size_t>(pixels), 0);
  }
  void add(const std::int8_t* cells, int count, int side) {
    for (int first = 0, pixel = 0; first < count; first += side, ++pixel) {
      int sum = 0;
      int unknown = 0;
      const int end = std::min(first + side, count);
      for (int i = first; i < end; ++i) {
        sum += std::max<int>(cells[i], 0);
        unknown += cells[i] < 0 ? 1 : 0;
      }
      sums[static_cast<std::size_t>(pixel)] += sum;
      unknowns[static_cast<std::size_t>(pixel)] += unknown;
    }
  }
};

/// One pixel for each square of `side` cells; those of the last row and column may hold fewer.
QImage meanImage(const sim2d::OccupancyGrid& grid, const Theme& theme, int side) {
  const Shades shades(theme);
  const int width = grid.width();
  const int height = grid.height();
  QImage image((width + side - 1) / side, (height + side - 1) / side, QImage::Format_RGB32);
  PixelRow pixels;
  for (int row = 0; row < image.height(); ++row) {
    const int top = height - 1 - row * side;
    const int rows = std::min(side, top + 1);
    pixels.clear(image.width());
    for (int i = 0; i < rows; ++i) {
      const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(top - i) * width;
      pixels.add(grid.cells().data() + first, width, side);
    }
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (int column = 0; column < image.width(); ++column) {
      const int cells = rows * std::min(side, width - column * side);
      const auto at = static_cast<std::size_t>(column);
      line[column] = shades.mean(cells, pixels.unknowns[at], pixels.sums[at]);
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

void MapItem::set(std::shared_ptr<const sim2d::OccupancyGrid> grid, const Theme& theme) {
  prepareGeometryChange();
  grid_ = std::move(grid);
  theme_ = theme;
  levels_.clear();
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
}

/// Made when it is first seen: one cell per pixel takes much memory and time for a large map.
const QPixmap& MapItem::levelOf(int side) {
  const auto [level, isNew] = levels_.try_emplace(side);
  if (isNew) {
    level->second =
        QPixmap::fromImage(side == 1 ? mapImage(*grid_, theme_) : meanImage(*grid_, theme_, side));
  }
  return level->second;
}

void MapItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (isOpenPlane()) {
    return;
  }
  const double pixelsPerMetre =
      QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter->worldTransform());
  const double pixelsPerCell = pixelsPerMetre * grid_->resolution();
  int side = 1;
  while (pixelsPerCell * side < 0.5 && side < std::max(grid_->width(), grid_->height())) {
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
