#pragma once

#include <string>
#include <string_view>

#include "sim2d/base/Result.h"
#include "sim2d/base/yaml/YamlTree.h"

/// Files of other programs, in which a key may be repeated. Each repetition is a warning with both
/// lines; which value counts depends on the program that the file is written for.
namespace base {

enum class RepeatedKeys {
  LastCounts,  // parameter files of ROS 2 (rcl_yaml_param_parser): maps are merged, also those of
               // several documents; aliases and merge keys are replaced, as launch tools do
  FirstCounts  // files that are read with yaml-cpp: maps of map_server, metadata of rosbag2
};

/// As `parseYaml` of YamlTree.h, without its error for repeated keys: no map of the result has a
/// key twice.
YamlNode parseYaml(std::string_view text, const std::string& file, RepeatedKeys rule,
                   Diagnostics& diagnostics);

/// The warning of a repeated key: the value at `kept` counts, that at `dropped` does not.
Diagnostic repeatedKey(const std::string& name, const YamlNode& kept, const YamlNode& dropped,
                       const std::string& file);

}  // namespace base
