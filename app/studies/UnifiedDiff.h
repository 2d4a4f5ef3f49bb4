#pragma once

#include <string>

namespace app {

/// The differences of two texts in the unified format of `diff -u`, with three lines of context;
/// empty if they are equal. `before`, `after`: names for the header. Not for texts of more than
/// some thousand lines: time and memory grow with the product of the changed parts.
std::string unifiedDiff(const std::string& textBefore, const std::string& textAfter,
                        const std::string& before, const std::string& after);

}  // namespace app
