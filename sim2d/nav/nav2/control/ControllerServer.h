#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/control/Controller.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/GoalChecker.h"
#include "sim2d/nav/nav2/control/PathHandler.h"
#include "sim2d/nav/nav2/control/ProgressChecker.h"

namespace sim2d::nav2 {

/// Keys of the node controller_server itself.
struct ControllerServerParameters {
  double frequency = 20.0;                           // controller_frequency [Hz]
  double minXVelocity = 1e-4;                        // slower counts as 0 [m/s]
  double minYVelocity = 1e-4;                        // [m/s]
  double minThetaVelocity = 1e-4;                    // [rad/s]
  double failureTolerance = 0.0;                     // [s]; 0: none, -1: for ever
  double costmapUpdateTimeout = 0.3;                 // [s], since Jazzy; Humble waits for ever
  bool publishesZeroVelocity = true;                 // at the end of a goal
  std::string progressChecker = "progress_checker";  // Humble: progress_checker_plugin
  std::vector<std::string> progressCheckers = {"progress_checker"};
  std::vector<std::string> goalCheckers = {"goal_checker"};
  std::vector<std::string> controllers = {"FollowPath"};
  std::vector<std::string> pathHandlers = {"PathHandler"};  // main
};
const std::vector<Nav2Key<ControllerServerParameters>>& controllerServerKeys();
const std::vector<IdleKey>& controllerServerIdleKeys();
/// All keys of the node, those of its plugins below their names.
Nav2Keys controllerServerNodeKeys(const Nav2Block& given, Distro distro);

/// What the action FollowPath asks for. An empty name will do where there is one alone.
struct FollowPathGoal {
  Path path;
  std::string controller, goalChecker, progressChecker, pathHandler;
};

/// What the server looks at in a cycle.
struct ControlCycle {
  Pose2 robot;
  BodyTwist speed;  // measured
  const Costmap& costmap;
  const ControlledShape& shape;
  bool isCostmapCurrent = true;  // false after a clear, until the next update
  double time = 0.0;             // [s]
  Pose2 planFrame{};             // the frame of plans in that of robot and costmap
};

enum class FollowStatus : std::uint8_t { Idle, Running, Succeeded, Failed, Canceled };

/// What came of a cycle.
struct FollowFeedback {
  FollowStatus status = FollowStatus::Idle;
  std::optional<BodyTwist> command;      // what is published; none: nothing, the last one holds
  ControlCode code = ControlCode::None;  // why it failed; Humble has the words alone
  std::string words;                     // of a failure, or of one that is borne in patience
  bool isPatient = false;                // zero was sent for want of a valid command
};

/// nav2_controller::ControllerServer: follows paths until the goal checker is content. One goal at
/// a time; who calls `update` at its frequency is its loop. Thread: one at a time.
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

  /// A goal; while one is followed the new path replaces the old one without a stop, at the next
  /// cycle.
  void follow(FollowPathGoal goal);
  /// Asks the goal to end; the next cycles do.
  void cancel() { isCancelRequested_ = isRunning() || pending_.has_value(); }
  FollowFeedback update(const ControlCycle& cycle);

  bool isRunning() const { return status_ == FollowStatus::Running; }
  const ControllerServerParameters& parameters() const { return parameters_; }
  /// Of every controller, as the topic speed_limit: 0 lifts it.
  void setSpeedLimit(double limit, bool isPercentage);
  /// The controller that drives or drove last, for display; null before the first goal.
  Controller* controller() const { return controller_; }

 private:
  bool accept(const FollowPathGoal& goal, bool isFirst, double time, FollowFeedback& feedback);
  bool waitsForCostmap(const ControlCycle& cycle, FollowFeedback& feedback);
  bool isGoalReached(const ControlCycle& cycle, const BodyTwist& speed, double length,
                     const Path* local);
  void command(const ControlCycle& cycle, const BodyTwist& speed, const Path* local,
               FollowFeedback& feedback);
  void bear(Control control, double time, FollowFeedback& feedback);
  void advance(const ControlCycle& cycle, FollowFeedback& feedback);
  void fail(ControlCode code, std::string words, FollowFeedback& feedback);
  void end(FollowStatus status, FollowFeedback& feedback);
  BodyTwist thresholded(const BodyTwist& speed) const;

  ControllerServerParameters parameters_;
  Distro distro_;
  Named<Controller> controllers_;
  Named<GoalChecker> goalCheckers_;
  Named<ProgressChecker> progressCheckers_;
  Named<PathHandler> pathHandlers_;
  Controller* controller_ = nullptr;  // those in use
  GoalChecker* goalChecker_ = nullptr;
  ProgressChecker* progressChecker_ = nullptr;
  PathHandler* pathHandler_ = nullptr;
  FollowStatus status_ = FollowStatus::Idle;
  std::optional<FollowPathGoal> pending_;
  bool isCancelRequested_ = false;
  Pose2 goal_;                        // end of the path
  double lastValid_ = 0.0;            // time of the last valid command [s]
  std::optional<double> waitsSince_;  // for the costmap [s]
};

/// The server with its plugins. `node`: what is given for controller_server, keys of plugins below
/// their names; every problem at once. `seed`, `robotId`: of controllers that draw.
base::Result<std::unique_ptr<ControllerServer>> makeControllerServer(const Nav2Block& node,
                                                                     Distro distro,
                                                                     std::uint64_t seed = 1,
                                                                     int robotId = -1);

}  // namespace sim2d::nav2
