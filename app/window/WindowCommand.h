#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QSize>

#include "app/cli/CommandRegistry.h"
#include "sim2d/base/Result.h"

namespace app {

class MainWindow;

/// Window options in addition to those of `run`.
struct WindowOptions {
  std::string screenshot;             // picture file; empty: interactive
  double at = 5.0;                    // [s], simulation time of the picture
  std::string size;                   // "1280x800"; empty: last size; for a picture, 1280x800
  double scale = 1.0;                 // device pixels per pixel of the picture
  std::string theme;                  // "light", "dark"; empty: system theme
  std::vector<std::string> docks;     // visible docks; empty: last layout
  std::vector<std::string> overlays;  // enabled in addition to stored ones
  std::string select;                 // selected person or robot, by name
  std::string tree;                   // person whose tree replaces the map; empty: none
};

/// Parses "1280x800". Nothing: not a valid window size.
std::optional<QSize> sizeFromText(const std::string& text);

/// Runs the scenario to a time and saves a picture of the whole window. Empty on success.
base::Diagnostics takeScreenshot(MainWindow& window, const WindowOptions& options);

/// Adds the default command, which opens the window, with a scenario if given.
void addWindow(CommandRegistry& commands);

}  // namespace app
