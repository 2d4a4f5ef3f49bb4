#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/GoalCheckers.h"
#include "sim2d/nav/nav2/control/PathHandler.h"

namespace sim2d::nav2 {

/// Keys of the node controller_server itself.
struct ControllerServerParameters {
  double frequency = 20.0;                           // controller_frequency [Hz]
  double minXVelocity = 1e-4;                        // lower speeds count as 0 [m/s]
  double minYVelocity = 1e-4;                        // [m/s]
  double minThetaVelocity = 1e-4;                    // [rad/s]
  double failureTolerance = 0.0;                     // [s]; 0: none, -1: unlimited
  double costmapUpdateTimeout = 0.3;                 // [s], since Jazzy; Humble waits indefinitely
  bool publishesZeroVelocity = true;                 // at the end of a goal
  std::string progressChecker = "progress_checker";  // Humble: progress_checker_plugin
  std::vector<std::string> progressCheckers = {"progress_checker"};
  std::vector<std::string> goalCheckers = {"goal_checker"};
  std::vector<std::string> controllers = {"FollowPath"};
  std::vector<std::string> pathHandlers = {"PathHandler"};  // main
};
const std::vector<Nav2Key<ControllerServerParameters>>& controllerServerKeys();
const std::vector<IgnoredKey>& ignoredControllerServerKeys();
/// All keys of the node, including those of its plugins.
Nav2KeyTable controllerServerNodeKeys(const Nav2ParameterBlock& given, Distro distro);

/// A goal of the action FollowPath. A name may be empty if there is only one plugin of the kind.
struct FollowPathGoal {
  Path path;
  std::string controller, goalChecker, progressChecker, pathHandler;
};

/// The server's input in one cycle.
struct ControlCycle {
  Pose2 robot;
  BodyTwist speed;  // measured
  const Costmap& costmap;
  const RobotFootprint& shape;
  bool isCostmapCurrent = true;  // false after a clear, until the next update
  double time = 0.0;             // [s]
  Pose2 planFrame{};             // frame of plans, in the frame of robot and costmap
};

enum class FollowStatus : std::uint8_t { Idle, Running, Succeeded, Failed, Canceled };

/// Result of a cycle.
struct FollowFeedback {
  FollowStatus status = FollowStatus::Idle;
  std::optional<BodyTwist> command;  // published command; none: the last one stays in effect
  ControllerError code = ControllerError::None;  // why it failed; Humble has only the message
  std::string words;                             // message of a failure, including a tolerated one
  bool isFailureTolerated = false;               // zero was sent because there was no valid command
};

/// nav2_controller::ControllerServer: follows paths until the goal checker reports success. One
/// goal at a time. The caller must call `update` at controller_frequency. Not thread-safe.
class ControllerServer {
 public:
  template <class T>
  using Named = std::map<std::string, std::unique_ptr<T>>;
  struct Setup {
    ControllerServerParameters parameters;
    Distro distro = Distro::Jazzy;
    Named<Controller> controllers;
    Named<GoalChecker> goalCheckers;
    Named<ProgressChecker> progressCheckers;
    Named<PathHandler> pathHandlers;  // main
  };
  explicit ControllerServer(Setup setup);

  /// Sets a goal. During an active goal the new path replaces the old one in the next cycle without
  /// stopping.
  void follow(FollowPathGoal goal);
  /// Requests cancelling, which happens in the next cycles.
  void cancel() { isCancelRequested_ = isRunning() || pending_.has_value(); }
  FollowFeedback update(const ControlCycle& cycle);

  bool isRunning() const { return status_ == FollowStatus::Running; }
  const ControllerServerParameters& parameters() const { return parameters_; }
  /// Sets the limit of all controllers, like the topic speed_limit; 0 removes it.
  void setSpeedLimit(double limit, bool isPercentage);
  /// The current or last controller, for display; null before the first goal.
  Controller* controller() const { return controller_; }

 private:
  bool acceptGoal(const FollowPathGoal& goal, bool isFirst, double time, FollowFeedback& feedback);
  bool waitsForCostmap(const ControlCycle& cycle, FollowFeedback& feedback);
  bool isGoalReached(const ControlCycle& cycle, const BodyTwist& speed, double length,
                     const Path* local);
  void command(const ControlCycle& cycle, const BodyTwist& speed, const Path* local,
               FollowFeedback& feedback);
  void handleFailure(ControlResult control, double time, FollowFeedback& feedback);
  void advance(const ControlCycle& cycle, FollowFeedback& feedback);
  void fail(ControllerError code, std::string words, FollowFeedback& feedback);
  void end(FollowStatus status, FollowFeedback& feedback);
  BodyTwist thresholded(const BodyTwist& speed) const;

  ControllerServerParameters parameters_;
  Distro distro_;
  Named<Controller> controllers_;
  Named<GoalChecker> goalCheckers_;
  Named<ProgressChecker> progressCheckers_;
  Named<PathHandler> pathHandlers_;
  Controller* controller_ = nullptr;  // plugins in use
  GoalChecker* goalChecker_ = nullptr;
  ProgressChecker* progressChecker_ = nullptr;
  PathHandler* pathHandler_ = nullptr;
  FollowStatus status_ = FollowStatus::Idle;
  std::optional<FollowPathGoal> pending_;
  bool isCancelRequested_ = false;
  Pose2 goal_;                        // end of the path
  double lastValid_ = 0.0;            // time of the last valid command [s]
  std::optional<double> waitsSince_;  // waiting for the costmap since [s]
};

/// Creates the server with its plugins, or returns all problems. `node`: values given for
/// controller_server, including the plugins' keys. `seed`, `robotId`: for controllers that use
/// random numbers.
base::Result<std::unique_ptr<ControllerServer>> makeControllerServer(const Nav2ParameterBlock& node,
                                                                     Distro distro,
                                                                     std::uint64_t seed = 1,
                                                                     int robotId = -1);

}  // namespace sim2d::nav2
