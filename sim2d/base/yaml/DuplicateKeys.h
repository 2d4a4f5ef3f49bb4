#pragma once

#include <string>
#include <string_view>

#include "sim2d/base/Result.h"
#include "sim2d/base/yaml/YamlTree.h"

/// Reads third-party YAML files that may repeat keys. Each repetition is a warning with both lines;
/// which value counts depends on the program that the file is written for.
namespace base {

enum class DuplicateKeys {
  LastWins,  // ROS 2 parameter files (rcl_yaml_param_parser): maps are merged, also across
             // documents; aliases and merge keys are resolved, as launch tools do
  FirstWins  // files read with yaml-cpp: map_server maps, rosbag2 metadata
};

/// As `parseYaml` of YamlTree.h, but repeated keys are not errors: in the result each key of a map
/// is unique.
YamlNode parseYaml(std::string_view text, const std::string& file, DuplicateKeys rule,
                   Diagnostics& diagnostics);

/// The warning for a repeated key: the value at `kept` is used, the one at `dropped` is not.
Diagnostic duplicateKeyWarning(const std::string& name, const YamlNode& kept,
                               const YamlNode& dropped, const std::string& file);

}  // namespace base
