#include "bt/robot/Nav2DriveServers.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "bt/robot/FirstPlugins.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"

namespace bt {
namespace {

using namespace sim2d::nav2;  // NOLINT: this file only concerns Nav2
using sim2d::BodyTwist;
using sim2d::TrackedBody;
using State = RobotOutcome::State;

constexpr double kReplanPeriod = 1.0;  // [s], as in Nav2's default tree
constexpr int kMostFailures = 6;       // of plans and drives to a staging pose, as in Nav2

RobotRequest followRequest(const Nav2Parameters& parameters, PathId path) {
  RobotRequest request;
  request.path = path;
  request.server = firstOf(parameters, "controller_plugins", "FollowPath");
  request.goalChecker = firstOf(parameters, "goal_checker_plugins", "goal_checker");
  return request;
}

/// The body that a frame or topic names: "anna", "3", "/anna/pose". Empty: none.
std::optional<int> namedBody(const std::string& text,
                             const std::vector<std::pair<std::string, int>>& names) {
  for (const std::string& part : base::split(text, '/')) {
    for (const auto& [name, id] : names) {
      if (part == name) {
        return id;
      }
    }
    if (const auto number = base::parseInt(part)) {
      return static_cast<int>(*number);
    }
  }
  return std::nullopt;
}

std::size_t placeOf(RobotAction action) {
  const auto& all = Nav2Servers::behaviorActions();
  return static_cast<std::size_t>(std::find(all.begin(), all.end(), action) - all.begin());
}

}  // namespace

bool Nav2Servers::Docking::handles(RobotAction action) {
  return std::find(kActions.begin(), kActions.end(), action) != kActions.end();
}

Nav2Servers::Docking::Docking(Nav2Servers& servers)
    : servers_(servers),
      docking_(servers.parameters().dockingServer, servers.distro(), servers.setup_.docks),
      following_(servers.parameters().followingServer, servers.distro()) {}

void Nav2Servers::Docking::begin(RobotAction action, const RobotRequest& request) {
  docking_.cancel();
  following_.cancel();
  endStaging();
  if (running_ && *running_ != action && servers_.result(*running_).state == State::Running) {
    servers_.result(*running_).state = State::Cancelled;
  }
  running_ = action;
  held_.reset();
  const double time = servers_.time_;
  if (action == RobotAction::DockRobot) {
    DockGoal goal = request.dock;
    const Path& pose = servers_.paths().get(request.path);
    goal.pose = pose.empty() ? Pose2() : pose.front();
    docking_.dock(goal, time);
  } else if (action == RobotAction::UndockRobot) {
    docking_.undock({request.dock.type, request.timeAllowance}, time);
  } else {
    object_ = request.object;
    track_.reset();
    following_.follow({request.timeAllowance, object_.frame.empty()}, time);
  }
}

void Nav2Servers::Docking::cancel(RobotAction action) {
  if (running_ != action) {
    return;
  }
  docking_.cancel();
  following_.cancel();
  endStaging();
  running_.reset();
  held_ = BodyTwist();  // published once
}

DockControllerInput Nav2Servers::Docking::view() const {
  return {servers_.observation_->pose, servers_.observation_->motion, servers_.local_->costmap(),
          servers_.local_->footprint(), servers_.localFrame()};
}

std::optional<BodyTwist> Nav2Servers::Docking::drive() {
  if (!running_) {
    return std::exchange(held_, std::nullopt);
  }
  if (*running_ == RobotAction::FollowObject) {
    driveFollowing();
  } else {
    driveDocking();
  }
  return running_ ? held_ : std::exchange(held_, std::nullopt);
}

void Nav2Servers::Docking::driveDocking() {
  const StagingDrive staging = stagingPose_ ? stage(*stagingPose_) : StagingDrive::None;
  const double frequency = docking_.parameters().controllerFrequency;
  if (!servers_.isDue(frequency)) {
    return;
  }
  const sim2d::Observation& seen = *servers_.observation_;
  const DockingStep step = docking_.update(
      {seen.time, std::max(seen.dt, 1.0 / frequency), view(), seen.docks, seen.battery, staging});
  if (step.staging) {
    stagingPose_ = step.staging;
    held_.reset();
  } else {
    endStaging();
    held_ = step.twist ? step.twist : held_;
  }
  if (!step.event.empty()) {
    events_.push_back(step.event);
  }
  if (step.status == ServerStatus::Running) {
    return;
  }
  RobotOutcome& outcome = end(step.status, static_cast<int>(docking_.code()), docking_.message());
  outcome.retries = docking_.retries();
}

RobotOutcome& Nav2Servers::Docking::end(ServerStatus status, int errorCode,
                                        const std::string& text) {
  const RobotAction action = *std::exchange(running_, std::nullopt);
  RobotOutcome& outcome = servers_.result(action);
  outcome.state = status == ServerStatus::Succeeded ? State::Succeeded : State::Failed;
  outcome.errorCode = errorCode;
  outcome.errorText = text;
  if (outcome.state == State::Failed) {
    servers_.noteFailure(action, errorCode);
  }
  return outcome;
}

// Drive to the staging pose

void Nav2Servers::Docking::planStaging() {
  RobotRequest request;
  request.path = staging_.goal;
  const auto& planners = servers_.parameters().planners;
  request.server = planners.empty() ? std::string() : planners.front().first;
  servers_.begin(RobotAction::ComputePath, request);
  staging_.isPlanning = true;
  staging_.plannedAt = servers_.time_;
}

StagingDrive Nav2Servers::Docking::stage(const Pose2& pose) {
  if (!staging_.isOn) {
    staging_ = {};
    staging_.isOn = true;
    staging_.goal = servers_.paths().add({pose});
    planStaging();
    return StagingDrive::Running;
  }
  if (staging_.isPlanning) {
    const RobotOutcome plan = servers_.outcome(RobotAction::ComputePath);
    staging_.isPlanning = plan.state == State::Running;
    staging_.failures += plan.state == State::Failed ? 1 : 0;
    if (plan.state == State::Succeeded) {
      servers_.begin(RobotAction::FollowPath, followRequest(servers_.parameters(), plan.path));
      staging_.isFollowing = true;
    }
  }
  if (staging_.isFollowing) {
    const RobotOutcome drive = servers_.outcome(RobotAction::FollowPath);
    if (drive.state == State::Succeeded) {
      return StagingDrive::Arrived;
    }
    if (drive.state != State::Running) {
      staging_.isFollowing = false;
      ++staging_.failures;
      servers_.clear({true, ClearRequest::Extent::Entire, 1.0, std::nullopt, {}});
    }
  }
  if (staging_.failures > kMostFailures) {
    return StagingDrive::Failed;
  }
  if (!staging_.isPlanning && servers_.time_ - staging_.plannedAt >= kReplanPeriod) {
    planStaging();
  }
  return StagingDrive::Running;
}

void Nav2Servers::Docking::endStaging() {
  stagingPose_.reset();
  if (std::exchange(staging_.isOn, false)) {
    servers_.cancel(RobotAction::ComputePath);
    servers_.cancel(RobotAction::FollowPath);
  }
}

// Following

/// The named body, otherwise the person that was nearest at the first detection.
const TrackedBody* Nav2Servers::Docking::tracked() const {
  const std::vector<TrackedBody>& bodies = servers_.observation_->bodies;
  const auto named =
      namedBody(object_.frame.empty() ? object_.topic : object_.frame, servers_.setup_.names);
  const std::optional<int> wanted = named ? named : track_;
  const TrackedBody* const found =
      wanted ? base::findBy(bodies, &TrackedBody::id, *wanted) : nullptr;
  if (named || found != nullptr) {
    return found;
  }
  const Vec2 robot = servers_.observation_->pose.position;
  const TrackedBody* nearest = nullptr;
  for (const TrackedBody& body : bodies) {
    const bool isNearer = nearest == nullptr || (body.position - robot).squaredNorm() <
                                                    (nearest->position - robot).squaredNorm();
    nearest = body.kind == sim2d::BodyKind::Person && isNearer ? &body : nearest;
  }
  return nearest;
}

std::optional<Pose2> Nav2Servers::Docking::object() {
  const TrackedBody* const body = tracked();
  if (body == nullptr) {
    return std::nullopt;
  }
  track_ = body->id;
  return Pose2{body->position, body->heading};
}

void Nav2Servers::Docking::driveFollowing() {
  const double frequency = following_.parameters().controllerFrequency;
  if (!servers_.isDue(frequency)) {
    return;
  }
  const sim2d::Observation& seen = *servers_.observation_;
  const FollowingStep step =
      following_.update({seen.time, std::max(seen.dt, 1.0 / frequency), view(), object()});
  held_ = step.twist ? step.twist : held_;
  if (step.status == ServerStatus::Running) {
    return;
  }
  RobotOutcome& outcome =
      end(step.status, static_cast<int>(following_.code()), following_.message());
  outcome.duration = following_.elapsedTime();
}

// Behaviours, velocity smoother and collision monitor

const std::array<RobotAction, 5>& Nav2Servers::behaviorActions() {
  return MotionServers::kActions;
}

bool Nav2Servers::MotionServers::handles(RobotAction action) {
  return placeOf(action) < kActions.size();
}

Nav2Servers::MotionServers::MotionServers(const Nav2Parameters& parameters,
                                          const Polygon& footprint)
    : distro_(parameters.distro),
      isThere_{parameters.behaviors.hasSpin, parameters.behaviors.hasBackUp,
               parameters.behaviors.hasDriveOnHeading, parameters.behaviors.hasWait,
               parameters.behaviors.hasAssistedTeleop},
      behaviors_(parameters.behaviors.server, parameters.behaviors.backUp,
                 parameters.behaviors.driveOnHeading),
      smoother_(parameters.velocitySmoother) {
  if (parameters.collisionMonitor) {
    monitor_.emplace(*parameters.collisionMonitor, footprint, parameters.distro);
  }
}

bool Nav2Servers::MotionServers::begin(RobotAction action, const RobotRequest& request,
                                       const Step& step) {
  if (!isThere_[placeOf(action)]) {
    return false;
  }
  const base::Pose2 pose = step.observation.pose;
  switch (action) {
    case RobotAction::Spin:
      behaviors_.spin({request.amount, request.timeAllowance}, step.time, pose);
      break;
    case RobotAction::BackUp:
      behaviors_.backUp({request.amount, request.speed, request.timeAllowance}, step.time, pose);
      break;
    case RobotAction::DriveOnHeading:
      behaviors_.driveOnHeading({request.amount, request.speed, request.timeAllowance}, step.time,
                                pose);
      break;
    case RobotAction::AssistedTeleop:
      behaviors_.assistedTeleop(request.timeAllowance, step.time);
      teleop_ = {};
      break;
    default:
      behaviors_.wait(request.amount, step.time);
  }
  running_ = action;
  ignoresCollisions_ = request.ignoresCollisions;
  outcome_.reset();
  return true;
}

void Nav2Servers::MotionServers::cancel(RobotAction action) {
  if (running_ == action) {
    behaviors_.cancel();
    running_.reset();
    direct_.reset();
    stops_ = true;
  }
}

std::optional<RobotOutcome> Nav2Servers::MotionServers::takeOutcome(RobotAction action) {
  return ended_ == action ? std::exchange(outcome_, std::nullopt) : std::nullopt;
}

/// Updates the running behaviour: its twist and its outcome.
void Nav2Servers::MotionServers::runBehavior(const Step& step, std::optional<BodyTwist>& command) {
  teleop_ = step.observation.teleop.value_or(teleop_);
  const std::optional<BehaviorStep> done =
      behaviors_.update({step.time, step.observation.pose, step.local.published(),
                         step.local.footprint().corners, !ignoresCollisions_, teleop_});
  if (!done || !running_) {
    return;
  }
  if (done->hasTwist && distro_ == Distro::Humble) {
    direct_ = done->twist;
  } else if (done->hasTwist) {
    command = done->twist;
  }
  if (done->status == BehaviorStatus::Running) {
    return;
  }
  const bool isFine = done->status == BehaviorStatus::Succeeded;
  RobotOutcome outcome;
  outcome.state = isFine ? State::Succeeded : State::Failed;
  outcome.errorCode = isFine ? 0 : behaviors_.code();
  outcome.errorText = done->words;
  outcome_ = outcome;
  ended_ = *std::exchange(running_, std::nullopt);
  direct_.reset();
  command = command ? command : std::optional<BodyTwist>(BodyTwist());
}

void Nav2Servers::enableCollisionMonitor(bool isOn) {
  motionServers_->enableCollisionMonitor(isOn);
}

BodyTwist Nav2Servers::MotionServers::drive(const Step& step, std::optional<BodyTwist> command) {
  if (std::exchange(stops_, false) && !command) {
    command = BodyTwist();
  }
  runBehavior(step, command);
  if (command) {
    smoother_.command(*command, step.time);
  }
  sent_ = smoother_.update(step.time, step.observation.motion).value_or(sent_);
  const BodyTwist wanted = direct_.value_or(sent_);
  return monitor_ && isMonitored_ ? monitor_->filter(wanted, step.inOdom).twist : wanted;
}

}  // namespace bt
