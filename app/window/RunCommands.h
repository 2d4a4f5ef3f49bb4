#pragma once

#include <cstddef>

#include <QAction>

#include "app/cli/FigureMap.h"
#include "app/window/Docks.h"
#include "app/window/NoticeBar.h"
#include "app/window/WindowActions.h"
#include "app/window/Workspace.h"
#include "app/window/files/FileDialogs.h"
#include "editor/look/Theme.h"
#include "editor/run/SimulationRunner.h"

class QMimeData;

namespace app {

/// Publishes runs started afterwards to Foxglove's live view and on ROS 2 topics. Both are off when
/// the program starts.
class RunSharing : public QObject {
  Q_OBJECT
 public:
  static constexpr int kUsualPort = 8765;  // Foxglove's default

  RunSharing(Workspace& workspace, QAction& foxglove, QAction& ros2, NoticeBar& notices,
             QObject* parent);

 private:
  void choose();
  void reportUrl(const QString& url);
  void reportWarning(const base::Diagnostics& diagnostics);
  void updateNotices();
  bool isLive() const;

  Workspace& workspace_;
  QAction& foxglove_;
  QAction& ros2_;
  NoticeBar& notices_;
  int branch_ = -1;  // branch of the current run
};

/// Stores playback settings between sessions: the trail length, and the A-B loops of recorded runs.
class PlaybackSettings : public QObject {
  Q_OBJECT
 public:
  static constexpr int kMostLoops = 50;  // newest loops kept

  PlaybackSettings(Workspace& workspace, UserSettings& userSettings, QObject* parent);
  void restoreLoop(const QString& folder);  // call when a recorded run is displayed

 private:
  void storeLoop();

  Workspace& workspace_;
  UserSettings& userSettings_;
  QString folder_;  // folder of the recorded run; empty: none
};

constexpr int kLeastHistory = 16, kMostHistory = 65536, kHistoryStep = 64;  // [MB]
int usualHistoryMegabytes();                                                // default [MB]

/// RAM for the frames of a run [B]: the last chosen value, otherwise the default.
std::size_t historyMemory(const UserSettings& memory);

/// Stores the memory for the history of runs started afterwards.
void setHistoryMemory(UserSettings& memory, editor::SimulationRunner& runner, int megabytes);

/// Settings for the memory of a run's history, with the usage of the displayed run.
class HistoryDialog : public QDialog {
  Q_OBJECT
 public:
  HistoryDialog(std::size_t memory, const editor::RecordingPtr& shown, const editor::Theme& theme,
                QWidget* parent = nullptr);
  std::size_t memory() const;  // [B]

 private:
  QSpinBox* megabytes_ = new QSpinBox(this);
};

/// Shows the dialog. The value applies to runs started afterwards.
void showHistoryDialog(UserSettings& memory, editor::SimulationRunner& runner,
                       const editor::Theme& theme, QWidget* parent);

/// The overlays of the canvas that figures have, and the people with custom trees.
FigureOptions figureOptionsOf(const editor::MapScene& scene);

/// Copies figures for publications to the clipboard as PNG (300 dpi) and SVG: the displayed frame
/// with its overlays, or the selected metric.
class FigureCommands : public QObject {
  Q_OBJECT
 public:
  FigureCommands(Workspace& workspace, Docks& docks, const WindowActions& actions, QObject* parent);

 Q_SIGNALS:
  void message(const QString& words);

 private:
  void updateEnabled();
  void copyMap();
  void copyPlot();
  std::string selectedMetric() const;  // metric key; empty: none

  Workspace& workspace_;
  Docks& docks_;
  const WindowActions& actions_;
};

/// A figure for the clipboard: as pixels (300 dpi) for office programs and as SVG for drawing
/// programs.
std::unique_ptr<QMimeData> copiedFigure(const QSizeF& size, const std::string& svg,
                                        const std::function<void(QPainter&)>& paint);

/// The frames of a recording up to `time`, thinned out so that the figure is created quickly.
sim2d::Trace figureTrace(const sim2d::Recording& recording, double time);

}  // namespace app
