#pragma once

#include <optional>
#include <string>

#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/nav/nav2/Nav2Block.h"

/// What ROS 2's parser of parameter files takes a YAML value for (rcl_yaml_param_parser): the type
/// is that of the text, and nothing is converted.
namespace sim2d::nav2 {

/// Tag of a value that was set from outside the file: integers pass for doubles then.
constexpr const char* kSetTag = "!set";

/// "double", "integer", "bool", "string", "double_array" …, "empty_array", "mixed_array", "map",
/// "empty".
std::string rosTypeName(const base::YamlNode& value);

/// The value as one of `like`'s type; nothing when it is of another. An empty list is a list of
/// anything.
std::optional<Nav2Value> rosValue(const base::YamlNode& value, const Nav2Value& like);
/// By its own type; nothing for integers in a list, which no key of Nav2 wants, and for what is no
/// parameter.
std::optional<Nav2Value> rosValue(const base::YamlNode& value);

/// As files write it, on one line.
std::string valueText(const Nav2Value& value);
std::string valueText(const base::YamlNode& value);

}  // namespace sim2d::nav2
