#include "editor/canvas/MapLegend.h"

#include <cmath>

#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/RobotPainters.h"
#include "editor/canvas/RunOverlays.h"
#include "editor/canvas/ViewOverlays.h"
#include "sim2d/scenario/ResolvedValues.h"

namespace editor {

namespace {

LegendRow noteRow(const QString& label) {
  return {label, {}, {}, true};
}

/// A horizontal line.
LegendSample strokeSample(const QPen& pen) {
  return [pen](QPainter& painter, const QRectF& box) {
    painter.setPen(pen);
    painter.drawLine(QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()));
  };
}

/// A row with a colour bar, wider than the box. `colorOf`: the colour for a share of its length,
/// 0 … 1.
LegendRow rampRow(const Theme& theme, const QString& value,
                  const std::function<QColor(double)>& colorOf) {
  return {{}, value, [&theme, colorOf](QPainter& painter, const QRectF& box) {
            const QRectF place(box.left(), box.top() + 5.0, kRampPx, 10.0);
            painter.fillRect(place, theme.color(Role::MapFree));
            for (int x = 0; x < kRampPx; ++x) {
              painter.fillRect(QRectF(place.left() + x, place.top(), 1.0, place.height()),
                               colorOf((x + 0.5) / kRampPx));
            }
            setPenAndBrush(painter, QPen(theme.color(Role::Line), 1.0));
            painter.drawRect(place);
          }};
}

/// The single selected person.
std::optional<int> watchedPerson(const MapScene& scene) {
  const std::vector<EntityId>& selection = scene.document().selection();
  const sim2d::Human* human =
      selection.size() == 1 ? scene.document().human(selection.front()) : nullptr;
  return human != nullptr ? std::optional(human->id) : scene.spawnedAgent();
}

QString legendTitle(const MapScene& scene, const QString& all, const QString& one,
                    const QString& chosen) {
  if (!scene.frameLayer().hasSelectedBody()) {
    return all;
  }
  const std::optional<int> person = watchedPerson(scene);
  return person ? one.arg(scene.frameLayer().nameOf(*person)) : chosen;
}

/// A bar that shows the length on the map of one unit.
LegendRow scaleRow(const Theme& theme, double perUnit, const QString& unit) {
  const double amount = niceLength(perUnit, 60.0);
  const double length = amount * perUnit;
  const QColor color = theme.color(Role::TextSecondary);
  return {{},
          QStringLiteral("%1 %2").arg(amount, 0, 'g', 3).arg(unit),
          [length, color](QPainter& painter, const QRectF& box) {
            const double y = box.center().y() + 2.0;
            painter.setPen(QPen(color, 1.5));
            painter.drawLine(QPointF(box.left(), y), QPointF(box.left() + length, y));
            for (const double x : {box.left(), box.left() + length}) {
              painter.drawLine(QPointF(x, y - 4.0), QPointF(x, y));
            }
          }};
}

LegendPart forcePart(const MapScene& scene, double pixelsPerMetre) {
  const Theme& theme = scene.theme();
  LegendPart part{legendTitle(scene, QObject::tr("Forces on people"), QObject::tr("Forces on %1"),
                              QObject::tr("Forces on selection")),
                  {}};
  if (!scene.overlays().hasForces()) {
    part.rows = {noteRow(scene.overlays().frame()->step == 0 ? QObject::tr("after the first step")
                                                             : QObject::tr("not recorded"))};
    return part;
  }
  const std::optional<int> person = watchedPerson(scene);
  const sim2d::Frame& frame = *scene.frameLayer().frame();
  std::vector<ForceArrow> terms = forcesOn(frame, person.value_or(frame.humans.id.front()));
  if (!scene.frameLayer().hasSelectedBody() && frame.humans.size() > kMaxTerms &&
      terms.size() > 1) {
    terms.erase(terms.begin(), terms.end() - 1);
  }
  for (const ForceArrow& term : terms) {
    part.rows.push_back({term.name, person ? QString::number(term.force.norm(), 'f', 2) : QString(),
                         [&theme, color = term.color](QPainter& painter, const QRectF& box) {
                           const QPointF tip(box.right(), box.center().y());
                           painter.setPen(QPen(theme.color(color), 2.2));
                           painter.drawLine(QPointF(box.left(), tip.y()), tip);
                           FigurePainter(theme).arrowHead(painter, tip, 0.0, 6.0);
                         }});
  }
  part.rows.push_back(scaleRow(theme, kMetresPerForce * pixelsPerMetre, QStringLiteral("m/s²")));
  return part;
}

LegendPart spacePart(const MapScene& scene) {
  const QColor color = scene.theme().line(Look::Regular);
  LegendPart part{legendTitle(scene, QObject::tr("Spaces"), QObject::tr("Spaces of %1"),
                              QObject::tr("Spaces of selection")),
                  {}};
  const auto add = [&](const QString& name, const QString& radius, double alpha) {
    part.rows.push_back({name, radius, [color, alpha](QPainter& painter, const QRectF& box) {
                           setPenAndBrush(painter, QPen(withAlpha(color, 0.8), 1.0),
                                          withAlpha(color, alpha));
                           painter.drawEllipse(box.center(), 7.0, 7.0);
                         }});
  };
  if (scene.options().proxemics) {
    add(QObject::tr("Intimate"), QStringLiteral("0.45 m"), 0.5);
    add(QObject::tr("Personal"), QStringLiteral("1.2 m"), 0.28);
    add(QObject::tr("Social"), QStringLiteral("3.6 m"), 0.1);
  }
  if (scene.options().gaussian) {
    part.rows.push_back({QObject::tr("Gaussian"), QObject::tr("at 0.6, 0.2"),
                         [color](QPainter& painter, const QRectF& box) {
                           setPenAndBrush(painter, QPen(color, 1.2));
                           painter.drawEllipse(box.adjusted(0.0, 4.0, 0.0, -4.0));
                           painter.drawEllipse(box.adjusted(4.0, 7.0, -6.0, -7.0));
                         }});
  }
  return part;
}

LegendPart sightPart(const MapScene& scene) {
  const std::optional<int> person = watchedPerson(scene);
  if (!person || !scene.frameLayer().positionOf(*person)) {
    return {QObject::tr("Field of view"), {noteRow(QObject::tr("Select a person"))}};
  }
  QColor color = scene.theme().line(Look::Curious);
  for (const ShownBody& body : scene.frameLayer().shownBodies()) {
    color = body.id == *person ? scene.theme().line(body.look) : color;
  }
  return {QObject::tr("Seen by %1").arg(scene.frameLayer().nameOf(*person)),
          {{QObject::tr("100° to either side"),
            QStringLiteral("%1 m").arg(scene.overlays().noticeDistance(*person), 0, 'g', 3),
            [color](QPainter& painter, const QRectF& box) {
              setPenAndBrush(painter, QPen(color, 1.0), withAlpha(color, 0.25));
              const QPointF eye(box.left() + 2.0, box.center().y());
              painter.drawPie(around(eye, 17.0), -30 * 16, 60 * 16);
            }}}};
}

LegendPart densityPart(const MapScene& scene) {
  const Theme& theme = scene.theme();
  const double most = scene.overlays().densityScaleMax();
  return {QObject::tr("People per m²"),
          {rampRow(theme, QStringLiteral("%1").arg(most > 0.0 ? most : 0.5, 0, 'g', 3),
                   [&theme](double share) { return densityColor(theme, share); }),
           noteRow(QObject::tr("exp(−d²/R²)/πR², R = %1 m").arg(metrics::kDensityRadius))}};
}

LegendRow planRow(const MapScene& scene) {
  const QColor color = scene.theme().line(Look::Regular);
  return scene.overlays().hasPlans() ? LegendRow{QObject::tr("Remaining path"),
                                                 {},
                                                 strokeSample(dashedPen(color, 1.4, {4.0, 2.5}))}
                                     : noteRow(QObject::tr("newest step only"));
}

LegendPart contactPart(const MapScene& scene) {
  LegendPart part{QObject::tr("Contacts so far"), {}};
  for (const ContactCause cause : {ContactCause::Robot, ContactCause::Person, ContactCause::Both}) {
    part.rows.push_back(
        {contactCauseText(cause), QString::number(scene.overlays().contactsSoFar(cause)),
         [&scene, cause](QPainter& painter, const QRectF& box) {
           OverlayPainter(painter, scene.theme(), {}).contactSign(box.center(), cause);
         }});
  }
  return part;
}

/// Returns true if a single robot with a lidar is selected in a run.
bool isLidarChosen(const MapScene& scene) {
  const std::vector<EntityId>& selection = scene.document().selection();
  const std::optional<Entity> value = scene.isRunMode() && selection.size() == 1
                                          ? scene.document().entity(selection.front())
                                          : std::nullopt;
  const auto* robot = value ? std::get_if<sim2d::Robot>(&*value) : nullptr;
  return robot != nullptr &&
         sim2d::resolveRobot(scene.document().scenario(), *robot, -1).lidar.beams > 0;
}

QString costText(double price) {
  return std::abs(price) >= 1e5 ? QString::number(price, 'g', 3) : QString::number(price, 'f', 2);
}

LegendSample cellSample(const Theme& theme, const QColor& color) {
  return [&theme, color](QPainter& painter, const QRectF& box) {
    const QRectF place = box.adjusted(3.0, 3.0, -3.0, -3.0);
    painter.fillRect(place, theme.color(Role::MapFree));
    setPenAndBrush(painter, QPen(theme.color(Role::Line), 1.0), color);
    painter.drawRect(place);
  };
}

/// Cell costs of a planner's costmaps.
LegendPart costPart(const MapScene& scene) {
  const Theme& theme = scene.theme();
  const std::optional<ObservedRobot> robot = observedPlanner(scene);
  LegendPart part{robot ? QObject::tr("Costs of %1").arg(robot->name) : QObject::tr("Costs"), {}};
  if (!robot || (!robot->senses->localCosts && !robot->senses->globalCosts)) {
    part.rows.push_back(noteRow(QObject::tr("newest step, Nav2 only")));
    return part;
  }
  part.rows.push_back(rampRow(theme, QStringLiteral("252"), [&theme](double share) {
    return costColor(theme, static_cast<std::uint8_t>(std::lround(252.0 * share)));
  }));
  const auto add = [&](const QString& name, std::uint8_t cost) {
    part.rows.push_back({name, QString::number(cost), cellSample(theme, costColor(theme, cost))});
  };
  add(QObject::tr("Inscribed"), 253);
  add(QObject::tr("Lethal"), 254);
  add(QObject::tr("Unknown"), 255);
  return part;
}

/// Least and largest percentage of the cells on which masks have an effect; 0, 0: none.
std::pair<std::uint8_t, std::uint8_t> rangeOf(const std::vector<sim2d::MaskGrid>& masks,
                                              sim2d::MaskGrid::Kind kind) {
  std::uint8_t least = 0, most = 0;
  for (const sim2d::MaskGrid& mask : masks) {
    if (mask.kind == kind && mask.most > 0) {
      least = least == 0 ? mask.least : std::min(least, mask.least);
      most = std::max(most, mask.most);
    }
  }
  return {least, most};
}

/// Effects of the masks of a planner's costmap filters.
LegendPart maskPart(const MapScene& scene) {
  using Kind = sim2d::MaskGrid::Kind;
  const Theme& theme = scene.theme();
  const std::optional<ObservedRobot> robot = observedPlanner(scene);
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

/// The score of each critic for the chosen trajectory, with a bar for its share of the largest one.
void addScoreRows(std::vector<LegendRow>& rows, const Theme& theme,
                  const sim2d::RobotTelemetry::Candidate& chosen) {
  double most = 0.0;
  for (const auto& [critic, score] : chosen.scores) {
    most = std::max(most, std::abs(score));
  }
  for (const auto& [critic, score] : chosen.scores) {
    const double share = most > 0.0 ? std::abs(score) / most : 0.0;
    rows.push_back({QString::fromStdString(critic), costText(score),
                    [&theme, share](QPainter& painter, const QRectF& box) {
                      const QRectF whole(box.left(), box.center().y() - 3.0, box.width(), 6.0);
                      painter.fillRect(whole, theme.color(Role::Line, 0.7));
                      painter.fillRect(
                          QRectF(whole.topLeft(), QSizeF(share * whole.width(), whole.height())),
                          theme.color(Role::Text, 0.75));
                    }});
  }
}

/// Costs of a planner's candidate trajectories; no rows if the planner does not report them.
LegendPart trajectoryCostPart(const MapScene& scene) {
  const Theme& theme = scene.theme();
  const std::optional<ObservedRobot> robot = observedPlanner(scene);
  if (!robot || (!hasCostTerms(*robot->senses) && robot->senses->lookahead.empty())) {
    return {};
  }
  const sim2d::RobotTelemetry& senses = *robot->senses;
  LegendPart part{senses.controller.empty() ? QObject::tr("Evaluated by %1").arg(robot->name)
                                            : QString::fromStdString(senses.controller),
                  {}};
  if (hasCostTerms(senses)) {
    const CostScale scale = costScaleOf(senses.ways);
    part.rows = {
        rampRow(theme, {}, [&theme](double share) { return trajectoryCostColor(theme, share); }),
        {costText(scale.low), QStringLiteral("≥ %1").arg(costText(scale.high)), {}, true},
        {QObject::tr("Rejected"), QString::number(scale.refused),
         strokeSample(QPen(theme.color(Role::TextSecondary, 0.4), 1.2))}};
  }
  if (!senses.lookahead.empty()) {
    part.rows.push_back(
        {QObject::tr("Lookahead"), {}, [&theme](QPainter& painter, const QRectF& box) {
           paintRing(painter, QPen(theme.color(Role::Accent), 2.0), 6.0, box.center());
           setPenAndBrush(painter, Qt::NoPen, theme.color(Role::Accent));
           painter.drawEllipse(box.center(), 1.8, 1.8);
         }});
  }
  const auto chosen = std::find_if(senses.ways.begin(), senses.ways.end(),
                                   [](const auto& way) { return way.isChosen; });
  if (chosen != senses.ways.end()) {
    part.rows.push_back({QObject::tr("Chosen"), costText(chosen->cost),
                         strokeSample(QPen(theme.color(Role::Text), 2.5))});
    addScoreRows(part.rows, theme, *chosen);
  }
  return part;
}

}  // namespace

std::vector<LegendRow> senseRows(const MapScene& scene) {
  std::vector<LegendRow> rows;
  const std::optional<ObservedRobot> robot = selectedRobot(scene);
  if (!robot) {
    return rows;
  }
  const sim2d::RobotTelemetry& senses = *robot->senses;
  const Theme& theme = scene.theme();
  const QColor color = theme.color(Role::Lidar);
  if (scene.options().lidar && senses.scan) {
    rows.push_back({QObject::tr("Lidar, %1 m").arg(senses.scan->range, 0, 'f', 1),
                    {},
                    [color](QPainter& painter, const QRectF& box) {
                      painter.fillRect(box.adjusted(0.0, 4.0, 0.0, -4.0), withAlpha(color, 0.2));
                      setPenAndBrush(painter, Qt::NoPen, color);
                      for (const double x : {0.1, 0.37, 0.63, 0.9}) {
                        painter.drawEllipse(QPointF(box.left() + x * box.width(), box.top() + 5.0),
                                            1.5, 1.5);
                      }
                    }});
  }
  if (scene.options().detections && !senses.bodies.empty()) {
    rows.push_back(
        {QObject::tr("Detection, velocity"), {}, [color](QPainter& painter, const QRectF& box) {
           paintRing(painter, dashedPen(color, 1.8, {3.0, 2.0}), 6.0, box.center());
         }});
  }
  if (scene.options().candidates && !senses.ways.empty() && !hasCostTerms(senses)) {
    const auto add = [&rows](const QString& label, const QColor& ink, double width) {
      rows.push_back({label, {}, strokeSample(QPen(ink, width))});
    };
    add(QObject::tr("Chosen trajectory"), theme.color(Role::Accent), 2.5);
    add(QObject::tr("Candidate (pale: costly)"), theme.color(Role::Accent, 0.5), 1.2);
    add(QObject::tr("Would collide"), theme.color(Role::Error, 0.6), 1.2);
  }
  return rows;
}

std::vector<LegendPart> legendOf(const MapScene& scene, double pixelsPerMetre) {
  std::vector<LegendPart> parts;
  if (!scene.isRunMode()) {
    return parts;
  }
  const CanvasOptions& on = scene.options();
  const auto add = [&parts](bool isOn, const std::function<LegendPart()>& make) {
    if (LegendPart part = isOn ? make() : LegendPart(); !part.rows.empty()) {
      parts.push_back(std::move(part));
    }
  };
  add(on.forces, [&] { return forcePart(scene, pixelsPerMetre); });
  add(on.velocities, [&]() -> LegendPart {
    return {QObject::tr("Velocities"),
            {scaleRow(scene.theme(), kMetresPerVelocity * pixelsPerMetre, QStringLiteral("m/s"))}};
  });
  add(on.proxemics || on.gaussian, [&] { return spacePart(scene); });
  add(on.sight, [&] { return sightPart(scene); });
  add(on.density, [&] { return densityPart(scene); });
  add(on.plans, [&]() -> LegendPart { return {QObject::tr("People's paths"), {planRow(scene)}}; });
  add(on.contacts, [&] { return contactPart(scene); });
  add(on.thoughts, []() -> LegendPart {
    return {QObject::tr("Below names"), {noteRow(QObject::tr("action and its reason"))}};
  });
  add(on.localCosts || on.globalCosts, [&] { return costPart(scene); });
  add(on.masks, [&] { return maskPart(scene); });
  add(on.candidates, [&] { return trajectoryCostPart(scene); });
  std::vector<LegendRow> senses = senseRows(scene);
  if (senses.empty() && on.lidar && isLidarChosen(scene)) {
    senses.push_back(noteRow(scene.frameLayer().areSensesHidden()
                                 ? QObject::tr("lidar: not side by side")
                                 : QObject::tr("lidar: newest only")));
  }
  add(true, [&]() -> LegendPart { return {QObject::tr("Robot"), std::move(senses)}; });
  return parts;
}

}  // namespace editor
