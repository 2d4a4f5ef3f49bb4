#include "editor/canvas/MapLegend.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPainter>
#include <QStringList>

#include "editor/canvas/MapView.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/RunOverlays.h"
#include "editor/canvas/ViewOverlays.h"

namespace editor {

namespace {

constexpr double kLegendRowPx = 20.0;
constexpr double kPlatePad = 10.0;
constexpr double kPlateMargin = 12.0;
constexpr double kSampleGap = 8.0;

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

LegendSample arrowSample(const Theme& theme, const QColor& color, double width) {
  return [&theme, color, width](QPainter& painter, const QRectF& box) {
    const QPointF tip(box.right(), box.center().y());
    painter.setPen(QPen(color, width));
    painter.drawLine(QPointF(box.left(), tip.y()), tip);
    FigurePainter(theme).arrowHead(painter, tip, 0.0, 6.0);
  };
}

/// A bar that shows the length on the map of one unit.
LegendRow scaleRow(double metresPerUnit, double pixelsPerMetre, const QString& unit,
                   const QColor& color) {
  const double perUnit = metresPerUnit * pixelsPerMetre;
  const double amount = niceLength(perUnit, 60.0);
  const double length = amount * perUnit;
  LegendRow row;
  row.value = QStringLiteral("%1 %2").arg(amount, 0, 'g', 3).arg(unit);
  row.sample = [length, color](QPainter& painter, const QRectF& box) {
    const double y = box.center().y() + 2.0;
    painter.setPen(QPen(color, 1.5));
    painter.drawLine(QPointF(box.left(), y), QPointF(box.left() + length, y));
    painter.drawLine(QPointF(box.left(), y - 4.0), QPointF(box.left(), y));
    painter.drawLine(QPointF(box.left() + length, y - 4.0), QPointF(box.left() + length, y));
  };
  return row;
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
                         arrowSample(theme, theme.color(term.color), 2.2)});
  }
  part.rows.push_back(scaleRow(kMetresPerForce, pixelsPerMetre, QStringLiteral("m/s²"),
                               theme.color(Role::TextSecondary)));
  return part;
}

LegendPart velocityPart(const MapScene& scene, double pixelsPerMetre) {
  LegendPart part{QObject::tr("Velocities"), {}};
  part.rows.push_back(scaleRow(kMetresPerVelocity, pixelsPerMetre, QStringLiteral("m/s"),
                               scene.theme().color(Role::TextSecondary)));
  return part;
}

LegendSample discSample(const QColor& color, double alpha) {
  return [color, alpha](QPainter& painter, const QRectF& box) {
    QColor fill = color;
    fill.setAlphaF(alpha);
    QColor rim = color;
    rim.setAlphaF(0.8);
    setPenAndBrush(painter, QPen(rim, 1.0), fill);
    painter.drawEllipse(box.center(), 7.0, 7.0);
  };
}

LegendPart spacePart(const MapScene& scene) {
  const QColor color = scene.theme().line(Look::Regular);
  LegendPart part{legendTitle(scene, QObject::tr("Spaces"), QObject::tr("Spaces of %1"),
                              QObject::tr("Spaces of selection")),
                  {}};
  if (scene.options().proxemics) {
    part.rows.push_back(
        {QObject::tr("Intimate"), QStringLiteral("0.45 m"), discSample(color, 0.5)});
    part.rows.push_back(
        {QObject::tr("Personal"), QStringLiteral("1.2 m"), discSample(color, 0.28)});
    part.rows.push_back({QObject::tr("Social"), QStringLiteral("3.6 m"), discSample(color, 0.1)});
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
  LegendPart part;
  const std::optional<int> person = watchedPerson(scene);
  if (!person || !scene.frameLayer().positionOf(*person)) {
    part.title = QObject::tr("Field of view");
    part.rows.push_back(noteRow(QObject::tr("Select a person")));
    return part;
  }
  part.title = QObject::tr("Seen by %1").arg(scene.frameLayer().nameOf(*person));
  QColor color = scene.theme().line(Look::Curious);
  for (const ShownBody& body : scene.frameLayer().shownBodies()) {
    color = body.id == *person ? scene.theme().line(body.look) : color;
  }
  part.rows.push_back(
      {QObject::tr("100° to either side"),
       QStringLiteral("%1 m").arg(scene.overlays().noticeDistance(*person), 0, 'g', 3),
       [color](QPainter& painter, const QRectF& box) {
         QColor fill = color;
         fill.setAlphaF(0.25);
         setPenAndBrush(painter, QPen(color, 1.0), fill);
         const QPointF eye(box.left() + 2.0, box.center().y());
         painter.drawPie(around(eye, 17.0), -30 * 16, 60 * 16);
       }});
  return part;
}

LegendPart densityPart(const MapScene& scene) {
  const Theme& theme = scene.theme();
  const double most = scene.overlays().densityScaleMax();
  LegendPart part{QObject::tr("People per m²"), {}};
  LegendRow bar;
  bar.value = QStringLiteral("%1").arg(most > 0.0 ? most : 0.5, 0, 'g', 3);
  bar.sample = rampSample(theme, [&theme](double share) { return densityColor(theme, share); });
  part.rows.push_back(bar);
  part.rows.push_back(
      noteRow(QObject::tr("exp(−d²/R²)/πR², R = %1 m").arg(metrics::kDensityRadius)));
  return part;
}

LegendPart planPart(const MapScene& scene) {
  const QColor color = scene.theme().line(Look::Regular);
  LegendPart part{QObject::tr("People's paths"), {}};
  if (!scene.overlays().hasPlans()) {
    part.rows.push_back(noteRow(QObject::tr("newest step only")));
    return part;
  }
  QPen pen(color, 1.4, Qt::CustomDashLine, Qt::FlatCap);
  pen.setDashPattern({4.0, 2.5});
  part.rows.push_back({QObject::tr("Remaining path"), {}, strokeSample(pen)});
  return part;
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

LegendPart thoughtPart() {
  LegendPart part{QObject::tr("Below names"), {}};
  part.rows.push_back(noteRow(QObject::tr("action and its reason")));
  return part;
}

}  // namespace

LegendRow noteRow(const QString& label) {
  return {label, {}, {}, true};
}

LegendSample strokeSample(const QPen& pen) {
  return [pen](QPainter& painter, const QRectF& box) {
    painter.setPen(pen);
    painter.drawLine(QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()));
  };
}

LegendSample rampSample(const Theme& theme, const std::function<QColor(double)>& colorOf) {
  return [&theme, colorOf](QPainter& painter, const QRectF& box) {
    constexpr int kRampPx = 118;
    const QRectF place(box.left(), box.top() + 5.0, kRampPx, 10.0);
    painter.fillRect(place, theme.color(Role::MapFree));
    for (int x = 0; x < kRampPx; ++x) {
      painter.fillRect(QRectF(place.left() + x, place.top(), 1.0, place.height()),
                       colorOf((x + 0.5) / kRampPx));
    }
    setPenAndBrush(painter, QPen(theme.color(Role::Line), 1.0));
    painter.drawRect(place);
  };
}

bool needsLegend(const MapScene& scene) {
  const CanvasOptions& on = scene.options();
  return scene.isRunMode() &&
         (on.forces || on.velocities || on.proxemics || on.gaussian || on.sight || on.density ||
          on.plans || on.contacts || on.thoughts || on.detections || on.candidates ||
          on.localCosts || on.globalCosts || on.masks || (on.lidar && isLidarChosen(scene)) ||
          !senseRows(scene).empty());
}

std::vector<LegendPart> legendOf(const MapScene& scene, double pixelsPerMetre) {
  std::vector<LegendPart> parts;
  if (!needsLegend(scene)) {
    return parts;
  }
  const CanvasOptions& on = scene.options();
  const auto add = [&parts](bool isOn, const auto& make) {
    if (isOn) {
      parts.push_back(make());
    }
  };
  add(on.forces, [&] { return forcePart(scene, pixelsPerMetre); });
  add(on.velocities, [&] { return velocityPart(scene, pixelsPerMetre); });
  add(on.proxemics || on.gaussian, [&] { return spacePart(scene); });
  add(on.sight, [&] { return sightPart(scene); });
  add(on.density, [&] { return densityPart(scene); });
  add(on.plans, [&] { return planPart(scene); });
  add(on.contacts, [&] { return contactPart(scene); });
  add(on.thoughts, [] { return thoughtPart(); });
  add(on.localCosts || on.globalCosts, [&] { return costPart(scene); });
  add(on.masks, [&] { return maskPart(scene); });
  if (LegendPart prices = on.candidates ? trajectoryCostPart(scene) : LegendPart();
      !prices.rows.empty()) {
    parts.push_back(std::move(prices));
  }
  std::vector<LegendRow> senses = senseRows(scene);
  if (senses.empty() && on.lidar && isLidarChosen(scene)) {
    senses.push_back(noteRow(QObject::tr("lidar: newest only")));
  }
  if (!senses.empty()) {
    parts.push_back({QObject::tr("Robot"), std::move(senses)});
  }
  return parts;
}

LegendStrip::LegendStrip(MapView& view) : QWidget(&view), view_(view) {
  setAccessibleName(tr("Legend"));
  setAttribute(Qt::WA_OpaquePaintEvent);
}

void LegendStrip::setStateColor(const QColor& color) {
  state_ = color;
  update();
}

void LegendStrip::paintEvent(QPaintEvent* /*event*/) {
  const MapScene& scene = view_.mapScene();
  QPainter painter(this);
  painter.fillRect(rect(), scene.groundColor());
  painter.setRenderHint(QPainter::Antialiasing);
  const std::vector<LegendPart> parts = legendOf(scene, view_.pixelsPerMetre());
  double height = 2.0 * kPlatePad - 4.0;
  for (const LegendPart& part : parts) {
    height += (static_cast<double>(part.rows.size()) + 1.0) * kLegendRowPx + 8.0;
  }
  const QRectF plate(0.5, kPlateMargin + 0.5, width() - kPlateMargin - 1.0, height - 8.0);
  if (!parts.empty()) {
    paintLegendBackground(painter, scene.theme(), plate);
  }
  QRectF room = plate.adjusted(kPlatePad, kPlatePad - 2.0, -kPlatePad, 0.0);
  for (const LegendPart& part : parts) {
    room.setTop(paintPart(painter, part, room));
  }
  if (state_.isValid()) {
    painter.fillRect(QRectF(0.0, 0.0, width(), kStateLinePx), state_);
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
                     QFontMetricsF(font).elidedText(label, Qt::ElideRight, place.width() + 1.0));
  };
  write(line, Qt::AlignLeft, part.title, theme.font(9.0, QFont::DemiBold), Role::Text);
  line.translate(0.0, kLegendRowPx);
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
