#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/PixelFrame.h"

/// What the mouse does to robots and people of a run: pulling, pushing, placing.
namespace editor {

/// Draws a line from a robot to the point to which the mouse pulls it.
void FrameLayer::paintPull(QPainter& painter) const {
  const auto& pull = mapScene().pull();
  const Body* robot = pull ? body(pull->robot) : nullptr;
  if (robot == nullptr) {
    return;
  }
  setPenAndBrush(painter, screenPen(painter, theme().color(Role::Accent), 2.0, Qt::DashLine));
  painter.drawLine(toScene(robot->pose.position), toScene(pull->to));
  const PixelFrame frame(painter, toScene(pull->to));
  setPenAndBrush(painter, QPen(theme().color(Role::Accent), 2.0), theme().color(Role::Panel));
  painter.drawEllipse(QPointF(), 5.0, 5.0);
}

/// Draws the arrow of a push with its speed.
void FrameLayer::paintPush(QPainter& painter) const {
  const auto& push = mapScene().push();
  const Body* person = push ? body(push->person) : nullptr;
  if (person == nullptr || push->velocity.isZero()) {
    return;
  }
  const Vec2 to = person->pose.position + push->velocity;
  setPenAndBrush(painter, screenPen(painter, theme().color(Role::Accent), 3.0));
  painter.drawLine(toScene(person->pose.position), toScene(to));
  const PixelFrame frame(painter, toScene(to));
  painter.setPen(QPen(theme().color(Role::Accent), 3.0));
  FigurePainter(theme()).arrowHead(painter, QPointF(), degrees(base::headingOf(push->velocity)),
                                   11.0);
  painter.setFont(theme().figureFont(9.0));
  const QString words = QStringLiteral("%1 m/s").arg(push->velocity.norm(), 0, 'f', 1);
  QRectF box = QFontMetricsF(painter.font()).boundingRect(words).adjusted(-6, -3, 6, 3);
  box.moveCenter(QPointF(0.0, push->velocity.y() >= 0.0 ? -20.0 : 20.0));
  setPenAndBrush(painter, QPen(theme().color(Role::Accent), 1.0), theme().color(Role::Panel));
  painter.drawRoundedRect(box, 4.0, 4.0);
  painter.setPen(theme().color(Role::Text));
  painter.drawText(box, Qt::AlignCenter, words);
}

/// Draws a person where the mouse drags them, with a line from where they stand.
void FrameLayer::paintPlacement(QPainter& painter) const {
  const auto& placement = mapScene().placement();
  const Body* person = placement ? body(placement->person) : nullptr;
  if (person == nullptr) {
    return;
  }
  setPenAndBrush(painter, screenPen(painter, theme().color(Role::Accent), 2.0, Qt::DashLine));
  painter.drawLine(toScene(person->pose.position), toScene(placement->pose.position));
  Body ghost = *person;
  ghost.pose = placement->pose;
  const PersonFigure figure = figureOf(ghost, pixelsPerMetreOf(painter));
  const PixelFrame frame(painter, toScene(ghost.pose.position));
  painter.setOpacity(0.75);
  FigurePainter(theme()).person(painter, figure);
  painter.setOpacity(1.0);
  paintRing(painter, QPen(theme().color(Role::Accent), 2.0), figure.radiusPx + 4.0);
}

}  // namespace editor
