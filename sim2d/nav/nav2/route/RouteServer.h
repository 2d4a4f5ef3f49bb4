#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/route/RouteOperations.h"
#include "sim2d/nav/nav2/route/RoutePathConverter.h"
#include "sim2d/nav/nav2/route/RoutePlanner.h"

/// nav2_route::RouteServer: computes routes through a graph and tracks progress on them.
namespace sim2d::nav2 {

/// Inputs of the server in a step.
struct RouteScene {
  Pose2 robot;
  const Costmap* global = nullptr;  // null: not available
  const Costmap* local = nullptr;
  double time = 0.0;   // [s]
  Pose2 localFrame{};  // frame of `local`, in the map
};

/// Result of a request.
struct RoutePlan {
  RouteError error = RouteError::None;
  std::string text;  // error message
  Route route;
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
  EdgeScorers scorers_;
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
