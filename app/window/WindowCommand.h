#pragma once

#include "app/cli/CommandRegistry.h"

namespace app {

/// Options of the window beside those of `run`.
struct WindowOptions {
  std::string screenshot;          // picture to save; empty: stay open
  double at = 5.0;                 // simulated time of the picture [s]
  std::string size;                // "1280x800"; empty: as last used, 1280x800 for a picture
  double scale = 1.0;              // pixels per point of the picture
  std::string theme;               // "light", "dark"; empty: the system's
  std::vector<std::string> docks;  // shown; empty: as last used
};

/// Opens the window, on the scenario if one is given: what the program does without a command.
void addWindow(CommandRegistry& commands);

}  // namespace app
