#include "bt/robot/Nav2Servers.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bt/robot/FirstPlugins.h"
#include "bt/robot/Nav2DriveServers.h"
#include "sim2d/base/Math.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/DriveKinematics.h"
#include "sim2d/nav/Observation.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

namespace bt {
namespace {

using sim2d::BodyTwist;
using namespace sim2d::nav2;  // NOLINT: this file only concerns Nav2
using State = RobotOutcome::State;

constexpr double kLidarHeight = 0.2;    // [m]; not part of the scenario
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

RobotFootprint shapeOf(const LayeredCostmap& costmap) {
  RobotFootprint shape;
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
    result.push_back(withFilePosition(parameters, base::withContext(node, problem)));
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
    smoothers_[name] = smoother;
  }
  motionServers_ = std::make_unique<MotionServers>(parameters, local_->footprint().corners);
  routes_ = std::make_unique<RouteServer>(parameters.route, setup_.graph);
  docking_ = std::make_unique<Docking>(*this);
  return problems;
}

// Step

bool Nav2Servers::isDue(double frequency) const {
  return timeBefore_ < 0.0 ||
         sim2d::eventIndexAt(time_, frequency) > sim2d::eventIndexAt(timeBefore_, frequency);
}

/// Delays a scan by the configured number of steps.
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
  processPlanRequest(RobotAction::ComputePath);
  processPlanRequest(RobotAction::ComputePathThroughPoses);
  processSmoothRequest();
  control();
  const std::optional<BodyTwist> docking = docking_->drive();
  const BodyTwist driven = motionServers_->drive({inLocal(), *inOdom_, *local_, time_}, command_);
  const BodyTwist wanted = docking.value_or(driven);
  for (const RobotAction action : MotionServers::kActions) {
    if (const auto outcome = motionServers_->takeOutcome(action)) {
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
  counts_.limitedCommands += isCut ? 1 : 0;
  return sent;
}

BodyTwist Nav2Servers::delayed(const BodyTwist& command) {
  delayedCommands_.push_back(command);
  if (static_cast<double>(delayedCommands_.size()) <= setup_.latencies.command) {
    return {};
  }
  const BodyTwist arrived = delayedCommands_.front();
  delayedCommands_.pop_front();
  return arrived;
}

void Nav2Servers::restart() {
  endNavigation();
  routes_->cancel();
  for (PendingRequest& each : pending_) {
    each.isWaiting = false;
  }
  if (controllers_->isRunning()) {
    cancel(RobotAction::FollowPath);
  }
  nextFollow_.reset();
  for (const RobotAction action : MotionServers::kActions) {
    motionServers_->cancel(action);
  }
  for (const RobotAction action : Docking::kActions) {
    docking_->cancel(action);
  }
  hasPlanned_ = false;
  lastFailure_.reset();
}

bool Nav2Servers::usesTeleop() const {
  return motionServers_->isRunning(RobotAction::AssistedTeleop);
}

std::vector<std::string> Nav2Servers::takeDockEvents() {
  return docking_->takeEvents();
}

// Actions

void Nav2Servers::begin(RobotAction action, const RobotRequest& asked) {
  const RobotRequest request = setup_.parameters.usesFirstPlugins
                                   ? withFirstPlugins(setup_.parameters, action, asked)
                                   : asked;
  if (isNavigation(action)) {
    beginNavigation(action, request);
    return;
  }
  result(action) = {};
  if (action == RobotAction::FollowPath) {
    const Path& path = paths().get(request.path);
    FollowPathGoal goal{path, request.server, request.goalChecker, request.progressChecker,
                        request.pathHandler};
    displayedPath_ = path;
    tracking_.index = 0;
    controllerName_ = request.server;
    if (isCancelling_) {
      nextFollow_ = std::move(goal);
    } else {
      controllers_->follow(std::move(goal));
    }
    return;
  }
  if (Docking::handles(action)) {
    docking_->begin(action, request);
    return;
  }
  if (MotionServers::handles(action)) {
    if (!motionServers_->begin(action, request, {inLocal(), *inOdom_, *local_, time_})) {
      result(action).state = State::Failed;
      result(action).errorText = "behavior_plugins has no such behavior";
      noteFailure(action, 0);
    }
    return;
  }
  pendingRequest(action) = {request, step_, true, -1.0};
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
  pendingRequest(action).isWaiting = false;
  if (errorCode != 0) {
    noteFailure(action, errorCode);
  }
}

void Nav2Servers::noteFailure(RobotAction action, int errorCode) {
  lastFailure_ = ActionFailure{action, errorCode};
  failureStep_ = step_;
  counts_.planFailures += isPlannerFailure(*lastFailure_) ? 1 : 0;
  ++(isPlannerFailure(*lastFailure_)
         ? counts_.planReasons
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
  } else if (Docking::handles(action)) {
    docking_->cancel(action);
  } else if (MotionServers::handles(action)) {
    motionServers_->cancel(action);
  } else if (action == RobotAction::ComputeAndTrackRoute) {
    routes_->cancel();
  }
  pendingRequest(action).isWaiting = false;
  if (result(action).state == State::Running) {
    result(action).state = State::Cancelled;
  }
}

// Queries of tree nodes that are answered immediately.
namespace {

Path::const_iterator nearestPose(const Path& path, const base::Vec2& place) {
  return std::min_element(
      path.begin(), path.end(), [&](const base::Pose2& a, const base::Pose2& b) {
        return (a.position - place).squaredNorm() < (b.position - place).squaredNorm();
      });
}

/// The cells of a layer; of the costmap itself for an empty name. Null: it has no such layer.
const Costmap* gridOf(const LayeredCostmap& costmap, const std::string& layer) {
  if (layer.empty()) {
    return &costmap.costmap();
  }
  const CostmapLayer* const found = costmap.layer(layer);
  return found != nullptr ? found->grid() : nullptr;
}

/// Whether a pose of this cost blocks a path; a robot of a radius also where it touches.
bool isBlocked(const PathCheck& check, std::uint8_t cost, bool isRadius) {
  if (cost == kNoInformation) {
    return check.unknownBlocks;
  }
  return cost == kLethal || (isRadius && cost == kInscribed) || cost >= check.maxCost;
}

}  // namespace

base::Pose2 Nav2Servers::poseIn(const std::string& frame) const {
  const FrameNames& frames = setup_.parameters.frames;
  const bool isOdom = bareName(frame) == frames.odom && frames.odom != frames.map;
  return isOdom ? inOdom_->pose : observation_->pose;
}

double Nav2Servers::speed() const {
  const BodyTwist mean = odometry_.mean();
  return std::sqrt(mean.linear * mean.linear + mean.lateral * mean.lateral);
}

std::optional<std::uint8_t> Nav2Servers::costAt(bool isLocal, const base::Pose2& pose,
                                                bool usesFootprint) const {
  const LayeredCostmap& costmap = isLocal ? *local_ : *global_;
  const auto cell = costmap.costmap().worldToCell(pose.position);
  if (!cell) {
    return std::nullopt;
  }
  return usesFootprint ? footprintCost(costmap.costmap(), costmap.footprint().corners, pose)
                       : costmap.costmap().at(*cell);
}

PathCheckResult Nav2Servers::checkPath(const PathCheck& check) const {
  const Path& path = paths().get(check.path);
  const Costmap* const costmap = gridOf(*global_, check.layer);
  const base::Result<Polygon> given = check.footprint.empty()
                                          ? base::Result<Polygon>(global_->footprint().corners)
                                          : readPolygon(check.footprint);
  if (path.empty() || costmap == nullptr || !given) {
    return {};
  }
  const bool isRadius = global_->footprint().isRadius && check.footprint.empty();
  PathCheckResult result;
  const auto nearest = nearestPose(path, observation_->pose.position);
  double distance = 0.0;  // [m] from the nearest pose
  for (auto pose = nearest; pose != path.end(); ++pose) {
    distance += pose == nearest ? 0.0 : (pose->position - (pose - 1)->position).norm();
    if (check.lookahead >= 0.0 && distance > check.lookahead) {
      break;
    }
    const std::uint8_t cost =
        isRadius ? pointCost(*costmap, pose->position) : footprintCost(*costmap, *given, *pose);
    if (isBlocked(check, cost, isRadius)) {
      result.collisions.push_back(*pose);
      if (check.stopsAtFirst) {
        break;
      }
    }
  }
  result.isValid = result.collisions.empty();
  return result;
}

bool Nav2Servers::relocalize() {
  asksRelocalization_ = asksRelocalization_ || observation_->canRelocalize;
  return observation_->canRelocalize;
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
    return costmap.clearEntirely(plugins);
  }
  const base::Pose2 inMap = request.pose.value_or(observation_->pose);
  const base::Vec2 place = (request.isLocal ? sim2d::toFrame(localFrame(), inMap) : inMap).position;
  return request.extent == Extent::Except ? costmap.clearExcept(place, request.distance, plugins)
                                          : costmap.clearAround(place, request.distance, plugins);
}

}  // namespace bt
