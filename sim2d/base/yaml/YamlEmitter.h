#pragma once

#include <string>
#include <string_view>

#include "sim2d/base/yaml/YamlTree.h"

namespace base {

/// The text as a double-quoted YAML scalar on one line.
std::string quotedText(std::string_view text);

/// Syntax that is accepted in addition to that of the program's own files.
struct YamlSyntax {
  bool keepsDuplicates = false;  // keeps repeated keys
  /// ROS 2 parameter file: aliases (`*name`) and merge keys (`<<`) are resolved, further documents
  /// are appended, and tabs are allowed wherever YAML allows them; each with a warning.
  bool isRosFile = false;
};

/// As `parseYaml` of YamlTree.h, with these rules.
YamlNode parseYaml(std::string_view text, const std::string& file, const YamlSyntax& rules,
                   Diagnostics& diagnostics);

}  // namespace base
