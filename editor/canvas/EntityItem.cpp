#include "editor/canvas/EntityItem.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/OverlayPainter.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/SpriteAtlas.h"
#include "editor/document/EditCommands.h"
#include "editor/document/PeopleEdits.h"
#include "sim2d/scenario/ResolvedValues.h"

namespace editor {

namespace {

constexpr std::size_t kMaxExact = 8;    // Maximum number of selected people drawn without sprites.
constexpr std::size_t kMaxNamed = 100;  // Selected people with names at any zoom.

class PersonItem : public EntityItem {
 public:
  using EntityItem::EntityItem;
  double distanceTo(const Vec2& world) const override {
    return std::max(0.0, (world - human_.initPose.position).norm() - reach());
  }

  std::vector<Label> labels() const override {
    const bool isChosen = isSelectedEntity();
    const bool isOneOfFew = isChosen && document().selection().size() <= kMaxNamed;
    const bool isAlways =
        isOneOfFew || (mapScene().pixelsPerMetre() >= kNameZoom && options().names);
    if (!isAlways && !isHovered()) {
      return {};
    }
    const bool isNeeded = !isAlways || (isChosen && document().selection().size() == 1);
    const double radiusPx = reach() * mapScene().pixelsPerMetre();
    const double clearance = radiusPx + (isChosen ? 12.0 : 4.0);
    return {{QString::fromStdString(human_.name), look_, place(), clearance, isChosen ? 3 : 1,
             isChosen, !isAlways, isNeeded}};
  }

  std::vector<QRectF> labelObstacles() const override { return {around(place(), 0.9 * reach())}; }

  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    if (options().proxemics && isSelectedEntity()) {
      paintSpaces(*painter, human_.initPose.position, theme().fill(look_));
    }
    PersonFigure figure;
    figure.look = look_;
    figure.kind = human_.ours.kind.value_or(sim2d::PersonKind::Adult);
    figure.radiusPx =
        std::max(radius_ * pixelsPerMetreOf(*painter), mapScene().minFigurePx(EntityKind::Human));
    figure.headingDeg = degrees(human_.initPose.heading);
    const PixelFrame frame(*painter, place());
    if (isSelectedEntity()) {
      paintRing(*painter, QPen(theme().line(look_), 1.0), figure.radiusPx);
    } else if (isHovered()) {
      paintRing(*painter, QPen(theme().color(Role::Accent, 0.6), 1.5), figure.radiusPx + 2.5);
    }
    if (isSelectedEntity() && document().selection().size() <= kMaxExact) {
      FigurePainter(theme()).person(*painter, figure);  // With exact heading.
    } else {
      mapScene().sprites().draw(*painter, theme(), {{QPointF(), figure}});
    }
  }

 protected:
  void take(const Entity& value) override {
    human_ = std::get<sim2d::Human>(value);
    radius_ = mapScene().bodyRadius(value);
    look_ = lookOfPerson(document(), human_);
  }

  QRectF bounds(double pixelsPerMetre) const override {
    const double spaces = options().proxemics ? 3.7 : 0.0;
    return around(place(),
                  std::max({1.5 * radius_, (1.5 * kFewFigurePx) / pixelsPerMetre, spaces}));
  }

 private:
  QPointF place() const { return toScene(human_.initPose.position); }
  double reach() const {
    return std::max(radius_, metres(mapScene().minFigurePx(EntityKind::Human)));
  }

  sim2d::Human human_;
  double radius_ = 0.35;  // [m]
  Look look_ = Look::Regular;
};

class RobotItem : public EntityItem {
 public:
  using EntityItem::EntityItem;
  double distanceTo(const Vec2& world) const override {
    const double body = (world - robot_.start.position).norm() - reach();
    const double goal =
        robot_.goal.point ? (world - *robot_.goal.point).norm() - metres(kRobotGoalPx) : body;
    return std::max(0.0, std::min(body, goal));
  }

  std::vector<Label> labels() const override {
    const bool isChosen = isSelectedEntity();
    const bool isAlways = options().names || isChosen;
    if (!isAlways && !isHovered()) {
      return {};
    }
    const double radiusPx = std::max(radius_ * mapScene().pixelsPerMetre(), kMinFigurePx);
    Label label;
    label.text = QString::fromStdString(robot_.name);
    label.centre = toScene(robot_.start.position);
    label.clearancePx = radiusPx + (isChosen ? 12.0 : 5.0);
    label.priority = isChosen ? 3 : 2;
    label.isHoverOnly = !isAlways;
    std::vector<Label> labels = {label};
    if (robot_.goal.point) {
      label.text = QStringLiteral("%1 goal").arg(label.text);
      label.centre = toScene(*robot_.goal.point);
      label.clearancePx = kRobotGoalPx + 4.0;
      labels.push_back(label);
    }
    return labels;
  }

  std::vector<QRectF> labelObstacles() const override {
    std::vector<QRectF> parts = {around(toScene(robot_.start.position), reach())};
    if (robot_.goal.point) {
      parts.push_back(around(toScene(*robot_.goal.point), metres(kRobotGoalPx)));
    }
    return parts;
  }

  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    if (robot_.goal.point) {
      paintRobotGoal(*painter, theme(), *robot_.goal.point);
    }
    const RobotFigure figure = robotFigure(radius_, footprint_, kinematics_, robot_.start.heading,
                                           pixelsPerMetreOf(*painter));
    const PixelFrame frame(*painter, toScene(robot_.start.position));
    if (isHovered() && !isSelectedEntity()) {
      paintRing(*painter, QPen(theme().color(Role::Accent, 0.6), 1.5), figure.radiusPx + 3.0);
    }
    FigurePainter(theme()).robot(*painter, figure);
  }

 protected:
  void take(const Entity& value) override {
    robot_ = std::get<sim2d::Robot>(value);
    const sim2d::ResolvedRobot resolved = sim2d::resolveRobot(document().scenario(), robot_, -1);
    footprint_ = resolved.footprint;
    kinematics_ = resolved.kinematics;
    radius_ = resolved.radius;
    for (const Vec2& point : footprint_) {
      radius_ = std::max(radius_, point.norm());
    }
  }

  QRectF bounds(double pixelsPerMetre) const override {
    const double least = 12.0 / pixelsPerMetre;
    QRectF result = around(toScene(robot_.start.position), std::max(1.3 * radius_, least));
    if (robot_.goal.point) {
      result |= around(toScene(*robot_.goal.point), 14.0 / pixelsPerMetre);
    }
    return result;
  }

 private:
  double reach() const { return std::max(radius_, metres(kMinFigurePx)); }

  sim2d::Robot robot_;
  double radius_ = 0.35;         // Radius of the circle around the footprint [m].
  std::vector<Vec2> footprint_;  // Robot frame.
  sim2d::Kinematics kinematics_ = sim2d::Kinematics::Differential;
};

constexpr double kPinWidthPx = 18.0;
constexpr double kPinHeightPx = 27.0;
constexpr double kGoalRingMetres = 0.3;

class GoalItem : public EntityItem {
 public:
  using EntityItem::EntityItem;
  double distanceTo(const Vec2& world) const override {
    const QPointF offset = (toScene(world) - tip()) * mapScene().pixelsPerMetre();
    const QPointF fromHead = offset - QPointF(0.0, -17.0);
    const double toHead = std::hypot(fromHead.x(), fromHead.y()) - 0.5 * kPinWidthPx;
    const double toTip = std::hypot(offset.x(), offset.y());
    return metres(std::max(0.0, std::min(toHead, toTip)));
  }

  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    const bool isChosen = isSelectedEntity();
    if (isChosen || isHovered()) {
      QPen pen(theme().color(Role::Accent, isChosen ? 1.0 : 0.6), 1.5);
      makeCosmetic(pen, *painter);
      setPenAndBrush(*painter, pen, theme().color(Role::Accent, 0.08));
      painter->drawEllipse(tip(), kGoalRingMetres, kGoalRingMetres);
    }
    const PixelFrame frame(*painter, tip());
    setPenAndBrush(*painter, Qt::NoPen, theme().color(Role::Text, 0.25));
    painter->drawEllipse(QPointF(0.0, 0.5), 4.0, 1.6);
    FigurePainter(theme()).pin(*painter, QString::number(goal_.id), isChosen);
  }

  std::vector<QRectF> labelObstacles() const override {
    return {QRectF(tip().x() - metres(0.5 * kPinWidthPx), tip().y() - metres(kPinHeightPx),
                   metres(kPinWidthPx), metres(kPinHeightPx))};
  }

 protected:
  void take(const Entity& value) override { goal_ = std::get<sim2d::GlobalGoal>(value); }

  QRectF bounds(double pixelsPerMetre) const override {
    const double unit = 1.0 / pixelsPerMetre;
    const QRectF pin(tip().x() - 11.0 * unit, tip().y() - 29.0 * unit, 22.0 * unit, 32.0 * unit);
    return pin | around(tip(), kGoalRingMetres + 2.0 * unit);
  }

 private:
  QPointF tip() const { return toScene(goal_.position); }

  sim2d::GlobalGoal goal_;
};

}  // namespace

QRectF around(const QPointF& centre, double reach) {
  return {centre.x() - reach, centre.y() - reach, 2.0 * reach, 2.0 * reach};
}

void EntityItem::sync(const Entity& value) {
  take(value);
  setOpacity(isListed(value) ? 1.0 : 0.4);
  zoomChanged();
  update();
}

void EntityItem::zoomChanged() {
  const QRectF fresh = bounds(mapScene().pixelsPerMetre());
  if (fresh != bounds_) {
    prepareGeometryChange();
    bounds_ = fresh;
  }
}

RobotFigure robotFigure(double radius, const std::vector<Vec2>& footprint,
                        sim2d::Kinematics kinematics, double heading, double pixelsPerMetre) {
  const double scale = std::max(pixelsPerMetre, kMinFigurePx / radius);
  RobotFigure figure;
  figure.kinematics = kinematics;
  figure.radiusPx = radius * scale;
  figure.headingDeg = degrees(heading);
  for (const Vec2& point : footprint) {
    figure.footprintPx.emplace_back(point.x() * scale, point.y() * scale);
  }
  return figure;
}

void paintSpaces(QPainter& painter, const Vec2& at, QColor color) {
  painter.setPen(Qt::NoPen);
  for (const auto& [reach, alpha] : kHallZones) {
    color.setAlphaF(alpha);
    painter.setBrush(color);
    painter.drawEllipse(toScene(at), reach, reach);
  }
}

void paintRobotGoal(QPainter& painter, const Theme& theme, const Vec2& at) {
  const PixelFrame frame(painter, toScene(at));
  setPenAndBrush(painter, QPen(theme.color(Role::RobotBody), 2.0), theme.color(Role::MapFree));
  painter.drawEllipse(QPointF(), kRobotGoalPx, kRobotGoalPx);
  setPenAndBrush(painter, QPen(theme.color(Role::RobotBody), 1.2), theme.color(Role::RobotFront));
  painter.drawEllipse(QPointF(), 0.52 * kRobotGoalPx, 0.52 * kRobotGoalPx);
}

std::unique_ptr<EntityItem> makeEntityItem(const MapScene& scene, EntityId id) {
  switch (id.kind) {
    case EntityKind::Human:
      return std::make_unique<PersonItem>(scene, id);
    case EntityKind::Robot:
      return std::make_unique<RobotItem>(scene, id);
    case EntityKind::Goal:
      return std::make_unique<GoalItem>(scene, id);
    default:
      return makeShapeItem(scene, id);
  }
}

}  // namespace editor
