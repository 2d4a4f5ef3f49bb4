#pragma once

#include <memory>
#include <set>

#include <QAction>
#include <QKeyEvent>

#include "app/run/HandSteering.h"
#include "editor/canvas/MapScene.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// Driving robots by hand in a run that goes on: the selected one by keys while `toggle` is on, any
/// by a drag with the mouse (`MapScene::pull`). What holds it overrides its planner and is recorded
/// as inputs.
class HandDrive : public QObject {
  Q_OBJECT
 public:
  /// `map` hears the keys.
  HandDrive(const ScenarioDocument& document, SimulationRunner& runner, MapScene& scene,
            QWidget& map);

  /// On: arrows or WASD give velocities up to the robot's limits, without a key it brakes. Off, or
  /// Escape: its planner drives.
  QAction* toggle() const { return toggle_; }
  /// Of the robot that would be driven, as in frames; none: there is none, or no run goes on.
  std::optional<int> candidate() const;
  static bool isDriveKey(const QKeyEvent& event);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow();
  void take(bool on);
  void pull();
  bool hold(int robot);
  void tell();
  bool isLive() const;

  const ScenarioDocument& document_;
  SimulationRunner& runner_;
  MapScene& scene_;
  QWidget& map_;
  QAction* toggle_;
  std::set<int> keys_;  // that are down
  std::shared_ptr<app::HandSteering> steering_;
  sim2d::DriveLimits limits_;  // of its robot
};

}  // namespace editor
