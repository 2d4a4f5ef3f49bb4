#include "bt/robot/Nav2Servers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bt/robot/Nav2Motions.h"
#include "sim2d/base/Math.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/Motion.h"
#include "sim2d/nav/SensedWorld.h"
#include "sim2d/nav/nav2/costmap/FootprintCost.h"
#include "sim2d/nav/nav2/global/PlannerServer.h"

namespace bt {
namespace {

using sim2d::BodyTwist;
using namespace sim2d::nav2;  // NOLINT: this file is about nothing else
using State = RobotOutcome::State;

constexpr double kCostmapTimeout = 1.0;  // [s], of planner_server since Jazzy
constexpr double kLidarHeight = 0.2;     // [m]; scenarios do not tell
constexpr double kCutTolerance = 1e-9;   // [m/s], [rad/s]

sim2d::nav2::CostmapSetup costmapSetup(const CostmapSettings& settings,
                                       const Nav2Servers::Setup& setup) {
  CostmapSetup result;
  result.settings = settings;
  result.map = setup.map;
  result.lidarHeight = kLidarHeight;
  result.distro = setup.parameters.distro;
  return result;
}

/// The only one may be left without a name. Null: there is none.
template <class T>
T* namedOne(const std::map<std::string, std::unique_ptr<T>>& all, const std::string& name) {
  if (name.empty() && all.size() == 1) {
    return all.begin()->second.get();
  }
  const auto found = all.find(name);
  return found == all.end() ? nullptr : found->second.get();
}

ControlledShape shapeOf(const LayeredCostmap& costmap) {
  ControlledShape shape;
  shape.vertices = costmap.footprint().corners;
  shape.inscribedRadius = costmap.footprint().inscribed;
  shape.circumscribedRadius = costmap.footprint().circumscribed;
  shape.isRadius = costmap.footprint().isRadius;
  shape.tracksUnknown = costmap.tracksUnknown();
  if (const auto law = costmap.inflation()) {
    shape.costScaling = law->scaling;
    shape.inflationRadius = law->radius;
  }
  return shape;
}

base::Diagnostics prefixed(const std::string& where, const base::Diagnostics& problems) {
  base::Diagnostics result;
  for (const base::Diagnostic& problem : problems) {
    result.push_back(base::within(where, problem));
  }
  return result;
}

}  // namespace

Nav2Servers::Nav2Servers(Setup setup) : setup_(std::move(setup)) {}
Nav2Servers::~Nav2Servers() = default;

base::Result<std::unique_ptr<Nav2Servers>> Nav2Servers::make(Setup setup) {
  std::unique_ptr<Nav2Servers> servers(new Nav2Servers(std::move(setup)));
  base::Diagnostics problems = servers->build();
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::move(servers), std::move(problems)};
}

base::Diagnostics Nav2Servers::build() {
  base::Diagnostics problems;
  const Nav2Parameters& parameters = setup_.parameters;
  const CostmapSetup local = costmapSetup(parameters.localCostmap, setup_);
  const CostmapSetup global = costmapSetup(parameters.globalCostmap, setup_);
  base::append(problems, prefixed("local_costmap", problemsOf(local)));
  base::append(problems, prefixed("global_costmap", problemsOf(global)));
  base::Result<std::unique_ptr<ControllerServer>> controllers = makeControllerServer(
      parameters.controllerServer, parameters.distro, setup_.seed, setup_.robotId);
  base::append(problems, prefixed("controller_server", controllers.diagnostics()));
  if (base::hasErrors(problems)) {
    return problems;
  }
  controllers_ = *std::move(controllers);
  local_ = std::make_unique<LayeredCostmap>(local);
  global_ = std::make_unique<LayeredCostmap>(global);
  shape_ = shapeOf(*local_);
  for (const auto& [name, planner] : parameters.planners) {
    planners_[name] = makeGlobalPlanner(planner, parameters.distro);
  }
  for (const auto& [name, smoother] : parameters.smoothers) {
    smoothers_[name] = makePathSmoother(smoother, parameters.distro);
  }
  motions_ = std::make_unique<Motions>(parameters, local_->footprint().corners);
  return problems;
}

// ---- the step ----------------------------------------------------------------------------------

bool Nav2Servers::isDue(double frequency) const {
  return timeBefore_ < 0.0 ||
         sim2d::eventAt(time_, frequency) > sim2d::eventAt(timeBefore_, frequency);
}

/// A scan reaches the costmaps so many steps after it was made.
void Nav2Servers::delayScan(const sim2d::Observation& observation) {
  if (observation.scan != nullptr && observation.scan->time > newestScan_) {
    newestScan_ = observation.scan->time;
    scans_.emplace_back(step_, *observation.scan);
  }
  const auto latency = static_cast<std::int64_t>(setup_.latencies.scan);
  while (!scans_.empty() && step_ - scans_.front().first >= latency) {
    scan_ = std::move(scans_.front().second);
    scans_.pop_front();
  }
}

void Nav2Servers::sense(const sim2d::Observation& observation) {
  timeBefore_ = step_ == 0 ? -1.0 : time_;
  time_ = observation.time;
  ++step_;
  observation_ = &observation;
  command_.reset();
  delayScan(observation);
  sensed_ = observation;
  sensed_.scan = scan_ ? &*scan_ : nullptr;
  odometry_.add(time_, observation.motion);
  local_->update(sensed_);
  global_->update(sensed_);
}

BodyTwist Nav2Servers::act() {
  planIfAsked(RobotAction::ComputePath);
  planIfAsked(RobotAction::ComputePathThroughPoses);
  smoothIfAsked();
  control();
  const BodyTwist wanted = motions_->drive({sensed_, *local_, time_}, command_);
  for (const RobotAction action : Motions::kActions) {
    if (const auto outcome = motions_->takeOutcome(action)) {
      result(action) = *outcome;
    }
  }
  const BodyTwist sent = delayed(wanted);
  const BodyTwist left = sim2d::reached(setup_.body, observation_->motion, sent, observation_->dt);
  const bool isCut = std::fabs(left.linear - sent.linear) > kCutTolerance ||
                     std::fabs(left.angular - sent.angular) > kCutTolerance ||
                     std::fabs(left.lateral - sent.lateral) > kCutTolerance;
  counts_.cutCommands += isCut ? 1 : 0;
  return sent;
}

BodyTwist Nav2Servers::delayed(const BodyTwist& command) {
  underWay_.push_back(command);
  if (static_cast<double>(underWay_.size()) <= setup_.latencies.command) {
    return {};
  }
  const BodyTwist arrived = underWay_.front();
  underWay_.pop_front();
  return arrived;
}

void Nav2Servers::restart() {
  for (Asked& each : asked_) {
    each.isWaiting = false;
  }
  if (controllers_->isRunning()) {
    cancel(RobotAction::FollowPath);
  }
  nextFollow_.reset();
  for (const RobotAction action : Motions::kActions) {
    motions_->cancel(action);
  }
  hasPlanned_ = false;
}

// ---- planning and smoothing --------------------------------------------------------------------

void Nav2Servers::begin(RobotAction action, const RobotRequest& request) {
  result(action) = {};
  if (action == RobotAction::FollowPath) {
    const Path& path = paths().get(request.path);
    FollowPathGoal goal{path, request.server, request.goalChecker, request.progressChecker,
                        request.pathHandler};
    shownPath_ = path;
    if (isCancelling_) {
      nextFollow_ = std::move(goal);
    } else {
      controllers_->follow(std::move(goal));
    }
    return;
  }
  if (Motions::isOne(action)) {
    if (!motions_->begin(action, request, {sensed_, *local_, time_})) {
      result(action).state = State::Failed;
    }
    return;
  }
  asked(action) = {request, step_, true, -1.0};
}

RobotOutcome Nav2Servers::outcome(RobotAction action) const {
  return results_[static_cast<std::size_t>(action)];
}

void Nav2Servers::finish(RobotAction action, int errorCode, PathId path) {
  RobotOutcome& outcome = result(action);
  outcome.state = errorCode == 0 ? State::Succeeded : State::Failed;
  outcome.errorCode = errorCode;
  outcome.path = path;
  asked(action).isWaiting = false;
}

void Nav2Servers::cancel(RobotAction action) {
  if (action == RobotAction::FollowPath) {
    nextFollow_.reset();
    if (result(action).state == State::Running) {
      controllers_->cancel();
      isCancelling_ = true;
    }
  } else if (Motions::isOne(action)) {
    motions_->cancel(action);
  }
  asked(action).isWaiting = false;
  if (result(action).state == State::Running) {
    result(action).state = State::Cancelled;
  }
}

/// After a clear, until the next update: Humble waits for ever, the others give up.
bool Nav2Servers::waitsForCostmap(Asked& asked) {
  if (global_->isCurrent() && global_->updates() > 0) {
    return false;
  }
  asked.waitsSince = asked.waitsSince < 0.0 ? time_ : asked.waitsSince;
  return distro() == Distro::Humble || time_ - asked.waitsSince <= kCostmapTimeout;
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

void Nav2Servers::planIfAsked(RobotAction action) {
  Asked& request = asked(action);
  const auto latency = static_cast<std::int64_t>(setup_.latencies.planner);
  if (request.isWaiting && step_ - request.step >= latency && !waitsForCostmap(request)) {
    planNow(action, request);
  }
}

void Nav2Servers::planNow(RobotAction action, Asked& asked) {
  if (!global_->isCurrent()) {
    finish(action, static_cast<int>(PlanError::Timeout));
    ++counts_.planFailures;
    return;
  }
  GlobalPlanner* const planner = namedOne(planners_, asked.request.server);
  const Path& goals = paths().get(asked.request.path);
  const Path& starts = paths().get(asked.request.start.value_or(0));
  const base::Pose2 start = starts.empty() ? observation_->pose : starts.front();
  PlanError error = PlanError::InvalidPlanner;
  Path path;
  if (planner != nullptr && goals.empty()) {
    error = PlanError::NoValidPath;
  } else if (planner != nullptr && action == RobotAction::ComputePath) {
    PlanResult plan = planner->plan(planRequest(start, goals.back()));
    error = plan.error;
    path = std::move(plan.path);
  } else if (planner != nullptr) {
    ThroughPosesResult plan =
        planThroughPoses(*planner, planRequest(start, goals.back()), goals,
                         setup_.parameters.plannerServer.allowPartialPlanning);
    error = plan.error;
    path = std::move(plan.path);
  }
  if (error == PlanError::None && path.empty()) {
    error = PlanError::NoValidPath;
  }
  if (error != PlanError::None) {
    ++counts_.planFailures;
    finish(action, static_cast<int>(error));
    return;
  }
  hasReplanned_ = hasReplanned_ || hasPlanned_;
  counts_.replans += hasPlanned_ ? 1 : 0;
  hasPlanned_ = true;
  finish(action, 0, paths().add(std::move(path)));
}

void Nav2Servers::smoothIfAsked() {
  Asked& request = asked(RobotAction::SmoothPath);
  if (request.isWaiting) {
    smoothNow(request.request);
  }
}

/// Smoothers look at the published global costmap.
void Nav2Servers::smoothNow(const RobotRequest& request) {
  const PathSmoother* const smoother = namedOne(smoothers_, request.server);
  if (smoother == nullptr) {
    finish(RobotAction::SmoothPath, static_cast<int>(SmoothError::InvalidSmoother));
    return;
  }
  const Path& path = paths().get(request.path);
  SmoothResult smoothed = path.empty()
                              ? SmoothResult{SmoothError::InvalidPath, {}, false}
                              : smoother->smooth(path, global_->published(), request.timeAllowance);
  if (smoothed.error == SmoothError::None && request.checksCollisions) {
    const bool isHit =
        std::any_of(smoothed.path.begin(), smoothed.path.end(), [&](const base::Pose2& place) {
          return isInCollision(global_->published(), global_->footprint(), place, true);
        });
    smoothed.error = isHit ? SmoothError::SmoothedPathInCollision : smoothed.error;
  }
  const bool isFine = smoothed.error == SmoothError::None;
  finish(RobotAction::SmoothPath, static_cast<int>(smoothed.error),
         isFine ? paths().add(std::move(smoothed.path)) : 0);
  result(RobotAction::SmoothPath).wasCompleted = smoothed.wasCompleted;
}

// ---- controlling -------------------------------------------------------------------------------

ControlCycle Nav2Servers::cycle() const {
  return {observation_->pose,
          observation_->motion,
          local_->costmap(),
          shape_,
          local_->isCurrent() && local_->updates() > 0,
          time_};
}

/// A cancelled goal ends at once, whatever the rate; then the next one may begin.
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
    takeFeedback(controllers_->update(cycle()));
  }
}

void Nav2Servers::takeFeedback(const FollowFeedback& feedback) {
  command_ = feedback.command ? feedback.command : command_;
  counts_.noValidControl +=
      feedback.isPatient || feedback.code == ControlCode::NoValidControl ? 1 : 0;
  counts_.progressFailures += feedback.code == ControlCode::FailedToMakeProgress ? 1 : 0;
  RobotOutcome& outcome = result(RobotAction::FollowPath);
  if (outcome.state != State::Running) {
    return;
  }
  if (feedback.status == FollowStatus::Succeeded) {
    outcome.state = State::Succeeded;
  } else if (feedback.status == FollowStatus::Failed) {
    outcome.state = State::Failed;
    outcome.errorCode = static_cast<int>(feedback.code);
  } else if (feedback.status == FollowStatus::Canceled) {
    outcome.state = State::Cancelled;
  }
}

// ---- what nodes ask ----------------------------------------------------------------------------

double Nav2Servers::speed() const {
  const BodyTwist mean = odometry_.mean();
  return std::sqrt(mean.linear * mean.linear + mean.lateral * mean.lateral);
}

bool Nav2Servers::isPathValid(PathId id, int maxCost, bool unknownBlocks) const {
  const Path& path = paths().get(id);
  const base::Vec2 robot = observation_->pose.position;
  const CostmapFootprint& footprint = global_->footprint();
  const Costmap& costmap = global_->costmap();
  const auto nearest =
      std::min_element(path.begin(), path.end(), [&](const base::Pose2& a, const base::Pose2& b) {
        return (a.position - robot).squaredNorm() < (b.position - robot).squaredNorm();
      });
  const auto isBlocked = [&](const base::Pose2& place) {
    const std::uint8_t cost = footprint.isRadius ? placeCost(costmap, place.position)
                                                 : footprintCost(costmap, footprint.corners, place);
    if (cost == kNoInformation) {
      return unknownBlocks;
    }
    return cost == kLethal || (footprint.isRadius && cost == kInscribed) || cost >= maxCost;
  };
  return !path.empty() && std::none_of(nearest, path.end(), isBlocked);
}

bool Nav2Servers::clear(const ClearRequest& request) {
  LayeredCostmap& costmap = request.isLocal ? *local_ : *global_;
  ++counts_.clears;
  std::string names = request.plugins;
  std::replace(names.begin(), names.end(), ';', ',');
  std::vector<std::string> plugins;
  for (const std::string& name : base::split(names, ',')) {
    if (!base::trimmed(name).empty()) {
      plugins.push_back(base::trimmed(name));
    }
  }
  using Extent = ClearRequest::Extent;
  if (request.extent == Extent::Entire) {
    costmap.clearEntirely();
    return true;
  }
  const base::Vec2 place = request.pose ? request.pose->position : observation_->pose.position;
  return request.extent == Extent::Except ? costmap.clearExcept(place, request.distance, plugins)
                                          : costmap.clearAround(place, request.distance, plugins);
}

}  // namespace bt
