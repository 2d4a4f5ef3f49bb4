#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/MapLegend.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/PlannerPainter.h"
#include "sim2d/scenario/Defaults.h"

// What the colours of lidar, detector and weighed ways say, while a robot of a run is selected.
namespace editor {

namespace {

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

bool isLidarChosen(const MapScene& scene) {
  const std::vector<EntityId>& selection = scene.document().selection();
  const std::optional<Entity> value = scene.isRunMode() && selection.size() == 1
                                          ? scene.document().entity(selection.front())
                                          : std::nullopt;
  const auto* robot = value ? std::get_if<sim2d::Robot>(&*value) : nullptr;
  return robot != nullptr &&
         sim2d::resolveRobot(scene.document().scenario(), *robot, -1).lidar.beams > 0;
}

}  // namespace editor
