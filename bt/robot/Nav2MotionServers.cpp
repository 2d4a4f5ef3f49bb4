#include "bt/robot/Nav2MotionServers.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace bt {
namespace {

using sim2d::BodyTwist;
using sim2d::nav2::BehaviorStatus;
using sim2d::nav2::BehaviorStep;
using sim2d::nav2::Distro;
using sim2d::nav2::Nav2Parameters;
using State = RobotOutcome::State;

std::size_t placeOf(RobotAction action) {
  const auto& all = Nav2Servers::behaviorActions();
  return static_cast<std::size_t>(std::find(all.begin(), all.end(), action) - all.begin());
}

}  // namespace

const std::array<RobotAction, 5>& Nav2Servers::behaviorActions() {
  return MotionServers::kActions;
}

bool Nav2Servers::MotionServers::handles(RobotAction action) {
  return placeOf(action) < kActions.size();
}

Nav2Servers::MotionServers::MotionServers(const Nav2Parameters& parameters,
                                          const sim2d::nav2::Polygon& footprint)
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
                         step.local.footprint().corners, !ignoresCollisions_},
                        teleop_);
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
