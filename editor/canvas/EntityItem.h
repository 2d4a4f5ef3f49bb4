#pragma once

#include <memory>
#include <vector>

#include <QGraphicsItem>

#include "editor/canvas/MapScene.h"
#include "editor/look/FigurePainter.h"

namespace editor {

/// A name on the canvas, drawn by LabelLayer where there is room.
struct Label {
  QString text;
  std::optional<Look> mark;
  QPointF centre;            // scene; for layoutLabels() [px]
  double clearancePx = 0.0;  // from the centre to the edge of the label
  int priority = 0;          // higher ones choose first
  bool isAbove = false;      // would rather stand above than below
  bool isOfHover = false;    // shown while the mouse is over it and not otherwise
  bool isNeeded = false;     // covers bodies rather than being left out
  QSizeF size = {};          // [px], once its picture is there
  QString detail = {};       // a second line, softer
};

/// What is drawn on the canvas, in scene coordinates (the item itself stays at the origin); what
/// has a least size on the screen asks the scene for the zoom.
class CanvasItem : public QGraphicsItem {
 public:
  explicit CanvasItem(const MapScene& scene) : scene_(scene) {}

 protected:
  const MapScene& mapScene() const { return scene_; }
  const ScenarioDocument& document() const { return scene_.document(); }
  const CanvasOptions& options() const { return scene_.options(); }
  const Theme& theme() const { return scene_.theme(); }
  double metres(double pixels) const { return pixels / scene_.pixelsPerMetre(); }

 private:
  const MapScene& scene_;
};

/// Draws one entity.
class EntityItem : public CanvasItem {
 public:
  EntityItem(const MapScene& scene, EntityId id) : CanvasItem(scene), id_(id) {}

  EntityId id() const { return id_; }
  void sync(const Entity& value);
  void zoomChanged();

  /// Distance from the visible body [m]; 0 inside.
  virtual double distanceTo(const Vec2& world) const = 0;
  virtual std::vector<Label> labels() const { return {}; }
  /// What labels keep off.
  virtual std::vector<QRectF> solidParts() const { return {boundingRect()}; }
  QRectF boundingRect() const override { return bounds_; }

 protected:
  virtual void take(const Entity& value) = 0;
  virtual QRectF bounds(double pixelsPerMetre) const = 0;
  bool isSelectedEntity() const { return document().isSelected(id_); }
  bool isHovered() const { return mapScene().isHovered(id_); }

 private:
  EntityId id_;
  QRectF bounds_;
};

std::unique_ptr<EntityItem> makeEntityItem(const MapScene& scene, EntityId id);
/// Obstacles, doors, areas and docks: outlines in the plane.
std::unique_ptr<EntityItem> makeShapeItem(const MapScene& scene, EntityId id);

/// Marker of a robot's own goal point.
void paintRobotGoal(QPainter& painter, const Theme& theme, const Vec2& at);
/// A robot as large as it is on the ground [px], but never too small to be seen.
RobotFigure robotFigure(double radius, const std::vector<Vec2>& footprint,
                        sim2d::Kinematics kinematics, double heading, double pixelsPerMetre);
/// Intimate, personal and social space (Hall) around somebody.
void paintSpaces(QPainter& painter, const Vec2& at, QColor color);
constexpr double kRobotGoalPx = 10.0;   // its radius
constexpr double kLeastFigurePx = 5.0;  // radius of the smallest figure
constexpr double kFewFigurePx = 9.0;    // and where there are few people
constexpr double kNameZoom = 17.0;      // [px/m], from which names are shown
QRectF around(const QPointF& centre, double reach);
inline double degrees(double radians) {
  return radians * 180.0 / base::kPi;
}

}  // namespace editor
