#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "bt/robot/Nav2Servers.h"
#include "sim2d/base/Math.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"
#include "sim2d/nav/nav2/global/GlobalPlanner.h"

// Requests to the planner, smoother and route servers; cycles of the controller server.
namespace bt {
namespace {

using namespace sim2d::nav2;  // NOLINT: this file only concerns Nav2

/// The action's error code for an error of its planner.
int codeOf(RobotAction action, PlanError error) {
  const int code = static_cast<int>(error);
  return action == RobotAction::ComputePathThroughPoses ? throughPosesCode(code) : code;
}

/// Finds by name; the name may be empty if there is only one. Null: not found.
template <class T>
const T* findByName(const std::map<std::string, T>& all, const std::string& name) {
  const auto found = name.empty() && all.size() == 1 ? all.begin() : all.find(name);
  return found == all.end() ? nullptr : &found->second;
}

}  // namespace

/// After a clear, until the next update: Humble waits indefinitely, later distributions give up.
bool Nav2Servers::waitsForCostmap(PendingRequest& pendingRequest) {
  if (global_->isCurrent() && global_->updates() > 0) {
    return false;
  }
  pendingRequest.waitsSince = pendingRequest.waitsSince < 0.0 ? time_ : pendingRequest.waitsSince;
  const double longest = setup_.parameters.plannerServer.costmapUpdateTimeout;
  return distro() == Distro::Humble || time_ - pendingRequest.waitsSince <= longest;
}

PlanRequest Nav2Servers::planRequest(const base::Pose2& from, const base::Pose2& to) const {
  PlanRequest request(global_->costmap(), from, to);
  const CostmapFootprint& footprint = global_->footprint();
  if (!footprint.isRadius) {
    request.footprint = footprint.corners;
  }
  if (const auto law = global_->inflation()) {
    request.circumscribedCost = law->cost(footprint.circumscribed);
  }
  return request;
}

void Nav2Servers::processPlanRequest(RobotAction action) {
  PendingRequest& request = pendingRequest(action);
  const auto latency = static_cast<std::int64_t>(setup_.latencies.planner);
  if (request.isWaiting && step_ - request.step >= latency && !waitsForCostmap(request)) {
    executePlanRequest(action, request);
  }
}

void Nav2Servers::executePlanRequest(RobotAction action, PendingRequest& pendingRequest) {
  const auto fail = [&](PlanError error) {
    finish(action, codeOf(action, error), 0, planErrorMessage(error));
  };
  if (!global_->isCurrent() || global_->updates() == 0) {
    fail(PlanError::Timeout);
    return;
  }
  if (!isLocalized()) {
    fail(PlanError::TfError);
    return;
  }
  const PlannerPointer* const planner = findByName(planners_, pendingRequest.request.server);
  const Path& goals = paths().get(pendingRequest.request.path);
  if (planner == nullptr || goals.empty()) {
    fail(planner == nullptr ? PlanError::InvalidPlanner : PlanError::NoValidPath);
    return;
  }
  const Path& starts = paths().get(pendingRequest.request.start.value_or(0));
  const base::Pose2 start = starts.empty() ? observation_->pose : starts.front();
  ThroughPosesResult plan = planPath(**planner, action, pendingRequest.request, start);
  if (plan.error == PlanError::None && plan.path.empty()) {
    plan.error = PlanError::NoValidPath;
  }
  if (plan.error != PlanError::None) {
    fail(plan.error);
    return;
  }
  hasReplanned_ = hasReplanned_ || hasPlanned_;
  counts_.replans += hasPlanned_ ? 1 : 0;
  hasPlanned_ = true;
  passPlanToCostmaps(plan.path);
  finish(action, 0, paths().add(std::move(plan.path)));
  result(action).lastReached = plan.reached;
}

/// Passes the plan to the costmap layers, in the frame of each costmap.
void Nav2Servers::passPlanToCostmaps(const Path& plan) {
  global_->setPlan(plan);
  Path local = plan;
  for (base::Pose2& pose : local) {
    pose = sim2d::toFrame(localFrame(), pose);
  }
  local_->setPlan(local);
}

/// Plans to one goal, optionally through intermediate poses, or through all goals.
ThroughPosesResult Nav2Servers::planPath(GlobalPlanner& planner, RobotAction action,
                                         const RobotRequest& request, const base::Pose2& start) {
  Path goals = paths().get(request.path);
  if (action == RobotAction::ComputePath) {
    Path via = paths().get(request.viaPoints);
    if (via.empty()) {
      PlanResult plan = planner.plan(planRequest(start, goals.back()));
      return {plan.error, std::move(plan.path), 0, true};
    }
    via.push_back(goals.back());
    return planThroughPoses(planner, planRequest(start, via.back()), via, false);
  }
  return planThroughPoses(planner, planRequest(start, goals.back()), goals,
                          setup_.parameters.plannerServer.allowPartialPlanning);
}

void Nav2Servers::processSmoothRequest() {
  PendingRequest& request = pendingRequest(RobotAction::SmoothPath);
  if (request.isWaiting) {
    executeSmoothRequest(request.request);
  }
}

/// Smoothers use the published global costmap.
void Nav2Servers::executeSmoothRequest(const RobotRequest& request) {
  const PathSmootherParameters* const smoother = findByName(smoothers_, request.server);
  if (smoother == nullptr) {
    finish(RobotAction::SmoothPath, static_cast<int>(SmoothError::InvalidSmoother), 0,
           smoothErrorMessage(SmoothError::InvalidSmoother));
    return;
  }
  const Path& path = paths().get(request.path);
  SmoothResult smoothed = path.empty() ? SmoothResult{SmoothError::InvalidPath, {}, false}
                                       : smoothPath(*smoother, setup_.parameters.distro, path,
                                                    global_->published(), request.timeAllowance);
  if (smoothed.error == SmoothError::None && request.checksCollisions) {
    const bool isHit =
        std::any_of(smoothed.path.begin(), smoothed.path.end(), [&](const base::Pose2& place) {
          return isInCollision(global_->published(), global_->footprint(), place, true);
        });
    smoothed.error = isHit ? SmoothError::SmoothedPathInCollision : smoothed.error;
  }
  const bool isFine = smoothed.error == SmoothError::None;
  finish(RobotAction::SmoothPath, static_cast<int>(smoothed.error),
         isFine ? paths().add(std::move(smoothed.path)) : 0, smoothErrorMessage(smoothed.error));
  result(RobotAction::SmoothPath).wasCompleted = smoothed.wasCompleted;
}

// Requests to the route server.
namespace {

using State = RobotOutcome::State;

/// The nodes of a route as poses; each faces along the edge that leaves it, the last one along the
/// edge before it.
Path routePoses(const Route& route, const RouteGraph& graph) {
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

/// Executes the service calls of the scenario's topics.
void Nav2Servers::callRouteServices() {
  const auto each = [&](const std::string& service, const auto& call) {
    int& heard = seenServiceCalls_[service];
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
  outcome.progress.route = paths().add(routePoses(plan.route, routes_->graph()));
}

/// ComputeRoute is answered immediately; ComputeAndTrackRoute keeps running.
void Nav2Servers::route() {
  callRouteServices();
  const RouteScene scene{observation_->pose, global_->updates() > 0 ? &global_->costmap() : nullptr,
                         local_->updates() > 0 ? &local_->costmap() : nullptr, time_, localFrame()};
  if (PendingRequest& request = pendingRequest(RobotAction::ComputeRoute); request.isWaiting) {
    const RoutePlan plan = routes_->compute(routeRequest(request.request), scene);
    finish(RobotAction::ComputeRoute, static_cast<int>(plan.error), 0, plan.text);
    if (plan.error == RouteError::None) {
      showRoute(result(RobotAction::ComputeRoute), plan);
    }
  }
  RobotOutcome& tracked = result(RobotAction::ComputeAndTrackRoute);
  if (PendingRequest& request = pendingRequest(RobotAction::ComputeAndTrackRoute);
      request.isWaiting) {
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

ControlCycle Nav2Servers::cycle() const {
  return {inLocal().pose,
          observation_->motion,
          local_->costmap(),
          shape_,
          local_->isCurrent() && local_->updates() > 0,
          time_,
          sim2d::inverse(localFrame())};
}

/// A cancelled goal ends immediately, independent of the rate; then the next one may start.
void Nav2Servers::control() {
  if (isCancelling_) {
    const FollowFeedback feedback = controllers_->update(cycle());
    command_ = feedback.command ? feedback.command : command_;
    isCancelling_ = controllers_->isRunning();
    if (!isCancelling_ && nextFollow_) {
      controllers_->follow(*std::exchange(nextFollow_, std::nullopt));
    }
  }
  if (!isCancelling_ && isDue(controllers_->parameters().frequency)) {
    configureController();
    takeFeedback(controllers_->update(cycle()));
    trackPath();
  }
}

/// Tracking error as in the controller server since Lyrical, on the last given path. The search for
/// the nearest segment starts at the previous one and covers two metres.
void Nav2Servers::trackPath() {
  constexpr double kWindow = 2.0;  // [m], search_window
  if (!controllers_->isRunning() || displayedPath_.empty()) {
    return;
  }
  const int number = tracking_.number + 1;
  tracking_ = trackingError(displayedPath_, observation_->pose, tracking_.index, kWindow);
  tracking_.number = number;
}

/// Recording trajectories is slow; the first cycle of a robot has none.
void Nav2Servers::configureController() {
  if (Controller* const controller = controllers_->controller()) {
    controller->watch(recordsTrajectories_);
  }
}

/// Applies the limit of the costmap whose filters changed last; records the states of binary
/// filters for the manifest.
void Nav2Servers::applySpeedLimit() {
  for (const LayeredCostmap* const costmap : {local_.get(), global_.get()}) {
    SpeedLimit& last = costmap == local_.get() ? localLimit_ : globalLimit_;
    if (!(costmap->speedLimit() == last)) {
      last = costmap->speedLimit();
      controllers_->setSpeedLimit(last.value, last.isPercentage);
    }
    const std::string node = costmap == local_.get() ? "local_costmap." : "global_costmap.";
    for (const auto& [name, state] : costmap->binaryStates()) {
      counts_.binaryFilters[node + name] = state;
    }
  }
}

void Nav2Servers::takeFeedback(const FollowFeedback& feedback) {
  command_ = feedback.command ? feedback.command : command_;
  counts_.noValidControl +=
      feedback.isFailureTolerated || feedback.code == ControllerError::NoValidControl ? 1 : 0;
  counts_.progressFailures += feedback.code == ControllerError::FailedToMakeProgress ? 1 : 0;
  RobotOutcome& outcome = result(RobotAction::FollowPath);
  if (outcome.state != State::Running) {
    return;
  }
  if (feedback.status == FollowStatus::Succeeded) {
    outcome.state = State::Succeeded;
  } else if (feedback.status == FollowStatus::Failed) {
    outcome.state = State::Failed;
    outcome.errorCode = static_cast<int>(feedback.code);
    outcome.errorText = feedback.words;
    noteFailure(RobotAction::FollowPath, outcome.errorCode);
  } else if (feedback.status == FollowStatus::Canceled) {
    outcome.state = State::Cancelled;
  }
}

}  // namespace bt
