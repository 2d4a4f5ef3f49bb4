#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/params/NodeReader.h"

/// Plugins of other packages: what is used in their place. Private to this folder.
namespace sim2d::nav2 {

/// Greatest velocities of a robot by its velocity smoother; none: the file has no such node.
struct RobotLimits {
  std::optional<double> ahead;  // [m/s]
  std::optional<double> turn;   // [rad/s]
};
RobotLimits limitsOfSmoother(const ParameterFile& file, const std::string& robot);

/// In a node controller_server that has not been read yet: each controller, goal checker, progress
/// checker and path handler whose class belongs to another package gets the class that comes
/// nearest. Keys that both have keep their values. Of a controller that has none of the keys of the
/// nearest one, the limits of velocity and acceleration are kept by their names in common
/// packages (`max_vel_x`, `vx_max`, `desired_linear_vel` …), else those of `limits` count. Each
/// replacement is a warning (nav2.treated-as); a misspelt class is left to the reader.
void replaceControllerPlugins(NodeReader& node, const RobotLimits& limits);

/// The class that is read instead of `type`: `type` itself when it is known or misspelt, else
/// `fallback`, with a warning and without the keys that `keys` does not have.
std::string replacedClass(NodeReader& node, const std::string& name, const std::string& type,
                          const std::vector<std::string>& known, const std::string& fallback,
                          const Nav2Keys& keys);

}  // namespace sim2d::nav2
