#pragma once

#include <functional>
#include <string>

#include "sim2d/nav/nav2/params/Nav2Parameters.h"
#include "sim2d/nav/nav2/params/NodeReader.h"
#include "sim2d/nav/nav2/route/RouteParameters.h"

namespace sim2d::nav2 {

/// Reads behaviors, velocity smoother and collision monitor; `reader` starts reading a node of the
/// file. Private to this folder.
void readMotionServers(Nav2Parameters& to,
                       const std::function<NodeReader(const std::string&)>& reader,
                       const ParameterFile& file);

/// Reads the node route_server with its plugins. Private to this folder.
RouteSettings readRouteServer(NodeReader node);

/// Masks of costmap filters, as Nav2's nodes publish them. A filter subscribes to
/// `filter_info_topic`; a costmap_filter_info_server publishes the mask's scale and topic there; a
/// map_server (`filter_mask_server`) publishes the mask of `yaml_filename` on that topic. Private
/// to this folder.

/// Assigns to the filters of both costmaps the masks that nodes of the file publish on their
/// topics. A filter with its own `mask_file` keeps it. `reader` starts reading a node of the file.
void readMasks(Nav2Parameters& to, const std::function<NodeReader(const std::string&)>& reader,
               const ParameterFile& file);

}  // namespace sim2d::nav2
