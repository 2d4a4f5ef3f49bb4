#pragma once

#include <map>
#include <optional>
#include <string>

#include <QMenu>

#include "editor/canvas/MapScene.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// What hands do to people of a run that goes on: push and stop them, drop one in. Everything acts
/// in the next step and is an input of the run: it is recorded, and a repeated run has it again.
class PeopleHands : public QObject {
  Q_OBJECT
 public:
  PeopleHands(SimulationRunner& runner, MapScene& scene, QObject* parent = nullptr);

  void push(int person, const Vec2& velocity);  // beside the own [m/s]
  void stop(int person);                        // until letGo()
  void letGo(int person);
  bool isStopped(int person) const;  // by the inputs up to the state that is shown, or waiting
  /// A person like the one of that name, where a body is free or near by.
  void dropIn(const std::string& like, const Vec2& place);
  /// What can be done at a place of the map; `person`: who stands there. Empty without a run that
  /// goes on.
  void fillMenu(QMenu& menu, std::optional<int> person, const Vec2& place);

 private:
  void give(sim2d::InputKind kind, int person);
  void addDropIn(QMenu& menu, std::optional<int> person, const Vec2& place);

  SimulationRunner& runner_;
  MapScene& scene_;
  std::map<int, bool> waiting_;  // stops that have not acted yet
};

}  // namespace editor
