#pragma once

#include <optional>

#include <QWidget>

#include "editor/canvas/MapScene.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// A small read-only map around a person, shown in a corner of the tree view while the map is
/// hidden. It shows the person's motion while the nodes run.
class MapInset : public QWidget {
  Q_OBJECT
 public:
  static constexpr QSize kSize{232, 164};

  MapInset(MapScene& scene, SimulationRunner& runner, QWidget* parent);
  void follow(EntityId person);
  /// Position of the person in the shown state, else at the start; none if there is no person.
  std::optional<Vec2> centre() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  MapScene& scene_;
  SimulationRunner& runner_;
  EntityId person_;
};

}  // namespace editor
