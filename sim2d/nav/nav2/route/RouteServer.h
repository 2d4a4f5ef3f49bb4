#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/route/EdgeScorers.h"
#include "sim2d/nav/nav2/route/RouteOperations.h"
#include "sim2d/nav/nav2/route/RoutePath.h"

/// nav2_route::RouteServer: routes through a graph, and progress on them.
namespace sim2d::nav2 {

/// What the server looks at in a step.
struct RouteScene {
  Pose2 robot;
  const Costmap* global = nullptr;  // null: none yet
  const Costmap* local = nullptr;
  double time = 0.0;   // [s]
  Pose2 localFrame{};  // the frame of `local`, in the map
};

/// What came of a request.
struct RoutePlan {
  RouteError error = RouteError::None;
  std::string text;  // why there is none, in words
  Route route;
  Path path;
};

enum class TrackStatus : std::uint8_t { Idle, Running, Succeeded, Failed };

/// Feedback and result of ComputeAndTrackRoute.
struct TrackFeedback {
  TrackStatus status = TrackStatus::Idle;
  int number = 0;  // of the feedback; it grows when something has changed
  bool isRerouted = false;
  std::uint32_t lastNode = 0, nextNode = 0, currentEdge = 0;  // by ids; 0 where there is none
  RoutePlan plan;                                             // that is followed; why it failed
  double duration = 0.0;                                      // [s] since the request
};

/// Something that an operation did, for the manifest.
struct RouteEvent {
  double time = 0.0;  // [s]
  std::string what;
};

/// Equal calls in the same order give equal results, to the bit. Thread: one at a time.
class RouteServer {
 public:
  RouteServer(const RouteSettings& settings, RouteGraph graph);

  const RouteGraph& graph() const { return graph_; }
  /// Action ComputeRoute: at once.
  RoutePlan compute(const RouteRequest& request, const RouteScene& scene) const;

  /// Begins the action ComputeAndTrackRoute and ends an earlier one. `update`, to be called in each
  /// step, advances it at `tracker_update_rate`.
  void track(const RouteRequest& request, const RouteScene& scene);
  void update(const RouteScene& scene);
  void cancel() { feedback_.status = TrackStatus::Idle; }
  const TrackFeedback& feedback() const { return feedback_; }

  void requestReroute() { operations_.requestReroute(); }  // service of ReroutingService
  bool adjustEdges(const std::string& text) { return dynamicEdges_.apply(text); }
  /// Of AdjustSpeedLimit, once: percent of the full speed.
  std::optional<double> takeSpeedLimit() { return std::exchange(speedLimit_, std::nullopt); }
  const std::vector<RouteEvent>& events() const { return events_; }

 private:
  /// What is kept from a route that has to be found anew.
  struct Rerouting {
    std::optional<std::size_t> start;  // node by index
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
  void take(const OperationsResult& result, double time);

  RouteSettings settings_;
  RouteGraph graph_;
  EdgeScorers scorers_;
  RouteOperations operations_;
  DynamicEdges dynamicEdges_;
  RouteRequest request_;
  Rerouting rerouting_;
  TrackState state_;
  TrackFeedback feedback_;
  double begun_ = 0.0;             // [s]
  std::optional<double> updated_;  // [s], the cycle before
  std::optional<double> speedLimit_;
  std::vector<RouteEvent> events_;
};

}  // namespace sim2d::nav2
