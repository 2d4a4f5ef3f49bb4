#pragma once

#include <memory>
#include <vector>

#include "app/run/Futures.h"
#include "editor/canvas/Layers.h"

namespace editor {

/// Where everybody goes in the futures of a run: the ways of robots, of which those that end in a
/// contact differ by colour and by a cross, and, fainter, those of people.
class FanLayer : public FullLayer {
 public:
  using Futures = std::shared_ptr<const std::vector<app::Future>>;
  using FullLayer::FullLayer;
  void show(Futures futures);  // null: none
  const Futures& futures() const { return futures_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void paintContact(QPainter& painter, const QPointF& where) const;
  void paintPeople(QPainter& painter, const app::Future& future) const;
  void paintRobots(QPainter& painter, const app::Future& future) const;

  Futures futures_;
};

}  // namespace editor
