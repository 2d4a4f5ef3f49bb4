#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim2d/nav/nav2/docking/DockingServer.h"

/// Nav2's following_server (opennav_following), which keeps a robot at a distance from a moving
/// object. Like DockingServer it has no clock and publishes nothing.
namespace sim2d::nav2 {

/// Error codes of the action FollowObject.
enum class FollowError : std::uint16_t {
  None = 0,
  FailedToDetectObject = 1002,
  FailedToControl = 1003,
  Unknown = 1999
};

struct FollowGoal {
  double maxDuration = 0.0;  // [s]; 0: until cancelled
  bool isDetected = true;    // by a pose topic, with filtering; else by a frame
};

struct FollowingInput {
  double time = 0.0, dt = 0.05;  // [s]
  DockControllerInput view;
  std::optional<Pose2> object;  // pose if detected in this cycle
};

struct FollowingStep {
  ServerStatus status = ServerStatus::Idle;
  std::optional<BodyTwist> twist;  // none: nothing is published
};

class FollowingServer {
 public:
  FollowingServer(const FollowingServerParameters& parameters, Distro distro)
      : parameters_(parameters), controller_(parameters, distro) {}

  void follow(const FollowGoal& goal, double time);
  /// The caller must stop the robot.
  void cancel() { isRunning_ = false; }
  bool isRunning() const { return isRunning_; }
  FollowingStep update(const FollowingInput& input);

  // Results of the last action.
  FollowError code() const { return code_; }
  const std::string& message() const { return message_; }
  double elapsedTime() const { return elapsed_; }  // [s]
  const FollowingServerParameters& parameters() const { return parameters_; }

  /// The pose at `distance` from the object on the line to the robot, with the object's heading.
  static Pose2 poseAtDistance(const Pose2& object, const Vec2& robot, double distance);

 private:
  bool detect(const FollowingInput& input);
  FollowingStep drive(const FollowingInput& input);
  FollowingStep search(const FollowingInput& input);
  FollowingStep handleLoss(const FollowingInput& input, FollowError code, std::string message);
  FollowingStep end(ServerStatus status, FollowError code, std::string message);

  FollowingServerParameters parameters_;
  DockController controller_;
  FollowGoal goal_;
  bool isRunning_ = false, isSearching_ = false;
  double startTime_ = 0.0;             // [s]
  double elapsed_ = 0.0;               // [s]
  std::optional<Pose2> object_;        // last detected pose
  double lastDetection_ = 0.0;         // [s]; the start before the first detection
  std::optional<double> staticSince_;  // [s], robot and object have not moved
  double searchStart_ = 0.0;           // [s]
  double searchStartHeading_ = 0.0;    // [rad], robot heading at the start of the search
  int searchSide_ = 0;                 // search direction: 0 left, 1 right
  int retries_ = 0;
  FollowError code_ = FollowError::None;
  std::string message_;
};

}  // namespace sim2d::nav2
