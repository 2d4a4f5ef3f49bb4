#pragma once

#include <string>
#include <string_view>

#include "sim2d/base/yaml/YamlTree.h"

/// Placeholders in parameter files, which launch files, templates or users replace before a robot
/// reads the file.
namespace sim2d::nav2 {

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
