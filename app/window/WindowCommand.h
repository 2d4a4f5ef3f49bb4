#pragma once

#include <optional>
#include <string>

#include <QSize>

#include "app/cli/CommandRegistry.h"

namespace app {

/// "1280x800"; nothing when it is no size of a window.
std::optional<QSize> sizeFromText(const std::string& text);

/// Opens the window, on the scenario if one is given: what the program does without a command.
void addWindow(CommandRegistry& commands);

}  // namespace app
