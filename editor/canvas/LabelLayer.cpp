#include <cmath>

#include <QPainterPath>

#include "editor/canvas/LabelLayout.h"
#include "editor/canvas/Layers.h"
#include "editor/canvas/Overlays.h"
#include "editor/canvas/PixelFrame.h"

namespace editor {

namespace {

constexpr double kMarkPx = 9.0;
constexpr double kMarkGapPx = 5.0;
constexpr double kHaloPx = 3.5;
constexpr double kPadPx = 2.0;
constexpr double kEdgePx = kHaloPx + 1.0;  // between a name and the edge of the window
constexpr std::size_t kMostPictures = 4000;

QFont labelFont(const Theme& theme) {
  return theme.font(9.0, QFont::Medium);
}

double markSpace(const Label& label) {
  return label.mark ? kMarkPx + kMarkGapPx : 0.0;
}

}  // namespace

QSizeF labelSize(const Theme& theme, const Label& label) {
  const QFontMetricsF metrics(labelFont(theme));
  return {metrics.horizontalAdvance(label.text) + markSpace(label) + 2.0 * kPadPx,
          metrics.height()};
}

void paintLabel(QPainter& painter, const Theme& theme, const QRectF& box, const Label& label) {
  const QFont font = labelFont(theme);
  const QFontMetricsF metrics(font);
  const QPointF baseline(box.left() + kPadPx + markSpace(label), box.top() + metrics.ascent());
  const QColor ground = theme.color(Role::MapFree, 0.9);
  QPainterPath text;
  text.addText(baseline, font, label.text);
  painter.setPen(QPen(ground, kHaloPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(text);
  painter.setFont(font);
  painter.setPen(theme.color(Role::Text));
  painter.drawText(baseline, label.text);
  if (label.mark) {
    const QPointF centre(box.left() + kPadPx + 0.5 * kMarkPx,
                         baseline.y() - 0.5 * metrics.capHeight());
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawEllipse(centre, 0.5 * kMarkPx + 1.5, 0.5 * kMarkPx + 1.5);
    FigurePainter(theme).mark(painter, *label.mark, centre, kMarkPx);
  }
}

const LabelLayer::Picture& LabelLayer::pictureOf(const Label& label, double ratio) {
  const Key key{label.text, label.mark ? static_cast<int>(*label.mark) : -1, theme().isDark(),
                static_cast<int>(std::lround(100.0 * ratio))};
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
  if (pictures_.size() > kMostPictures) {
    pictures_.clear();
  }
  const double pixelsPerMetre = pixelsPerMetreOf(*painter);
  const double ratio = painter->device()->devicePixelRatioF();
  const QTransform toPixels = QTransform::fromScale(pixelsPerMetre, pixelsPerMetre);
  const QRectF window = toPixels.mapRect(shownRect(*painter, *option, widget));
  std::vector<LabelWish> wishes;
  std::vector<const Picture*> pictures;
  for (const Label& label : mapScene().labels()) {
    const QPointF centre = toPixels.map(label.centre);
    const double reach = label.clearancePx;  // who is partly seen is named too
    if (window.adjusted(-reach, -reach, reach, reach).contains(centre)) {
      pictures.push_back(&pictureOf(label, ratio));
      wishes.push_back({centre, label.clearancePx, pictures.back()->size, label.priority,
                        label.isAbove, label.isNeeded});
    }
  }
  if (wishes.empty()) {
    return;
  }
  std::vector<QRectF> taken = overlayBoxes({mapScene(), window, toPixels, pixelsPerMetre});
  for (const QRectF& part : mapScene().solidParts()) {
    const QRectF inPixels = toPixels.mapRect(part);
    if (inPixels.intersects(window)) {
      taken.push_back(inPixels);
    }
  }
  const std::vector<QRectF> places =
      layoutLabels(wishes, taken, window.adjusted(kEdgePx, kEdgePx, -kEdgePx, -kEdgePx));
  const PixelFrame frame(*painter, {});
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    if (!places[i].isNull()) {
      // On whole pixels: letters stay sharp.
      const QTransform toDevice = painter->worldTransform();
      const QPointF corner = toDevice.map(places[i].topLeft() - QPointF(kHaloPx, kHaloPx));
      const QPointF whole(std::round(corner.x()), std::round(corner.y()));
      painter->drawPixmap(toDevice.inverted().map(whole), pictures[i]->pixmap);
    }
  }
}

}  // namespace editor
