#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include <QtWidgets>

#include "app/run/Session.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/MapView.h"
#include "editor/panels/EventsPanel.h"
#include "editor/panels/runs/RunOverlayReader.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// Manual control of robots during a run: the selected robot by keys while `toggle` is on, any
/// robot by a mouse drag (`MapScene::pull`). It overrides the planner and is recorded as inputs.
class ManualDriveController : public QObject {
  Q_OBJECT
 public:
  /// `map`: the widget whose key events are handled.
  ManualDriveController(const ScenarioDocument& document, SimulationRunner& runner, MapScene& scene,
                        QWidget& map);

  /// On: arrows or WASD set velocities up to the robot's limits; without a key the robot brakes.
  /// Off, or Escape: its planner drives.
  QAction* toggle() const { return toggle_; }
  /// The robot that would be driven, by its id in frames; none: no robot, or no run in progress.
  std::optional<int> candidate() const;
  static bool isDriveKey(const QKeyEvent& event);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow();
  void take(bool on);
  void pull();
  bool takeControl(int robot);
  void sendVelocity();
  bool isLive() const;

  const ScenarioDocument& document_;
  SimulationRunner& runner_;
  MapScene& scene_;
  QWidget& map_;
  QAction* toggle_;
  std::set<int> keys_;  // Pressed keys.
  std::shared_ptr<app::ManualDrive> steering_;
  sim2d::DriveLimits limits_;  // Limits of the robot.
};

/// User interaction with people during a run: push, stop, and add. Each action takes effect in the
/// next step and is recorded as an input, so that a re-run repeats it.
class PeopleInteraction : public QObject {
  Q_OBJECT
 public:
  PeopleInteraction(SimulationRunner& runner, MapScene& scene, QObject* parent = nullptr);

  void push(int person, const Vec2& velocity);  // Added to the person's own velocity [m/s].
  void stop(int person);                        // Until resume().
  void resume(int person);
  bool isStopped(int person) const;  // By the inputs up to the shown state, or pending.
  /// Adds a copy of the person with that name at a free position at or near `place`.
  void addPerson(const std::string& like, const Vec2& place);
  /// Adds the actions available at a map position; `person`: the person there. Nothing without a
  /// run in progress.
  void fillMenu(QMenu& menu, std::optional<int> person, const Vec2& place);

 private:
  void addInput(sim2d::InputKind kind, int person, const Vec2& velocity = Vec2::Zero());
  void addSpawnActions(QMenu& menu, std::optional<int> person, const Vec2& place);

  SimulationRunner& runner_;
  MapScene& scene_;
  std::map<int, bool> waiting_;  // Stops that have not taken effect yet.
};

/// Transfers contacts and thoughts from the recording of a run to the active map overlays. A
/// tooltip at the mouse shows name, action, reason and speech of an agent.
class RunOverlayUpdater : public QObject {
  Q_OBJECT
 public:
  RunOverlayUpdater(SimulationRunner& runner, const RunEvents& events, MapView& view);

  /// Text lines about a person or robot in the shown state; empty: not in it.
  QString tooltipFor(int id) const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow();
  QString thoughtOf(int id) const;
  QStringList speechOf(int id, double time) const;

  SimulationRunner& runner_;
  const RunEvents& events_;
  MapView& view_;
  RunOverlayReader* reader_;
};

}  // namespace editor
