#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "bt/robot/PathStore.h"
#include "sim2d/nav/nav2/Nav2Key.h"

/// What the nodes of a navigator tree ask for: Nav2's servers, without their messages.
namespace bt {

/// One server each: it does one thing at a time, a new request takes the place of the old one.
enum class RobotAction : std::uint8_t {
  ComputePath,
  ComputePathThroughPoses,
  FollowPath,
  SmoothPath,
  Spin,
  BackUp,
  DriveOnHeading,
  Wait
};
constexpr std::size_t kRobotActions = 8;

/// What a request says; which members count depends on the action.
struct RobotRequest {
  PathId path = 0;              // to follow or smooth; goals of a plan
  std::optional<PathId> start;  // of a plan; none: where the robot is
  std::string server;           // planner, controller or smoother by name; empty: the only one
  std::string goalChecker, progressChecker, pathHandler;
  double amount = 0.0;             // angle [rad], distance [m] or time [s] of a behaviour
  double speed = 0.0;              // [m/s]
  double timeAllowance = 0.0;      // [s]; also of smoothing
  bool checksCollisions = false;   // of a smoothed path
  bool ignoresCollisions = false;  // of a behaviour, in Main
};

/// What came of it.
struct RobotOutcome {
  enum class State : std::uint8_t { Running, Succeeded, Failed, Cancelled };
  State state = State::Running;
  int errorCode = 0;      // Nav2's: 0 none, 100 … controller, 200 … planner, 500 … smoother
  PathId path = 0;        // planned or smoothed
  double duration = 0.0;  // of smoothing [s]
  bool wasCompleted = true;  // smoothing
};

/// What a service does to the layers of a costmap that can be cleared.
struct ClearRequest {
  enum class Extent : std::uint8_t { Entire, Around, Except, AroundPose };
  bool isLocal = true;
  Extent extent = Extent::Entire;
  double distance = 1.0;            // side of the square [m]
  std::optional<base::Pose2> pose;  // of AroundPose
  std::string plugins;              // names with ',' or ';' between; empty: all
};

/// Implemented over the servers of the planner `nav2`, and by tests. One tree, one thread.
class NavigatorHost {
 public:
  virtual ~NavigatorHost() = default;
  NavigatorHost() = default;
  NavigatorHost(const NavigatorHost&) = delete;
  NavigatorHost& operator=(const NavigatorHost&) = delete;
  NavigatorHost(NavigatorHost&&) = delete;
  NavigatorHost& operator=(NavigatorHost&&) = delete;

  virtual sim2d::nav2::Distro distro() const = 0;
  virtual base::Pose2 pose() const = 0;             // [m], [rad]
  virtual double speed() const = 0;                 // smoothed, of the odometry [m/s]
  virtual double goalReachedTolerance() const = 0;  // [m]
  virtual PathId newestGoal() const = 0;            // what a moving goal is now
  /// By the global costmap, from the robot on; `maxCost`, `unknownBlocks` of Main.
  virtual bool isPathValid(PathId path, int maxCost, bool unknownBlocks) const = 0;

  virtual void begin(RobotAction action, const RobotRequest& request) = 0;
  virtual RobotOutcome outcome(RobotAction action) const = 0;  // of the last request
  virtual void cancel(RobotAction action) = 0;                 // nothing when it does not run
  virtual bool clear(const ClearRequest& request) = 0;         // false: it was refused
  virtual void countRecovery() = 0;

  /// The robot has a pose in the map.
  virtual bool isLocalized() const { return true; }
  /// Whether TF has a transform between two frames.
  virtual bool canTransform(const std::string& /*parent*/, const std::string& /*child*/) const {
    return true;
  }
  /// Service reinitialize_global_localization; false: there is no localiser.
  virtual bool relocalize() { return false; }

  PathStore& paths() { return paths_; }
  const PathStore& paths() const { return paths_; }

 private:
  PathStore paths_;
};

}  // namespace bt
