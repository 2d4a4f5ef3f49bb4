#pragma once

#include <string>
#include <vector>

#include <QAction>
#include <QList>

#include "app/window/FileDialogs.h"
#include "app/window/Workspace.h"

namespace app {

/// The action is checked while the option of the map is on, and switches it.
void followOption(QAction& action, editor::MapScene& scene, bool editor::CanvasOptions::*option);

/// What the map shows over a run when it is asked for: one checkable command each, all off at
/// first.
class OverlayActions : public QObject {
  Q_OBJECT
 public:
  OverlayActions(Workspace& workspace, QObject* parent);

  QAction *velocities, *gaussian, *sight, *density, *plans, *contacts, *thoughts, *speech,
      *localCosts, *globalCosts;
  QList<QAction*> all;
  void remember(Memory& memory);  // they are as they were left
  /// Words of the command line for them, with "zones", "forces" and "ways".
  static std::vector<std::string> names();
  void show(const std::vector<std::string>& names);

 private:
  QAction* toggle(const QString& text, bool editor::CanvasOptions::*option, int letter,
                  const QString& says);

  Workspace& workspace_;
};

}  // namespace app
