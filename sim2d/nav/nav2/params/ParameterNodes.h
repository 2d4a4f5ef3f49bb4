#pragma once

#include <string>
#include <vector>

#include "sim2d/nav/nav2/params/ParameterFile.h"

/// The nodes of a parameter file, found in its YAML. Private to this folder.
namespace sim2d::nav2 {

constexpr const char* kForAllNodes = "/**";

/// Puts a parameter at the end; one of the same name is taken away.
void putParameter(std::vector<GivenParameter>& to, GivenParameter parameter);

/// Whether Nav2 has a node of this name, "controller_server", here or not.
bool isNav2Node(const std::string& name);

/// The nodes of a file with their parameters, which point into `tree`. What is wrong with it is
/// appended: values outside of nodes, blocks without `ros__parameters`, more than this program
/// reads.
std::vector<NodeParameters> findNodes(const base::YamlNode& tree, const std::string& file,
                                      base::Diagnostics& problems);

}  // namespace sim2d::nav2
