#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/nav/Observation.h"
#include "sim2d/nav/nav2/docking/DockController.h"

/// Nav2's docking_server (opennav_docking): drives a robot into docks and out of them. It keeps no
/// clock, plans no paths and publishes nothing: time and the state of the drive to the staging pose
/// are handed in, commands are handed out.
namespace sim2d::nav2 {

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
  std::string type;                // empty: of the dock that the robot drove into
  double maxUndockingTime = 30.0;  // [s]
};

enum class ServerStatus : std::uint8_t { Idle, Running, Succeeded, Failed };
/// State of the drive to the staging pose.
enum class StagingDrive : std::uint8_t { None, Running, Arrived, Failed };

struct DockingInput {
  double time = 0.0, dt = 0.05;  // [s]
  DockView view;
  const std::vector<DockPlace>& seen;   // docks that the robot detects now
  std::optional<BatteryState> battery;  // none: a docked robot counts as charged
  StagingDrive staging = StagingDrive::None;
};

/// What came of one call of `update`.
struct DockingStep {
  ServerStatus status = ServerStatus::Idle;
  std::optional<BodyTwist> twist;  // none: nothing is published
  std::optional<Pose2> staging;    // the robot is to be driven there by planner and controller
  std::string event;               // "docked home", "undocked home"; empty: nothing of the kind
};

/// One action at a time; a new one takes the place of the old one. Thread: one at a time.
class DockingServer {
 public:
  /// `known`: docks of the scenario. Those whose names the file's docks do not have are added with
  /// the first plugin for their kind, or the class with its defaults.
  DockingServer(DockingServerParameters parameters, Distro distro,
                const std::vector<DockPlace>& known);

  void dock(const DockGoal& goal, double time);
  void undock(const UndockGoal& goal, double time);
  /// The robot stops: the caller commands zero.
  void cancel() { phase_ = Phase::Idle; }
  bool isRunning() const { return phase_ != Phase::Idle; }
  /// A cycle; nothing while no action runs.
  DockingStep update(const DockingInput& input);

  // Of the action that ran last.
  DockError code() const { return code_; }
  const std::string& message() const { return message_; }  // Nav2's own words
  int retries() const { return retries_; }
  const DockingServerParameters& parameters() const { return parameters_; }

  /// Where the robot begins its approach of a dock at `pose`.
  static Pose2 stagingPose(const DockPluginParameters& plugin, const Pose2& pose);
  /// Exponential filter of detections (PoseFilter): position and heading move by `coef` of the
  /// difference.
  static Pose2 filtered(const Pose2& estimate, const Pose2& measured, double coef);

 private:
  enum class Phase : std::uint8_t {
    Idle,
    BeforeStaging,
    Staging,
    Perceiving,
    Rotating,
    Approaching,
    WaitingForCharge,
    Returning,  // to the staging pose, to try again
    BeforeUndocking,
    Undocking,
    RotatingBack
  };

  const DockPluginParameters* pluginOf(const std::string& type) const;
  bool isBackward() const;
  bool isDocked(const DockingInput& input) const;
  bool isCharging(const DockingInput& input) const;
  bool isConnected(const DockingInput& input) const;
  bool refine(const DockingInput& input);
  void enter(Phase phase, double time);
  double elapsed(const DockingInput& input) const { return input.time - since_; }

  DockingStep prepare(const DockingInput& input);
  DockingStep stage(const DockingInput& input);
  DockingStep perceive(const DockingInput& input);
  DockingStep rotate(const DockingInput& input);
  DockingStep approach(const DockingInput& input);
  DockingStep waitForCharge(const DockingInput& input);
  DockingStep goBack(const DockingInput& input);
  DockingStep prepareUndocking(const DockingInput& input);
  DockingStep leave(const DockingInput& input);
  DockingStep afterLeaving(const DockingInput& input);
  /// Towards a pose; nothing: the robot is there.
  std::optional<DockingStep> driveTo(const DockingInput& input, const Pose2& pose, bool isBackward);
  /// A turn on the spot; nothing: it is done.
  std::optional<DockingStep> turnTo(const DockingInput& input, double heading);

  DockingStep fail(DockError code, std::string message);
  /// As Nav2 does for what goes wrong in an approach: another attempt while there are some left.
  DockingStep retry(const DockingInput& input, DockError code, std::string message);
  DockingStep succeed(const std::string& event);

  DockingServerParameters parameters_;
  Distro distro_;
  DockController controller_;
  std::vector<DockPluginParameters> plugins_;
  std::vector<DockInstance> docks_;

  Phase phase_ = Phase::Idle;
  double since_ = 0.0;  // [s], when the phase began
  DockGoal goal_;
  UndockGoal undock_;
  DockInstance dock_;                             // of this action
  const DockPluginParameters* plugin_ = nullptr;  // its class
  Pose2 dockPose_;                                // as refined by detections
  std::optional<double> detectedAt_;              // [s], the last detection
  Pose2 staging_;
  bool isIn_ = false;  // in `dock_`, by the action that ended last
  int retries_ = 0;
  DockError code_ = DockError::None;
  std::string message_;
};

}  // namespace sim2d::nav2
