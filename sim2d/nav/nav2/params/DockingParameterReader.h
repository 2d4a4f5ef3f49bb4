#pragma once

#include <functional>
#include <string>

#include "sim2d/nav/nav2/params/Nav2Parameters.h"

/// Reads docking_server, following_server and waypoint_follower. Private to this folder.
namespace sim2d::nav2 {

/// `reader` starts reading a node of the file. Nodes that are absent from the file keep their
/// defaults.
void readDocking(Nav2Parameters& to, const std::function<NodeReader(const std::string&)>& reader,
                 const ParameterFile& file);

}  // namespace sim2d::nav2
