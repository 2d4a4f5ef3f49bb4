#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/MapLegend.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/RobotPainters.h"
#include "sim2d/scenario/ResolvedValues.h"

// Legend of lidar, detector and candidate trajectories while a robot of a run is selected.
namespace editor {

namespace {

/// Perception of the single selected robot in the shown frame.
const sim2d::RobotTelemetry* sensesOfSelected(const MapScene& scene) {
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
      {QObject::tr("Chosen trajectory"), theme.color(Role::Accent), 2.5},
      {QObject::tr("Candidate (pale: costly)"), theme.color(Role::Accent, 0.5), 1.2},
      {QObject::tr("Would collide"), theme.color(Role::Error, 0.6), 1.2}};
  for (const auto& [label, color, width] : kinds) {
    rows.push_back({label, {}, strokeSample(QPen(color, width))});
  }
}

}  // namespace

std::vector<LegendRow> senseRows(const MapScene& scene) {
  std::vector<LegendRow> rows;
  const sim2d::RobotTelemetry* senses = sensesOfSelected(scene);
  if (senses == nullptr) {
    return rows;
  }
  const Theme& theme = scene.theme();
  const QColor color = theme.color(Role::Lidar);
  if (scene.options().lidar && senses->scan) {
    rows.push_back({QObject::tr("Lidar, %1 m").arg(senses->scan->range, 0, 'f', 1),
                    {},
                    [color](QPainter& painter, const QRectF& box) {
                      QColor fill = color;
                      fill.setAlphaF(0.2);
                      painter.fillRect(box.adjusted(0.0, 4.0, 0.0, -4.0), fill);
                      setPenAndBrush(painter, Qt::NoPen, color);
                      for (const double x : {0.1, 0.37, 0.63, 0.9}) {
                        painter.drawEllipse(QPointF(box.left() + x * box.width(), box.top() + 5.0),
                                            1.5, 1.5);
                      }
                    }});
  }
  if (scene.options().detections && !senses->bodies.empty()) {
    rows.push_back(
        {QObject::tr("Detection, velocity"), {}, [color](QPainter& painter, const QRectF& box) {
           QPen pen(color, 1.8, Qt::CustomDashLine, Qt::FlatCap);
           pen.setDashPattern({3.0, 2.0});
           paintRing(painter, pen, 6.0, box.center());
         }});
  }
  if (scene.options().candidates && !senses->ways.empty() && !hasCostTerms(*senses)) {
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

// Legend of costmaps and candidate trajectories, and the score of each critic for the chosen
// trajectory.

namespace {

LegendSample cellSample(const Theme& theme, const QColor& color) {
  return [&theme, color](QPainter& painter, const QRectF& box) {
    const QRectF place = box.adjusted(3.0, 3.0, -3.0, -3.0);
    painter.fillRect(place, theme.color(Role::MapFree));
    setPenAndBrush(painter, QPen(theme.color(Role::Line), 1.0), color);
    painter.drawRect(place);
  };
}

LegendSample aimSample(const Theme& theme) {
  return [&theme](QPainter& painter, const QRectF& box) {
    paintRing(painter, QPen(theme.color(Role::Accent), 2.0), 6.0, box.center());
    setPenAndBrush(painter, Qt::NoPen, theme.color(Role::Accent));
    painter.drawEllipse(box.center(), 1.8, 1.8);
  };
}

/// A bar for the share of the total cost.
LegendSample shareSample(const Theme& theme, double share) {
  return [&theme, share](QPainter& painter, const QRectF& box) {
    const QRectF whole(box.left(), box.center().y() - 3.0, box.width(), 6.0);
    painter.fillRect(whole, theme.color(Role::Line, 0.7));
    painter.fillRect(QRectF(whole.topLeft(), QSizeF(share * whole.width(), whole.height())),
                     theme.color(Role::Text, 0.75));
  };
}

QString costText(double price) {
  return std::abs(price) >= 1e5 ? QString::number(price, 'g', 3) : QString::number(price, 'f', 2);
}

/// Least and largest percentage of the cells on which masks have an effect; 0, 0: none.
std::pair<std::uint8_t, std::uint8_t> rangeOf(const std::vector<sim2d::MaskGrid>& masks,
                                              sim2d::MaskGrid::Kind kind) {
  std::uint8_t least = 0, most = 0;
  for (const sim2d::MaskGrid& mask : masks) {
    for (const std::uint8_t percent : mask.grid->costs) {
      if (mask.kind == kind && percent > 0) {
        least = least == 0 ? percent : std::min(least, percent);
        most = std::max(most, percent);
      }
    }
  }
  return {least, most};
}

}  // namespace

LegendPart costPart(const MapScene& scene) {
  const Theme& theme = scene.theme();
  const std::optional<ObservedPlanner> robot = observedPlanner(scene);
  LegendPart part{robot ? QObject::tr("Costs of %1").arg(robot->name) : QObject::tr("Costs"), {}};
  const bool isKnown = robot && (robot->senses->localCosts || robot->senses->globalCosts);
  if (!isKnown) {
    part.rows.push_back(noteRow(QObject::tr("newest step, Nav2 only")));
    return part;
  }
  LegendRow ramp;
  ramp.value = QStringLiteral("252");
  ramp.sample = rampSample(theme, [&theme](double share) {
    return costColor(theme, static_cast<std::uint8_t>(std::lround(252.0 * share)));
  });
  part.rows = {
      ramp,
      {QObject::tr("Inscribed"), QStringLiteral("253"), cellSample(theme, costColor(theme, 253))},
      {QObject::tr("Lethal"), QStringLiteral("254"), cellSample(theme, costColor(theme, 254))},
      {QObject::tr("Unknown"), QStringLiteral("255"), cellSample(theme, costColor(theme, 255))}};
  return part;
}

LegendPart maskPart(const MapScene& scene) {
  using Kind = sim2d::MaskGrid::Kind;
  const Theme& theme = scene.theme();
  const std::optional<ObservedPlanner> robot = observedPlanner(scene);
  LegendPart part{
      robot ? QObject::tr("Filter masks of %1").arg(robot->name) : QObject::tr("Filter masks"), {}};
  if (!robot || robot->senses->masks.empty()) {
    part.rows.push_back(noteRow(QObject::tr("none; newest step, Nav2 only")));
    return part;
  }
  const std::pair<Kind, QString> names[] = {{Kind::Keepout, QObject::tr("Keep out")},
                                            {Kind::Speed, QObject::tr("Speed limit")},
                                            {Kind::Switch, QObject::tr("Switch")}};
  for (const auto& [kind, name] : names) {
    const auto [least, most] = rangeOf(robot->senses->masks, kind);
    if (most == 0) {
      continue;
    }
    const QString both = QObject::tr("%1–%2 %").arg(int(least)).arg(int(most));
    const QString value = least == most ? QObject::tr("%1 %").arg(int(most)) : both;
    part.rows.push_back({name, kind == Kind::Switch ? QString() : value,
                         cellSample(theme, maskColor(theme, kind, least))});
  }
  return part;
}

LegendPart trajectoryCostPart(const MapScene& scene) {
  LegendPart part;
  const Theme& theme = scene.theme();
  const std::optional<ObservedPlanner> robot = observedPlanner(scene);
  if (!robot || (!hasCostTerms(*robot->senses) && robot->senses->lookahead.empty())) {
    return part;
  }
  const sim2d::RobotTelemetry& senses = *robot->senses;
  part.title = senses.controller.empty() ? QObject::tr("Evaluated by %1").arg(robot->name)
                                         : QString::fromStdString(senses.controller);
  if (hasCostTerms(senses)) {
    const CostScale scale = costScaleOf(senses.ways);
    LegendRow ramp;
    ramp.sample =
        rampSample(theme, [&theme](double share) { return trajectoryCostColor(theme, share); });
    part.rows.push_back(ramp);
    part.rows.push_back(
        {costText(scale.low), QStringLiteral("≥ %1").arg(costText(scale.high)), {}, true});
    part.rows.push_back({QObject::tr("Rejected"), QString::number(scale.refused),
                         strokeSample(QPen(theme.color(Role::TextSecondary, 0.4), 1.2))});
  }
  if (!senses.lookahead.empty()) {
    part.rows.push_back({QObject::tr("Lookahead"), {}, aimSample(theme)});
  }
  const auto chosen = std::find_if(senses.ways.begin(), senses.ways.end(),
                                   [](const auto& way) { return way.isChosen; });
  if (chosen == senses.ways.end()) {
    return part;
  }
  part.rows.push_back({QObject::tr("Chosen"), costText(chosen->cost),
                       strokeSample(QPen(theme.color(Role::Text), 2.5))});
  double most = 0.0;
  for (const auto& [critic, score] : chosen->scores) {
    most = std::max(most, std::abs(score));
  }
  for (const auto& [critic, score] : chosen->scores) {
    part.rows.push_back({QString::fromStdString(critic), costText(score),
                         shareSample(theme, most > 0.0 ? std::abs(score) / most : 0.0)});
  }
  return part;
}

}  // namespace editor
