#include "sim2d/nav/nav2/route/RouteServer.h"

#include <utility>

#include "sim2d/nav/nav2/route/RoutePlanner.h"

namespace sim2d::nav2 {

RouteServer::RouteServer(const RouteSettings& settings, RouteGraph graph)
    : settings_(settings),
      graph_(std::move(graph)),
      scorers_(settings.scorers),
      operations_(settings.operations) {}

RoutePlan RouteServer::compute(const RouteRequest& request, const RouteScene& scene) const {
  Rerouting none;
  return plan(request, scene, none);
}

RoutePlan RouteServer::plan(const RouteRequest& request, const RouteScene& scene,
                            Rerouting& rerouting) const {
  const auto refuse = [](RouteError error, std::string text) {
    RoutePlan plan;
    plan.error = error;
    plan.text = std::move(text);
    return plan;
  };
  if (graph_.isEmpty()) {
    return refuse(RouteError::NoValidGraph, "there is no graph (graph_filepath)");
  }
  std::optional<std::size_t> start = rerouting.start, goal;
  if (request.usesPoses) {
    const auto nodeOf = [&](const Pose2& pose) {
      return nodeOfPose(graph_, pose.position, scene.global, settings_.server);
    };
    start = start ? start : nodeOf(request.start);
    goal = nodeOf(request.goal);
  } else {
    start = start ? start : graph_.nodeOf(request.startId);
    goal = graph_.nodeOf(request.goalId);
  }
  if (!start || !goal) {
    const std::uint32_t id = start ? request.goalId : request.startId;
    return refuse(RouteError::IndeterminantNodes, "the graph has no node " + std::to_string(id));
  }
  return between(*start, *goal, request, scene, rerouting);
}

RoutePlan RouteServer::between(std::size_t start, std::size_t goal, const RouteRequest& request,
                               const RouteScene& scene, Rerouting& rerouting) const {
  RoutePlan plan;
  plan.route.start = start;
  if (start != goal) {
    RouteResult found =
        findRoute(graph_, {start, goal, settings_.server.maxIterations}, rerouting.blocked,
                  scorers_, {request, dynamicEdges_, scene.global, scene.local, scene.localFrame});
    plan.error = found.error;
    plan.text = std::move(found.text);
    plan.route = std::move(found.route);
  }
  if (plan.error != RouteError::None) {
    return plan;
  }
  RouteRequest from = request;
  if (!rerouting.isFirst) {
    from.start = rerouting.pose;
  }
  plan.route = pruneRoute(std::move(plan.route), graph_, from, rerouting.isFirst, settings_.server,
                          rerouting.continued);
  rerouting.isFirst = false;
  plan.path = pathOf(plan.route, graph_, settings_.server, rerouting.continued);
  return plan;
}

void RouteServer::track(const RouteRequest& request, const RouteScene& scene) {
  request_ = request;
  rerouting_ = {};
  operations_.begin();
  startTime_ = scene.time;
  lastUpdate_.reset();
  feedback_ = {};
  follow(scene, false);
}

/// Computes a route and follows it from its beginning.
void RouteServer::follow(const RouteScene& scene, bool isRerouted) {
  RoutePlan plan = this->plan(request_, scene, rerouting_);
  if (plan.error != RouteError::None) {
    fail(plan.error, plan.text);
    return;
  }
  feedback_.plan = std::move(plan);
  feedback_.status = TrackStatus::Running;
  state_ = beginTracking(feedback_.plan.route, graph_, rerouting_.continued);
  publish(isRerouted);
}

void RouteServer::publish(bool isRerouted) {
  ++feedback_.number;
  feedback_.isRerouted = isRerouted;
  feedback_.lastNode = state_.lastNode ? graph_.nodes[*state_.lastNode].id : 0;
  feedback_.nextNode = graph_.nodes[state_.nextNode].id;
  feedback_.currentEdge = state_.current ? graph_.edges[*state_.current].id : 0;
}

void RouteServer::fail(RouteError error, const std::string& text) {
  feedback_.status = TrackStatus::Failed;
  feedback_.plan = {};
  feedback_.plan.error = error;
  feedback_.plan.text = text;
}

/// Stores the results of operations.
void RouteServer::applyOperations(const OperationsResult& result, double time) {
  if (result.speedLimit) {
    speedLimit_ = result.speedLimit;
  }
  if (result.edgeTime) {
    graph_.edges[result.edgeTime->first].metadata.set(result.timeTag, result.edgeTime->second);
  }
  for (const std::string& event : result.events) {
    events_.push_back({time, event});
  }
}

void RouteServer::reroute(const OperationsResult& result, const RouteScene& scene) {
  if (!settings_.server.aggregateBlockedIds) {
    rerouting_.blocked.clear();
  }
  rerouting_.blocked.insert(result.blocked.begin(), result.blocked.end());
  rerouting_.start = state_.lastNode;
  rerouting_.pose = state_.lastNode ? scene.robot : request_.start;
  rerouting_.continued.edge = state_.current;
  events_.push_back({scene.time, "reroute"});
  follow(scene, true);
}

void RouteServer::update(const RouteScene& scene) {
  constexpr double kRounding = 1e-9;  // [s]
  const double period = 1.0 / settings_.server.trackerUpdateRate;
  const bool isDue = !lastUpdate_ || scene.time - *lastUpdate_ >= period - kRounding;
  if (feedback_.status != TrackStatus::Running || !isDue) {
    return;
  }
  lastUpdate_ = scene.time;
  feedback_.duration = scene.time - startTime_;
  const Route& route = feedback_.plan.route;
  const bool hasChanged =
      isNodeAchieved(state_, scene.robot.position, route, graph_, settings_.server);
  const bool isOver = hasChanged && !advanceToNextEdge(state_, route, graph_);
  const OperationsResult result =
      operations_.process(hasChanged, {graph_, route, state_, scene.robot.position, scene.global,
                                       scene.local, scene.time, scene.localFrame});
  applyOperations(result, scene.time);
  if (!result.failure.empty()) {
    fail(RouteError::OperationFailed, result.failure);
  } else if (isOver) {
    feedback_.status = TrackStatus::Succeeded;
    publish(false);
  } else if (result.reroutes) {
    reroute(result, scene);
  } else if (hasChanged || !result.triggered.empty()) {
    publish(false);
  }
}

}  // namespace sim2d::nav2
