#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

/// Types of YAML values as ROS 2's parser of parameter files determines them
/// (rcl_yaml_param_parser): from the text, without conversion.
namespace sim2d::nav2 {

/// Tag of a value set from outside the file: integers are accepted for doubles.
constexpr const char* kOverrideTag = "!set";

/// "double", "integer", "bool", "string", "double_array" …, "empty_array", "mixed_array", "map",
/// "empty".
std::string rosTypeName(const base::YamlNode& value);

/// The value with the type of `like`; nullopt if it has another type. An empty list fits any list
/// type.
std::optional<Nav2Value> toRosValue(const base::YamlNode& value, const Nav2Value& like);
/// The value with its own type; nullopt for a list of integers, which no key of Nav2 uses, and for
/// values that are no parameters.
std::optional<Nav2Value> toRosValue(const base::YamlNode& value);

/// The value as files write it, on one line.
std::string valueText(const Nav2Value& value);
std::string valueText(const base::YamlNode& value);

/// Placeholders in parameter files, which launch files, templates or users replace before a robot
/// reads the file.

/// Whether the whole text is a placeholder: `$(var name)`, `${NAME}`, `{{ name }}`,
/// `<robot_namespace>`, `@NAME@`, TO_BE_OVERRIDDEN, KEEPOUT_ZONE_ENABLED and similar words.
bool isPlaceholderText(std::string_view text);

/// Whether a parameter is a list of names, judged by its suffix: plugins, critics, filters,
/// polygons.
bool isListOfPlugins(const std::string& name);

/// Whether the value of parameter `name` is a placeholder regardless of its type: one of the texts
/// above, a null value, or for a list of plugins a word in capitals.
bool isLaunchPlaceholder(const std::string& name, const base::YamlNode& value);

/// Whether a value of a wrong type may be a placeholder: an empty string, a word in capitals, a
/// string or list item that contains one of the placeholders.
bool mayBePlaceholder(const base::YamlNode& value);

}  // namespace sim2d::nav2
