#pragma once

#include <optional>

#include <QWidget>

#include "editor/canvas/MapScene.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// A small piece of the map around a person, in the corner of a tree that has taken the map's
/// place: what the person does while the nodes run. To look at only.
class MapInset : public QWidget {
  Q_OBJECT
 public:
  static constexpr QSize kSize{232, 164};

  MapInset(MapScene& scene, SimulationRunner& runner, QWidget* parent);
  void follow(EntityId person);
  /// Of the person in the state that is shown, else at the start; nothing: there is nobody.
  std::optional<Vec2> centre() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  MapScene& scene_;
  SimulationRunner& runner_;
  EntityId person_;
};

}  // namespace editor
