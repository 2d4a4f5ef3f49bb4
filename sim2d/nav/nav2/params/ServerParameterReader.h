#pragma once

#include <functional>
#include <string>

#include "sim2d/nav/nav2/costmap/CostmapParameters.h"
#include "sim2d/nav/nav2/params/Nav2Parameters.h"
#include "sim2d/nav/nav2/params/NodeReader.h"
#include "sim2d/nav/nav2/route/RouteParameters.h"

/// Reading of the nodes of a parameter file. Private to this folder. `reader` starts reading a node
/// of the file.
namespace sim2d::nav2 {

/// The node of a costmap with its layers and filters.
CostmapSettings readCostmap(NodeReader& node);

/// docking_server, following_server and waypoint_follower. Nodes that are absent from the file keep
/// their defaults.
void readDocking(Nav2Parameters& to, const std::function<NodeReader(const std::string&)>& reader,
                 const ParameterFile& file);

/// Behaviors, velocity smoother and collision monitor.
void readMotionServers(Nav2Parameters& to,
                       const std::function<NodeReader(const std::string&)>& reader,
                       const ParameterFile& file);

/// The node route_server with its plugins.
RouteSettings readRouteServer(NodeReader node);

/// Masks of costmap filters, as Nav2's nodes publish them. A filter subscribes to
/// `filter_info_topic`; a costmap_filter_info_server publishes the mask's scale and topic there; a
/// map_server (`filter_mask_server`) publishes the mask of `yaml_filename` on that topic.

/// Assigns to the filters of both costmaps the masks that nodes of the file publish on their
/// topics. A filter with its own `mask_file` keeps it.
void readMasks(Nav2Parameters& to, const std::function<NodeReader(const std::string&)>& reader,
               const ParameterFile& file);

}  // namespace sim2d::nav2
