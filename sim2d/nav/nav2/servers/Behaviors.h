#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

/// Behaviors of behavior_server (nav2_behaviors): the computations of one cycle each. They have no
/// clock: the caller passes the time.
namespace sim2d::nav2 {

/// Keys of behavior_server.
struct BehaviorParameters {
  double cycleFrequency = 10.0;  // [Hz]
  std::vector<std::string> behaviorPlugins = {"spin", "backup", "drive_on_heading", "wait"};
  double simulateAheadTime = 2.0;                         // [s]
  double maxRotationalVel = 1.0, minRotationalVel = 0.4;  // [rad/s]
  double rotationalAccLim = 3.2;                          // [rad/s²]
  double projectionTime = 1.0, simulationTimeStep = 0.1;  // [s], of assisted_teleop
};
/// Keys of backup and drive_on_heading, below their names. 0: no limit.
struct DriveParameters {
  double accelerationLimit = 0.0, decelerationLimit = 0.0;  // [m/s²], the latter <= 0
  double minimumSpeed = 0.0;                                // [m/s]
};
DriveParameters driveDefaults(Distro distro);  // main: 2.5, -2.5, 0.1
Nav2Keys<BehaviorParameters> behaviorKeys();
Nav2Keys<DriveParameters> driveKeys();
IgnoredKeys ignoredBehaviorKeys();
/// Errors in values for which a behavior cannot run; `name`: name of the behavior.
base::Diagnostics problemsOf(const BehaviorParameters& parameters);
base::Diagnostics problemsOf(const DriveParameters& parameters, const std::string& name);

/// Result codes since Jazzy are those of the action plus the reason: Spin 700, BackUp 710,
/// DriveOnHeading 720, AssistedTeleop 730, Wait 740.
enum class BehaviorError : std::uint8_t { None, Timeout, CollisionAhead, InvalidInput };
enum class BehaviorKind : std::uint8_t { Spin, BackUp, DriveOnHeading, AssistedTeleop, Wait };
std::uint16_t behaviorCode(BehaviorKind kind, BehaviorError error);

enum class BehaviorStatus : std::uint8_t { Running, Succeeded, Failed };
struct BehaviorStep {
  BehaviorStatus status = BehaviorStatus::Running;
  bool hasTwist = true;  // false: nothing is published (Wait)
  BodyTwist twist;       // zero after the end
  BehaviorError error = BehaviorError::None;
  std::string words;  // Nav2's message on failure
};

/// Inputs of a behavior in a cycle.
struct BehaviorInput {
  double time = 0.0;               // [s]
  Pose2 pose;                      // robot pose
  const Costmap& costmap;          // published local costmap
  const Polygon& footprint;        // padded, robot frame [m]
  bool isCollisionChecked = true;  // main: not disable_collision_checks
  BodyTwist teleop{};              // command of the teleoperator, for AssistedTeleop
};
/// Whether the cost of the footprint's edges is 254 or 255, or the pose is off the map.
bool isBehaviorBlocked(const BehaviorInput& input, const Pose2& pose);

/// Rotates in place.
class Spin {
 public:
  struct Goal {
    double angle = 1.57;          // spin_dist [rad]
    double timeAllowance = 10.0;  // [s]; 0: none
  };
  Spin(const BehaviorParameters& parameters, const Goal& goal, double time, const Pose2& pose);
  BehaviorStep cycle(const BehaviorInput& input);
  double turned() const { return turned_; }  // [rad], for feedback

 private:
  BehaviorParameters parameters_;
  Goal goal_;
  double start_;                   // [s]
  double heading_, turned_ = 0.0;  // heading in the last cycle; rotation since the start [rad]
};

/// Drives straight forward (DriveOnHeading) or backward (BackUp).
class DriveStraight {
 public:
  struct Goal {
    double distance = 0.15;       // [m]; negative: backward
    double speed = 0.025;         // [m/s], with the same sign
    double timeAllowance = 10.0;  // [s]; 0: none
  };
  /// Goal of BackUp: the absolute values of both, driven backward.
  static Goal backUp(const Goal& goal);

  DriveStraight(const BehaviorParameters& parameters, const DriveParameters& drive,
                const Goal& goal, double time, const Pose2& pose);
  BehaviorStep cycle(const BehaviorInput& input);
  double driven() const { return driven_; }  // [m], for feedback

 private:
  double speedFor(double left) const;

  BehaviorParameters parameters_;
  DriveParameters drive_;
  Goal goal_;
  double start_;         // [s]
  Vec2 from_;            // [m]
  double driven_ = 0.0;  // [m]
  double speed_ = 0.0;   // last command [m/s]
};

/// Waits for a duration; publishes nothing.
class Wait {
 public:
  Wait(double duration, double time) : end_(time + duration) {}
  BehaviorStep cycle(const BehaviorInput& input) const;

 private:
  double end_;  // [s]
};

/// Scales the teleoperator's command down before a collision.
class AssistedTeleop {
 public:
  AssistedTeleop(const BehaviorParameters& parameters, double timeAllowance, double time)
      : parameters_(parameters), timeAllowance_(timeAllowance), start_(time) {}
  BehaviorStep cycle(const BehaviorInput& input) const;

 private:
  BehaviorParameters parameters_;
  double timeAllowance_, start_;  // [s]
};

/// Runs one behavior at a time at `cycle_frequency` (nav2_behaviors::TimedBehavior): its cycles are
/// at the first steps not before start + n / frequency. Not thread-safe.
class BehaviorServer {
 public:
  BehaviorServer(const BehaviorParameters& parameters, const DriveParameters& backUp,
                 const DriveParameters& driveOnHeading)
      : parameters_(parameters), backUp_(backUp), driveOnHeading_(driveOnHeading) {}

  // Each replaces the running behavior.
  void spin(const Spin::Goal& goal, double time, const Pose2& pose);
  void backUp(const DriveStraight::Goal& goal, double time, const Pose2& pose);
  void driveOnHeading(const DriveStraight::Goal& goal, double time, const Pose2& pose);
  void wait(double duration, double time);
  void assistedTeleop(double timeAllowance, double time);
  /// The caller must stop the robot.
  void cancel() { behavior_.reset(); }
  bool isRunning() const { return behavior_.has_value(); }

  /// Called each step: returns the result of a cycle if one is due. nullopt while no behavior runs
  /// or no cycle is due; the last command then stays in effect.
  std::optional<BehaviorStep> update(const BehaviorInput& input);
  /// Error code of the last behavior.
  std::uint16_t code() const { return code_; }

 private:
  using Behavior = std::variant<Spin, DriveStraight, Wait, AssistedTeleop>;
  void start(const Behavior& behavior, BehaviorKind kind, double time);

  BehaviorParameters parameters_;
  DriveParameters backUp_, driveOnHeading_;
  std::optional<Behavior> behavior_;
  BehaviorKind kind_ = BehaviorKind::Spin;
  double start_ = 0.0;  // [s]
  std::int64_t lastCycle_ = -1;
  std::uint16_t code_ = 0;
};

/// Tasks of waypoint_follower (nav2_waypoint_follower), executed at each goal of a robot.

enum class WaypointTask : std::uint8_t { None, Wait, Photo, Input };

struct WaypointTaskParameters {
  WaypointTask kind = WaypointTask::None;
  bool enabled = true;
  int pauseDuration = 0;       // Wait [ms]
  double inputTimeout = 10.0;  // Input [s]
};

struct WaypointFollowerParameters {
  std::string taskPlugin = "wait_at_waypoint";
  WaypointTaskParameters task;  // parameters of that plugin
};

Nav2Keys<WaypointFollowerParameters> waypointFollowerKeys();
IgnoredKeys ignoredWaypointFollowerKeys();
Nav2Keys<WaypointTaskParameters> waypointTaskKeys(WaypointTask task);
IgnoredKeys ignoredWaypointTaskKeys();

/// Duration of a task at a goal [s]. There is no input source, so Input lasts until its timeout.
double waypointTaskDuration(const WaypointTaskParameters& task);

}  // namespace sim2d::nav2
