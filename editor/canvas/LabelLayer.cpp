#include <QPainterPath>

#include "editor/canvas/LabelLayout.h"
#include "editor/canvas/Layers.h"
#include "editor/canvas/PixelFrame.h"

namespace editor {

namespace {

constexpr double kMarkPx = 9.0;
constexpr double kMarkGapPx = 5.0;
constexpr double kHaloPx = 3.5;
constexpr double kPadPx = 2.0;

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

void LabelLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const std::vector<Label> labels = mapScene().labels();
  if (labels.empty()) {
    return;
  }
  const QTransform toPixels =
      QTransform::fromScale(pixelsPerMetreOf(*painter), pixelsPerMetreOf(*painter));
  std::vector<LabelWish> wishes;
  wishes.reserve(labels.size());
  for (const Label& label : labels) {
    wishes.push_back({toPixels.map(label.centre), label.clearancePx, labelSize(theme(), label),
                      label.priority, label.isAbove});
  }
  std::vector<QRectF> taken = mapScene().solidParts();
  for (QRectF& part : taken) {
    part = toPixels.mapRect(part);
  }
  const std::vector<QRectF> places = layoutLabels(wishes, taken);
  const PixelFrame frame(*painter, {});
  painter->setRenderHint(QPainter::Antialiasing);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!places[i].isNull()) {
      paintLabel(*painter, theme(), places[i], labels[i]);
    }
  }
}

}  // namespace editor
