#include <algorithm>

#include "editor/canvas/EntityItem.h"
#include "editor/canvas/PixelFrame.h"
#include "sim2d/scenario/Defaults.h"

namespace editor {

namespace {

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
    const double pixelsPerMetre = pixelsPerMetreOf(*painter);
    if (robot_.goal.point) {
      const PixelFrame frame(*painter, MapScene::sceneFromWorld(*robot_.goal.point));
      paintRobotGoal(*painter, theme());
    }
    const PixelFrame frame(*painter, MapScene::sceneFromWorld(robot_.start.position));
    const double scale = std::max(pixelsPerMetre, kLeastFigurePx / radius_);
    RobotFigure figure;
    figure.radiusPx = radius_ * scale;
    figure.headingDeg = degrees(robot_.start.heading);
    for (const Vec2& point : footprint_) {
      figure.footprintPx.emplace_back(point.x() * scale, point.y() * scale);
    }
    if (isHovered() && !isSelectedEntity()) {
      painter->setBrush(Qt::NoBrush);
      painter->setPen(QPen(theme().color(Role::Accent, 0.6), 1.5));
      painter->drawEllipse(QPointF(), figure.radiusPx + 3.0, figure.radiusPx + 3.0);
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
    setOpacity(robot_.listed ? 1.0 : 0.4);
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

}  // namespace

std::unique_ptr<EntityItem> makeRobotItem(const MapScene& scene, EntityId id) {
  return std::make_unique<RobotItem>(scene, id);
}

}  // namespace editor
