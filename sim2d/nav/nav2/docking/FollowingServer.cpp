#include "sim2d/nav/nav2/docking/FollowingServer.h"

#include <cmath>
#include <utility>

#include "sim2d/base/Math.h"

namespace sim2d::nav2 {
namespace {

constexpr double kBeyondTarget = 0.25;  // [m], control target behind the kept pose
constexpr double kSameObject = 1e-6;    // [m]

}  // namespace

void FollowingServer::follow(const FollowGoal& goal, double time) {
  goal_ = goal;
  isRunning_ = true;
  isSearching_ = false;
  startTime_ = lastDetection_ = time;
  elapsed_ = 0.0;
  object_.reset();
  staticSince_.reset();
  retries_ = 0;
  code_ = FollowError::None;
  message_.clear();
}

Pose2 FollowingServer::poseAtDistance(const Pose2& object, const Vec2& robot, double distance) {
  const Vec2 line = object.position - robot;
  const double length = line.norm();
  return length < kSameObject ? object
                              : Pose2{object.position - distance / length * line, object.heading};
}

/// Returns false if the last detection is too old.
bool FollowingServer::detect(const FollowingInput& input) {
  if (input.object) {
    const bool isFresh = object_ && input.time - lastDetection_ <= parameters_.detectionTimeout;
    object_ = goal_.isDetected && isFresh
                  ? DockingServer::filtered(*object_, *input.object, parameters_.filterCoef)
                  : *input.object;
    lastDetection_ = input.time;
  }
  return object_ && input.time - lastDetection_ <= parameters_.detectionTimeout;
}

FollowingStep FollowingServer::update(const FollowingInput& input) {
  if (!isRunning_) {
    return {};
  }
  elapsed_ = input.time - startTime_;
  if (goal_.maxDuration > 0.0 && elapsed_ > goal_.maxDuration) {
    return end(ServerStatus::Succeeded, FollowError::None, {});
  }
  if (detect(input)) {
    isSearching_ = false;
    return drive(input);
  }
  if (isSearching_) {
    return search(input);
  }
  const bool isEarly = !object_ && input.time - lastDetection_ <= parameters_.detectionTimeout;
  return isEarly ? FollowingStep{ServerStatus::Running, BodyTwist()}
                 : handleLoss(input, FollowError::FailedToDetectObject, "Failed to detect object");
}

FollowingStep FollowingServer::drive(const FollowingInput& input) {
  const Pose2& robot = input.view.pose;
  const Vec2 line = object_->position - robot.position;
  Pose2 object = *object_;
  if (parameters_.skipOrientation) {
    object.heading = base::atan2(line.y(), line.x());
  }
  const double turn = base::wrapToPi(object.heading - robot.heading);
  const double excess = line.norm() - parameters_.desiredDistance;
  const bool faces = std::fabs(turn) < parameters_.angularTolerance;
  if (excess < parameters_.linearTolerance) {  // does not back up when closer
    staticSince_ = staticSince_.value_or(input.time);
    const bool isOver = parameters_.staticObjectTimeout > 0.0 &&
                        input.time - *staticSince_ > parameters_.staticObjectTimeout;
    if (faces && isOver) {
      return end(ServerStatus::Succeeded, FollowError::None, {});
    }
    const BodyTwist turning = controller_.rotation(turn, input.view.motion.angular, input.dt);
    return {ServerStatus::Running, faces ? BodyTwist() : turning};
  }
  staticSince_.reset();
  const Pose2 target =
      poseAtDistance(object, robot.position, parameters_.desiredDistance - kBeyondTarget);
  if (!controller_.isFree(input.view, target, true, false)) {
    return handleLoss(input, FollowError::FailedToControl, "Failed to get control");
  }
  return {ServerStatus::Running, controller_.command(input.view, target, false)};
}

/// Rotates to the left by the search angle, then to the right beyond the initial heading.
FollowingStep FollowingServer::search(const FollowingInput& input) {
  if (input.time - searchStart_ > parameters_.rotateToObjectTimeout) {
    isSearching_ = false;
    return handleLoss(input, FollowError::FailedToDetectObject, "Timed out rotating to object");
  }
  const double turned = base::wrapToPi(input.view.pose.heading - searchStartHeading_);
  const double turn = (searchSide_ == 0 ? 1.0 : -1.0) * parameters_.searchAngle - turned;
  if (std::fabs(turn) < parameters_.angularTolerance) {
    searchSide_ = 1 - searchSide_;
  }
  return {ServerStatus::Running, controller_.rotation(turn, input.view.motion.angular, input.dt)};
}

/// Starts another attempt while retries are left: a search, or a wait for `detection_timeout`.
FollowingStep FollowingServer::handleLoss(const FollowingInput& input, FollowError code,
                                          std::string message) {
  if (++retries_ > parameters_.maxRetries) {
    return end(ServerStatus::Failed, code, std::move(message));
  }
  isSearching_ = parameters_.searchByRotating && code == FollowError::FailedToDetectObject;
  searchStart_ = input.time;
  searchStartHeading_ = input.view.pose.heading;
  searchSide_ = 0;
  if (!isSearching_ && code == FollowError::FailedToDetectObject) {
    object_.reset();
    lastDetection_ = input.time;
  }
  return {ServerStatus::Running, BodyTwist()};
}

FollowingStep FollowingServer::end(ServerStatus status, FollowError code, std::string message) {
  isRunning_ = false;
  code_ = code;
  message_ = std::move(message);
  return {status, BodyTwist()};
}

}  // namespace sim2d::nav2
