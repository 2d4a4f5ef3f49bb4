#include <array>
#include <iterator>
#include <numeric>

#include "editor/canvas/Layers.h"
#include "editor/canvas/PixelFrame.h"
#include "sim2d/map/DistanceField.h"

namespace editor {

namespace {

/// Cell colours for channel-wise averaging.
struct Shades {
  explicit Shades(const Theme& theme)
      : free(theme.color(Role::MapFree)),
        wall(theme.color(Role::MapOccupied)),
        unknown(theme.color(Role::MapUnknown)) {}

  /// The mean colour of `count` cells, `unknowns` of them unknown; `sum` is the sum of the known
  /// values.
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

/// The area `pixels` of a picture with one pixel per square of `side` cells. The last row and
/// column may contain fewer cells.
QImage meanImage(const sim2d::OccupancyGrid& grid, const Theme& theme, int side,
                 const QRect& pixels) {
  const Shades shades(theme);
  const int width = grid.width();
  QImage image(pixels.size(), QImage::Format_RGB32);
  for (int row = 0; row < image.height(); ++row) {
    const int top = grid.height() - 1 - (pixels.top() + row) * side;
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (int column = 0; column < image.width(); ++column) {
      const int first = (pixels.left() + column) * side;
      const int end = std::min(first + side, width);
      int count = 0, unknowns = 0, sum = 0;
      for (int y = std::max(0, top - side + 1); y <= top; ++y) {
        const std::int8_t* cells = grid.cells().data() + static_cast<std::ptrdiff_t>(y) * width;
        for (int x = first; x < end; ++x, ++count) {
          sum += std::max<int>(cells[x], 0);
          unknowns += cells[x] < 0 ? 1 : 0;
        }
      }
      line[column] = shades.mean(count, unknowns, sum);
    }
  }
  return image;
}

/// The same for `side` 1.
QImage cellImage(const sim2d::OccupancyGrid& grid, const Theme& theme, const QRect& pixels) {
  const Shades shades(theme);
  std::array<QRgb, 256> colors{};  // Indexed by the bit pattern of the value.
  for (int value = -128; value <= 127; ++value) {
    colors[static_cast<std::uint8_t>(value)] =
        shades.mean(1, value < 0 ? 1 : 0, std::clamp(value, 0, 100));
  }
  QImage image(pixels.size(), QImage::Format_RGB32);
  for (int row = 0; row < image.height(); ++row) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
    const std::ptrdiff_t below = grid.height() - 1 - pixels.top() - row;
    const std::int8_t* cells = grid.cells().data() + below * grid.width() + pixels.left();
    std::transform(cells, cells + image.width(), line,
                   [&](std::int8_t cell) { return colors[static_cast<std::uint8_t>(cell)]; });
  }
  return image;
}

/// Side length of the tiles of a map [pixels].
int tileSide(const sim2d::OccupancyGrid& grid) {
  constexpr int kTile = 512;
  const double cells = static_cast<double>(grid.width()) * grid.height();
  return cells > sim2d::DistanceField::kMaxCells ? kTile : std::max(grid.width(), grid.height());
}

constexpr std::size_t kMaxTiles = 32;  // Number of tiles cached in addition to the visible ones.

}  // namespace

QImage mapImage(const sim2d::OccupancyGrid& grid, const Theme& theme) {
  return cellImage(grid, theme, QRect(0, 0, grid.width(), grid.height()));
}

void MapItem::refresh() {
  prepareGeometryChange();
  tiles_.clear();
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

/// Tiles are rendered on first use; one pixel per cell takes much memory and time for a large map.
const QPixmap& MapItem::tile(int side, const QRect& pixels) {
  Tile& tile = tiles_[{side, pixels.left(), pixels.top()}];
  if (tile.picture.isNull()) {
    const sim2d::OccupancyGrid& grid = *document().map();
    tile.picture = QPixmap::fromImage(side == 1 ? cellImage(grid, theme(), pixels)
                                                : meanImage(grid, theme(), side, pixels));
  }
  tile.seen = paints_;
  return tile.picture;
}

/// Keeps the tiles used by the last paint event, and others up to a limit.
void MapItem::evictTiles() {
  for (auto tile = tiles_.begin(); tile != tiles_.end() && tiles_.size() > kMaxTiles;) {
    tile = tile->second.seen == paints_ ? std::next(tile) : tiles_.erase(tile);
  }
}

qint64 MapItem::bytes() const {
  return std::accumulate(tiles_.begin(), tiles_.end(), qint64{0}, [](qint64 sum, const auto& tile) {
    const QPixmap& picture = tile.second.picture;
    return sum + qint64{picture.width()} * picture.height() * picture.depth() / 8;
  });
}

void MapItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) {
  if (mapScene().isOpenPlane()) {
    return;
  }
  const sim2d::OccupancyGrid& grid = *document().map();
  const double pixelsPerCell = pixelsPerMetreOf(*painter) * grid.resolution();
  int side = 1;
  while (pixelsPerCell * side < 0.5 && side < std::max(grid.width(), grid.height())) {
    side *= 2;
  }
  const QRect whole(0, 0, (grid.width() + side - 1) / side, (grid.height() + side - 1) / side);
  const QRectF shown = sceneFromPixel_.inverted().mapRect(shownRect(*painter, *option, widget));
  const QRect seen =
      QRectF(shown.topLeft() / side, shown.size() / side).toAlignedRect().intersected(whole);
  const int step = tileSide(grid);
  ++paints_;
  painter->save();
  painter->setRenderHint(QPainter::SmoothPixmapTransform, pixelsPerCell < 1.0);
  painter->setRenderHint(QPainter::Antialiasing, false);
  painter->setTransform(sceneFromPixel_, true);
  for (int top = seen.top() / step * step; top <= seen.bottom(); top += step) {
    for (int left = seen.left() / step * step; left <= seen.right(); left += step) {
      const QRect pixels = QRect(left, top, step, step).intersected(whole);
      painter->drawPixmap(QRectF(QPointF(pixels.topLeft()) * side, QSizeF(pixels.size()) * side),
                          tile(side, pixels), QRectF(QPointF(), QSizeF(pixels.size())));
    }
  }
  painter->restore();
  evictTiles();
}

}  // namespace editor
