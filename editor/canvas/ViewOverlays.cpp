#include "editor/canvas/ViewOverlays.h"

#include <array>
#include <cmath>

#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/document/PeopleEdits.h"

namespace editor {

namespace {

constexpr double kBarTargetPx = 100.0;
constexpr double kBarLeftPx = 16.0;
constexpr double kBarBottomPx = 14.0;
constexpr double kBarHeightPx = 22.0;  // Includes the text.
constexpr double kRowPx = 20.0;        // Height of a legend row.
constexpr double kMarginPx = 12.0;     // Distance of a legend from the edge of the window.
constexpr double kGroupsPadPx = 10.0;
constexpr double kSamplePx = 18.0;  // Ring and gap before the name.
constexpr std::size_t kMaxRows = 6;

QString lengthText(double metres) {
  return metres < 1.0 ? QStringLiteral("%1 cm").arg(metres * 100.0)
                      : QStringLiteral("%1 m").arg(metres);
}

}  // namespace

std::vector<QRectF> overlayRects(const OverlayContext& context) {
  const QRectF& window = context.window;
  const bool hasRulers = context.scene.options().rulers;
  const double bar =
      niceLength(context.pixelsPerMetre, kBarTargetPx) * context.pixelsPerMetre + kBarLeftPx;
  std::vector<QRectF> boxes = {QRectF(window.left() + (hasRulers ? kRulerPx : 0.0),
                                      window.bottom() - kBarBottomPx - kBarHeightPx, bar + 4.0,
                                      kBarBottomPx + kBarHeightPx)};
  if (hasRulers) {
    boxes.emplace_back(window.topLeft(), QSizeF(window.width(), kRulerPx));
    boxes.emplace_back(window.topLeft(), QSizeF(kRulerPx, window.height()));
  }
  return boxes;
}

void paintLegendBackground(QPainter& painter, const Theme& theme, const QRectF& box) {
  painter.setRenderHint(QPainter::Antialiasing);
  setPenAndBrush(painter, theme.color(Role::Line), theme.color(Role::Panel));
  painter.drawRoundedRect(box, 6.0, 6.0);
}

double niceLength(double pixelsPerMetre, double targetPx) {
  const double wanted = targetPx / pixelsPerMetre;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  const double part = wanted / power;
  return power * (part >= 5.0 ? 5.0 : part >= 2.0 ? 2.0 : 1.0);
}

std::vector<double> multiplesIn(double low, double high, double step) {
  std::vector<double> values;
  const auto last = static_cast<long long>(std::floor(high / step));
  for (auto number = static_cast<long long>(std::ceil(low / step)); number <= last; ++number) {
    values.push_back(static_cast<double>(number) * step);
  }
  return values;
}

void paintScaleBar(QPainter& painter, const OverlayContext& context) {
  const Theme& theme = context.scene.theme();
  const double metres = niceLength(context.pixelsPerMetre, kBarTargetPx);
  const double length = metres * context.pixelsPerMetre;
  const double left = kBarLeftPx + (context.scene.options().rulers ? kRulerPx : 0.0);
  const double bottom = context.window.bottom() - kBarBottomPx;
  const QPointF line[] = {
      {left, bottom - 6.0}, {left, bottom}, {left + length, bottom}, {left + length, bottom - 6.0}};
  painter.setRenderHint(QPainter::Antialiasing, false);
  for (const auto& [color, width] :
       {std::pair(theme.color(Role::CanvasOutside, 0.8), 4.0), {theme.color(Role::Text), 1.5}}) {
    painter.setPen(QPen(color, width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawPolyline(line, 4);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  const QFont font = theme.figureFont(9.0);
  const QFontMetricsF metrics(font);
  const QString words = lengthText(metres);
  const QPointF at(left + 0.5 * (length - metrics.horizontalAdvance(words)), bottom - 7.0);
  paintHaloText(painter, at, font, words, theme.color(Role::CanvasOutside, 0.8),
                theme.color(Role::Text));
}

void paintRulers(QPainter& painter, const OverlayContext& context) {
  const Theme& theme = context.scene.theme();
  const double step = niceLength(context.pixelsPerMetre, 90.0);
  const QRectF scene = context.windowFromScene.inverted().mapRect(context.window);
  const QRectF top(0.0, 0.0, context.window.width(), kRulerPx);
  const QRectF side(0.0, 0.0, kRulerPx, context.window.height());
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.fillRect(top, theme.color(Role::Window));
  painter.fillRect(side, theme.color(Role::Window));
  painter.setFont(theme.figureFont(8.0));
  painter.setPen(theme.color(Role::TextSecondary));
  for (const double x : multiplesIn(scene.left(), scene.right(), step)) {
    const double px = context.windowFromScene.map(QPointF(x, 0.0)).x();
    painter.drawLine(QPointF(px, kRulerPx - 6.0), QPointF(px, kRulerPx));
    painter.drawText(QPointF(px + 3.0, kRulerPx - 6.0), QString::number(x, 'g', 6));
  }
  for (const double y : multiplesIn(scene.top(), scene.bottom(), step)) {
    const double px = context.windowFromScene.map(QPointF(0.0, y)).y();
    painter.drawLine(QPointF(kRulerPx - 6.0, px), QPointF(kRulerPx, px));
    painter.save();
    painter.translate(kRulerPx - 6.0, px - 3.0);
    painter.rotate(-90.0);
    painter.drawText(QPointF(), QString::number(0.0 - y, 'g', 6));
    painter.restore();
  }
  painter.fillRect(QRectF(0.0, 0.0, kRulerPx, kRulerPx), theme.color(Role::Window));
  painter.setPen(theme.color(Role::Line));
  painter.drawLine(QPointF(0.0, kRulerPx), QPointF(context.window.width(), kRulerPx));
  painter.drawLine(QPointF(kRulerPx, 0.0), QPointF(kRulerPx, context.window.height()));
}

namespace {

struct GroupLegend {
  struct Row {
    QString words;
    QColor ring;  // None for a row that summarizes several groups.
  };
  std::vector<Row> rows;
  QRectF box;
  int corner = 0;
};

std::vector<GroupLegend::Row> groupRows(const MapScene& scene) {
  std::vector<GroupLegend::Row> rows;
  if (!scene.options().groups || !scene.options().people) {
    return rows;
  }
  const sim2d::Scenario& scenario = scene.document().scenario();
  const auto groups = groupsOf(scenario);
  for (const auto& [group, people] : groups) {
    if (rows.size() == kMaxRows) {
      rows.push_back({QObject::tr("%1 more").arg(groups.size() - kMaxRows), {}});
      break;
    }
    rows.push_back({QObject::tr("%1 · %2").arg(groupName(scenario, group)).arg(people.size()),
                    groupColor(group, scene.theme())});
  }
  return rows;
}

GroupLegend groupLegend(const OverlayContext& context) {
  GroupLegend legend{groupRows(context.scene), {}, context.legendCorner};
  if (legend.rows.empty()) {
    return legend;
  }
  const QFontMetricsF metrics(context.scene.theme().font(9.0));
  double width = 0.0;
  for (const GroupLegend::Row& row : legend.rows) {
    width = std::max(width, metrics.horizontalAdvance(row.words));
  }
  QRectF box(0.0, 0.0, width + kSamplePx + 2.0 * kGroupsPadPx,
             static_cast<double>(legend.rows.size()) * kRowPx + kGroupsPadPx);
  const QRectF room = context.window.adjusted(kMarginPx, kMarginPx, -kMarginPx, -kMarginPx);
  const std::array<QPointF, 3> corners = {
      QPointF(room.right() - box.width(), room.bottom() - box.height()),
      QPointF(room.right() - box.width(), room.top()),
      QPointF(room.left(), room.bottom() - box.height() - 3.0 * kMarginPx)};  // Above the scale.
  const auto count = static_cast<int>(corners.size());
  for (int i = 0; i < count; ++i) {
    const int corner = (context.legendCorner + i) % count;  // Prefers the previous corner.
    box.moveTopLeft(corners.at(static_cast<std::size_t>(corner)));
    const auto covers = [&](const sim2d::Human& human) {
      return box.adjusted(-kMarginPx, -kMarginPx, kMarginPx, kMarginPx)
          .contains(context.windowFromScene.map(toScene(human.initPose.position)));
    };
    const auto& people = context.scene.document().scenario().humans;
    if (std::none_of(people.begin(), people.end(), covers)) {
      legend.box = box;
      legend.corner = corner;
      break;
    }
  }
  return legend;  // Without a box: people must not be covered.
}

}  // namespace

QRectF groupLegendBox(const OverlayContext& context) {
  return groupLegend(context).box;
}

int paintGroupLegend(QPainter& painter, const OverlayContext& context) {
  const auto [rows, box, corner] = groupLegend(context);
  if (box.isEmpty()) {
    return corner;
  }
  const Theme& theme = context.scene.theme();
  paintLegendBackground(painter, theme, box);
  painter.setFont(theme.font(9.0));
  QRectF line(box.left() + kGroupsPadPx, box.top() + 0.5 * kGroupsPadPx,
              box.width() - 2.0 * kGroupsPadPx, kRowPx);
  for (const GroupLegend::Row& row : rows) {
    if (row.ring.isValid()) {
      paintRing(painter, QPen(row.ring, 2.0), 4.5, QPointF(line.left() + 5.0, line.center().y()));
    }
    painter.setPen(theme.color(Role::Text));
    painter.drawText(line.adjusted(kSamplePx, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter,
                     row.words);
    line.translate(0.0, kRowPx);
  }
  return corner;
}

}  // namespace editor
