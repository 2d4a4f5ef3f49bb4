#pragma once

#include <string>
#include <string_view>

#include "sim2d/base/yaml/YamlTree.h"

namespace base {

/// As a scalar in double quotes, on one line: every reader of YAML takes it for this text.
std::string quotedText(std::string_view text);

/// What a text may have beside the YAML of this program's own files.
struct YamlRules {
  bool keepsRepeats = false;  // of keys
  /// Aliases (`*name`) and merge keys (`<<`) are replaced by what they stand for, documents behind
  /// the first are put after it, tabs may stand wherever YAML reads them; a warning for each.
  bool isOfRos = false;
};

/// As `parseYaml` of YamlTree.h, by these rules.
YamlNode parseYaml(std::string_view text, const std::string& file, const YamlRules& rules,
                   Diagnostics& diagnostics);

}  // namespace base
