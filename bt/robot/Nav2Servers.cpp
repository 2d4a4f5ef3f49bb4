#include "bt/robot/Nav2Servers.h"

#include <cmath>
#include <utility>

#include "bt/robot/Nav2Docking.h"
#include "bt/robot/Nav2Motions.h"
#include "sim2d/base/Math.h"
#include "sim2d/nav/Motion.h"
#include "sim2d/nav/SensedWorld.h"

namespace bt {
namespace {

using sim2d::BodyTwist;
using namespace sim2d::nav2;  // NOLINT: this file is about nothing else
using State = RobotOutcome::State;

constexpr double kLidarHeight = 0.2;    // [m]; scenarios do not tell
constexpr double kCutTolerance = 1e-9;  // [m/s], [rad/s]

sim2d::nav2::CostmapSetup costmapSetup(const CostmapSettings& settings,
                                       const Nav2Servers::Setup& setup, const FilterMasks& masks) {
  CostmapSetup result;
  result.masks = masks;
  result.settings = settings;
  result.map = setup.map;
  result.lidarHeight = kLidarHeight;
  result.distro = setup.parameters.distro;
  return result;
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

bool isNavigation(RobotAction action) {
  return action == RobotAction::NavigateToPose || action == RobotAction::NavigateThroughPoses;
}

base::Diagnostics placed(const Nav2Parameters& parameters, const std::string& node,
                         const base::Diagnostics& problems) {
  base::Diagnostics result;
  for (const base::Diagnostic& problem : problems) {
    result.push_back(placedInFile(parameters, base::within(node, problem)));
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

base::Diagnostics Nav2Servers::costmapProblems(const Setup& setup) {
  const Nav2Parameters& parameters = setup.parameters;
  base::Diagnostics problems =
      placed(parameters, "local_costmap",
             problemsOf(costmapSetup(parameters.localCostmap, setup, setup.localMasks)));
  base::append(
      problems,
      placed(parameters, "global_costmap",
             problemsOf(costmapSetup(parameters.globalCostmap, setup, setup.globalMasks))));
  return problems;
}

base::Diagnostics Nav2Servers::build() {
  base::Diagnostics problems = costmapProblems(setup_);
  const Nav2Parameters& parameters = setup_.parameters;
  const CostmapSetup local = costmapSetup(parameters.localCostmap, setup_, setup_.localMasks);
  const CostmapSetup global = costmapSetup(parameters.globalCostmap, setup_, setup_.globalMasks);
  base::Result<std::unique_ptr<ControllerServer>> controllers = makeControllerServer(
      parameters.controllerServer, parameters.distro, setup_.seed, setup_.robotId);
  base::append(problems, placed(parameters, "controller_server", controllers.diagnostics()));
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
  routes_ = std::make_unique<RouteServer>(parameters.route, setup_.graph);
  docking_ = std::make_unique<Docking>(*this);
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
  const double speed = observation.motion.linear;
  acceleration_ = (speed - speedBefore_.value_or(speed)) / observation.dt;
  speedBefore_ = speed;
  inOdom_ = &odomObservation_.of(sensed_);
  local_->update(inLocal());
  if (observation.isLocalized) {
    global_->update(sensed_);
  }
  applySpeedLimit();
}

BodyTwist Nav2Servers::act() {
  navigate();
  route();
  planIfAsked(RobotAction::ComputePath);
  planIfAsked(RobotAction::ComputePathThroughPoses);
  smoothIfAsked();
  control();
  const std::optional<BodyTwist> docking = docking_->drive();
  const BodyTwist driven = motions_->drive({inLocal(), *inOdom_, *local_, time_}, command_);
  const BodyTwist wanted = docking.value_or(driven);
  for (const RobotAction action : Motions::kActions) {
    if (const auto outcome = motions_->takeOutcome(action)) {
      result(action) = *outcome;
      if (outcome->state == State::Failed) {
        noteFailure(action, outcome->errorCode);
      }
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
  endNavigation();
  routes_->cancel();
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
  for (const RobotAction action : Docking::kActions) {
    docking_->cancel(action);
  }
  hasPlanned_ = false;
  lastFailure_.reset();
}

bool Nav2Servers::wantsTeleop() const {
  return motions_->isRunning(RobotAction::AssistedTeleop);
}

std::vector<std::string> Nav2Servers::takeDockEvents() {
  return docking_->takeEvents();
}

// ---- actions --------------------------------------------------------------------

void Nav2Servers::begin(RobotAction action, const RobotRequest& request) {
  if (isNavigation(action)) {
    beginNavigation(action, request);
    return;
  }
  result(action) = {};
  if (action == RobotAction::FollowPath) {
    const Path& path = paths().get(request.path);
    FollowPathGoal goal{path, request.server, request.goalChecker, request.progressChecker,
                        request.pathHandler};
    shownPath_ = path;
    tracking_.index = 0;
    controllerName_ = request.server;
    if (isCancelling_) {
      nextFollow_ = std::move(goal);
    } else {
      controllers_->follow(std::move(goal));
    }
    return;
  }
  if (Docking::isOne(action)) {
    docking_->begin(action, request);
    return;
  }
  if (Motions::isOne(action)) {
    if (!motions_->begin(action, request, {inLocal(), *inOdom_, *local_, time_})) {
      result(action).state = State::Failed;
      result(action).errorText = "behavior_plugins has no such behavior";
      noteFailure(action, 0);
    }
    return;
  }
  asked(action) = {request, step_, true, -1.0};
}

RobotOutcome Nav2Servers::outcome(RobotAction action) const {
  if (isNavigation(action) && !isNavigating_) {
    return navigated_;
  }
  return results_[static_cast<std::size_t>(action)];
}

void Nav2Servers::finish(RobotAction action, int errorCode, PathId path, const std::string& text) {
  RobotOutcome& outcome = result(action);
  outcome.state = errorCode == 0 ? State::Succeeded : State::Failed;
  outcome.errorCode = errorCode;
  outcome.errorText = text;
  outcome.path = path;
  asked(action).isWaiting = false;
  if (errorCode != 0) {
    noteFailure(action, errorCode);
  }
}

void Nav2Servers::noteFailure(RobotAction action, int errorCode) {
  lastFailure_ = ActionFailure{action, errorCode};
  failureStep_ = step_;
  counts_.planFailures += isOfPlanner(*lastFailure_) ? 1 : 0;
  ++(isOfPlanner(*lastFailure_) ? counts_.planReasons
                                : counts_.actionReasons)[failureReason(*lastFailure_, distro())];
}

void Nav2Servers::cancel(RobotAction action) {
  if (isNavigation(action)) {
    if (!isNavigating_) {
      endNavigation();
    }
    return;
  }
  if (action == RobotAction::FollowPath) {
    nextFollow_.reset();
    if (result(action).state == State::Running) {
      controllers_->cancel();
      isCancelling_ = true;
    }
  } else if (Docking::isOne(action)) {
    docking_->cancel(action);
  } else if (Motions::isOne(action)) {
    motions_->cancel(action);
  } else if (action == RobotAction::ComputeAndTrackRoute) {
    routes_->cancel();
  }
  asked(action).isWaiting = false;
  if (result(action).state == State::Running) {
    result(action).state = State::Cancelled;
  }
}

}  // namespace bt
