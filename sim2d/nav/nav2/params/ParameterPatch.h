#pragma once

#include <optional>
#include <string>

namespace sim2d::nav2 {

/// A parameter of a node and its new value as YAML: "controller_server", "FollowPath.vx_max",
/// "0.3".
struct ParameterValue {
  std::string node, name, yaml;
};

/// The text of a parameter file with one value changed, or added if the file does not contain it.
/// Everything else keeps its bytes: comments, order, layout. A parameter that is only given below
/// "/**" is added to its node. `robot`: see ParameterFile::parametersOf. Nothing: the file cannot
/// be changed in this way (a flow map, a block scalar, an alias); the result is always read again
/// to check that no other value has changed.
std::optional<std::string> withParameter(const std::string& text, const ParameterValue& value,
                                         const std::string& robot = {});

}  // namespace sim2d::nav2
