#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/route/RouteGraph.h"
#include "sim2d/nav/nav2/route/RouteParameters.h"

/// Progress of a robot on a route (nav2_route::RouteTracker).
namespace sim2d::nav2 {

struct TrackState {
  int edge = -1;                       // position in the route; -1: on the way to its start
  std::optional<std::size_t> current;  // edge index; none: before the first, or after the last
  std::size_t nextNode = 0;            // node index
  std::optional<std::size_t> lastNode;
  bool isNear = false;  // was within the radius of the next node
};

/// State at the beginning of a route, or on a continued edge.
TrackState beginTracking(const Route& route, const RouteGraph& graph,
                         const ContinuedEdge& continued);

/// Whether the robot has achieved the next node. The first and the last node: the robot is within
/// `boundary_radius_to_achieve_node`. Nodes in between: it is within `radius_to_achieve_node` and
/// has crossed the bisector of the node's edges, or it has left that radius again.
bool isNodeAchieved(TrackState& state, const Vec2& robot, const Route& route,
                    const RouteGraph& graph, const RouteServerParameters& parameters);

/// Advances to the next edge. Returns false if the achieved node is the last one.
bool advanceToNextEdge(TrackState& state, const Route& route, const RouteGraph& graph);

/// Operations while a route is followed, by the plugins of the key operations (nav2_route,
/// plugins/route_operations).

/// Inputs of the operations.
struct OperationsScene {
  const RouteGraph& graph;
  const Route& route;
  const TrackState& state;
  const RouteScene& now;
};

struct OperationsResult {
  bool reroutes = false;                                   // a new route is required
  BlockedEdges blocked;                                    // without these edges
  std::optional<double> speedLimit;                        // percent of the maximum speed
  std::vector<std::string> triggered;                      // names of the plugins that acted
  std::vector<std::string> events;                         // of TriggerEvent: called services
  std::optional<std::pair<std::size_t, double>> edgeTime;  // of TimeMarker: edge index, time [s]
  std::string timeTag;                                     // its metadata key
  std::string failure;                                     // empty: no failure
};

/// The operations of one route server, with their state. Not thread-safe.
class RouteOperations {
 public:
  explicit RouteOperations(std::vector<std::pair<std::string, RouteOperationSettings>> settings)
      : settings_(std::move(settings)) {}

  void begin();  // starts a new route
  /// Processes a cycle of the tracker. `hasChanged`: a node was achieved in it.
  OperationsResult process(bool hasChanged, const OperationsScene& scene);
  /// Service call `reroute` of ReroutingService.
  void requestReroute() { isRerouteRequested_ = true; }

 private:
  void onChange(const OperationsScene& scene, OperationsResult& result);
  void onGraph(const OperationsScene& scene, OperationsResult& result) const;
  void onQuery(const OperationsScene& scene, OperationsResult& result);
  void markTime(const TimeMarkerParameters& marker, const OperationsScene& scene,
                OperationsResult& result);

  std::vector<std::pair<std::string, RouteOperationSettings>> settings_;
  bool isRerouteRequested_ = false;
  std::optional<double> lastCheck_;       // of CollisionMonitor [s]
  std::optional<std::size_t> timedEdge_;  // index
  double timedSince_ = 0.0;               // [s]
};

/// Index of the first edge that is blocked within a distance of the robot along the route. Unknown
/// cells are free, positions off the map are ignored. nullopt: no edge is blocked.
std::optional<std::size_t> blockedEdge(const RouteCollisionParameters& monitor,
                                       const OperationsScene& scene);

}  // namespace sim2d::nav2
