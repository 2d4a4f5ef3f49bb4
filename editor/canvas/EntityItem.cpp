#include "editor/canvas/EntityItem.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/SpriteAtlas.h"
#include "editor/document/EditCommands.h"
#include "editor/document/Groups.h"
#include "sim2d/scenario/Defaults.h"

namespace editor {

namespace {

constexpr std::size_t kMostExact = 8;    // selected people that are not drawn from sprites
constexpr std::size_t kMostNamed = 100;  // selected people who are named at any zoom

class PersonItem : public EntityItem {
 public:
  using EntityItem::EntityItem;
  double distanceTo(const Vec2& world) const override {
    const double reach = std::max(radius_, metres(kLeastFigurePx));
    return std::max(0.0, (world - human_.initPose.position).norm() - reach);
  }

  std::vector<Label> labels() const override {
    const double radiusPx = radius_ * mapScene().pixelsPerMetre();
    const bool isChosen = isSelectedEntity();
    const bool isOneOfFew = isChosen && mapScene().document().selection().size() <= kMostNamed;
    const bool isAlways =
        isOneOfFew || (2.0 * radiusPx >= kNameZoomPx && mapScene().options().names);
    if (!isAlways && !isHovered()) {
      return {};
    }
    const bool isNeeded = !isAlways || (isChosen && mapScene().document().selection().size() == 1);
    const double clearance = std::max(radiusPx, kLeastFigurePx) + (isChosen ? 12.0 : 4.0);
    return {{QString::fromStdString(human_.name), look_,
             MapScene::sceneFromWorld(human_.initPose.position), clearance, isChosen ? 3 : 1,
             isChosen, !isAlways, isNeeded}};
  }

  std::vector<QRectF> solidParts() const override {
    const double reach = std::max(radius_, metres(kLeastFigurePx));
    return {around(MapScene::sceneFromWorld(human_.initPose.position), 0.9 * reach)};
  }

  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    if (mapScene().options().proxemics && isSelectedEntity()) {
      paintSpaces(*painter, human_.initPose.position, theme().fill(look_));
    }
    const double radiusPx = std::max(radius_ * pixelsPerMetreOf(*painter), kLeastFigurePx);
    const PixelFrame frame(*painter, MapScene::sceneFromWorld(human_.initPose.position));
    if (isSelectedEntity()) {
      paintRing(*painter, QPen(theme().line(look_), 1.0), radiusPx);
    } else if (isHovered()) {
      paintRing(*painter, QPen(theme().color(Role::Accent, 0.6), 1.5), radiusPx + 2.5);
    }
    PersonFigure figure;
    figure.look = look_;
    figure.kind = human_.ours.kind.value_or(sim2d::PersonKind::Adult);
    figure.radiusPx = radiusPx;
    figure.headingDeg = degrees(human_.initPose.heading);
    if (isSelectedEntity() && mapScene().document().selection().size() <= kMostExact) {
      FigurePainter(theme()).person(*painter, figure);  // its heading to the degree
    } else {
      mapScene().sprites().draw(*painter, theme(), {{QPointF(), figure}});
    }
  }

 protected:
  void take(const Entity& value) override {
    human_ = std::get<sim2d::Human>(value);
    const sim2d::Scenario& scenario = mapScene().document().scenario();
    radius_ = sim2d::resolveHuman(scenario, human_, scenario.desktop.seed.value_or(1)).radius;
    look_ = lookOfPerson(mapScene().document(), human_);
  }

  QRectF bounds(double pixelsPerMetre) const override {
    const double spaces = mapScene().options().proxemics ? 3.7 : 0.0;
    const double reach = std::max({1.5 * radius_, (kLeastFigurePx + 5.0) / pixelsPerMetre, spaces});
    return around(MapScene::sceneFromWorld(human_.initPose.position), reach);
  }

 private:
  sim2d::Human human_;
  double radius_ = 0.35;  // [m]
  Look look_ = Look::Regular;
};

class RobotItem : public EntityItem {
 public:
  using EntityItem::EntityItem;
  double distanceTo(const Vec2& world) const override {
    const double body =
        (world - robot_.start.position).norm() - std::max(radius_, metres(kLeastFigurePx));
    const double goal =
        robot_.goal.point ? (world - *robot_.goal.point).norm() - metres(kRobotGoalPx) : body;
    return std::max(0.0, std::min(body, goal));
  }

  std::vector<Label> labels() const override {
    const bool isAlways = mapScene().options().names || isSelectedEntity();
    if (!isAlways && !isHovered()) {
      return {};
    }
    const double radiusPx = std::max(radius_ * mapScene().pixelsPerMetre(), kLeastFigurePx);
    const QString name = QString::fromStdString(robot_.name);
    const int priority = isSelectedEntity() ? 3 : 2;
    std::vector<Label> labels = {
        {name, std::nullopt, MapScene::sceneFromWorld(robot_.start.position),
         radiusPx + (isSelectedEntity() ? 12.0 : 5.0), priority, false, !isAlways}};
    if (robot_.goal.point) {
      labels.push_back({QStringLiteral("%1 goal").arg(name), std::nullopt,
                        MapScene::sceneFromWorld(*robot_.goal.point), kRobotGoalPx + 4.0, priority,
                        false, !isAlways});
    }
    return labels;
  }

  std::vector<QRectF> solidParts() const override {
    std::vector<QRectF> parts = {around(MapScene::sceneFromWorld(robot_.start.position),
                                        std::max(radius_, metres(kLeastFigurePx)))};
    if (robot_.goal.point) {
      parts.push_back(around(MapScene::sceneFromWorld(*robot_.goal.point), metres(kRobotGoalPx)));
    }
    return parts;
  }

  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    if (robot_.goal.point) {
      paintRobotGoal(*painter, theme(), *robot_.goal.point);
    }
    const RobotFigure figure =
        robotFigure(radius_, footprint_, robot_.start.heading, pixelsPerMetreOf(*painter));
    const PixelFrame frame(*painter, MapScene::sceneFromWorld(robot_.start.position));
    if (isHovered() && !isSelectedEntity()) {
      paintRing(*painter, QPen(theme().color(Role::Accent, 0.6), 1.5), figure.radiusPx + 3.0);
    }
    FigurePainter(theme()).robot(*painter, figure);
  }

 protected:
  void take(const Entity& value) override {
    robot_ = std::get<sim2d::Robot>(value);
    const sim2d::ResolvedRobot resolved =
        sim2d::resolveRobot(mapScene().document().scenario(), robot_, -1);
    footprint_ = resolved.footprint;
    radius_ = resolved.radius;
    for (const Vec2& point : footprint_) {
      radius_ = std::max(radius_, point.norm());
    }
  }

  QRectF bounds(double pixelsPerMetre) const override {
    const double least = 12.0 / pixelsPerMetre;
    QRectF result =
        around(MapScene::sceneFromWorld(robot_.start.position), std::max(1.3 * radius_, least));
    if (robot_.goal.point) {
      result |= around(MapScene::sceneFromWorld(*robot_.goal.point), 14.0 / pixelsPerMetre);
    }
    return result;
  }

 private:
  sim2d::Robot robot_;
  double radius_ = 0.35;         // of the circle around the footprint [m]
  std::vector<Vec2> footprint_;  // robot frame
};

constexpr double kPinWidthPx = 18.0;
constexpr double kPinHeightPx = 27.0;
constexpr double kGoalRingMetres = 0.3;

class GoalItem : public EntityItem {
 public:
  using EntityItem::EntityItem;
  double distanceTo(const Vec2& world) const override {
    const QPointF offset =
        (MapScene::sceneFromWorld(world) - MapScene::sceneFromWorld(goal_.position)) *
        mapScene().pixelsPerMetre();
    const QPointF head(0.0, -17.0);
    const QPointF fromHead = offset - head;
    const double toHead = std::hypot(fromHead.x(), fromHead.y()) - 0.5 * kPinWidthPx;
    const double toTip = std::hypot(offset.x(), offset.y());
    return metres(std::max(0.0, std::min(toHead, toTip)));
  }

  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    const QPointF tip = MapScene::sceneFromWorld(goal_.position);
    const bool isChosen = isSelectedEntity();
    if (isChosen || isHovered()) {
      QPen pen(theme().color(Role::Accent, isChosen ? 1.0 : 0.6), 1.5);
      makeCosmetic(pen, *painter);
      painter->setPen(pen);
      painter->setBrush(theme().color(Role::Accent, 0.08));
      painter->drawEllipse(tip, kGoalRingMetres, kGoalRingMetres);
    }
    const PixelFrame frame(*painter, tip);
    painter->setPen(Qt::NoPen);
    painter->setBrush(theme().color(Role::Text, 0.25));
    painter->drawEllipse(QPointF(0.0, 0.5), 4.0, 1.6);
    FigurePainter(theme()).pin(*painter, QString::number(goal_.id), isChosen);
  }

  std::vector<QRectF> solidParts() const override {
    const QPointF tip = MapScene::sceneFromWorld(goal_.position);
    return {QRectF(tip.x() - metres(0.5 * kPinWidthPx), tip.y() - metres(kPinHeightPx),
                   metres(kPinWidthPx), metres(kPinHeightPx))};
  }

 protected:
  void take(const Entity& value) override { goal_ = std::get<sim2d::GlobalGoal>(value); }

  QRectF bounds(double pixelsPerMetre) const override {
    const QPointF tip = MapScene::sceneFromWorld(goal_.position);
    const double unit = 1.0 / pixelsPerMetre;
    const QRectF pin(tip.x() - 11.0 * unit, tip.y() - 29.0 * unit, 22.0 * unit, 32.0 * unit);
    return pin | around(tip, kGoalRingMetres + 2.0 * unit);
  }

 private:
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
  const QRectF fresh = bounds(scene_.pixelsPerMetre());
  if (fresh != bounds_) {
    prepareGeometryChange();
    bounds_ = fresh;
  }
}

RobotFigure robotFigure(double radius, const std::vector<Vec2>& footprint, double heading,
                        double pixelsPerMetre) {
  const double scale = std::max(pixelsPerMetre, kLeastFigurePx / radius);
  RobotFigure figure;
  figure.radiusPx = radius * scale;
  figure.headingDeg = degrees(heading);
  for (const Vec2& point : footprint) {
    figure.footprintPx.emplace_back(point.x() * scale, point.y() * scale);
  }
  return figure;
}

void paintSpaces(QPainter& painter, const Vec2& at, QColor color) {
  painter.setPen(Qt::NoPen);
  for (const auto& [reach, alpha] : {std::pair(3.6, 0.05), {1.2, 0.10}, {0.45, 0.18}}) {
    color.setAlphaF(alpha);
    painter.setBrush(color);
    painter.drawEllipse(MapScene::sceneFromWorld(at), reach, reach);
  }
}

void paintRobotGoal(QPainter& painter, const Theme& theme, const Vec2& at) {
  const PixelFrame frame(painter, MapScene::sceneFromWorld(at));
  painter.setPen(QPen(theme.color(Role::RobotBody), 2.0));
  painter.setBrush(theme.color(Role::MapFree));
  painter.drawEllipse(QPointF(), kRobotGoalPx, kRobotGoalPx);
  painter.setPen(QPen(theme.color(Role::RobotBody), 1.2));
  painter.setBrush(theme.color(Role::RobotFront));
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
    case EntityKind::Obstacle:
    case EntityKind::Door:
    case EntityKind::Area:
      return makeShapeItem(scene, id);
    case EntityKind::Scenario:
    case EntityKind::None:
      break;
  }
  return nullptr;
}

}  // namespace editor
