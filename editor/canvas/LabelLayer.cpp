#include <array>
#include <cmath>
#include <numeric>

#include "editor/canvas/Layers.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/ViewOverlays.h"

namespace editor {

namespace {

using Places = std::array<QRectF, 8>;

/// The start of an interval that is shifted to lie between `low` and `high`.
double shiftedInto(double begin, double length, double low, double high) {
  return high - low < length ? begin : std::clamp(begin, low, high - length);
}

Places placesFor(const Label& label, const QRectF& window) {
  const double width = label.size.width();
  const double height = label.size.height();
  const QPointF c = label.centre;
  const double middle = shiftedInto(c.x() - 0.5 * width, width, window.left(), window.right());
  const double below = c.y() + label.clearancePx;
  const double above = c.y() - label.clearancePx - height;
  const double right = c.x() + label.clearancePx;
  const double left = c.x() - label.clearancePx - width;
  const double first = label.isAbove ? above : below;
  const double second = label.isAbove ? below : above;
  const double beside = shiftedInto(c.y() - 0.5 * height, height, window.top(), window.bottom());
  return {QRectF(middle, first, width, height), QRectF(middle, second, width, height),
          QRectF(right, beside, width, height), QRectF(left, beside, width, height),
          QRectF(right, first, width, height),  QRectF(left, first, width, height),
          QRectF(right, second, width, height), QRectF(left, second, width, height)};
}

/// A spatial hash of rectangles by the tiles that they touch.
class Occupied {
 public:
  void add(const QRectF& rect) {
    forTiles(rect, [&](const Tile& tile) {
      tiles_[tile].push_back(rect);
      return true;
    });
  }
  bool isFree(const QRectF& place) const {
    return forTiles(place, [&](const Tile& tile) {
      const auto found = tiles_.find(tile);
      return found == tiles_.end() ||
             std::none_of(found->second.begin(), found->second.end(),
                          [&](const QRectF& other) { return other.intersects(place); });
    });
  }

 private:
  using Tile = std::pair<int, int>;
  static constexpr double kSide = 96.0;  // [px]

  /// Calls `visit` for each tile until it returns false. Returns true if it never did.
  template <class Visit>
  static bool forTiles(const QRectF& rect, Visit&& visit) {
    const auto tileOf = [](double x) { return static_cast<int>(std::floor(x / kSide)); };
    for (int x = tileOf(rect.left()); x <= tileOf(rect.right()); ++x) {
      for (int y = tileOf(rect.top()); y <= tileOf(rect.bottom()); ++y) {
        if (!visit(Tile(x, y))) {
          return false;
        }
      }
    }
    return true;
  }

  std::map<Tile, std::vector<QRectF>> tiles_;
};

constexpr double kMarkPx = 9.0;
constexpr double kMarkGapPx = 5.0;
constexpr double kPadPx = 2.0;
constexpr double kEdgePx = kHaloPx + 1.0;  // Distance between a name and the edge of the window.
constexpr std::size_t kMaxPictures = 4000;
constexpr double kSparePx = 6.0;

QFont labelFont(const Theme& theme) {
  return theme.font(9.0, QFont::Medium);
}

QFont detailFont(const Theme& theme) {
  QFont font = theme.font(9.0);
  font.setItalic(true);
  return font;
}

double markSpace(const Label& label) {
  return label.mark ? kMarkPx + kMarkGapPx : 0.0;
}

/// Draws text with a halo in the background colour and an optional mark before it, in pixels.
void paintLabel(QPainter& painter, const Theme& theme, const QRectF& box, const Label& label) {
  const QFont font = labelFont(theme);
  const QFontMetricsF metrics(font);
  const QPointF baseline(box.left() + kPadPx + markSpace(label), box.top() + metrics.ascent());
  const QColor ground = theme.color(Role::MapFree, 0.9);
  paintHaloText(painter, baseline, font, label.text, ground, theme.color(Role::Text));
  if (!label.detail.isEmpty()) {
    paintHaloText(painter, {box.left() + kPadPx, baseline.y() + metrics.height()},
                  detailFont(theme), label.detail, ground, theme.color(Role::TextSecondary));
  }
  if (label.mark) {
    const QPointF centre(box.left() + kPadPx + 0.5 * kMarkPx,
                         baseline.y() - 0.5 * metrics.capHeight());
    setPenAndBrush(painter, Qt::NoPen, ground);
    painter.drawEllipse(centre, 0.5 * kMarkPx + 1.5, 0.5 * kMarkPx + 1.5);
    FigurePainter(theme).mark(painter, *label.mark, centre, kMarkPx);
  }
}

}  // namespace

std::vector<QRectF> layoutLabels(const std::vector<Label>& labels, const std::vector<QRectF>& taken,
                                 const QRectF& window) {
  std::vector<std::size_t> order(labels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rankOf = [&labels](std::size_t i) {  // Shown ones stay.
    return std::pair(labels[i].priority, labels[i].side >= 0);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rankOf(a) > rankOf(b); });
  Occupied bodies, placed;
  for (const QRectF& part : taken) {
    bodies.add(part);
  }
  std::vector<QRectF> result(labels.size());
  for (const std::size_t i : order) {
    Places places = placesFor(labels[i], window);
    if (labels[i].side > 0) {
      const auto kept = places.begin() + labels[i].side;
      std::rotate(places.begin(), kept, kept + 1);  // First.
    }
    const double spare = labels[i].side == Label::kHiddenSide ? kSparePx : 0.0;
    // A label must touch this area, so that its owner is recognizable.
    const QRectF near = around(labels[i].centre, labels[i].clearancePx + 1.0);
    const auto isOffLabels = [&](const QRectF& place) {
      return window.contains(place) && near.intersects(place) && placed.isFree(place);
    };
    const auto* found = std::find_if(places.begin(), places.end(), [&](const QRectF& place) {
      const QRectF wider = place.adjusted(-spare, -spare, spare, spare);
      return isOffLabels(place) && bodies.isFree(wider) && placed.isFree(wider);
    });
    if (found == places.end() && labels[i].isNeeded) {
      found = std::find_if(places.begin(), places.end(), isOffLabels);
    }
    if (found != places.end()) {
      result[i] = *found;
      placed.add(*found);
    }
  }
  return result;
}

int sideOf(const Label& label, const QRectF& place, const QRectF& window) {
  const Places places = placesFor(label, window);
  const auto* found = std::find(places.begin(), places.end(), place);
  return found == places.end() ? Label::kHiddenSide : static_cast<int>(found - places.begin());
}

QSizeF labelSize(const Theme& theme, const Label& label) {
  const QFontMetricsF metrics(labelFont(theme));
  const double width = metrics.horizontalAdvance(label.text) + markSpace(label);
  const double second = QFontMetricsF(detailFont(theme)).horizontalAdvance(label.detail);
  return {std::max(width, second) + 2.0 * kPadPx,
          label.detail.isEmpty() ? metrics.height() : 2.0 * metrics.height()};
}

const LabelLayer::Picture& LabelLayer::pictureOf(const Label& label, double ratio) {
  const Key key{label.text, label.detail, label.mark ? static_cast<int>(*label.mark) : -1,
                theme().isDark(), static_cast<int>(std::lround(100.0 * ratio))};
  const auto [found, isNew] = pictures_.try_emplace(key);
  Picture& picture = found->second;
  if (isNew) {
    picture.size = labelSize(theme(), label);
    const QSizeF whole = (picture.size + QSizeF(2.0 * kHaloPx, 2.0 * kHaloPx)) * ratio;
    picture.pixmap = QPixmap(whole.toSize() + QSize(1, 1));
    picture.pixmap.setDevicePixelRatio(ratio);
    picture.pixmap.fill(Qt::transparent);
    QPainter painter(&picture.pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    paintLabel(painter, theme(), QRectF(QPointF(kHaloPx, kHaloPx), picture.size), label);
  }
  return picture;
}

void LabelLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) {
  if (pictures_.size() > kMaxPictures) {
    pictures_.clear();
  }
  const bool isRun = mapScene().isRunMode();
  if (!isRun || sides_.size() > kMaxPictures) {
    sides_.clear();
  }
  const double pixelsPerMetre = pixelsPerMetreOf(*painter);
  const double ratio = painter->device()->devicePixelRatioF();
  const QTransform toPixels = QTransform::fromScale(pixelsPerMetre, pixelsPerMetre);
  const QRectF window = toPixels.mapRect(shownRect(*painter, *option, widget));
  std::vector<Label> labels;
  std::vector<const Picture*> pictures;
  for (Label& label : mapScene().labels()) {
    label.centre = toPixels.map(label.centre);
    const double reach = label.clearancePx;  // Partly visible entities get labels too.
    if (window.adjusted(-reach, -reach, reach, reach).contains(label.centre)) {
      pictures.push_back(&pictureOf(label, ratio));
      label.size = pictures.back()->size;
      const auto side = sides_.find(label.text);
      label.side = side == sides_.end() ? Label::kNoSide : side->second;
      labels.push_back(std::move(label));
    }
  }
  if (labels.empty()) {
    return;
  }
  std::vector<QRectF> taken = overlayRects({mapScene(), window, toPixels, pixelsPerMetre});
  for (const QRectF& part : mapScene().labelObstacles()) {
    const QRectF inPixels = toPixels.mapRect(part);
    if (inPixels.intersects(window)) {
      taken.push_back(inPixels);
    }
  }
  const QRectF inside = window.adjusted(kEdgePx, kEdgePx, -kEdgePx, -kEdgePx);
  const std::vector<QRectF> places = layoutLabels(labels, taken, inside);
  const PixelFrame frame(*painter, {});
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (isRun) {
      sides_[labels[i].text] = sideOf(labels[i], places[i], inside);
    }
    if (!places[i].isNull()) {
      // Aligned to device pixels for sharp letters.
      const QTransform toDevice = painter->worldTransform();
      const QPointF corner = toDevice.map(places[i].topLeft() - QPointF(kHaloPx, kHaloPx));
      const QPointF whole(std::round(corner.x()), std::round(corner.y()));
      painter->drawPixmap(toDevice.inverted().map(whole), pictures[i]->pixmap);
    }
  }
}

}  // namespace editor
