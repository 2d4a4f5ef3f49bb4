#pragma once

#include <string>
#include <string_view>

#include "sim2d/base/yaml/YamlTree.h"

/// Values of parameter files that are no values yet: launch files, templates or people put the real
/// ones in their places before a robot reads them.
namespace sim2d::nav2 {

/// Whether the whole text stands for something else: `$(var name)`, `${NAME}`, `{{ name }}`,
/// `<robot_namespace>`, `@NAME@`, TO_BE_OVERRIDDEN, KEEPOUT_ZONE_ENABLED and words like these.
bool isPlaceholderText(std::string_view text);

/// A list of names, by the end of its own: plugins, critics, filters, polygons.
bool isListOfPlugins(const std::string& name);

/// Whether the value of parameter `name` is a placeholder whatever its type would be: one of the
/// texts above, no value at all, or for a list of plugins a word in capitals.
bool isLaunchPlaceholder(const std::string& name, const base::YamlNode& value);

/// Whether a value that does not have the parameter's type may be a placeholder: an empty text, a
/// word in capitals, a text or an item of a list with one of the placeholders in it.
bool mayBePlaceholder(const base::YamlNode& value);

}  // namespace sim2d::nav2
