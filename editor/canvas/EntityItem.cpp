#include "editor/canvas/EntityItem.h"

#include <cmath>
#include <limits>

#include "editor/canvas/Layers.h"
#include "editor/canvas/OverlayPainter.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/document/EditCommands.h"
#include "editor/document/PeopleEdits.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/scenario/ScenarioCheck.h"

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
      const LayerOpacity opacity(*painter, options(), &CanvasOptions::proxemics);
      for (const auto& [reach, alpha] : kHallZones) {
        setPenAndBrush(*painter, Qt::NoPen, withAlpha(theme().fill(look_), alpha));
        painter->drawEllipse(place(), reach, reach);
      }
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
      label.text = QCoreApplication::translate("Entity", "%1 goal").arg(label.text);
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
      const QPen pen(theme().color(Role::Accent, isChosen ? 1.0 : 0.6), 1.5);
      setPenAndBrush(*painter, cosmetic(pen, *painter), theme().color(Role::Accent, 0.08));
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

constexpr double kSignPx = 16.0;       // Sign for the kind of an area.
constexpr double kSignInsetPx = 14.0;  // From the corner to the centre of the sign.
constexpr double kLabelGapPx = 6.0;    // From the edges to the name.
constexpr double kDockSide = 0.6;      // Side of the square that represents a docked robot [m].
constexpr double kMinSignPx = 12.0;    // Smaller areas on the screen have no sign.

double distanceToOutline(const Vec2& point, const sim2d::Outline& outline) {
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < outline.points.size(); ++i) {
    const Vec2& next = outline.points[(i + 1) % outline.points.size()];
    nearest = std::min(nearest, sim2d::distanceToSegment({outline.points[i], next}, point));
  }
  return nearest;
}

/// Obstacles, doors, areas and docks: outlines in the plane.
class ShapeItem : public EntityItem {
 public:
  using EntityItem::EntityItem;
  /// 0 inside, but not inside the room enclosed by a closed wall: holes have the opposite
  /// orientation.
  double distanceTo(const Vec2& world) const override {
    double nearest = std::numeric_limits<double>::max();
    int winding = 0;
    for (const sim2d::Outline& outline : outlines_) {
      if (outline.points.size() > 2 && sim2d::isInside(outline.points, world)) {
        winding += sim2d::signedArea(outline.points) > 0.0 ? 1 : -1;
      }
      nearest = std::min(nearest, distanceToOutline(world, outline));
    }
    return winding != 0 ? 0.0 : nearest;
  }

  std::vector<Label> labels() const override {
    const auto* area = std::get_if<sim2d::Area>(&value_);
    if (!isSelectedEntity() && !isHovered() && (area == nullptr || !options().names)) {
      return {};
    }
    if (area != nullptr) {
      return {areaLabel(*area)};
    }
    const QRectF box = path_.boundingRect();
    return {{displayName(value_), std::nullopt, box.center(),
             0.5 * box.height() * mapScene().pixelsPerMetre() + 4.0, 0, false}};
  }

  /// Labels do not cover the signs of areas.
  std::vector<QRectF> labelObstacles() const override {
    if (kindOf(value_) != EntityKind::Area) {
      return {};
    }
    return {around(signPlace(mapScene().pixelsPerMetre()), 0.5 * metres(kSignPx))};
  }

  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    painter->setRenderHint(QPainter::Antialiasing);
    switch (kindOf(value_)) {
      case EntityKind::Door:
        paintDoor(*painter);
        break;
      case EntityKind::Area:
        paintArea(*painter);
        break;
      case EntityKind::Dock:
        paintDock(*painter);
        break;
      default:
        setPenAndBrush(*painter, screenPen(*painter, theme().color(Role::ObstacleEdge), 1.2),
                       theme().color(Role::ObstacleFill));
        painter->drawPath(path_);
    }
    if (isHovered() && !isSelectedEntity()) {
      setPenAndBrush(*painter, screenPen(*painter, theme().color(Role::Accent, 0.6), 1.5));
      painter->drawPath(path_);
    }
  }

 protected:
  void take(const Entity& value) override {
    value_ = value;
    outlines_.clear();
    if (const auto* obstacle = std::get_if<sim2d::Obstacle>(&value_)) {
      outlines_ = sim2d::outlinesOf(*obstacle);
    } else if (const auto* door = std::get_if<sim2d::Door>(&value_)) {
      outlines_ = sim2d::outlinesOf(*door);
    } else if (const auto* area = std::get_if<sim2d::Area>(&value_)) {
      outlines_ = {sim2d::polygonOutline(area->points)};
    } else if (const auto* dock = std::get_if<sim2d::Dock>(&value_)) {
      outlines_ = {sim2d::boxOutline(dock->pose, kDockSide, kDockSide)};
    }
    path_ = QPainterPath();
    path_.setFillRule(Qt::WindingFill);
    for (const sim2d::Outline& outline : outlines_) {
      path_.addPolygon(toScene(outline.points));
      path_.closeSubpath();
    }
    if (outlines_.size() > 1) {
      path_ = path_.simplified();
    }
  }

  QRectF bounds(double pixelsPerMetre) const override {
    const double margin = 4.0 / pixelsPerMetre;
    return path_.boundingRect().adjusted(-margin, -margin, margin, margin);
  }

 private:
  void paintDoor(QPainter& painter) const {
    const auto& door = std::get<sim2d::Door>(value_);
    if (!mapScene().isDoorOpen(id(), door)) {
      setPenAndBrush(painter, screenPen(painter, theme().color(Role::ObstacleEdge), 1.0),
                     theme().color(Role::WarningMark));
      painter.drawPath(path_);
      return;
    }
    setPenAndBrush(painter,
                   screenPen(painter, theme().color(Role::ObstacleEdge), 1.5, Qt::DashLine));
    painter.drawLine(toScene(door.from), toScene(door.to));
    // The open leaf and the arc of its swing.
    const Vec2 across = door.to - door.from;
    const Vec2 leaf = door.from + Vec2(-across.y(), across.x());
    painter.setPen(screenPen(painter, theme().color(Role::ObstacleEdge), 2.0));
    painter.drawLine(toScene(door.from), toScene(leaf));
    const double startDeg = degrees(base::headingOf(across));
    QPainterPath arc;
    const QRectF box = around(toScene(door.from), across.norm());
    arc.arcMoveTo(box, startDeg);
    arc.arcTo(box, startDeg, 90.0);
    painter.setPen(screenPen(painter, theme().color(Role::ObstacleEdge, 0.6), 1.0, Qt::DotLine));
    painter.drawPath(arc);
  }

  /// Draws the position of the robot, an arrow in its direction and the contact plate in front of
  /// it; a flash if the dock charges.
  void paintDock(QPainter& painter) const {
    const auto& dock = std::get<sim2d::Dock>(value_);
    const double half = 0.5 * kDockSide;
    const auto at = [&](double ahead, double left) {
      return toScene(dock.pose.toWorld(Vec2(ahead * half, left * half)));
    };
    paintDashedOutline(painter, 0.08, 0.15);
    painter.setPen(screenPen(painter, theme().color(Role::ObstacleEdge), 3.0));
    painter.drawLine(at(1.0, 0.6), at(1.0, -0.6));
    setPenAndBrush(painter, screenPen(painter, theme().color(Role::Accent), 1.5));
    if (dock.kind == sim2d::DockKind::Charging) {
      painter.drawPolyline(QPolygonF({at(0.7, -0.1), at(0.0, 0.3), at(0.0, -0.3), at(-0.7, 0.1)}));
    } else {
      painter.drawPolyline(QPolygonF({at(0.2, 0.4), at(0.6, 0.0), at(0.2, -0.4)}));
      painter.drawLine(at(-0.6, 0.0), at(0.6, 0.0));
    }
  }

  /// `weak`, `strong`: opacity of the fill; strong if hovered or selected.
  void paintDashedOutline(QPainter& painter, double weak, double strong) const {
    const bool isStrong = isHovered() || isSelectedEntity();
    setPenAndBrush(
        painter,
        screenPen(painter, theme().color(Role::ObstacleEdge), isStrong ? 1.5 : 1.0, Qt::DashLine),
        theme().color(Role::Accent, isStrong ? strong : weak));
    painter.drawPath(path_);
  }

  /// Draws the area and the sign of its kind.
  void paintArea(QPainter& painter) const {
    paintDashedOutline(painter, 0.05, 0.10);
    const double pixelsPerMetre = pixelsPerMetreOf(painter);
    const QRectF box = path_.boundingRect();
    const double sidePx = std::min(box.width(), box.height()) * pixelsPerMetre;
    if (sidePx >= kMinSignPx) {
      const PixelFrame frame(painter, signPlace(pixelsPerMetre));
      paintAreaGlyph(painter, std::get<sim2d::Area>(value_).kind, QPointF(),
                     std::min(kSignPx, sidePx), theme());
    }
  }

  /// Centre of the sign in the scene: in the upper left corner, or the middle of a narrow area.
  QPointF signPlace(double pixelsPerMetre) const {
    const QRectF box = path_.boundingRect();
    const double inset = kSignInsetPx / pixelsPerMetre;
    const QPointF corner(box.width() > 2.0 * inset ? box.left() + inset : box.center().x(),
                         box.height() > 2.0 * inset ? box.top() + inset : box.center().y());
    return path_.contains(corner) ? corner : box.center();
  }

  /// Inside the area after its sign, at the top or else at the bottom; below the area if there is
  /// no space. Includes the kind as text if it fits.
  Label areaLabel(const sim2d::Area& area) const {
    const QString name = displayName(value_);
    const QString kind = areaKindName(area.kind);
    const QRectF box = path_.boundingRect();
    const double pixelsPerMetre = mapScene().pixelsPerMetre();
    const double width = box.width() * pixelsPerMetre - 2.0 * kSignInsetPx - kLabelGapPx;
    const double height = box.height() * pixelsPerMetre;
    Label label{kind, std::nullopt, box.center(), 0.5 * height + 4.0, 0, false};
    if (!area.name.empty()) {
      const bool saysKind = base::startsWith(area.name, nameStem(value_)) || name.startsWith(kind);
      label.text = saysKind ? name : QStringLiteral("%1 · %2").arg(name, kind);
      label.text = labelSize(theme(), label).width() > width ? name : label.text;
    }
    const QSizeF size = labelSize(theme(), label);
    const QPointF sign = signPlace(pixelsPerMetre);
    const bool isAside = sign.x() < box.center().x() && size.width() < width;
    if (isAside && size.height() < height) {
      label.centre.setX(sign.x() + metres(0.5 * kSignPx + 2.0 + 0.5 * size.width()));
      label.clearancePx =
          std::max(0.5 * height - size.height() - kLabelGapPx, -0.5 * size.height());
      label.isAbove = true;
    }
    return label;
  }

  Entity value_;
  std::vector<sim2d::Outline> outlines_;
  QPainterPath path_;  // Scene coordinates.
};

}  // namespace

QRectF around(const QPointF& centre, double reach) {
  return {centre.x() - reach, centre.y() - reach, 2.0 * reach, 2.0 * reach};
}

void EntityItem::sync(const Entity& value) {
  take(value);
  setOpacity(mapScene().layerOpacity(id_.kind) * (isListed(value) ? 1.0 : 0.4));
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
      return std::make_unique<ShapeItem>(scene, id);
  }
}

}  // namespace editor
