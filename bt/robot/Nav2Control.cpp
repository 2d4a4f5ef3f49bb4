#include <utility>

#include "bt/robot/Nav2Servers.h"

// What the controller server does in its cycles.
namespace bt {
namespace {

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else
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
    watchController();
    takeFeedback(controllers_->update(cycle()));
    trackPath();
  }
}

/// As the controller server does since Lyrical, on the path that was given last. It looks for the
/// nearest segment from the last one on, within two metres.
void Nav2Servers::trackPath() {
  constexpr double kWindow = 2.0;  // [m], search_window
  if (!controllers_->isRunning() || shownPath_.empty()) {
    return;
  }
  const int number = tracking_.number + 1;
  tracking_ = trackingError(shownPath_, observation_->pose, tracking_.index, kWindow);
  tracking_.number = number;
}

/// Its ways cost time; the first cycle of a robot has none.
void Nav2Servers::watchController() {
  if (Controller* const controller = controllers_->controller()) {
    controller->watch(watchesWays_);
  }
}

/// Of the costmap whose filters spoke last; states of binary filters for the manifest.
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
    outcome.errorText = feedback.words;
    noteFailure(RobotAction::FollowPath, outcome.errorCode);
  } else if (feedback.status == FollowStatus::Canceled) {
    outcome.state = State::Cancelled;
  }
}

}  // namespace bt
