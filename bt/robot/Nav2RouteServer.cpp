#include <string>
#include <utility>

#include "bt/robot/Nav2Servers.h"
#include "sim2d/base/Math.h"

// What the route server does when it is asked.
namespace bt {
namespace {

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else
using State = RobotOutcome::State;

/// The nodes of a route as poses, each looking along the edge that leaves it, the last one along
/// the edge before it.
Path nodesOf(const Route& route, const RouteGraph& graph) {
  Path nodes;
  if (graph.isEmpty()) {
    return nodes;
  }
  nodes.reserve(route.edges.size() + 1);
  nodes.push_back({graph.nodes[route.start].place, 0.0});
  for (const std::size_t index : route.edges) {
    const base::Vec2 to = graph.nodes[graph.edges[index].to].place;
    const base::Vec2 along = to - nodes.back().position;
    nodes.back().heading = base::atan2(along.y(), along.x());
    nodes.push_back({to, nodes.back().heading});
  }
  return nodes;
}

}  // namespace

RouteRequest Nav2Servers::routeRequest(const RobotRequest& request) const {
  RouteRequest route;
  route.usesPoses = request.usesPoses;
  route.startId = request.startId;
  route.goalId = request.goalId;
  const Path& starts = paths().get(request.start.value_or(0));
  const Path& goals = paths().get(request.path);
  route.start = starts.empty() ? observation_->pose : starts.front();
  route.goal = goals.empty() ? route.start : goals.back();
  return route;
}

/// Calls of its services, by the topics of the scenario.
void Nav2Servers::callRouteServices() {
  const auto each = [&](const std::string& service, const auto& call) {
    int& heard = heardServices_[service];
    for (const TopicMessage& message : setup_.topics.after(service, heard, time_)) {
      heard = message.number;
      call(message.text);
    }
  };
  const RouteSettings& settings = setup_.parameters.route;
  for (const auto& [name, operation] : settings.operations) {
    if (std::holds_alternative<ReroutingServiceParameters>(operation)) {
      each("route_server/" + name + "/reroute",
           [&](const std::string& /*text*/) { routes_->requestReroute(); });
    }
  }
  for (const auto& [name, scorer] : settings.scorers) {
    if (std::holds_alternative<DynamicEdgesParameters>(scorer)) {
      each("route_server/" + name + "/adjust_edges",
           [&](const std::string& text) { routes_->adjustEdges(text); });
    }
  }
}

void Nav2Servers::showRoute(RobotOutcome& outcome, const RoutePlan& plan) {
  outcome.path = paths().add(plan.path);
  outcome.progress.route = paths().add(nodesOf(plan.route, routes_->graph()));
}

/// ComputeRoute is answered immediately; ComputeAndTrackRoute keeps running.
void Nav2Servers::route() {
  callRouteServices();
  const RouteScene scene{observation_->pose, global_->updates() > 0 ? &global_->costmap() : nullptr,
                         local_->updates() > 0 ? &local_->costmap() : nullptr, time_, localFrame()};
  if (Asked& request = asked(RobotAction::ComputeRoute); request.isWaiting) {
    const RoutePlan plan = routes_->compute(routeRequest(request.request), scene);
    finish(RobotAction::ComputeRoute, static_cast<int>(plan.error), 0, plan.text);
    if (plan.error == RouteError::None) {
      showRoute(result(RobotAction::ComputeRoute), plan);
    }
  }
  RobotOutcome& tracked = result(RobotAction::ComputeAndTrackRoute);
  if (Asked& request = asked(RobotAction::ComputeAndTrackRoute); request.isWaiting) {
    request.isWaiting = false;
    routes_->track(routeRequest(request.request), scene);
  }
  if (routes_->feedback().status == TrackStatus::Idle || tracked.state != State::Running) {
    return;
  }
  routes_->update(scene);
  const TrackFeedback& feedback = routes_->feedback();
  if (const auto limit = routes_->takeSpeedLimit()) {
    controllers_->setSpeedLimit(*limit, true);
  }
  counts_.routeEvents = routes_->events();
  tracked.duration = feedback.duration;
  if (feedback.number != tracked.progress.number) {
    if (tracked.progress.number == 0 || feedback.isRerouted) {
      showRoute(tracked, feedback.plan);
    }
    tracked.progress = {feedback.number,   tracked.progress.route, feedback.lastNode,
                        feedback.nextNode, feedback.currentEdge,   feedback.isRerouted};
  }
  if (feedback.status == TrackStatus::Succeeded) {
    tracked.state = State::Succeeded;
  } else if (feedback.status == TrackStatus::Failed) {
    tracked.state = State::Failed;
    tracked.path = 0;
    tracked.progress.route = 0;
    tracked.errorCode = static_cast<int>(feedback.plan.error);
    tracked.errorText = feedback.plan.text;
    noteFailure(RobotAction::ComputeAndTrackRoute, tracked.errorCode);
  }
}

}  // namespace bt
