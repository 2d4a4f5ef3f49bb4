#pragma once

#include <vector>

#include <QGraphicsItem>

#include "editor/canvas/EntityItem.h"
#include "editor/canvas/MapScene.h"
#include "editor/document/Handles.h"

namespace editor {

/// Fine lines every metre, stronger ones every five; they fade when they get too dense.
class GridItem : public QGraphicsItem {
 public:
  explicit GridItem(const MapScene& scene) : scene_(scene) {}
  void setBounds(const QRectF& sceneBounds);
  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void paintLines(QPainter& painter, const QRectF& area, double step, double alpha) const;
  const MapScene& scene_;
  QRectF bounds_;
};

/// Covers all that the scene shows: for layers whose extent is that of the window.
class FullLayer : public QGraphicsItem {
 public:
  explicit FullLayer(const MapScene& scene) : scene_(scene) {}
  QRectF boundingRect() const override { return bounds_; }
  void setBounds(const QRectF& sceneBounds);

 protected:
  const MapScene& mapScene() const { return scene_; }
  const Theme& theme() const { return scene_.theme(); }

 private:
  const MapScene& scene_;
  QRectF bounds_;
};

/// Names with halos, placed where there is room; the less important ones are left out.
class LabelLayer : public FullLayer {
 public:
  using FullLayer::FullLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
};

/// Frames and handles of what is selected.
class SelectionLayer : public FullLayer {
 public:
  using FullLayer::FullLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  /// The handle under a point (16 px wide), of which entity.
  std::pair<EntityId, Handle> handleAt(const Vec2& world) const;
  std::vector<QRectF> solidParts() const;  // handles, scene

 private:
  std::vector<Handle> handlesFor(const Entity& entity) const;
  void paintFrame(QPainter& painter, const Entity& entity,
                  const std::vector<Handle>& handles) const;
};

/// What the current tool shows while a gesture lasts.
class ToolLayer : public FullLayer {
 public:
  using FullLayer::FullLayer;
  void setRubberBand(const Vec2& corner, const Vec2& opposite);
  void setLine(std::vector<Vec2> points);  // dashed, with arrow heads
  void setArrow(const Vec2& from, const Vec2& to);
  void setTag(const Vec2& at, const QString& text);  // small dark box beside a point
  void clear();
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  std::optional<QRectF> band_;
  std::vector<Vec2> line_;
  std::optional<std::pair<Vec2, Vec2>> arrow_;
  std::optional<std::pair<Vec2, QString>> tag_;
};

/// Text with a halo in the ground's colour and an optional mark before it, in pixels.
void paintLabel(QPainter& painter, const Theme& theme, const QRectF& box, const Label& label);
QSizeF labelSize(const Theme& theme, const Label& label);

}  // namespace editor
