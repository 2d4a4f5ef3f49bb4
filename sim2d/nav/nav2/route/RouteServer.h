#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/route/RouteOperations.h"
#include "sim2d/nav/nav2/route/RoutePlanner.h"

/// nav2_route::RouteServer: computes routes through a graph and tracks progress on them.
namespace sim2d::nav2 {

/// The start and goal nodes of a request (nav2_route::GoalIntentExtractor).

/// The nodes nearest to a position, nearest first; at equal distances in file order.
std::vector<std::size_t> nearestNodes(const RouteGraph& graph, const Vec2& place,
                                      std::size_t count);

/// The node of a pose: the nearest one if the straight line to it is free in the costmap (no cell
/// >= 253 except unknown ones); else, of the nearest `num_nearest_nodes`, the first one reached by
/// a search through free cells. The nearest one without a costmap, with `enable_nn_search` off, or
/// when the search reaches none. nullopt: the graph has no nodes.
std::optional<std::size_t> nodeOfPose(const RouteGraph& graph, const Vec2& place,
                                      const Costmap* costmap,
                                      const RouteServerParameters& parameters);

/// Removes the first edge if the start is beside it and past its first node, and the last one if
/// the goal is beside it and before its last node. `continued`: the edge being followed; kept if it
/// is the removed one, else reset. `isFirst`: the route is not a reroute.
Route pruneRoute(Route route, const RouteGraph& graph, const RouteRequest& request, bool isFirst,
                 const RouteServerParameters& parameters, ContinuedEdge& continued);

/// A circular arc that rounds a corner between two segments (nav2_route::CornerArc) and is tangent
/// to both. World frame [m].
class CornerArc {
 public:
  /// Invalid if the segments are collinear, one has no length, or the arc would begin or end beyond
  /// them.
  CornerArc(const Vec2& start, const Vec2& corner, const Vec2& end, double radius);

  bool isValid() const { return isValid_; }
  const Vec2& begin() const { return begin_; }
  const Vec2& end() const { return end_; }
  const Vec2& centre() const { return centre_; }
  /// Points from the beginning, without the end, at most `step` apart [rad].
  std::vector<Vec2> points(double step) const;

 private:
  bool isValid_ = false;
  Vec2 begin_ = Vec2::Zero(), end_ = Vec2::Zero(), centre_ = Vec2::Zero();
};

/// Converts a route to a path (nav2_route::PathConverter): poses at most `path_density` apart along
/// the edges, with arcs at corners if `smooth_corners` is set. Starts with a continued edge, from
/// its nearest point. Headings point to the next pose; the last one is that of the last edge. A
/// route without edges is its node only.
Path pathOf(const Route& route, const RouteGraph& graph, const RouteServerParameters& parameters,
            const ContinuedEdge& continued = {});

/// Result of a request.
struct RoutePlan : RouteResult {
  Path path;
};

enum class TrackStatus : std::uint8_t { Idle, Running, Succeeded, Failed };

/// Feedback and result of ComputeAndTrackRoute.
struct TrackFeedback {
  TrackStatus status = TrackStatus::Idle;
  int number = 0;  // sequence number; increases with each change
  bool isRerouted = false;
  std::uint32_t lastNode = 0, nextNode = 0, currentEdge = 0;  // ids; 0 for none
  RoutePlan plan;                                             // current route or failure
  double duration = 0.0;                                      // [s] since the request
};

/// An event of an operation, for the manifest.
struct RouteEvent {
  double time = 0.0;  // [s]
  std::string what;
};

/// Equal calls in the same order give bit-identical results. Not thread-safe.
class RouteServer {
 public:
  RouteServer(const RouteSettings& settings, RouteGraph graph);

  const RouteGraph& graph() const { return graph_; }
  /// Action ComputeRoute; returns immediately.
  RoutePlan compute(const RouteRequest& request, const RouteScene& scene) const;

  /// Starts the action ComputeAndTrackRoute and ends an earlier one. Call `update` in each step; it
  /// advances the action at `tracker_update_rate`.
  void track(const RouteRequest& request, const RouteScene& scene);
  void update(const RouteScene& scene);
  void cancel() { feedback_.status = TrackStatus::Idle; }
  const TrackFeedback& feedback() const { return feedback_; }

  void requestReroute() { operations_.requestReroute(); }  // service of ReroutingService
  bool adjustEdges(const std::string& text) { return dynamicEdges_.apply(text); }
  /// Returns a new limit of AdjustSpeedLimit once: percent of the maximum speed.
  std::optional<double> takeSpeedLimit() { return std::exchange(speedLimit_, std::nullopt); }
  const std::vector<RouteEvent>& events() const { return events_; }

 private:
  /// State kept for rerouting.
  struct Rerouting {
    std::optional<std::size_t> start;  // node index
    Pose2 pose;
    BlockedEdges blocked;
    ContinuedEdge continued;
    bool isFirst = true;
  };
  RoutePlan plan(const RouteRequest& request, const RouteScene& scene, Rerouting& rerouting) const;
  RoutePlan between(std::size_t start, std::size_t goal, const RouteRequest& request,
                    const RouteScene& scene, Rerouting& rerouting) const;
  void follow(const RouteScene& scene, bool isRerouted);
  void reroute(const OperationsResult& result, const RouteScene& scene);
  void publish(bool isRerouted);
  void fail(RouteError error, const std::string& text);
  void applyOperations(const OperationsResult& result, double time);

  RouteSettings settings_;
  RouteGraph graph_;
  RouteOperations operations_;
  DynamicEdges dynamicEdges_;
  RouteRequest request_;
  Rerouting rerouting_;
  TrackState state_;
  TrackFeedback feedback_;
  double startTime_ = 0.0;            // [s]
  std::optional<double> lastUpdate_;  // [s], previous cycle
  std::optional<double> speedLimit_;
  std::vector<RouteEvent> events_;
};

}  // namespace sim2d::nav2
