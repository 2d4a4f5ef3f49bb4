#pragma once

#include <QAction>
#include <QComboBox>

#include "editor/look/Theme.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// Reset, step back, play or pause, step, and the speed; they follow the state of the runner.
class PlaybackActions : public QObject {
  Q_OBJECT
 public:
  PlaybackActions(SimulationRunner& runner, const Theme& theme, QObject* parent = nullptr);
  void setTheme(const Theme& theme);

  QAction* reset() const { return reset_; }
  QAction* stepBack() const { return stepBack_; }
  QAction* playPause() const { return playPause_; }
  QAction* step() const { return step_; }
  QAction* newest() const { return newest_; }
  QList<QAction*> all() const { return {reset_, stepBack_, playPause_, step_}; }
  /// A combo box of speeds, for a tool bar that takes it.
  QComboBox* makeSpeedBox(QWidget* parent);

 private:
  void follow();
  SimulationRunner& runner_;
  Theme theme_;
  QAction *reset_, *stepBack_, *playPause_, *step_, *newest_;
};

/// "0:12.4"
QString clockText(double seconds);

}  // namespace editor
