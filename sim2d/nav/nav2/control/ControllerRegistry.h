#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/control/GoalCheckers.h"

/// Controllers of Nav2 (nav2_core::Controller), which follow a path.
namespace sim2d::nav2 {

/// Why a controller or its server failed: error codes of the action FollowPath since Jazzy. Humble
/// has the same failures without codes.
enum class ControllerError : std::uint8_t {
  None = 0,
  Unknown = 100,
  InvalidController = 101,
  TfError = 102,
  InvalidPath = 103,
  PatienceExceeded = 104,
  FailedToMakeProgress = 105,
  NoValidControl = 106,
  ControllerTimedOut = 107,
};
const char* controllerErrorName(ControllerError code);  // "NO_VALID_CONTROL" …

/// A command, or why there is none.
struct ControlResult {
  BodyTwist twist;  // zero on failure
  ControllerError code = ControllerError::None;
  std::string words;  // Nav2's message on failure

  ControlResult(const BodyTwist& command) : twist(command) {}  // NOLINT: meant to convert
  ControlResult(ControllerError why, std::string text) : code(why), words(std::move(text)) {}
  explicit operator bool() const { return code == ControllerError::None; }
};

/// The robot's footprint in its local costmap, and the inflation of that costmap.
struct RobotFootprint {
  std::vector<Vec2> vertices;        // padded, robot frame [m]
  double inscribedRadius = 0.0;      // [m]
  double circumscribedRadius = 0.0;  // [m]
  bool isRadius = true;              // given by robot_radius: checking the centre's cost suffices
  bool tracksUnknown = false;        // track_unknown_space of the costmap
  double costScaling = 10.0;         // cost_scaling_factor of the inflation layer [1/m]
  double inflationRadius = 0.0;      // of the inflation layer [m]; 0: there is none
};

/// The input of a controller in one cycle. Robot, costmap and local plan are in the frame of the
/// local costmap, plans in that of the global one.
struct ControlInput {
  const Pose2& robot;
  const BodyTwist& speed;  // measured; 0 below the server's thresholds
  const Costmap& costmap;  // local costmap
  const RobotFootprint& shape;
  GoalChecker& goalChecker;
  double time = 0.0;                // simulation time [s]
  const Path* localPlan = nullptr;  // main: from the server's path handler; before: null
  Pose2 planFrame{};                // frame of plans, in the costmap frame

  Pose2 fromPlan(const Pose2& pose) const { return toParent(planFrame, pose); }
};

/// One term of a trajectory's cost.
struct CriticScore {
  std::string critic;
  double raw = 0.0;
  double scale = 0.0;  // 0: the critic was not evaluated
};

/// A trajectory that a controller has evaluated, for display.
struct EvaluatedTrajectory {
  std::vector<Pose2> poses;
  BodyTwist twist;
  double total = 0.0;               // sum of scale * raw
  std::vector<CriticScore> scores;  // until the evaluation ended
  std::string rejection;            // why it is invalid: "BaseObstacle: Trajectory Hits Obstacle."
  bool isChosen = false;
};

/// The state of a controller after the last cycle, for display.
struct ControlView {
  Path localPlan;                                 // pruned part of the path
  Path predicted;                                 // predicted trajectory
  std::vector<Vec2> lookahead;                    // carrot or target point; may be empty
  std::vector<EvaluatedTrajectory> trajectories;  // only while watched
};

/// Follows the path last set. Not thread-safe. Equal calls in the same order give bit-identical
/// commands. Does not throw.
class Controller {
 public:
  virtual ~Controller() = default;
  Controller() = default;
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;
  Controller(Controller&&) = delete;
  Controller& operator=(Controller&&) = delete;

  /// Replaces the path.
  virtual void setPlan(const Path& plan) = 0;
  virtual ControlResult computeVelocityCommands(const ControlInput& input) = 0;
  /// `limit` in [m/s], or in percent of the maximum speed; 0 removes it.
  virtual void setSpeedLimit(double limit, bool isPercentage) = 0;
  /// Returns whether cancelling is complete; false: the controller brakes and must be called again.
  virtual bool cancel() { return true; }
  /// Called when a goal begins or ends (since Jazzy).
  virtual void reset() {}

  const ControlView& view() const { return view_; }
  /// Enables `view().trajectories`, which takes time and does not affect commands.
  void watch(bool isWatched) { isWatched_ = isWatched; }

 protected:
  bool isWatched() const { return isWatched_; }
  ControlView view_;

 private:
  bool isWatched_ = false;
};

/// Data from which a controller is created.
struct ControllerSetup {
  Distro distro = Distro::Jazzy;
  double frequency = 20.0;   // controller_frequency [Hz]
  Nav2ParameterBlock block;  // values given below the controller's name
  std::string name = "FollowPath";
  std::uint64_t seed = 1;  // for controllers that use random numbers
  int robotId = -1;        // selects the random stream, together with the seed
};

/// A controller class, identified by its plugin name.
struct ControllerType {
  std::string plugin;  // "dwb_core::DWBLocalPlanner"
  /// The keys; some depend on the given values, such as those of critics on the list of critics.
  std::function<Nav2KeyTable(const Nav2ParameterBlock& given, Distro distro)> keys;
  /// Creates a controller, or returns all problems of the block: wrong types, invalid values,
  /// unknown critics.
  std::function<base::Result<std::unique_ptr<Controller>>(const ControllerSetup& setup)> make;
};

/// The classes, each of which all branches have. To add one, add it in ControllerRegistry.cpp.
ControllerType dwbController();
ControllerType gracefulController();
ControllerType mppiController();
ControllerType regulatedPurePursuit();
ControllerType rotationShim();

/// Finds a class; accepts both spellings ("a::B", "a/B"). Null: unknown.
const ControllerType* findController(const std::string& plugin);
/// Creates a controller of a class; the error for an unknown one contains the nearest name.
base::Result<std::unique_ptr<Controller>> makeController(const std::string& plugin,
                                                         const ControllerSetup& setup);
/// The names of all classes.
std::vector<std::string> controllerPlugins();

/// Error "unknown plugin" with the nearest of `known` and all of them.
base::Diagnostic unknownPlugin(const std::string& found, const std::vector<std::string>& known);

}  // namespace sim2d::nav2
