#include "editor/canvas/FanLayer.h"

#include <cmath>
#include <utility>

#include "editor/canvas/PixelFrame.h"

namespace editor {

namespace {

constexpr std::size_t kMostPeople = 60;  // of whom all ways are drawn; else those of contacts
constexpr double kCrossPx = 5.0;

/// The points from one time to another [s] at which somebody is there.
QPolygonF wayPart(const app::Future& future, const std::vector<Vec2>& way, double from, double to) {
  QPolygonF line;
  for (std::size_t k = 0; k < way.size(); ++k) {
    if (future.times[k] >= from - 1e-9 && future.times[k] <= to + 1e-9 && way[k].allFinite()) {
      line << toScene(way[k]);
    }
  }
  return line;
}

}  // namespace

void FanLayer::show(Futures futures) {
  const bool isNothing = futures_ == nullptr && futures == nullptr;
  futures_ = std::move(futures);
  if (!isNothing) {
    update();
  }
}

void FanLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (futures_ == nullptr) {
    return;
  }
  painter->setRenderHint(QPainter::Antialiasing);
  for (const app::Future& future : *futures_) {
    if (options().people) {
      paintPeople(*painter, future);
    }
  }
  for (const bool isOfContact : {false, true}) {  // these over those
    for (const app::Future& future : *futures_) {
      if (options().robots && future.contact.has_value() == isOfContact) {
        paintRobots(*painter, future);
      }
    }
  }
  for (const app::Future& future : *futures_) {
    if (future.contact && future.contact->where.allFinite()) {
      paintContact(*painter, toScene(future.contact->where));
    }
  }
}

void FanLayer::paintContact(QPainter& painter, const QPointF& where) const {
  const PixelFrame frame(painter, where);
  for (const bool isHalo : {true, false}) {
    const QColor color = isHalo ? theme().color(Role::Panel) : theme().color(Role::Error);
    painter.setPen(QPen(color, isHalo ? 5.0 : 2.4, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(-kCrossPx, -kCrossPx), QPointF(kCrossPx, kCrossPx));
    painter.drawLine(QPointF(-kCrossPx, kCrossPx), QPointF(kCrossPx, -kCrossPx));
  }
}

void FanLayer::paintPeople(QPainter& painter, const app::Future& future) const {
  const bool showsAll = future.ways.size() <= kMostPeople;
  for (const auto& [id, way] : future.ways) {
    const bool isTouched =
        future.contact && (future.contact->id == id || future.contact->other == id);
    if (id < 0 || way.empty() || !(showsAll || isTouched)) {
      continue;
    }
    const QColor color = theme().color(Role::TextSecondary, isTouched ? 0.55 : 0.22);
    setInk(painter, screenPen(painter, color, isTouched ? 1.6 : 1.2));
    painter.drawPolyline(wayPart(future, way, future.times.front(), future.times.back()));
  }
}

/// What comes after a contact is dotted.
void FanLayer::paintRobots(QPainter& painter, const app::Future& future) const {
  const QColor color =
      future.contact ? theme().color(Role::Error, 0.8) : theme().color(Role::Accent, 0.55);
  for (const auto& [id, way] : future.ways) {
    if (id >= 0 || way.empty()) {
      continue;
    }
    const double end = future.contact ? future.contact->time : future.times.back();
    setInk(painter, screenPen(painter, color, 2.0));
    painter.drawPolyline(wayPart(future, way, future.times.front(), end));
    if (future.contact) {
      setInk(painter, screenPen(painter, color, 1.4, Qt::DotLine));
      painter.drawPolyline(wayPart(future, way, end, future.times.back()));
    }
  }
}

}  // namespace editor
