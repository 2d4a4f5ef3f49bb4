#include "sim2d/nav/nav2/docking/DockingServer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/control/ControllerUtils.h"
#include "sim2d/nav/nav2/control/GracefulController.h"

namespace sim2d::nav2 {
namespace {

constexpr double kBeyondDock = 0.25;    // [m], approach target behind the dock's pose
constexpr double kAtTarget = 0.01;      // [m], end of a simulation
constexpr double kDetectionGate = 1.0;  // [m], ignores detections farther from the dock

Pose2 ahead(const Pose2& pose, double distance) {
  return {pose.position + distance * Vec2(base::cos(pose.heading), base::sin(pose.heading)),
          pose.heading};
}

Pose2 reversed(const Pose2& pose) {
  return {pose.position, base::wrapToPi(pose.heading + base::kPi)};
}

DockingStep running(std::optional<BodyTwist> twist = std::nullopt) {
  return {ServerStatus::Running, twist, std::nullopt, {}};
}

/// The first plugin of a kind; adds the class with its defaults if there is none.
std::string findOrAddPlugin(bool isCharging, std::vector<DockPluginParameters>& plugins) {
  const auto found = std::find_if(
      plugins.begin(), plugins.end(),
      [isCharging](const DockPluginParameters& each) { return each.isCharger == isCharging; });
  if (found != plugins.end()) {
    return found->name;
  }
  DockPluginParameters plugin;
  plugin.name = isCharging ? "simple_charging_dock" : "simple_non_charging_dock";
  plugin.isCharger = isCharging;
  plugins.push_back(plugin);
  return plugin.name;
}

/// The element of that name; null: none.
template <class Named>
const Named* findNamed(const std::vector<Named>& all, const std::string& name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Named& each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

BodyTwist DockController::command(const DockControllerInput& view, const Pose2& target,
                                  bool isBackward) const {
  return gracefulCommand(parameters_, distro_, target, view.pose, isBackward);
}

bool DockController::isFree(const DockControllerInput& view, const Pose2& target, bool isDocking,
                            bool isBackward) const {
  if (!parameters_.usesCollisionDetection) {
    return true;
  }
  const double dt = parameters_.simulationTimeStep;
  const auto most = static_cast<int>(std::ceil(parameters_.projectionTime / dt));
  const Vec2 exemptPoint = isDocking ? target.position : view.pose.position;
  Pose2 pose = view.pose;
  for (int i = 0; i < most; ++i) {
    const BodyTwist twist = gracefulCommand(parameters_, distro_, target, pose, isBackward);
    pose.position += twist.linear * dt * Vec2(base::cos(pose.heading), base::sin(pose.heading));
    pose.heading = base::wrapToPi(pose.heading + twist.angular * dt);
    const bool isTested = (pose.position - exemptPoint).norm() > parameters_.dockCollisionThreshold;
    const Pose2 inCostmap = toFrame(view.costmapFrame, pose);
    if (isTested && footprintCost(view.costmap, view.footprint.corners, inCostmap) == kLethal) {
      return false;
    }
    if ((target.position - pose.position).norm() <= kAtTarget) {
      break;
    }
  }
  return true;
}

BodyTwist DockController::rotation(double angle, double turnRate, double dt) const {
  return {0.0, rotationVelocity({parameters_.rotationSpeed, parameters_.rotationAcceleration},
                                angle, turnRate, dt)};
}

DockingServer::DockingServer(DockingServerParameters parameters, Distro distro,
                             const std::vector<DockPose>& known)
    : parameters_(std::move(parameters)),
      distro_(distro),
      controller_(parameters_, distro),
      plugins_(parameters_.plugins),
      docks_(parameters_.instances) {
  for (const DockPose& place : known) {
    if (findNamed(docks_, place.name) == nullptr) {
      docks_.push_back(
          {place.name, findOrAddPlugin(place.isCharging, plugins_), "map", place.pose});
    }
  }
  if (plugins_.empty()) {
    findOrAddPlugin(true, plugins_);
  }
}

Pose2 DockingServer::stagingPose(const DockPluginParameters& plugin, const Pose2& pose) {
  const Pose2 place = ahead(pose, plugin.stagingXOffset);
  return {place.position, base::wrapToPi(pose.heading + plugin.stagingYawOffset)};
}

Pose2 DockingServer::filtered(const Pose2& estimate, const Pose2& measured, double coef) {
  const double turn = base::wrapToPi(measured.heading - estimate.heading);
  return {estimate.position + coef * (measured.position - estimate.position),
          base::wrapToPi(estimate.heading + coef * turn)};
}

const DockPluginParameters* DockingServer::pluginOf(const std::string& type) const {
  if (type.empty() && plugins_.size() == 1) {
    return &plugins_.front();
  }
  return findNamed(plugins_, type);
}

/// Jazzy has one direction for all docks; Kilted still accepts that key; later each class has its
/// own.
bool DockingServer::isBackward() const {
  if (distro_ <= Distro::Jazzy || (distro_ == Distro::Kilted && parameters_.hasDockBackwards)) {
    return parameters_.dockBackwards;
  }
  return plugin_->isBackward();
}

void DockingServer::enterPhase(Phase phase, double time) {
  phase_ = phase;
  phaseStart_ = time;
}

void DockingServer::dock(const DockGoal& goal, double time) {
  goal_ = goal;
  isDockedByAction_ = false;
  begin(&DockingServer::prepareDocking, time);
}

void DockingServer::undock(const UndockGoal& goal, double time) {
  undock_ = goal;
  begin(&DockingServer::prepareUndocking, time);
}

void DockingServer::begin(Phase phase, double time) {
  code_ = DockError::None;
  message_.clear();
  retries_ = 0;
  enterPhase(phase, time);
}

DockingStep DockingServer::update(const DockingInput& input) {
  return phase_ == nullptr ? DockingStep() : (this->*phase_)(input);
}

// ---- dock detection

bool DockingServer::isDocked(const DockingInput& input) const {
  return (input.view.pose.position - dockPose_.position).norm() < plugin_->dockingThreshold;
}

bool DockingServer::isCharging(const DockingInput& input) const {
  if (!plugin_->usesBatteryStatus || !input.battery) {
    return isDocked(input);
  }
  return input.battery->current > plugin_->chargingThreshold;
}

bool DockingServer::isConnected(const DockingInput& input) const {
  return isDocked(input) || (plugin_->isCharger && isCharging(input));
}

/// Returns false if the dock is not detected. Without detection its known pose is used.
bool DockingServer::refineDockPose(const DockingInput& input) {
  if (!plugin_->usesDetection) {
    return true;
  }
  const DockPose* nearest = nullptr;
  double least = kDetectionGate;
  for (const DockPose& place : input.seen) {
    const double distance = (place.pose.position - dockPose_.position).norm();
    if (distance <= least) {
      least = distance;
      nearest = &place;
    }
  }
  if (nearest == nullptr) {
    return detectedAt_ && input.time - *detectedAt_ <= plugin_->detectionTimeout;
  }
  const bool isNew = !detectedAt_ || input.time - *detectedAt_ > plugin_->detectionTimeout;
  dockPose_ = isNew ? nearest->pose : filtered(dockPose_, nearest->pose, plugin_->filterCoef);
  detectedAt_ = input.time;
  return true;
}

// ---- docking -----------------------------------------------------------------------------------

DockingStep DockingServer::prepareDocking(const DockingInput& input) {
  if (goal_.usesDockId) {
    const DockInstance* const found = findNamed(docks_, goal_.dockId);
    if (found == nullptr) {
      return fail(DockError::DockNotInDb, "Dock ID '" + goal_.dockId + "' is not in the database!");
    }
    dock_ = *found;
  } else {
    dock_ = {"", goal_.type, "map", goal_.pose};
  }
  plugin_ = pluginOf(dock_.type);
  if (plugin_ == nullptr) {
    return fail(DockError::DockNotValid, "Dock type '" + dock_.type + "' is not valid!");
  }
  dockPose_ = dock_.pose;
  detectedAt_.reset();
  staging_ = stagingPose(*plugin_, dock_.pose);
  if (isConnected(input)) {
    return succeed("docked");
  }
  const double distance = (input.view.pose.position - staging_.position).norm();
  if (!goal_.navigatesToStaging || distance < parameters_.dockPrestagingTolerance) {
    enterPhase(&DockingServer::perceive, input.time);
    return perceive(input);
  }
  enterPhase(&DockingServer::navigateToStaging, input.time);
  return continueToStaging();
}

DockingStep DockingServer::navigateToStaging(const DockingInput& input) {
  if (input.staging == StagingDrive::Failed || input.staging == StagingDrive::None) {
    return fail(DockError::FailedToStage, "Failed to reach the staging pose");
  }
  if (input.staging == StagingDrive::Arrived) {
    enterPhase(&DockingServer::perceive, input.time);
    return running(BodyTwist());
  }
  if (elapsed(input) > goal_.maxStagingTime) {
    return fail(DockError::FailedToStage, "Navigation to the staging pose timed out");
  }
  return continueToStaging();
}

DockingStep DockingServer::perceive(const DockingInput& input) {
  if (refineDockPose(input)) {
    enterPhase(rotatesToDock() ? &DockingServer::rotate : &DockingServer::approach, input.time);
    return running(BodyTwist());
  }
  if (elapsed(input) > parameters_.initialPerceptionTimeout) {
    return fail(DockError::FailedToDetectDock, "Failed initial dock detection");
  }
  return running();
}

std::optional<DockingStep> DockingServer::turnTo(const DockingInput& input, double heading) {
  const double angle = base::wrapToPi(heading - input.view.pose.heading);
  if (std::fabs(angle) < parameters_.rotationAngularTolerance) {
    return std::nullopt;
  }
  if (elapsed(input) > parameters_.rotateToDockTimeout) {
    return fail(DockError::FailedToControl, "Timed out rotating to dock");
  }
  return running(controller_.rotation(angle, input.view.motion.angular, input.dt));
}

DockingStep DockingServer::rotate(const DockingInput& input) {
  if (const auto turning = turnTo(input, dockPose_.heading + base::kPi)) {
    return *turning;
  }
  enterPhase(&DockingServer::approach, input.time);
  return running(BodyTwist());
}

DockingStep DockingServer::approach(const DockingInput& input) {
  if (isConnected(input)) {
    enterPhase(&DockingServer::waitForCharge, input.time);
    return waitForCharge(input);
  }
  // A robot facing away from the dock does not detect it.
  if (!rotatesToDock() && !refineDockPose(input)) {
    return retry(input, DockError::FailedToDetectDock, "Failed dock detection");
  }
  const bool isBackward = this->isBackward();
  Pose2 target = ahead(dockPose_, kBeyondDock);
  target = isBackward ? reversed(target) : target;
  if (!controller_.isFree(input.view, target, true, isBackward)) {
    return retry(input, DockError::FailedToControl, "Failed to get control");
  }
  if (elapsed(input) > parameters_.dockApproachTimeout) {
    return retry(input, DockError::FailedToControl,
                 "Timed out approaching dock; dock nor charging detected");
  }
  return running(controller_.command(input.view, target, isBackward));
}

DockingStep DockingServer::waitForCharge(const DockingInput& input) {
  if (!plugin_->isCharger || isCharging(input)) {
    isDockedByAction_ = true;
    return succeed("docked");
  }
  if (elapsed(input) > parameters_.waitChargeTimeout) {
    return retry(input, DockError::FailedToCharge, "Timed out waiting for charge to start");
  }
  return running(BodyTwist());
}

std::optional<DockingStep> DockingServer::driveTo(const DockingInput& input, const Pose2& pose,
                                                  bool isBackward) {
  const Pose2& robot = input.view.pose;
  const double distance = (robot.position - pose.position).norm();
  const double turn = std::fabs(base::wrapToPi(robot.heading - pose.heading));
  if (distance < parameters_.undockLinearTolerance && turn < parameters_.undockAngularTolerance) {
    return std::nullopt;
  }
  if (!controller_.isFree(input.view, pose, false, isBackward)) {
    return fail(DockError::FailedToControl, "Failed to get control");
  }
  return running(controller_.command(input.view, pose, isBackward));
}

DockingStep DockingServer::resetApproach(const DockingInput& input) {
  const Pose2 target = rotatesToDock() ? reversed(staging_) : staging_;
  if (const auto driving = driveTo(input, target, !isBackward())) {
    const bool isLate = elapsed(input) > parameters_.dockApproachTimeout;
    return isLate ? fail(DockError::FailedToControl, "Timed out resetting dock approach")
                  : *driving;
  }
  enterPhase(&DockingServer::approach, input.time);
  return running(BodyTwist());
}

// ---- undocking ---------------------------------------------------------------------------------

/// Computes the staging pose in front of the robot's pose.
DockingStep DockingServer::prepareUndocking(const DockingInput& input) {
  const std::string type = undock_.type.empty() && isDockedByAction_ ? dock_.type : undock_.type;
  plugin_ = pluginOf(type);
  if (plugin_ == nullptr) {
    return fail(DockError::DockNotValid, "No dock information to undock from!");
  }
  if (!isDockedByAction_) {  // the robot started in the dock
    const auto nearest = std::min_element(
        docks_.begin(), docks_.end(), [&](const DockInstance& a, const DockInstance& b) {
          return (a.pose.position - input.view.pose.position).squaredNorm() <
                 (b.pose.position - input.view.pose.position).squaredNorm();
        });
    dock_ = nearest == docks_.end() ? DockInstance() : *nearest;
    dockPose_ = dock_.pose;
  }
  if (!isConnected(input)) {
    return succeed({});  // the robot is not docked
  }
  staging_ = stagingPose(*plugin_, isBackward() ? reversed(input.view.pose) : input.view.pose);
  if (rotatesToDock()) {
    staging_ = reversed(staging_);  // the robot turns after leaving
  }
  enterPhase(&DockingServer::driveOut, input.time);
  return driveOut(input);
}

DockingStep DockingServer::driveOut(const DockingInput& input) {
  if (elapsed(input) > undock_.maxUndockingTime) {
    return fail(DockError::FailedToControl, "Undocking timed out");
  }
  if (const auto driving = driveTo(input, staging_, !isBackward())) {
    return *driving;
  }
  if (rotatesToDock()) {
    enterPhase(&DockingServer::finishUndocking, input.time);
    return running(BodyTwist());
  }
  return finishUndocking(input);
}

DockingStep DockingServer::finishUndocking(const DockingInput& input) {
  if (phase_ == &DockingServer::finishUndocking) {
    if (const auto turning = turnTo(input, staging_.heading + base::kPi)) {
      return *turning;
    }
  }
  if (plugin_->isCharger && isCharging(input)) {
    return fail(DockError::FailedToControl, "Failed to control off dock, still charging");
  }
  isDockedByAction_ = false;
  return succeed("undocked");
}

// ---- results -----------------------------------------------------------------------------------

DockingStep DockingServer::fail(DockError code, std::string message) {
  code_ = code;
  message_ = std::move(message);
  phase_ = nullptr;
  return {ServerStatus::Failed, BodyTwist(), std::nullopt, {}};
}

DockingStep DockingServer::retry(const DockingInput& input, DockError code, std::string message) {
  if (++retries_ > parameters_.maxRetries) {
    return fail(code, std::move(message));
  }
  enterPhase(&DockingServer::resetApproach, input.time);
  return running(BodyTwist());
}

DockingStep DockingServer::succeed(const std::string& event) {
  phase_ = nullptr;
  const std::string name = dock_.name.empty() ? std::string() : " " + dock_.name;
  return {ServerStatus::Succeeded, BodyTwist(), std::nullopt, event.empty() ? event : event + name};
}

}  // namespace sim2d::nav2
