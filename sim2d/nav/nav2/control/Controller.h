#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/Body.h"
#include "sim2d/nav/FrameTransform.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/control/GoalChecker.h"

/// Controllers of Nav2 (nav2_core::Controller): what follows a path.
namespace sim2d::nav2 {

/// Why a controller or its server failed: codes of the action FollowPath since Jazzy. Humble has
/// the same failures without a code.
enum class ControlCode : std::uint8_t {
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
const char* controlCodeName(ControlCode code);  // "NO_VALID_CONTROL" …

/// A command, or why there is none.
struct Control {
  BodyTwist twist;  // zero when it failed
  ControlCode code = ControlCode::None;
  std::string words;  // Nav2's own, when it failed

  Control(const BodyTwist& command) : twist(command) {}  // NOLINT: meant to convert
  Control(ControlCode why, std::string text) : code(why), words(std::move(text)) {}
  explicit operator bool() const { return code == ControlCode::None; }
};

/// The robot's shape as its local costmap has it, and how that map is inflated.
struct ControlledShape {
  std::vector<Vec2> vertices;        // padded, in the robot's frame [m]
  double inscribedRadius = 0.0;      // [m]
  double circumscribedRadius = 0.0;  // [m]
  bool isRadius = true;              // given by robot_radius: the centre's cost is enough
  bool tracksUnknown = false;        // the costmap's track_unknown_space
  double costScaling = 10.0;         // of the inflation layer: cost_scaling_factor [1/m]
  double inflationRadius = 0.0;      // of the inflation layer [m]; 0: there is none
};

/// All that a controller looks at in a cycle. Robot, costmap and local plan are in the frame of the
/// local costmap, plans in that of the global one.
struct ControlInput {
  const Pose2& robot;
  const BodyTwist& speed;  // measured, below the server's thresholds 0
  const Costmap& costmap;  // the local one
  const ControlledShape& shape;
  GoalChecker& goalChecker;
  double time = 0.0;                // [s] of the simulation
  const Path* localPlan = nullptr;  // main: what the server's path handler cut; before: null
  Pose2 planFrame{};                // the frame of plans in that of the costmap

  Pose2 fromPlan(const Pose2& pose) const { return toParent(planFrame, pose); }
};

/// One summand of a trajectory's price.
struct CriticScore {
  std::string critic;
  double raw = 0.0;
  double scale = 0.0;  // 0: it was not asked
};

/// What a controller has weighed, for display.
struct WeighedTrajectory {
  std::vector<Pose2> poses;
  BodyTwist twist;
  double total = 0.0;               // sum of scale * raw
  std::vector<CriticScore> scores;  // up to where it was given up
  std::string refusal;              // why it is illegal: "BaseObstacle: Trajectory Hits Obstacle."
  bool isChosen = false;
};

/// What a controller did in the last cycle, for display.
struct ControlView {
  Path localPlan;                               // part of the path that counted
  Path predicted;                               // where it means to go
  std::vector<Vec2> lookahead;                  // carrot or target; may be empty
  std::vector<WeighedTrajectory> trajectories;  // while watched
};

/// Follows the path last set. Thread: one at a time. Equal calls in the same order give equal
/// commands, to the bit. Nothing throws.
class Controller {
 public:
  virtual ~Controller() = default;
  Controller() = default;
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;
  Controller(Controller&&) = delete;
  Controller& operator=(Controller&&) = delete;

  /// A new path from the planner; the old one is forgotten whole.
  virtual void setPlan(const Path& plan) = 0;
  virtual Control computeVelocityCommands(const ControlInput& input) = 0;
  /// `limit` [m/s], or in percent of the greatest speed; 0 lifts it.
  virtual void setSpeedLimit(double limit, bool isPercentage) = 0;
  /// Whether it is done with being cancelled; false: it brakes and is asked on.
  virtual bool cancel() { return true; }
  /// A new goal begins, or one has ended (since Jazzy).
  virtual void reset() {}

  const ControlView& view() const { return view_; }
  /// Whether `view().trajectories` is filled: display only, costs time, changes no command.
  void watch(bool isWatched) { isWatched_ = isWatched; }

 protected:
  bool isWatched() const { return isWatched_; }
  ControlView view_;

 private:
  bool isWatched_ = false;
};

}  // namespace sim2d::nav2
