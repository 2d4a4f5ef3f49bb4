#include "editor/canvas/LegendStrip.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/MapView.h"
#include "editor/canvas/ViewOverlays.h"

namespace editor {

namespace {

constexpr double kPlatePad = 10.0;
constexpr double kPlateMargin = 12.0;
constexpr double kSampleGap = 8.0;
constexpr double kWidthStep = 16.0;
constexpr double kWidestPlate = 184.0;

}  // namespace

LegendStrip::LegendStrip(MapView& view) : QWidget(&view), view_(view) {
  setAccessibleName(tr("Legend"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
}

void LegendStrip::setParts(std::vector<LegendPart> parts) {
  if (isBrief_) {
    for (LegendPart& part : parts) {
      const auto isLong = [](const LegendRow& row) {
        return !row.sample || row.label.isEmpty() || row.value.isEmpty();
      };
      part.rows.erase(std::remove_if(part.rows.begin(), part.rows.end(), isLong), part.rows.end());
      for (LegendRow& row : part.rows) {
        row.label.clear();
      }
    }
    const auto isBare = [](const LegendPart& part) { return part.rows.empty(); };
    parts.erase(std::remove_if(parts.begin(), parts.end(), isBare), parts.end());
  }
  parts_ = std::move(parts);
  update();
}

double LegendStrip::rowWidth(const LegendRow& row) const {
  const Theme& theme = view_.mapScene().theme();
  const double sample = !row.sample                        ? 0.0
                        : row.label.isEmpty() && !isBrief_ ? kRampPx + kSampleGap
                                                           : kLegendRowPx + kSampleGap;
  return sample + QFontMetricsF(theme.font(9.0)).horizontalAdvance(row.label) + kSampleGap +
         QFontMetricsF(theme.figureFont(9.0)).horizontalAdvance(row.value);
}

QSize LegendStrip::fittingSize() const {
  const QFontMetricsF titles(view_.mapScene().theme().font(9.0, QFont::DemiBold));
  double width = 0.0;
  double height = 2.0 * kPlatePad - 4.0;
  for (const LegendPart& part : parts_) {
    width = std::max(width, isBrief_ ? 0.0 : titles.horizontalAdvance(part.title));
    for (const LegendRow& row : part.rows) {
      width = std::max(width, rowWidth(row));
    }
    height += (static_cast<double>(part.rows.size()) + (isBrief_ ? 0.0 : 1.0)) * kLegendRowPx + 8.0;
  }
  const double steps = std::ceil((width + 2.0 * kPlatePad + 2.0) / kWidthStep);
  return {static_cast<int>(std::min(kWidestPlate, steps * kWidthStep)),
          static_cast<int>(height - 7.0)};
}

QRect LegendStrip::boxAt(int corner, const QRect& room) const {
  const bool hasRulers = view_.mapScene().options().rulers;
  const int margin = static_cast<int>(kPlateMargin);
  const int ruler = hasRulers ? kRulerPx : 0;
  const QRect inside = room.adjusted(margin + ruler, margin + ruler, -margin, -margin);
  QSize size = fittingSize();
  if (!isHidden()) {
    size.setWidth(std::max(size.width(), width()));
  }
  QRect box(inside.topLeft(), size);
  if (corner != 1) {
    box.moveRight(inside.right());
  }
  if (corner == 2) {
    box.moveBottom(inside.bottom());
  }
  return box;
}

void LegendStrip::place(const QRect& room) {
  setGeometry(boxAt(corner_, room));
}

void LegendStrip::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  paintLegendBackground(painter, view_.mapScene().theme(),
                        QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  QRectF room = QRectF(rect()).adjusted(kPlatePad, kPlatePad - 2.0, -kPlatePad, 0.0);
  for (const LegendPart& part : parts_) {
    room.setTop(paintPart(painter, part, room));
  }
}

/// Returns the position of the next part.
double LegendStrip::paintPart(QPainter& painter, const LegendPart& part, const QRectF& room) const {
  const Theme& theme = view_.mapScene().theme();
  QRectF line(room.left(), room.top(), room.width(), kLegendRowPx);
  const auto write = [&](const QRectF& place, int side, const QString& label, const QFont& font,
                         Role role) {
    painter.setFont(font);
    painter.setPen(theme.color(role));
    painter.drawText(place, side | Qt::AlignVCenter,
                     QFontMetricsF(font).elidedText(label, Qt::ElideMiddle, place.width() + 1.0));
  };
  if (!isBrief_) {
    write(line, Qt::AlignLeft, part.title, theme.font(9.0, QFont::DemiBold), Role::Text);
    line.translate(0.0, kLegendRowPx);
  }
  for (const LegendRow& row : part.rows) {
    double left = line.left();
    if (row.sample) {
      row.sample(painter, QRectF(line.topLeft(), QSizeF(kLegendRowPx, kLegendRowPx)));
      left += kLegendRowPx + kSampleGap;
    }
    const QFont figures = theme.figureFont(9.0);
    const double value = QFontMetricsF(figures).horizontalAdvance(row.value);
    write(line, Qt::AlignRight, row.value, figures, Role::TextSecondary);
    write(QRectF(QPointF(left, line.top()), QPointF(line.right() - value - 4.0, line.bottom())),
          Qt::AlignLeft, row.label, theme.font(9.0), row.isNote ? Role::TextSecondary : Role::Text);
    line.translate(0.0, kLegendRowPx);
  }
  return line.top() + 8.0;
}

}  // namespace editor
