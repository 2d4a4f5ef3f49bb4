#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt/robot/PathStore.h"
#include "sim2d/nav/Battery.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/control/TrackingError.h"
#include "sim2d/nav/nav2/docking/DockingServer.h"

/// Interface of navigator tree nodes to Nav2's servers, without ROS messages.
namespace bt {

/// One server per action: it executes one request at a time, a new request replaces the old one.
enum class RobotAction : std::uint8_t {
  ComputePath,
  ComputePathThroughPoses,
  FollowPath,
  SmoothPath,
  Spin,
  BackUp,
  DriveOnHeading,
  Wait,
  NavigateToPose,
  NavigateThroughPoses,
  ComputeRoute,
  ComputeAndTrackRoute,
  AssistedTeleop,
  DockRobot,
  UndockRobot,
  FollowObject
};
constexpr std::size_t kRobotActions = 16;

/// The object that FollowObject follows.
struct FollowedObject {
  std::string topic, frame;  // the frame takes precedence
};

/// Parameters of a request; the action determines which members are used.
struct RobotRequest {
  PathId path = 0;              // to follow or smooth; goals of a plan
  std::optional<PathId> start;  // start of a plan; empty: the robot's pose
  std::string server;           // name of planner, controller or smoother; empty: the only one
  std::string goalChecker, progressChecker, pathHandler;
  double amount = 0.0;             // angle [rad], distance [m] or time [s] of a behaviour
  double speed = 0.0;              // [m/s]
  double timeAllowance = 0.0;      // [s]; also for smoothing
  bool checksCollisions = false;   // for smoothing
  bool ignoresCollisions = false;  // for behaviours, since Kilted
  PathId viaPoints = 0;            // for a plan to one pose: intermediate poses, since Lyrical
  std::string tree;                // for navigation: tree by name; empty: the default one
  bool usesPoses = true;           // for routes: use `path` and `start`, otherwise node ids
  std::uint32_t startId = 0, goalId = 0;
  sim2d::nav2::DockGoal dock{};  // for DockRobot and UndockRobot; the pose is in `path`
  FollowedObject object{};       // for FollowObject
};

/// Progress on a route; ids of graph nodes and edges, 0: none.
struct RouteProgress {
  int number = 0;    // increases with every change
  PathId route = 0;  // nodes as poses along the edges
  std::uint32_t lastNode = 0, nextNode = 0, currentEdge = 0;
  bool isRerouted = false;
};

/// Result of a request.
struct RobotOutcome {
  enum class State : std::uint8_t { Running, Succeeded, Failed, Cancelled };
  State state = State::Running;
  int errorCode = 0;  // Nav2's codes: 0 none, 100 … controller, 200 … planner, 500 … smoother
  std::string errorText;     // reason of a failure; empty: none
  PathId path = 0;           // planned or smoothed
  double duration = 0.0;     // of smoothing, route tracking or following [s]
  bool wasCompleted = true;  // for smoothing
  int lastReached = -1;      // index of the last goal that a path through poses reaches
  RouteProgress progress;    // for routes
  int retries = 0;           // for docking
};

/// Request of a service that clears the clearable layers of a costmap.
struct ClearRequest {
  enum class Extent : std::uint8_t { Entire, Around, Except, AroundPose };
  bool isLocal = true;
  Extent extent = Extent::Entire;
  double distance = 1.0;            // side of the square [m]
  std::optional<base::Pose2> pose;  // for AroundPose
  std::string plugins;              // names separated by ',' or ';'; empty: all
};

/// Request of the service is_path_valid.
struct PathCheck {
  PathId path = 0;
  int maxCost = 254;           // cost from which a cell blocks the path
  bool unknownBlocks = false;  // unknown cells block the path
  double lookahead = -1.0;     // length of the checked path [m]; < 0: all of it
  std::string layer;           // layer of the global costmap; empty: all layers merged
  std::string footprint;       // "[[x, y], …]" [m]; empty: that of the costmap
  bool stopsAtFirst = true;    // stops at the first blocked pose
};
struct PathCheckResult {
  bool isValid = false;
  sim2d::nav2::Path collisions;  // blocked poses in path order
};

/// Status of one pose of NavigateThroughPoses (nav2_msgs/WaypointStatus).
struct Waypoint {
  enum class Status : std::uint8_t { Pending, Completed, Skipped, Failed };
  base::Pose2 pose;
  Status status = Status::Pending;
};
using Waypoints = std::vector<Waypoint>;

/// The last message of a topic.
struct TopicMessage {
  double time = 0.0;  // publication time [s]
  std::string text;
  int number = 0;  // number of messages of the topic so far
};

/// Implemented by the servers of the planner `nav2` and by tests. Used by one tree in one thread.
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
  virtual double speed() const = 0;                 // smoothed odometry [m/s]
  virtual double goalReachedTolerance() const = 0;  // [m]
  virtual std::optional<sim2d::BatteryState> battery() const { return std::nullopt; }
  virtual PathId newestGoal() const = 0;        // current position of a moving goal
  virtual double time() const = 0;              // simulated time [s]
  virtual sim2d::BodyTwist motion() const = 0;  // last reading of the odometry
  /// Change of the forward speed between the last two readings of the odometry [m/s²].
  virtual double acceleration() const = 0;
  /// Checks the path against the global costmap from the pose nearest to the robot.
  virtual PathCheckResult checkPath(const PathCheck& check) const = 0;
  /// Service get_cost of a costmap: the maximum cost on the edges of the footprint, or the cost of
  /// the cell at the pose. Empty: the pose is off the map.
  virtual std::optional<std::uint8_t> costAt(bool isLocal, const base::Pose2& pose,
                                             bool usesFootprint) const = 0;
  /// Feedback for the path of FollowPath; number 0 before its first cycle.
  virtual sim2d::nav2::TrackingFeedback tracking() const = 0;
  virtual void enableCollisionMonitor(bool isOn) = 0;  // service toggle of the collision monitor
  /// The last message up to now; number 0: none published. A leading '/' of the name is ignored.
  virtual TopicMessage lastMessage(const std::string& topic) const = 0;

  virtual void begin(RobotAction action, const RobotRequest& request) = 0;
  virtual RobotOutcome outcome(RobotAction action) const = 0;  // of the last request
  virtual void cancel(RobotAction action) = 0;                 // no effect if not running
  virtual bool clear(const ClearRequest& request) = 0;         // false: refused
  virtual void countRecovery() = 0;

  /// Whether the robot has a pose in the map.
  virtual bool isLocalized() const { return true; }
  /// Whether TF has a transform between two frames.
  virtual bool canTransform(const std::string& /*parent*/, const std::string& /*child*/) const {
    return true;
  }
  /// Service reinitialize_global_localization. Returns false without a localiser.
  virtual bool relocalize() { return false; }

  PathStore& paths() { return paths_; }
  const PathStore& paths() const { return paths_; }
  HandleStore<Waypoints>& waypoints() { return waypoints_; }
  const HandleStore<Waypoints>& waypoints() const { return waypoints_; }

 private:
  PathStore paths_;
  HandleStore<Waypoints> waypoints_;
};

}  // namespace bt
