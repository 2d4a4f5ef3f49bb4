#pragma once

#include <QObject>

#include "app/window/FileDialogs.h"
#include "app/window/Workspace.h"

namespace app {

/// What is kept of looking at runs from one start of the program to the next: how long trails are,
/// and of recorded runs the part A-B that is played again and again.
class RunMemory : public QObject {
  Q_OBJECT
 public:
  static constexpr int kMostLoops = 50;  // the newest

  RunMemory(Workspace& workspace, Memory& memory, QObject* parent);
  void followRun(const QString& folder);  // a recorded run is shown from here on

 private:
  void noteLoop();

  Workspace& workspace_;
  Memory& memory_;
  QString folder_;  // of the recorded run; empty: none is shown
};

}  // namespace app
