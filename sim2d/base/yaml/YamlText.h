#pragma once

#include <string>
#include <string_view>

#include "sim2d/base/yaml/YamlTree.h"

namespace base {

/// As a scalar in double quotes, on one line: every reader of YAML takes it for this text.
std::string quotedText(std::string_view text);

/// As `parseYaml`; repeated keys are kept, and are no error.
YamlNode parseWithRepeats(std::string_view text, const std::string& file, Diagnostics& diagnostics);

}  // namespace base
