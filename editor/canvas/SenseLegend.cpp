#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/MapLegend.h"
#include "editor/canvas/Overlays.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/PlannerPainter.h"

// What the colours of lidar, detector and weighed ways say, while a robot of a run is selected.
namespace editor {

namespace {

constexpr double kSenseRowPx = 20.0;
constexpr double kSenseWidthPx = 220.0;
constexpr double kSenseMarginPx = 12.0;
constexpr double kSenseSamplePx = 20.0;

void sampleLine(QPainter& painter, const QRectF& box, const QPen& pen) {
  setInk(painter, pen);
  painter.drawLine(QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()));
}

/// Of the one robot that is selected, in the frame that is shown.
const sim2d::RobotSenses* sensesOfSelected(const MapScene& scene) {
  const std::vector<EntityId>& selection = scene.document().selection();
  const sim2d::Frame* frame = scene.frameLayer().frame();
  if (selection.size() != 1 || selection.front().kind != EntityKind::Robot || frame == nullptr ||
      frame->senses == nullptr) {
    return nullptr;
  }
  for (std::size_t i = 0; i < std::min(frame->robots.size(), frame->senses->size()); ++i) {
    if (scene.frameLayer().entityOf(frame->robots.id[i]) == selection.front()) {
      return &(*frame->senses)[i];
    }
  }
  return nullptr;
}

void addWayRows(std::vector<LegendRow>& rows, const Theme& theme) {
  const std::tuple<QString, QColor, double> kinds[] = {
      {QObject::tr("Way chosen"), theme.color(Role::Accent), 2.5},
      {QObject::tr("Weighed, paler is dearer"), theme.color(Role::Accent, 0.5), 1.2},
      {QObject::tr("Would hit something"), theme.color(Role::Error, 0.6), 1.2}};
  for (const auto& [words, color, width] : kinds) {
    rows.push_back({words, {}, [pen = QPen(color, width)](QPainter& painter, const QRectF& box) {
                      sampleLine(painter, box, pen);
                    }});
  }
}

QRectF boxOfRows(const OverlayContext& context, std::size_t rows) {
  return {context.window.right() - kSenseWidthPx - kSenseMarginPx,
          context.window.top() + kSenseMarginPx, kSenseWidthPx,
          static_cast<double>(rows) * kSenseRowPx + 12.0};
}

}  // namespace

std::vector<LegendRow> senseRows(const MapScene& scene) {
  std::vector<LegendRow> rows;
  const sim2d::RobotSenses* senses = sensesOfSelected(scene);
  if (senses == nullptr) {
    return rows;
  }
  const Theme& theme = scene.theme();
  const QColor color = theme.color(Role::Lidar);
  if (scene.options().lidar && senses->scan) {
    rows.push_back({QObject::tr("Laser, %1 m").arg(senses->scan->range, 0, 'f', 1),
                    {},
                    [color](QPainter& painter, const QRectF& box) {
                      QColor fill = color;
                      fill.setAlphaF(0.2);
                      painter.fillRect(box.adjusted(0.0, 4.0, 0.0, -4.0), fill);
                      setInk(painter, Qt::NoPen, color);
                      for (const double x : {0.1, 0.37, 0.63, 0.9}) {
                        painter.drawEllipse(QPointF(box.left() + x * box.width(), box.top() + 5.0),
                                            1.5, 1.5);
                      }
                    }});
  }
  if (scene.options().detections && !senses->bodies.empty()) {
    rows.push_back(
        {QObject::tr("Detected, its speed"), {}, [color](QPainter& painter, const QRectF& box) {
           QPen pen(color, 1.8, Qt::CustomDashLine, Qt::FlatCap);
           pen.setDashPattern({3.0, 2.0});
           paintRing(painter, pen, 6.0, box.center());
         }});
  }
  if (scene.options().candidates && !senses->ways.empty() && !hasPrices(*senses)) {
    addWayRows(rows, theme);
  }
  return rows;
}

/// Over the map as long as there is no legend beside it.
QRectF senseLegendBox(const OverlayContext& context) {
  const std::size_t rows = senseRows(context.scene).size();
  return rows == 0 || wantsLegend(context.scene) ? QRectF() : boxOfRows(context, rows);
}

void paintSenseLegend(QPainter& painter, const OverlayContext& context) {
  const std::vector<LegendRow> rows = senseRows(context.scene);
  if (rows.empty() || wantsLegend(context.scene)) {
    return;
  }
  const Theme& theme = context.scene.theme();
  const QRectF box = boxOfRows(context, rows.size());
  paintPlate(painter, theme, box);
  painter.setFont(theme.font(9.0));
  QRectF line(box.left() + 12.0, box.top() + 6.0, box.width() - 20.0, kSenseRowPx);
  for (const LegendRow& row : rows) {
    row.sample(painter, QRectF(line.topLeft(), QSizeF(kSenseSamplePx, kSenseRowPx)));
    painter.setPen(theme.color(Role::Text));
    painter.drawText(line.adjusted(kSenseSamplePx + 8.0, 0.0, 0.0, 0.0),
                     Qt::AlignLeft | Qt::AlignVCenter, row.words);
    line.translate(0.0, kSenseRowPx);
  }
}

}  // namespace editor
