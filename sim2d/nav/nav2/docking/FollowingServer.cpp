#include "sim2d/nav/nav2/docking/FollowingServer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim2d/base/Math.h"

namespace sim2d::nav2 {
namespace {

constexpr double kBeyondTarget = 0.25;  // [m], of the target behind the pose that is kept
constexpr double kSamePlace = 1e-6;     // [m]

}  // namespace

void FollowingServer::follow(const FollowGoal& goal, double time) {
  goal_ = goal;
  isRunning_ = true;
  isSearching_ = false;
  begun_ = seenAt_ = time;
  elapsed_ = 0.0;
  object_.reset();
  standingSince_.reset();
  retries_ = 0;
  code_ = FollowError::None;
  message_.clear();
}

Pose2 FollowingServer::poseAtDistance(const Pose2& object, const Vec2& robot, double distance) {
  const Vec2 line = object.position - robot;
  const double length = line.norm();
  return length < kSamePlace ? object
                             : Pose2{object.position - distance / length * line, object.heading};
}

/// False: the object has not been seen for too long.
bool FollowingServer::detect(const FollowingInput& input) {
  if (input.object) {
    const bool isFresh = object_ && input.time - seenAt_ <= parameters_.detectionTimeout;
    object_ = goal_.isDetected && isFresh
                  ? DockingServer::filtered(*object_, *input.object, parameters_.filterCoef)
                  : *input.object;
    seenAt_ = input.time;
  }
  return object_ && input.time - seenAt_ <= parameters_.detectionTimeout;
}

FollowingStep FollowingServer::update(const FollowingInput& input) {
  if (!isRunning_) {
    return {};
  }
  elapsed_ = input.time - begun_;
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
  const bool isEarly = !object_ && input.time - seenAt_ <= parameters_.detectionTimeout;
  return isEarly ? FollowingStep{ServerStatus::Running, BodyTwist()}
                 : lose(input, FollowError::FailedToDetectObject, "Failed to detect object");
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
  if (excess < parameters_.linearTolerance) {  // near enough; nearer than that it does not back off
    standingSince_ = standingSince_.value_or(input.time);
    const bool isOver = parameters_.staticObjectTimeout > 0.0 &&
                        input.time - *standingSince_ > parameters_.staticObjectTimeout;
    if (faces && isOver) {
      return end(ServerStatus::Succeeded, FollowError::None, {});
    }
    const BodyTwist turning = controller_.rotation(turn, input.view.motion.angular, input.dt);
    return {ServerStatus::Running, faces ? BodyTwist() : turning};
  }
  standingSince_.reset();
  const Pose2 target =
      poseAtDistance(object, robot.position, parameters_.desiredDistance - kBeyondTarget);
  if (!controller_.isFree(input.view, target, true, false)) {
    return lose(input, FollowError::FailedToControl, "Failed to get control");
  }
  return {ServerStatus::Running, controller_.command(input.view, target, false)};
}

/// Turns to the left by the search angle, then to the right past the heading that it began with.
FollowingStep FollowingServer::search(const FollowingInput& input) {
  if (input.time - searchedSince_ > parameters_.rotateToObjectTimeout) {
    isSearching_ = false;
    return lose(input, FollowError::FailedToDetectObject, "Timed out rotating to object");
  }
  const double turned = base::wrapToPi(input.view.pose.heading - searchFrom_);
  const double turn = (side_ == 0 ? 1.0 : -1.0) * parameters_.searchAngle - turned;
  if (std::fabs(turn) < parameters_.angularTolerance) {
    side_ = 1 - side_;
  }
  return {ServerStatus::Running, controller_.rotation(turn, input.view.motion.angular, input.dt)};
}

/// Another attempt while there are some left: a search, or a wait for as long as a detection
/// counts.
FollowingStep FollowingServer::lose(const FollowingInput& input, FollowError code,
                                    std::string message) {
  if (++retries_ > parameters_.maxRetries) {
    return end(ServerStatus::Failed, code, std::move(message));
  }
  isSearching_ = parameters_.searchByRotating && code == FollowError::FailedToDetectObject;
  searchedSince_ = input.time;
  searchFrom_ = input.view.pose.heading;
  side_ = 0;
  if (!isSearching_ && code == FollowError::FailedToDetectObject) {
    object_.reset();
    seenAt_ = input.time;
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
