#pragma once

#include "sim2d/nav/nav2/params/NodeReader.h"
#include "sim2d/nav/nav2/route/RouteParameters.h"

namespace sim2d::nav2 {

/// The node route_server with its plugins. Private to this folder.
RouteSettings readRouteServer(NodeReader node);

}  // namespace sim2d::nav2
