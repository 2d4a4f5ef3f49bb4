#pragma once

#include <functional>
#include <string>

#include "sim2d/nav/nav2/params/Nav2Parameters.h"

namespace sim2d::nav2 {

/// Behaviours, velocity smoother and collision monitor; `reader` begins to read a node of the file.
/// Private to this folder.
void readMotions(Nav2Parameters& to, const std::function<NodeReader(const std::string&)>& reader,
                 const ParameterFile& file);

}  // namespace sim2d::nav2
