#pragma once

#include <QObject>

#include "app/window/Workspace.h"
#include "app/window/files/FileDialogs.h"

namespace app {

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

}  // namespace app
