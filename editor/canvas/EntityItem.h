#pragma once

#include "editor/canvas/MapScene.h"
#include "editor/look/FigurePainter.h"

namespace editor {

/// A text label on the canvas. LabelLayer draws it if there is space.
struct Label {
  QString text;
  std::optional<Look> mark;
  QPointF centre;            // Scene coordinates; in pixels for layoutLabels().
  double clearancePx = 0.0;  // Distance from the centre to the edge of the label.
  int priority = 0;          // Labels with higher priority are placed first.
  bool isAbove = false;      // Prefers a position above the centre.
  bool isHoverOnly = false;  // Shown only while the mouse hovers over the entity.
  bool isNeeded = false;     // May cover bodies; it is never left out.
  QSizeF size = {};          // Size [px]; valid once the label has been rendered.
  QString detail = {};       // A second line in a softer colour.
  /// The previous place, which the label keeps while it is free; kNoSide: none, kHiddenSide: it was
  /// left out, and returns where there is some more space than it needs.
  int side = kNoSide;
  static constexpr int kNoSide = -1, kHiddenSide = -2;
};

/// Base of the canvas items. Items draw in scene coordinates and stay at the origin. They query the
/// zoom from the scene for parts with a minimum size on the screen.
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
  /// Areas that labels must not cover.
  virtual std::vector<QRectF> labelObstacles() const { return {boundingRect()}; }
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

/// Draws the marker of a robot's own goal point.
void paintRobotGoal(QPainter& painter, const Theme& theme, const Vec2& at);
/// A robot at its true size [px], with a minimum size for visibility.
RobotFigure robotFigure(double radius, const std::vector<Vec2>& footprint,
                        sim2d::Kinematics kinematics, double heading, double pixelsPerMetre);
constexpr double kRobotGoalPx = 10.0;  // Radius.
constexpr double kMinFigurePx = 5.0;   // Minimum radius of a figure.
constexpr double kFewFigurePx = 9.0;   // Minimum radius if there are few people.
constexpr double kNameZoom = 17.0;     // Names are shown from this zoom on [px/m].
QRectF around(const QPointF& centre, double reach);
inline double degrees(double radians) {
  return radians * 180.0 / base::kPi;
}

}  // namespace editor
