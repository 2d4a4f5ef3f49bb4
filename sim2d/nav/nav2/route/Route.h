#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/route/RouteGraph.h"

namespace sim2d::nav2 {

/// Why there is no route, with the numbers of nav2_msgs/action/ComputeRoute and
/// ComputeAndTrackRoute.
enum class RouteError : std::uint16_t {
  None = 0,
  Unknown = 400,
  TfError = 401,  // never here
  NoValidGraph = 402,
  IndeterminantNodes = 403,
  Timeout = 404,  // the limit of iterations is used up
  NoValidRoute = 405,
  OperationFailed = 406,
  InvalidEdgeScorerUse = 407,
};

/// A way through a graph: edges by index, one after the other.
struct Route {
  std::size_t start = 0;           // node by index
  std::vector<std::size_t> edges;  // empty: the start is the goal
  std::vector<double> costs;       // beside them
  double cost = 0.0;               // sum of all

  std::size_t endOf(const RouteGraph& graph) const {  // node by index
    return edges.empty() ? start : graph.edges[edges.back()].to;
  }
};

struct RouteResult {
  RouteError error = RouteError::None;
  std::string text;  // why, in words
  Route route;       // without an error
};

/// What the action asks for.
struct RouteRequest {
  bool usesPoses = false;  // else nodes by their ids
  Pose2 start, goal;
  std::uint32_t startId = 0, goalId = 0;
};

/// By ids.
using BlockedEdges = std::set<std::uint32_t>;

}  // namespace sim2d::nav2
