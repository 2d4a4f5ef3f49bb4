#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2Key.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

/// Behaviours of behavior_server (nav2_behaviors): the rules of one cycle each. They keep no clock:
/// time is handed in.
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
/// Keys of backup and drive_on_heading, below their names. 0: the speed is driven at once.
struct DriveParameters {
  double accelerationLimit = 0.0, decelerationLimit = 0.0;  // [m/s²], the latter <= 0
  double minimumSpeed = 0.0;                                // [m/s]
};
DriveParameters driveDefaults(Distro distro);  // main: 2.5, -2.5, 0.1
const std::vector<Nav2Key<BehaviorParameters>>& behaviorKeys();
const std::vector<Nav2Key<DriveParameters>>& driveKeys();
const std::vector<IdleKey>& idleBehaviorKeys();
/// Values that no behaviour can be driven by; `name`: the behaviour's.
base::Diagnostics problemsOf(const BehaviorParameters& parameters);
base::Diagnostics problemsOf(const DriveParameters& parameters, const std::string& name);

/// Codes of results since Jazzy are those of the action plus the reason: Spin 700, BackUp 710,
/// DriveOnHeading 720, AssistedTeleop 730, Wait 740.
enum class BehaviorError : std::uint8_t { None, Timeout, CollisionAhead, InvalidInput };
enum class BehaviorKind : std::uint8_t { Spin, BackUp, DriveOnHeading, AssistedTeleop, Wait };
std::uint16_t behaviorCode(BehaviorKind kind, BehaviorError error);

enum class BehaviorStatus : std::uint8_t { Running, Succeeded, Failed };
struct BehaviorStep {
  BehaviorStatus status = BehaviorStatus::Running;
  bool hasTwist = true;  // false: nothing is published (Wait)
  BodyTwist twist;       // zero once it has ended
  BehaviorError error = BehaviorError::None;
  std::string words;  // Nav2's own, when it failed
};

/// What a behaviour looks at in a cycle.
struct BehaviorInput {
  double time = 0.0;               // [s]
  Pose2 pose;                      // of the robot
  const Costmap& costmap;          // the published local one
  const Polygon& footprint;        // padded, robot frame [m]
  bool isCollisionChecked = true;  // main: not disable_collision_checks
};
/// Whether the footprint's edges are at 254 or 255, or the pose is off the map.
bool isBehaviorBlocked(const BehaviorInput& input, const Pose2& pose);

/// Turns on the spot.
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
  bool isFree(const BehaviorInput& input, double omega) const;

  BehaviorParameters parameters_;
  Goal goal_;
  double start_;                   // [s]
  double heading_, turned_ = 0.0;  // of the last cycle; since the start [rad]
};

/// Drives straight ahead (DriveOnHeading) or backwards (BackUp).
class DriveStraight {
 public:
  struct Goal {
    double distance = 0.15;       // [m]; below 0: backwards
    double speed = 0.025;         // [m/s], of the same sign
    double timeAllowance = 10.0;  // [s]; 0: none
  };
  /// Of BackUp: both by their absolute values, driven backwards.
  static Goal backUp(const Goal& goal);

  DriveStraight(const BehaviorParameters& parameters, const DriveParameters& drive,
                const Goal& goal, double time, const Pose2& pose);
  BehaviorStep cycle(const BehaviorInput& input);
  double driven() const { return driven_; }  // [m], for feedback

 private:
  double speedFor(double left) const;
  bool isFree(const BehaviorInput& input, double speed, double left) const;

  BehaviorParameters parameters_;
  DriveParameters drive_;
  Goal goal_;
  double start_;         // [s]
  Vec2 from_;            // [m]
  double driven_ = 0.0;  // [m]
  double speed_ = 0.0;   // commanded last [m/s]
};

/// Stands for a time; publishes nothing.
class Wait {
 public:
  Wait(double duration, double time) : end_(time + duration) {}
  BehaviorStep cycle(const BehaviorInput& input) const;

 private:
  double end_;  // [s]
};

/// Slows down what a teleoperator wants before it touches something.
class AssistedTeleop {
 public:
  AssistedTeleop(const BehaviorParameters& parameters, double timeAllowance, double time)
      : parameters_(parameters), timeAllowance_(timeAllowance), start_(time) {}
  BehaviorStep cycle(const BehaviorInput& input, const BodyTwist& wish) const;

 private:
  BehaviorParameters parameters_;
  double timeAllowance_, start_;  // [s]
};

}  // namespace sim2d::nav2
