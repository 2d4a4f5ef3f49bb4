#pragma once

#include <QPainterPath>

#include "editor/canvas/EntityItem.h"
#include "sim2d/map/Outlines.h"

namespace editor {

class PersonItem : public EntityItem {
 public:
  using EntityItem::EntityItem;
  double distanceTo(const Vec2& world) const override;
  std::vector<Label> labels() const override;
  std::vector<QRectF> solidParts() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 protected:
  void take(const Entity& value) override;
  QRectF bounds(double pixelsPerMetre) const override;

 private:
  void paintSpaces(QPainter& painter) const;
  sim2d::Human human_;
  double radius_ = 0.35;  // [m]
  Look look_ = Look::Regular;
};

class RobotItem : public EntityItem {
 public:
  using EntityItem::EntityItem;
  double distanceTo(const Vec2& world) const override;
  std::vector<Label> labels() const override;
  std::vector<QRectF> solidParts() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 protected:
  void take(const Entity& value) override;
  QRectF bounds(double pixelsPerMetre) const override;

 private:
  sim2d::Robot robot_;
  double radius_ = 0.35;         // of the circle around the footprint [m]
  std::vector<Vec2> footprint_;  // robot frame
};

class GoalItem : public EntityItem {
 public:
  using EntityItem::EntityItem;
  double distanceTo(const Vec2& world) const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  std::vector<QRectF> solidParts() const override;

 protected:
  void take(const Entity& value) override;
  QRectF bounds(double pixelsPerMetre) const override;

 private:
  sim2d::GlobalGoal goal_;
};

/// Obstacles, doors and areas: outlines in the plane.
class ShapeItem : public EntityItem {
 public:
  using EntityItem::EntityItem;
  double distanceTo(const Vec2& world) const override;
  std::vector<Label> labels() const override;
  std::vector<QRectF> solidParts() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 protected:
  void take(const Entity& value) override;
  QRectF bounds(double pixelsPerMetre) const override;

 private:
  void paintDoor(QPainter& painter) const;
  void paintArea(QPainter& painter) const;
  void paintSign(QPainter& painter) const;
  QPointF signPlace(double pixelsPerMetre) const;  // scene
  Label areaLabel(const sim2d::Area& area) const;
  Entity value_;
  std::vector<sim2d::Outline> outlines_;
  QPainterPath path_;  // scene
};

/// Marker of a robot's own goal point, in pixels around the painter's origin.
void paintRobotGoal(QPainter& painter, const Theme& theme);
constexpr double kRobotGoalPx = 10.0;   // its radius
constexpr double kLeastFigurePx = 5.0;  // radius of the smallest figure

}  // namespace editor
