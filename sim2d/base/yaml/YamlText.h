#pragma once

#include <string>
#include <string_view>

namespace base {

/// As a scalar in double quotes, on one line: every reader of YAML takes it for this text.
std::string quotedText(std::string_view text);

}  // namespace base
