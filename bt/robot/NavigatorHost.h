#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt/robot/NumberedStore.h"
#include "bt/robot/PathStore.h"
#include "sim2d/nav/Battery.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Nav2Key.h"
#include "sim2d/nav/nav2/control/TrackingError.h"
#include "sim2d/nav/nav2/docking/DockingServer.h"

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

/// What FollowObject follows.
struct FollowedObject {
  std::string topic, frame;  // the frame counts if there is one
};

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
  bool ignoresCollisions = false;  // of a behaviour, since Kilted
  PathId viaPoints = 0;            // of a plan to one pose: poses before the goal, since Lyrical
  std::string tree;                // of a navigation: its tree by name; empty: the default one
  bool usesPoses = true;           // of a route: `path` and `start` count, else the ids of nodes
  std::uint32_t startId = 0, goalId = 0;
  sim2d::nav2::DockGoal dock{};  // of DockRobot and UndockRobot; its pose is that of `path`
  FollowedObject object{};       // of FollowObject
};

/// How far a robot has come on a route; ids of nodes and edges of the graph, 0 where there is none.
struct RouteProgress {
  int number = 0;    // grows when something has changed
  PathId route = 0;  // the nodes, as poses along the edges
  std::uint32_t lastNode = 0, nextNode = 0, currentEdge = 0;
  bool isRerouted = false;
};

/// What came of it.
struct RobotOutcome {
  enum class State : std::uint8_t { Running, Succeeded, Failed, Cancelled };
  State state = State::Running;
  int errorCode = 0;      // Nav2's: 0 none, 100 … controller, 200 … planner, 500 … smoother
  std::string errorText;  // why it failed, in words; empty: it did not
  PathId path = 0;        // planned or smoothed
  double duration = 0.0;  // of smoothing, of following a route or an object [s]
  bool wasCompleted = true;  // smoothing
  int lastReached = -1;      // index of the last goal that a path through poses leads to
  RouteProgress progress;    // of a route
  int retries = 0;           // of docking
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

/// What the service is_path_valid is asked.
struct PathCheck {
  PathId path = 0;
  int maxCost = 254;           // cost from which a cell blocks the path
  bool unknownBlocks = false;  // cells without information block the path
  double lookahead = -1.0;     // length of the path that is looked at [m]; below 0: all of it
  std::string layer;           // of the global costmap by name; empty: all layers merged
  std::string footprint;       // "[[x, y], …]" [m]; empty: that of the costmap
  bool stopsAtFirst = true;    // at the first blocked pose
};
struct PathCheckResult {
  bool isValid = false;
  sim2d::nav2::Path collisions;  // poses that are blocked, in the order of the path
};

/// What has become of one pose of NavigateThroughPoses (nav2_msgs/WaypointStatus).
struct Waypoint {
  enum class Status : std::uint8_t { Pending, Completed, Skipped, Failed };
  base::Pose2 pose;
  Status status = Status::Pending;
};
using Waypoints = std::vector<Waypoint>;

/// The last message of a topic.
struct TopicMessage {
  double time = 0.0;  // [s], when it was published
  std::string text;
  int number = 0;  // messages of the topic so far
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
  virtual std::optional<sim2d::BatteryState> battery() const { return std::nullopt; }
  virtual PathId newestGoal() const = 0;        // what a moving goal is now
  virtual double time() const = 0;              // of the simulation [s]
  virtual sim2d::BodyTwist motion() const = 0;  // the last reading of the odometry
  /// Change of the forward speed between the last two readings of the odometry [m/s²].
  virtual double acceleration() const = 0;
  /// By the global costmap, from the pose nearest to the robot on.
  virtual PathCheckResult checkPath(const PathCheck& check) const = 0;
  /// Service get_cost of a costmap: the greatest cost on the edges of the footprint, or that of the
  /// cell at the pose. None: the pose is off the map.
  virtual std::optional<std::uint8_t> costAt(bool isLocal, const base::Pose2& pose,
                                             bool usesFootprint) const = 0;
  /// Of the path that FollowPath drives along; number 0 before its first cycle.
  virtual sim2d::nav2::TrackingFeedback tracking() const = 0;
  virtual void monitorCollisions(bool isOn) = 0;  // service toggle of the collision monitor
  /// By now; number 0: nothing has been published. A leading '/' of the name does not matter.
  virtual TopicMessage lastMessage(const std::string& topic) const = 0;

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
  NumberedStore<Waypoints>& waypoints() { return waypoints_; }
  const NumberedStore<Waypoints>& waypoints() const { return waypoints_; }

 private:
  PathStore paths_;
  NumberedStore<Waypoints> waypoints_;
};

}  // namespace bt
