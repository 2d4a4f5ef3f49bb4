#include "sim2d/nav/nav2/control/ControllerServer.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace sim2d::nav2 {
namespace {

/// The plugin of that name; without a name the only one. Null: none.
template <class T>
T* findPlugin(const ControllerServer::Named<T>& all, const std::string& name) {
  if (name.empty() && all.size() == 1) {
    return all.begin()->second.get();
  }
  const auto found = all.find(name);
  return found == all.end() ? nullptr : found->second.get();
}

}  // namespace

ControllerServer::ControllerServer(Setup setup)
    : parameters_(std::move(setup.parameters)),
      distro_(setup.distro),
      controllers_(std::move(setup.controllers)),
      goalCheckers_(std::move(setup.goalCheckers)),
      progressCheckers_(std::move(setup.progressCheckers)),
      pathHandlers_(std::move(setup.pathHandlers)) {}

void ControllerServer::follow(FollowPathGoal goal) {
  pending_ = std::move(goal);
  isCancelRequested_ = isCancelRequested_ && isRunning();
}

void ControllerServer::setSpeedLimit(double limit, bool isPercentage) {
  for (const auto& each : controllers_) {
    each.second->setSpeedLimit(limit, isPercentage);
  }
}

FollowFeedback ControllerServer::update(const ControlCycle& cycle) {
  FollowFeedback feedback;
  if (status_ != FollowStatus::Running) {
    if (!pending_) {
      return feedback;
    }
    status_ = FollowStatus::Running;
    waitsSince_.reset();
    const FollowPathGoal goal = *std::exchange(pending_, std::nullopt);
    if (!acceptGoal(goal, true, cycle.time, feedback)) {
      return feedback;
    }
  }
  feedback.status = FollowStatus::Running;
  if (isCancelRequested_ && (distro_ == Distro::Humble || controller_->cancel())) {
    pending_.reset();
    end(FollowStatus::Canceled, feedback);
    return feedback;
  }
  if (waitsForCostmap(cycle, feedback)) {
    return feedback;
  }
  if (pending_) {
    const FollowPathGoal goal = *std::exchange(pending_, std::nullopt);
    if (!acceptGoal(goal, false, cycle.time, feedback)) {
      return feedback;
    }
  }
  advance(cycle, feedback);
  return feedback;
}

/// Takes over a goal's path and plugins. Returns false on failure.
bool ControllerServer::acceptGoal(const FollowPathGoal& goal, bool isFirst, double time,
                                  FollowFeedback& feedback) {
  Controller* controller = findPlugin(controllers_, goal.controller);
  GoalChecker* goalChecker = findPlugin(goalCheckers_, goal.goalChecker);
  ProgressChecker* progressChecker = findPlugin(progressCheckers_, goal.progressChecker);
  PathHandler* handler = findPlugin(pathHandlers_, goal.pathHandler);
  if (controller == nullptr) {
    fail(ControllerError::InvalidController, "Failed to find controller name: " + goal.controller,
         feedback);
  } else if (goalChecker == nullptr) {
    fail(ControllerError::Unknown, "Failed to find goal checker name: " + goal.goalChecker,
         feedback);
  } else if (progressChecker == nullptr) {
    fail(ControllerError::Unknown, "Failed to find progress checker name: " + goal.progressChecker,
         feedback);
  } else if (distro_ >= Distro::Lyrical && handler == nullptr) {
    fail(ControllerError::Unknown, "Failed to find path handler name: " + goal.pathHandler,
         feedback);
  } else if (goal.path.empty()) {
    fail(ControllerError::InvalidPath, "Path is empty.", feedback);
  } else {
    const bool isOtherChecker = progressChecker != progressChecker_;
    controller_ = controller;
    goalChecker_ = goalChecker;
    progressChecker_ = progressChecker;
    pathHandler_ = handler;
    controller_->setPlan(goal.path);
    if (pathHandler_ != nullptr) {
      pathHandler_->setPlan(goal.path);
    }
    goal_ = goal.path.back();
    goalChecker_->reset();
    if (isFirst || isOtherChecker) {
      progressChecker_->reset();
    }
    lastValid_ = isFirst ? time : lastValid_;
    return true;
  }
  return false;
}

/// After a clear, no command is computed until the next update. Returns true if the cycle ends.
bool ControllerServer::waitsForCostmap(const ControlCycle& cycle, FollowFeedback& feedback) {
  if (cycle.isCostmapCurrent) {
    waitsSince_.reset();
    return false;
  }
  waitsSince_ = waitsSince_.value_or(cycle.time);
  if (distro_ != Distro::Humble && cycle.time - *waitsSince_ > parameters_.costmapUpdateTimeout) {
    fail(ControllerError::ControllerTimedOut, "Costmap timed out waiting for update", feedback);
  }
  return true;
}

void ControllerServer::advance(const ControlCycle& cycle, FollowFeedback& feedback) {
  const BodyTwist speed = thresholded(cycle.speed);
  LocalPlan local;
  const Path* cut = nullptr;
  double length = 0.0;
  if (distro_ >= Distro::Lyrical) {
    local = pathHandler_->localPlan(cycle.robot, cycle.costmap, cycle.planFrame);
    if (local.problem != nullptr) {
      fail(ControllerError::InvalidPath, local.problem, feedback);
      return;
    }
    cut = &local.poses;
    length = pathLength(local.poses);
  }
  if (distro_ != Distro::Humble && isGoalReached(cycle, speed, length, cut)) {
    end(FollowStatus::Succeeded, feedback);
    return;
  }
  if (!progressChecker_->check(cycle.robot, cycle.time)) {
    fail(ControllerError::FailedToMakeProgress, "Failed to make progress", feedback);
    return;
  }
  command(cycle, speed, cut, feedback);
  if (distro_ == Distro::Humble && status_ == FollowStatus::Running &&
      isGoalReached(cycle, speed, length, cut)) {
    end(FollowStatus::Succeeded, feedback);
  }
}

bool ControllerServer::isGoalReached(const ControlCycle& cycle, const BodyTwist& speed,
                                     double length, const Path* local) {
  return goalChecker_->isGoalReached(
      {cycle.robot, toParent(cycle.planFrame, goal_), speed, length, local});
}

void ControllerServer::command(const ControlCycle& cycle, const BodyTwist& speed, const Path* local,
                               FollowFeedback& feedback) {
  const ControlInput input{cycle.robot,   speed,      cycle.costmap, cycle.shape,
                           *goalChecker_, cycle.time, local,         cycle.planFrame};
  ControlResult control = controller_->computeVelocityCommands(input);
  if (control) {
    lastValid_ = cycle.time;
    feedback.command = control.twist;
    return;
  }
  handleFailure(std::move(control), cycle.time, feedback);
}

/// Patience: sends zero until valid commands have been missing for too long. Since Jazzy, failures
/// other than NoValidControl end the goal immediately; Humble does not distinguish failures.
void ControllerServer::handleFailure(ControlResult control, double time, FollowFeedback& feedback) {
  const double tolerance = parameters_.failureTolerance;
  const bool isBearable =
      distro_ == Distro::Humble || control.code == ControllerError::NoValidControl;
  const bool isForEver = tolerance == -1.0;
  if (!isBearable || !(tolerance > 0.0 || isForEver)) {
    fail(control.code, std::move(control.words), feedback);
  } else if (!isForEver && time - lastValid_ > tolerance) {
    fail(ControllerError::PatienceExceeded, "Controller patience exceeded", feedback);
  } else {
    feedback.command = BodyTwist();
    feedback.words = std::move(control.words);
    feedback.isFailureTolerated = true;
  }
}

void ControllerServer::fail(ControllerError code, std::string words, FollowFeedback& feedback) {
  end(FollowStatus::Failed, feedback);
  feedback.code = code;
  feedback.words = std::move(words);
}

void ControllerServer::end(FollowStatus status, FollowFeedback& feedback) {
  status_ = FollowStatus::Idle;
  isCancelRequested_ = false;
  feedback.status = status;
  if (parameters_.publishesZeroVelocity) {
    feedback.command = BodyTwist();
  }
  if (distro_ != Distro::Humble) {
    for (const auto& each : controllers_) {
      each.second->reset();
    }
  }
}

BodyTwist ControllerServer::thresholded(const BodyTwist& speed) const {
  const auto above = [](double v, double threshold) { return std::abs(v) > threshold ? v : 0.0; };
  return {above(speed.linear, parameters_.minXVelocity),
          above(speed.angular, parameters_.minThetaVelocity),
          above(speed.lateral, parameters_.minYVelocity)};
}

}  // namespace sim2d::nav2
