#pragma once

#include <QString>

#include "app/window/MainWindow.h"

/// A window for tests: its theme and its memory do not depend on who runs them.
namespace quiet {

inline app::WindowSetup setup() {
  app::WindowSetup setup;
  setup.followsSystem = false;
  setup.remembers = false;
  setup.shippedMaps = QStringLiteral(SOURCE_DIR "/maps");
  return setup;
}

inline QString demoPath() {
  return QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
}

}  // namespace quiet
