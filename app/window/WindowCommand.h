#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QSize>

#include "app/cli/CommandRegistry.h"
#include "sim2d/base/Result.h"

namespace app {

class MainWindow;

/// Options of the window beside those of `run`.
struct WindowOptions {
  std::string screenshot;             // picture to save; empty: stay open
  double at = 5.0;                    // simulated time of the picture [s]
  std::string size;                   // "1280x800"; empty: as last used, 1280x800 for a picture
  double scale = 1.0;                 // pixels per point of the picture
  std::string theme;                  // "light", "dark"; empty: the system's
  std::vector<std::string> docks;     // shown; empty: as last used
  std::vector<std::string> overlays;  // switched on beside those of last time
  std::string select;                 // a person or robot by name
  std::string tree;                   // person whose tree takes the place of the map; empty: none
};

/// "1280x800"; nothing when it is no size of a window.
std::optional<QSize> sizeFromText(const std::string& text);

/// Runs the scenario of the window to a time and saves a picture of the whole window. Empty = done.
base::Diagnostics takeScreenshot(MainWindow& window, const WindowOptions& options);

/// Opens the window, on the scenario if one is given: what the program does without a command.
void addWindow(CommandRegistry& commands);

}  // namespace app
