#pragma once

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QGraphicsItem>
#include <QPixmap>

#include "editor/look/Theme.h"
#include "sim2d/trace/Frame.h"

namespace editor {

class MapScene;

/// One item that paints everybody of a frame from a sprite atlas (headings x looks x steps), made
/// anew when the zoom changes, with trails, robot paths and speech.
class FrameLayer : public QGraphicsItem {
 public:
  explicit FrameLayer(MapScene& scene);
  ~FrameLayer() override;
  FrameLayer(const FrameLayer&) = delete;
  FrameLayer& operator=(const FrameLayer&) = delete;

  /// Looks, sizes and names are taken from the document when a run begins.
  void begin();
  void show(std::shared_ptr<const sim2d::Frame> frame);
  void end();
  const sim2d::Frame* frame() const { return frame_.get(); }
  /// Id of the person or robot (negative) under a point, within its body or 8 px; none: nullopt.
  std::optional<int> agentAt(const base::Vec2& world) const;

  void zoomChanged();
  void themeChanged();

  QRectF boundingRect() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  struct Person;
  struct Atlas;
  struct Speech {
    int id = 0;
    QString text;
    double since = 0.0;  // [s]
  };
  void follow(const sim2d::Frame& frame);
  void paintTrails(QPainter& painter) const;
  void paintPeople(QPainter& painter);
  void paintRobots(QPainter& painter) const;
  void paintRobotPaths(QPainter& painter) const;
  void paintLabels(QPainter& painter) const;
  void paintSpeech(QPainter& painter) const;
  const Person& personOf(int id) const;

  MapScene& scene_;
  std::shared_ptr<const sim2d::Frame> frame_;
  std::map<int, Person> people_;
  std::unique_ptr<Atlas> atlas_;
  std::map<int, std::deque<base::Vec2>> trails_;
  std::vector<Speech> speeches_;
  std::map<int, double> walked_;  // [m], for the step of the feet
};

}  // namespace editor
