#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/control/PathHandler.h"
#include "sim2d/nav/nav2/docking/DockingServer.h"

/// Interface of navigator tree nodes to Nav2's servers, without ROS messages.
namespace bt {

/// Number of a path in a store, as stored in blackboard entries: 0: none, an empty path. Each path
/// has a unique number, so numbers differ like the time stamps of Nav2's messages. A goal is a path
/// of one pose, goals are a path of several.
using PathId = std::int64_t;

/// The paths that entries of one robot's tree refer to. The newest kMost paths with at most
/// kMostPoses poses in total are kept, more than an hour of a tree that writes a pose in each step;
/// older ones are empty. An entry may refer to an old path, for example to a goal.
class PathStore {
 public:
  static constexpr std::size_t kMost = 100'000;
  static constexpr std::size_t kMostPoses = 2'000'000;

  PathId add(sim2d::nav2::Path path);
  /// Returns `known` if that path is equal: the output of a node has not changed.
  PathId addUnlessEqual(sim2d::nav2::Path path, PathId known);
  const sim2d::nav2::Path& get(PathId id) const;  // valid until a path is added

 private:
  std::deque<std::unique_ptr<const sim2d::nav2::Path>> paths_;
  PathId newest_ = 0;
  std::size_t poses_ = 0;  // total of the stored paths
};

/// Length along the poses [m].
double lengthOf(const sim2d::nav2::Path& path);

/// Values that blackboard entries refer to by number, like the paths of a PathStore. Numbers start
/// at 1; 0 is a default value. The newest kMost values are kept; older numbers give the default
/// value.
template <class T>
class HandleStore {
 public:
  static constexpr std::size_t kMost = 256;

  std::int64_t add(T value) {
    values_.push_back(std::make_unique<const T>(std::move(value)));
    if (values_.size() > kMost) {
      values_.pop_front();
    }
    return ++newest_;
  }
  /// Valid until the next kMost values are added.
  const T& get(std::int64_t number) const {
    static const T kNone{};
    const std::int64_t first = newest_ - static_cast<std::int64_t>(values_.size()) + 1;
    const bool isKept = number >= first && number <= newest_ && number > 0;
    return isKept ? *values_[static_cast<std::size_t>(number - first)] : kNone;
  }

 private:
  std::deque<std::unique_ptr<const T>> values_;
  std::int64_t newest_ = 0;
};

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
  int maxCost = 254;           // minimum cost of a cell that blocks the path
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

/// The name of a topic or frame without a leading '/'.
std::string bareName(const std::string& name);

/// The last message of a topic.
struct TopicMessage {
  double time = 0.0;  // publication time [s]
  std::string text;
  int number = 0;  // number of messages of the topic so far
};

/// Messages and service calls to a robot's navigator at given times, from the scenario's
/// `nav2_topics`. A plain value.
class NavigatorTopics {
 public:
  /// Parses "12.0 controller_selector FollowPath2; 20 /pause": entries separated by ';', each with
  /// its time [s], the name of the topic or service and the message text (empty for a call).
  /// Errors: a missing or negative time, a missing name.
  static base::Result<NavigatorTopics> read(const std::string& text);

  /// The last message of a topic published by `now` [s]. A leading '/' is ignored.
  TopicMessage lastOf(const std::string& topic, double now) const;
  /// The messages after the one with that number, oldest first.
  std::vector<TopicMessage> after(const std::string& topic, int number, double now) const;

 private:
  struct Published {
    double time = 0.0;  // [s]
    std::string text;
  };
  std::map<std::string, std::vector<Published>> topics_;  // by name without '/', ordered by time
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
  virtual base::Pose2 pose() const = 0;  // in the map [m], [rad]
  /// The same in a frame by name: the map or the odometry's.
  virtual base::Pose2 poseIn(const std::string& /*frame*/) const { return pose(); }
  virtual double speed() const = 0;                 // smoothed odometry [m/s]
  virtual double goalReachedTolerance() const = 0;  // [m]
  virtual std::optional<sim2d::BatteryState> battery() const { return std::nullopt; }
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

// Names of the error codes of Nav2's actions (nav2_msgs/action of Jazzy and later). Humble has no
// codes; the names are then given without numbers.

/// Codes of nav2_msgs/action/NavigateToPose; those of NavigateThroughPoses are larger by 100.
enum class NavigationError : std::uint16_t {
  None = 0,
  Unknown = 9000,
  FailedToLoadTree = 9001,
};
constexpr int navigationCode(RobotAction action, NavigationError error) {
  const int code = static_cast<int>(error);
  return code == 0 || action == RobotAction::NavigateToPose ? code : code + 100;
}

/// A failed action.
struct ActionFailure {
  RobotAction action = RobotAction::ComputePath;
  int errorCode = 0;  // 0: the server does not have the requested item
};

/// Offset between the planner error codes of ComputePathThroughPoses (300 …) and ComputePathToPose
/// (200 …).
constexpr int kThroughPosesOffset = 100;
constexpr int throughPosesCode(int planCode) {
  return planCode == 0 ? 0 : planCode + kThroughPosesOffset;
}

/// "planner NO_VALID_PATH (208)", in Humble "planner NO_VALID_PATH"; "spin COLLISION_AHEAD (703)".
std::string failureReason(const ActionFailure& failure, sim2d::nav2::Distro distro);
/// The same as a sentence without a full stop: "there is no path to the goal".
std::string failureMessage(const ActionFailure& failure);
/// Whether the failure is one of a planner.
bool isPlannerFailure(const ActionFailure& failure);

}  // namespace bt
