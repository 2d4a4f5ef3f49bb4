#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QGraphicsItem>

#include "editor/canvas/SpriteAtlas.h"
#include "editor/look/Theme.h"
#include "sim2d/trace/Frame.h"

namespace editor {

class MapScene;
struct Label;

/// One item that paints everybody of a frame from a sprite atlas, with trails, robot paths, speech
/// and, for selected people, personal spaces and forces.
class FrameLayer : public QGraphicsItem {
 public:
  explicit FrameLayer(MapScene& scene) : scene_(scene) {}

  /// Looks, sizes and names are taken from the document when a run begins.
  void begin();
  void show(std::shared_ptr<const sim2d::Frame> frame);
  void end();
  const sim2d::Frame* frame() const { return frame_.get(); }
  /// What was said; shown for some seconds from then on, also when looking back.
  void hear(const std::vector<sim2d::Event>& events, double time);

  /// Id of the person or robot (negative) under a point, within its body or 8 px.
  std::optional<int> agentAt(const base::Vec2& world) const;
  std::optional<base::Vec2> positionOf(int agent) const;
  base::EntityId entityOf(int id) const { return agent(id).entity; }  // none: made by a source
  std::vector<Label> labels() const;
  std::vector<QRectF> solidParts() const;

  void zoomChanged() { atlas_.clear(); }
  void themeChanged() { atlas_.clear(); }

  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  struct Agent {
    QString name;
    base::EntityId entity;
    Look look = Look::Regular;
    sim2d::PersonKind kind = sim2d::PersonKind::Adult;
    double radius = 0.35;               // [m]
    std::vector<base::Vec2> footprint;  // robots
  };
  struct Speech {
    int id = 0;
    QString text;
    double since = 0.0;  // [s]
  };
  struct Trail {
    std::deque<std::pair<double, base::Vec2>> points;  // time [s], position
    double walked = 0.0;                               // [m], moves the feet
  };
  void follow(const sim2d::Frame& frame);
  void updateBounds();
  const Agent& agent(int id) const;
  bool isChosen(int id) const;
  PersonFigure figureOf(std::size_t index, double pixelsPerMetre) const;
  void paintTrails(QPainter& painter) const;
  void paintTrail(QPainter& painter, const Trail& trail, const QColor& color) const;
  void paintRobotPaths(QPainter& painter) const;
  void paintPeople(QPainter& painter);
  void paintRobots(QPainter& painter) const;
  void paintSpeech(QPainter& painter) const;
  void paintBubble(QPainter& painter, const Speech& speech) const;
  void paintForces(QPainter& painter) const;

  MapScene& scene_;
  std::shared_ptr<const sim2d::Frame> frame_;
  std::map<int, Agent> agents_;
  Agent stranger_;  // people from sources
  SpriteAtlas atlas_;
  std::map<int, Trail> trails_;
  std::vector<Speech> speeches_;
  QRectF bounds_;
};

/// Where number `i` of the people or robots of a frame is.
inline base::Vec2 positionAt(const sim2d::BodyColumns& bodies, std::size_t i) {
  return {bodies.x[i], bodies.y[i]};
}

/// The force terms on a person that the canvas draws, in the order of the legend.
struct ForceArrow {
  QString name;
  Role color = Role::ForceTotal;
  base::Vec2 force = base::Vec2::Zero();  // [m/s²]
};
/// Empty when the frame has no forces or the person is not in it. The last one is the sum.
std::vector<ForceArrow> forcesOn(const sim2d::Frame& frame, int humanId);
constexpr double kMetresPerForce = 0.6;  // length of 1 m/s² on the map

}  // namespace editor
