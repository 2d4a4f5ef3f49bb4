#include <algorithm>
#include <cmath>

#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/MapLegend.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/PlannerPainter.h"

// What colours of costmaps and of weighed ways say, and what each critic gave the chosen way.
namespace editor {

namespace {

constexpr double kRampPx = 118.0;

using PlannerSample = std::function<void(QPainter&, const QRectF&)>;

LegendRow plannerNote(const QString& words) {
  return {words, {}, {}, true};
}

/// A bar of colours, with what it ends at beside it.
template <class ColorOf>
PlannerSample rampSample(const Theme& theme, ColorOf colorOf) {
  return [&theme, colorOf](QPainter& painter, const QRectF& box) {
    const QRectF place(box.left(), box.top() + 5.0, kRampPx, 10.0);
    painter.fillRect(place, theme.color(Role::MapFree));
    for (int x = 0; x < static_cast<int>(kRampPx); ++x) {
      painter.fillRect(QRectF(place.left() + x, place.top(), 1.0, place.height()),
                       colorOf((x + 0.5) / kRampPx));
    }
    setInk(painter, QPen(theme.color(Role::Line), 1.0));
    painter.drawRect(place);
  };
}

PlannerSample cellSample(const Theme& theme, std::uint8_t cost) {
  return [&theme, cost](QPainter& painter, const QRectF& box) {
    const QRectF place = box.adjusted(3.0, 3.0, -3.0, -3.0);
    painter.fillRect(place, theme.color(Role::MapFree));
    setInk(painter, QPen(theme.color(Role::Line), 1.0), costColor(theme, cost));
    painter.drawRect(place);
  };
}

PlannerSample strokeSample(const QPen& pen) {
  return [pen](QPainter& painter, const QRectF& box) {
    painter.setPen(pen);
    painter.drawLine(QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()));
  };
}

PlannerSample aimSample(const Theme& theme) {
  return [&theme](QPainter& painter, const QRectF& box) {
    paintRing(painter, QPen(theme.color(Role::Accent), 2.0), 6.0, box.center());
    setInk(painter, Qt::NoPen, theme.color(Role::Accent));
    painter.drawEllipse(box.center(), 1.8, 1.8);
  };
}

/// How much of the price it is.
PlannerSample shareSample(const Theme& theme, double share) {
  return [&theme, share](QPainter& painter, const QRectF& box) {
    const QRectF whole(box.left(), box.center().y() - 3.0, box.width(), 6.0);
    painter.fillRect(whole, theme.color(Role::Line, 0.7));
    painter.fillRect(QRectF(whole.topLeft(), QSizeF(share * whole.width(), whole.height())),
                     theme.color(Role::Text, 0.75));
  };
}

QString priceText(double price) {
  return std::abs(price) >= 1e5 ? QString::number(price, 'g', 3) : QString::number(price, 'f', 2);
}

}  // namespace

LegendPart costPart(const MapScene& scene) {
  const Theme& theme = scene.theme();
  const std::optional<LookedAt> robot = plannerLookedAt(scene);
  LegendPart part{robot ? QObject::tr("Costs of %1").arg(robot->name) : QObject::tr("Costs"), {}};
  const bool isKnown = robot && (robot->senses->localCosts || robot->senses->globalCosts);
  if (!isKnown) {
    part.rows.push_back(plannerNote(QObject::tr("newest moment, of Nav2")));
    return part;
  }
  LegendRow ramp;
  ramp.value = QStringLiteral("252");
  ramp.sample = rampSample(theme, [&theme](double share) {
    return costColor(theme, static_cast<std::uint8_t>(std::lround(252.0 * share)));
  });
  part.rows = {ramp,
               {QObject::tr("Would touch"), QStringLiteral("253"), cellSample(theme, 253)},
               {QObject::tr("Obstacle"), QStringLiteral("254"), cellSample(theme, 254)},
               {QObject::tr("Unknown"), QStringLiteral("255"), cellSample(theme, 255)}};
  return part;
}

LegendPart pricePart(const MapScene& scene) {
  LegendPart part;
  const Theme& theme = scene.theme();
  const std::optional<LookedAt> robot = plannerLookedAt(scene);
  if (!robot || (!hasPrices(*robot->senses) && robot->senses->lookahead.empty())) {
    return part;
  }
  const sim2d::RobotSenses& senses = *robot->senses;
  part.title = senses.controller.empty() ? QObject::tr("Weighed by %1").arg(robot->name)
                                         : QString::fromStdString(senses.controller);
  if (hasPrices(senses)) {
    const PriceScale scale = priceScaleOf(senses.ways);
    LegendRow ramp;
    ramp.sample = rampSample(theme, [&theme](double share) { return priceColor(theme, share); });
    part.rows.push_back(ramp);
    part.rows.push_back(
        {priceText(scale.low), QStringLiteral("≥ %1").arg(priceText(scale.high)), {}, true});
    part.rows.push_back({QObject::tr("Refused"), QString::number(scale.refused),
                         strokeSample(QPen(theme.color(Role::TextSecondary, 0.4), 1.2))});
  }
  if (!senses.lookahead.empty()) {
    part.rows.push_back({QObject::tr("Aims at"), {}, aimSample(theme)});
  }
  const auto chosen = std::find_if(senses.ways.begin(), senses.ways.end(),
                                   [](const auto& way) { return way.isChosen; });
  if (chosen == senses.ways.end()) {
    return part;
  }
  part.rows.push_back({QObject::tr("Chosen"), priceText(chosen->cost),
                       strokeSample(QPen(theme.color(Role::Text), 2.5))});
  double most = 0.0;
  for (const auto& [critic, score] : chosen->scores) {
    most = std::max(most, std::abs(score));
  }
  for (const auto& [critic, score] : chosen->scores) {
    part.rows.push_back({QString::fromStdString(critic), priceText(score),
                         shareSample(theme, most > 0.0 ? std::abs(score) / most : 0.0)});
  }
  return part;
}

}  // namespace editor
