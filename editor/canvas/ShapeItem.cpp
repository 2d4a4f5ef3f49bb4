#include <algorithm>
#include <limits>

#include "editor/canvas/Layers.h"
#include "editor/canvas/PixelFrame.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace editor {

namespace {

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
    const bool strong = isHovered() || isSelectedEntity();
    setPenAndBrush(
        painter,
        screenPen(painter, theme().color(Role::ObstacleEdge), strong ? 1.5 : 1.0, Qt::DashLine),
        theme().color(Role::Accent, strong ? 0.15 : 0.08));
    painter.drawPath(path_);
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

  void paintArea(QPainter& painter) const {
    const bool strong = isHovered() || isSelectedEntity();
    setPenAndBrush(
        painter,
        screenPen(painter, theme().color(Role::ObstacleEdge), strong ? 1.5 : 1.0, Qt::DashLine),
        theme().color(Role::Accent, strong ? 0.10 : 0.05));
    painter.drawPath(path_);
    paintSign(painter);
  }

  void paintSign(QPainter& painter) const {
    const double pixelsPerMetre = pixelsPerMetreOf(painter);
    const QRectF box = path_.boundingRect();
    const double sidePx = std::min(box.width(), box.height()) * pixelsPerMetre;
    if (sidePx < kMinSignPx) {
      return;
    }
    const PixelFrame frame(painter, signPlace(pixelsPerMetre));
    paintAreaGlyph(painter, std::get<sim2d::Area>(value_).kind, QPointF(),
                   std::min(kSignPx, sidePx), theme());
  }

  /// The centre of the sign in the scene: in the upper left corner, or in the middle of a narrow
  /// area.
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
      label.text = name.startsWith(kind) ? name : QStringLiteral("%1 · %2").arg(name, kind);
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

std::unique_ptr<EntityItem> makeShapeItem(const MapScene& scene, EntityId id) {
  return std::make_unique<ShapeItem>(scene, id);
}

}  // namespace editor
