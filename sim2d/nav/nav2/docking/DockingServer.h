#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/nav/Body.h"
#include "sim2d/nav/Observation.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"
#include "sim2d/nav/nav2/docking/DockingParameters.h"

/// Nav2's docking_server (opennav_docking), which drives a robot into and out of docks. It has no
/// clock, plans no paths and publishes nothing: the caller passes time and the state of the drive
/// to the staging pose, and executes the returned commands.
namespace sim2d::nav2 {

/// Inputs of the controller: poses in the map, the costmap in its own frame.
struct DockControllerInput {
  Pose2 pose;                         // robot pose
  BodyTwist motion;                   // odometry
  const Costmap& costmap;             // local costmap
  const CostmapFootprint& footprint;  // robot frame
  Pose2 costmapFrame{};               // in the map: odom, if that is the costmap's frame
};

/// The controller of docking_server and following_server (opennav_docking::Controller).
class DockController {
 public:
  DockController(const DockControllerParameters& parameters, Distro distro)
      : parameters_(parameters), distro_(distro) {}

  /// The graceful control law towards a target.
  BodyTwist command(const DockControllerInput& view, const Pose2& target, bool isBackward) const;
  /// Whether the footprint's edges are free along the motion towards the target: simulated in steps
  /// of `simulation_time_step` until the target is within 1 cm or `projection_time` is over. Poses
  /// within `dock_collision_threshold` of the dock (docking) or of the start (undocking) are not
  /// checked. True without `use_collision_detection`.
  bool isFree(const DockControllerInput& view, const Pose2& target, bool isDocking,
              bool isBackward) const;
  /// A rotation in place by `angle` [rad] in a step `dt` [s], slow enough to stop in time: w =
  /// sqrt(2 a |angle|).
  BodyTwist rotation(double angle, double turnRate, double dt) const;

 private:
  DockControllerParameters parameters_;
  Distro distro_;
};

/// Error codes of the actions DockRobot and UndockRobot.
enum class DockError : std::uint16_t {
  None = 0,
  DockNotInDb = 901,
  DockNotValid = 902,
  FailedToStage = 903,
  FailedToDetectDock = 904,
  FailedToControl = 905,
  FailedToCharge = 906,
  Timeout = 907,
  Unknown = 999
};

struct DockGoal {
  bool usesDockId = true;  // else `pose` and `type`
  std::string dockId;
  Pose2 pose;  // of the docked robot
  std::string type;
  double maxStagingTime = 1000.0;  // [s]
  bool navigatesToStaging = true;
};
struct UndockGoal {
  std::string type;                // empty: that of the last dock
  double maxUndockingTime = 30.0;  // [s]
};

enum class ServerStatus : std::uint8_t { Idle, Running, Succeeded, Failed };
/// State of the drive to the staging pose.
enum class StagingDrive : std::uint8_t { None, Running, Arrived, Failed };

struct DockingInput {
  double time = 0.0, dt = 0.05;  // [s]
  DockControllerInput view;
  const std::vector<DockPose>& seen;    // docks detected in this cycle
  std::optional<BatteryState> battery;  // none: a docked robot counts as charged
  StagingDrive staging = StagingDrive::None;
};

/// Result of a call of `update`.
struct DockingStep {
  ServerStatus status = ServerStatus::Idle;
  std::optional<BodyTwist> twist;  // none: nothing is published
  std::optional<Pose2> staging;    // requests planner and controller to drive there
  std::string event;               // "docked home", "undocked home"; empty: none
};

/// Runs one action at a time; a new one replaces the current one. Not thread-safe.
class DockingServer {
 public:
  /// `known`: docks of the scenario. Those whose names are not among the file's docks are added
  /// with the first plugin of their kind, or the class with its defaults.
  DockingServer(DockingServerParameters parameters, Distro distro,
                const std::vector<DockPose>& known);

  void dock(const DockGoal& goal, double time);
  void undock(const UndockGoal& goal, double time);
  /// The caller must stop the robot.
  void cancel() { phase_ = nullptr; }
  bool isRunning() const { return phase_ != nullptr; }
  /// Performs a cycle; no effect without an action.
  DockingStep update(const DockingInput& input);

  // Results of the last action.
  DockError code() const { return code_; }
  const std::string& message() const { return message_; }  // Nav2's message
  int retries() const { return retries_; }
  const DockingServerParameters& parameters() const { return parameters_; }

  /// The pose at which the approach of a dock at `pose` begins.
  static Pose2 stagingPose(const DockPluginParameters& plugin, const Pose2& pose);
  /// Exponential filter of detections (PoseFilter): moves position and heading by `coef` times the
  /// difference.
  static Pose2 filtered(const Pose2& estimate, const Pose2& measured, double coef);

 private:
  /// The function that performs a cycle of a phase; null: no action.
  using Phase = DockingStep (DockingServer::*)(const DockingInput& input);

  const DockPluginParameters* pluginOf(const std::string& type) const;
  bool isBackward() const;
  bool rotatesToDock() const { return plugin_->rotatesToDock && distro_ >= Distro::Kilted; }
  bool isDocked(const DockingInput& input) const;
  bool isCharging(const DockingInput& input) const;
  bool isConnected(const DockingInput& input) const;
  bool refineDockPose(const DockingInput& input);
  void begin(Phase phase, double time);
  void enterPhase(Phase phase, double time);
  double elapsed(const DockingInput& input) const { return input.time - phaseStart_; }

  DockingStep prepareDocking(const DockingInput& input);
  DockingStep navigateToStaging(const DockingInput& input);
  DockingStep continueToStaging() const { return {ServerStatus::Running, {}, staging_, {}}; }
  DockingStep perceive(const DockingInput& input);
  DockingStep rotate(const DockingInput& input);
  DockingStep approach(const DockingInput& input);
  DockingStep waitForCharge(const DockingInput& input);
  DockingStep resetApproach(const DockingInput& input);  // to the staging pose, for a retry
  DockingStep prepareUndocking(const DockingInput& input);
  DockingStep driveOut(const DockingInput& input);
  DockingStep finishUndocking(const DockingInput& input);
  /// Drives to a pose; nullopt: it is reached.
  std::optional<DockingStep> driveTo(const DockingInput& input, const Pose2& pose, bool isBackward);
  /// Rotates in place; nullopt: complete.
  std::optional<DockingStep> turnTo(const DockingInput& input, double heading);

  DockingStep fail(DockError code, std::string message);
  /// Starts another attempt after a failed approach while retries are left, as in Nav2.
  DockingStep retry(const DockingInput& input, DockError code, std::string message);
  DockingStep succeed(const std::string& event);

  DockingServerParameters parameters_;
  Distro distro_;
  DockController controller_;
  std::vector<DockPluginParameters> plugins_;
  std::vector<DockInstance> docks_;

  Phase phase_ = nullptr;
  double phaseStart_ = 0.0;  // [s], start of the phase
  DockGoal goal_;
  UndockGoal undock_;
  DockInstance dock_;                             // of this action
  const DockPluginParameters* plugin_ = nullptr;  // its class
  Pose2 dockPose_;                                // refined by detections
  std::optional<double> detectedAt_;              // [s], last detection
  Pose2 staging_;
  bool isDockedByAction_ = false;  // docked at `dock_` by the last action
  int retries_ = 0;
  DockError code_ = DockError::None;
  std::string message_;
};

}  // namespace sim2d::nav2
