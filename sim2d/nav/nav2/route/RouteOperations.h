#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/route/RouteTracker.h"

/// What is done while a route is followed, by the plugins of the key operations (nav2_route,
/// plugins/route_operations).
namespace sim2d::nav2 {

/// What operations look at.
struct OperationsScene {
  const RouteGraph& graph;
  const Route& route;
  const TrackState& state;
  Vec2 robot = Vec2::Zero();        // [m]
  const Costmap* global = nullptr;  // null: none yet
  const Costmap* local = nullptr;
  double time = 0.0;   // [s]
  Pose2 localFrame{};  // the frame of `local`, in the map
};

struct OperationsResult {
  bool reroutes = false;               // the route has to be found anew
  BlockedEdges blocked;                // without these edges
  std::optional<double> speedLimit;    // percent of the full speed
  std::vector<std::string> triggered;  // names of the plugins that did something
  std::vector<std::string> events;     // of TriggerEvent: services that were called
  std::optional<std::pair<std::size_t, double>> edgeTime;  // of TimeMarker: edge by index, time [s]
  std::string timeTag;                                     // where it is kept
  std::string failure;                                     // empty: none has failed
};

/// The operations of one route server, with their state. Thread: one at a time.
class RouteOperations {
 public:
  explicit RouteOperations(std::vector<std::pair<std::string, RouteOperationSettings>> settings)
      : settings_(std::move(settings)) {}

  void begin();  // of a new route
  /// A cycle of the tracker. `hasChanged`: a node was achieved in it.
  OperationsResult process(bool hasChanged, const OperationsScene& scene);
  /// A call of the service reroute of ReroutingService.
  void requestReroute() { isRerouteRequested_ = true; }

 private:
  void onChange(const OperationsScene& scene, OperationsResult& result);
  void onGraph(const OperationsScene& scene, OperationsResult& result) const;
  void onQuery(const OperationsScene& scene, OperationsResult& result);
  void markTime(const TimeMarkerParameters& marker, const OperationsScene& scene,
                OperationsResult& result);

  std::vector<std::pair<std::string, RouteOperationSettings>> settings_;
  bool isRerouteRequested_ = false;
  std::optional<double> lastLook_;        // of CollisionMonitor [s]
  std::optional<std::size_t> timedEdge_;  // by index
  double timedSince_ = 0.0;               // [s]
};

/// The edge on which something stands, within a distance of the robot along the route; by its
/// number in `graph`. Unknown cells are free, and what lies off the map is not looked at. None: all
/// is free.
std::optional<std::size_t> blockedEdge(const RouteCollisionParameters& monitor,
                                       const OperationsScene& scene);

}  // namespace sim2d::nav2
