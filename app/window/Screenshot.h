#pragma once

#include <string>

#include <QSize>

#include "app/window/MainWindow.h"
#include "app/window/WindowCommand.h"

namespace app {

/// "1280x800"; nothing when it is no size of a window.
std::optional<QSize> sizeFromText(const std::string& text);

/// Runs the scenario of the window to a time and saves a picture of the whole window. Empty = done.
base::Diagnostics takeScreenshot(MainWindow& window, const WindowOptions& options);

}  // namespace app
