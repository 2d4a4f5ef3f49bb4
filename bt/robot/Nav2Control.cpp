#include <utility>

#include "bt/robot/Nav2Servers.h"

// Cycles of the controller server.
namespace bt {
namespace {

using namespace sim2d::nav2;  // NOLINT: this file only concerns Nav2
using State = RobotOutcome::State;

}  // namespace

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
