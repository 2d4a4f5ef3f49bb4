#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt/engine/TreeState.h"
#include "bt/robot/Nav2Files.h"
#include "sim2d/base/TreeResults.h"
#include "sim2d/map/CostGrid.h"
#include "sim2d/map/OccupancyGrid.h"
#include "sim2d/nav/Observation.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/ControllerServer.h"
#include "sim2d/nav/nav2/costmap/LayeredCostmap.h"
#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/params/Nav2Parameters.h"
#include "sim2d/nav/nav2/route/RouteServer.h"
#include "sim2d/nav/nav2/servers/VelocitySmoother.h"

namespace bt {

// Display data of the servers

std::vector<base::Vec2> pointsOf(const sim2d::nav2::Path& path);

/// A trajectory with its cost. Scores are scale * raw for each critic that was evaluated. Rejected
/// trajectories have infinite cost.
sim2d::Candidate toCandidate(const sim2d::nav2::EvaluatedTrajectory& trajectory);

/// A copy of a costmap that is renewed after each update.
class CostmapSnapshot {
 public:
  sim2d::CostGridPtr of(const sim2d::nav2::LayeredCostmap& costmap);

 private:
  sim2d::CostGridPtr copy_;
  std::int64_t updates_ = -1;  // update count of the costmap at the time of the copy
};

/// Nav2's frames: a robot's servers use its observation in the map or, for everything that moves
/// with the odometry, in the frame odom.

/// Converts an observation to the frame odom. Obstacles seen earlier keep their position there when
/// the localiser corrects map -> odom.
class OdomObservation {
 public:
  /// `inMap` must outlive the use of the result. If both frames coincide, the result is `inMap`
  /// itself. A scan is placed by the odometry at its time stamp.
  const sim2d::Observation& of(const sim2d::Observation& inMap);

 private:
  sim2d::Observation converted_;
  sim2d::LaserScan scan_;
};

/// Transforms points from a frame, given by its pose in the map, to the map.
void moveToMap(const base::Pose2& frame, std::vector<base::Vec2>& points);

/// Resamples a grid along the axes of a frame to a grid along the axes of the map that covers it; 0
/// outside. For the identity the grid itself is returned. For display.
sim2d::CostGridPtr costsInMap(const base::Pose2& frame, sim2d::CostGridPtr grid);

/// The masks of a costmap's enabled filters. `topSpeed`: of the robot [m/s], for limits in m/s.
std::vector<sim2d::MaskGrid> maskGrids(const sim2d::nav2::CostmapSettings& costmap,
                                       const sim2d::nav2::FilterMasks& masks, double topSpeed);

/// Latencies of a real robot in whole steps; Nav2's servers respond immediately here.
struct Nav2Latencies {
  double scan = 0.0;     // steps from the lidar to the costmaps
  double planner = 0.0;  // steps from a request to its path
  double command = 1.0;  // steps from the last server to the wheels
};

/// Event counts of a run, for the manifest.
struct Nav2Statistics {
  int replans = 0;                           // paths after the first one of a goal
  int planFailures = 0;                      // of planners
  int noValidControl = 0;                    // controller cycles without a valid command
  int progressFailures = 0;                  // FAILED_TO_MAKE_PROGRESS
  int recoveries = 0;                        // as counted by Nav2's feedback
  int clears = 0;                            // of costmaps
  int limitedCommands = 0;                   // steps in which the robot's limits reduced a command
  int treeFailures = 0;                      // tree runs that gave up a goal
  std::map<std::string, int> planReasons{};  // planFailures by reason
  std::map<std::string, int> actionReasons{};                     // other failed actions by reason
  std::vector<sim2d::nav2::RouteEvent> routeEvents;               // route server operations
  std::map<std::string, sim2d::nav2::BinaryState> binaryFilters;  // "local_costmap.lights"
};

/// Stores a waypoint list with all goals pending and returns its number.
std::int64_t addPendingWaypoints(NavigatorHost& host, const sim2d::nav2::Path& goals);

/// What the nodes of trees have returned, by program; trees of one program share an entry.
class ProgramResults {
 public:
  /// The tree adds its statuses from now on; this must outlive its ticks.
  void record(TreeState& tree) {
    const Program& program = tree.program();
    base::TreeResults& results = results_[program.paths()];
    results.paths = program.paths();
    results.unreachable = program.unreachable();
    results.returned.resize(results.paths->size());
    tree.recordResults(results.returned.data());
  }
  std::vector<base::TreeResults> all() const {
    std::vector<base::TreeResults> results;
    for (const auto& [paths, each] : results_) {
      base::addTreeResults(each, results);
    }
    std::sort(results.begin(), results.end(),
              [](const auto& a, const auto& b) { return *a.paths < *b.paths; });
    return results;
  }

 private:
  std::map<std::shared_ptr<const std::vector<std::string>>, base::TreeResults> results_;
};

/// A navigation requested by a node of another tree: its own tree and blackboard on the servers of
/// the same host. Not synchronised.
class NestedNavigation {
 public:
  /// `goals`: a path of one or more poses. `waypoints`: their statuses.
  NestedNavigation(RobotAction action, std::shared_ptr<const Program> program, PathId goals,
                   std::int64_t waypoints);
  void recordResults(ProgramResults& results) { results.record(tree_); }

  RobotAction action() const { return action_; }
  PathId goals() const { return goals_; }
  /// One step of `dt` [s]. Returns FAILURE also for a faulty tree.
  base::NodeStatus tick(NavigatorHost& host, double dt);
  void halt(NavigatorHost& host, double dt);
  /// The fault of the tree; empty: none.
  std::string fault() const;

 private:
  RobotAction action_;
  PathId goals_;
  TreeState tree_;
  std::int64_t step_ = 0;
};

/// Nav2's servers of one robot: costmaps, planners, smoothers, controllers, behaviours, velocity
/// smoother, collision monitor. Per step: `sense`, tick of the tree, `act`. Rates are quantised to
/// steps: an event is due when floor(t f) has increased.
class Nav2Servers final : public NavigatorHost {
 public:
  struct Setup {
    sim2d::nav2::Nav2Parameters parameters;
    sim2d::RobotBody body;
    sim2d::OccupancyGrid map;  // known map
    Nav2Latencies latencies;
    std::uint64_t seed = 1;
    int robotId = -1;
    sim2d::nav2::FilterMasks localMasks{}, globalMasks{};  // filter masks
    NavigatorTopics topics{};                              // messages published during the run
    NavigatorTrees trees{};                                // requested by nodes of the tree
    sim2d::nav2::RouteGraph graph{};                       // of the route server
    std::vector<sim2d::DockPose> docks{};                  // of the scenario
    std::vector<std::pair<std::string, int>> names{};      // of bodies it may follow
  };
  /// Problems of the costmaps, with the lines of the file.
  static base::Diagnostics costmapProblems(const Setup& setup);
  /// Problems of costmaps, controllers and other servers have the lines of the file. With errors
  /// there are no servers.
  static base::Result<std::unique_ptr<Nav2Servers>> make(Setup setup);
  ~Nav2Servers() override;
  Nav2Servers(const Nav2Servers&) = delete;
  Nav2Servers& operator=(const Nav2Servers&) = delete;
  Nav2Servers(Nav2Servers&&) = delete;
  Nav2Servers& operator=(Nav2Servers&&) = delete;

  /// Processes the step's observation, which must live until `act` returns; updates costmaps.
  void sense(const sim2d::Observation& observation);
  /// Executes the requests of the tree and all due updates; returns the command for the wheels.
  sim2d::BodyTwist act();
  /// Call before a new run of the tree: drops all requests.
  void restart();
  static const std::array<RobotAction, 5>& behaviorActions();
  /// Whether manual commands are wanted: AssistedTeleop is running.
  bool usesTeleop() const;
  /// Docking events since the last call: "docked dock1" …
  std::vector<std::string> takeDockEvents();
  /// Whether the controller keeps its evaluated trajectories, for display.
  void recordTrajectories(bool wanted) { recordsTrajectories_ = wanted; }

  std::vector<base::TreeResults> nestedTreeResults() const { return nestedResults_.all(); }
  const Nav2Statistics& counts() const { return counts_; }
  void countTreeFailure() { ++counts_.treeFailures; }
  /// The last failed action in this run of the tree; empty: all succeeded.
  const std::optional<ActionFailure>& lastFailure() const { return lastFailure_; }
  /// Whether it failed since the previous tick.
  bool failedSinceLastTick() const { return lastFailure_ && step_ - failureStep_ <= 1; }
  bool takeReplanned() { return std::exchange(hasReplanned_, false); }
  bool takeRelocalizationRequest() { return std::exchange(asksRelocalization_, false); }
  /// The frame of local costmap, controllers and behaviours, as a pose in the map.
  const base::Pose2& localFrame() const { return inLocal().frame; }
  const sim2d::nav2::Path& displayedPath() const { return displayedPath_; }
  const sim2d::nav2::LayeredCostmap& localCostmap() const { return *local_; }
  const sim2d::nav2::LayeredCostmap& globalCostmap() const { return *global_; }
  sim2d::nav2::Controller* controller() const { return controllers_->controller(); }
  const std::string& controllerName() const { return controllerName_; }  // as named by the tree
  const sim2d::nav2::Nav2Parameters& parameters() const { return setup_.parameters; }

  // NavigatorHost
  sim2d::nav2::Distro distro() const override { return setup_.parameters.distro; }
  base::Pose2 pose() const override { return observation_->pose; }
  base::Pose2 poseIn(const std::string& frame) const override;
  std::optional<sim2d::BatteryState> battery() const override { return observation_->battery; }
  double speed() const override;
  double goalReachedTolerance() const override {
    return setup_.parameters.btNavigator.goalReachedTol;
  }
  double time() const override { return time_; }
  sim2d::BodyTwist motion() const override { return observation_->motion; }
  double acceleration() const override { return acceleration_; }
  PathCheckResult checkPath(const PathCheck& check) const override;
  std::optional<std::uint8_t> costAt(bool isLocal, const base::Pose2& pose,
                                     bool usesFootprint) const override;
  sim2d::nav2::TrackingFeedback tracking() const override { return tracking_; }
  void enableCollisionMonitor(bool isOn) override;
  TopicMessage lastMessage(const std::string& topic) const override {
    return setup_.topics.lastOf(topic, time_);
  }
  void begin(RobotAction action, const RobotRequest& asked) override;
  RobotOutcome outcome(RobotAction action) const override;
  void cancel(RobotAction action) override;
  bool clear(const ClearRequest& request) override;
  void countRecovery() override { ++counts_.recoveries; }
  bool isLocalized() const override { return observation_->isLocalized; }
  bool canTransform(const std::string& parent, const std::string& child) const override {
    return setup_.parameters.frames.canTransform(parent, child, isLocalized());
  }
  bool relocalize() override;

 private:
  /// A pending request to a server that responds once.
  struct PendingRequest {
    RobotRequest request;
    std::int64_t step = 0;  // step of the request
    bool isWaiting = false;
    double waitsSince = -1.0;  // waiting for a current costmap [s]
  };
  class Docking;        // docking and following servers
  class MotionServers;  // behaviours, velocity smoother, collision monitor

  explicit Nav2Servers(Setup setup);
  base::Diagnostics build();

  PendingRequest& pendingRequest(RobotAction action) {
    return pending_[static_cast<std::size_t>(action)];
  }
  RobotOutcome& result(RobotAction action) { return results_[static_cast<std::size_t>(action)]; }
  bool isDue(double frequency) const;
  /// The step's observation in the frame of the local costmap.
  const sim2d::Observation& inLocal() const {
    return setup_.parameters.frames.isLocalInOdom && inOdom_ != nullptr ? *inOdom_ : sensed_;
  }
  void finish(RobotAction action, int errorCode, PathId path = 0, const std::string& text = {});
  void noteFailure(RobotAction action, int errorCode);
  void processPlanRequest(RobotAction action);
  void executePlanRequest(RobotAction action, PendingRequest& pendingRequest);
  sim2d::nav2::ThroughPosesResult planPath(sim2d::nav2::GlobalPlanner& planner, RobotAction action,
                                           const RobotRequest& request, const base::Pose2& start);
  void passPlanToCostmaps(const sim2d::nav2::Path& plan);
  bool waitsForCostmap(PendingRequest& pendingRequest);
  void processSmoothRequest();
  void executeSmoothRequest(const RobotRequest& request);
  void control();
  void configureController();
  void applySpeedLimit();
  void takeFeedback(const sim2d::nav2::FollowFeedback& feedback);
  void trackPath();
  void route();
  void callRouteServices();
  void showRoute(RobotOutcome& outcome, const sim2d::nav2::RoutePlan& plan);
  sim2d::nav2::RouteRequest routeRequest(const RobotRequest& request) const;
  void beginNavigation(RobotAction action, const RobotRequest& request);
  void navigate();
  void endNavigation();
  sim2d::nav2::ControlCycle cycle() const;
  sim2d::nav2::PlanRequest planRequest(const base::Pose2& from, const base::Pose2& to) const;
  sim2d::BodyTwist delayed(const sim2d::BodyTwist& command);
  void delayScan(const sim2d::Observation& observation);

  Setup setup_;
  std::unique_ptr<sim2d::nav2::LayeredCostmap> local_, global_;
  std::map<std::string, std::unique_ptr<sim2d::nav2::GlobalPlanner>> planners_;
  std::map<std::string, sim2d::nav2::PathSmootherParameters> smoothers_;
  std::unique_ptr<sim2d::nav2::ControllerServer> controllers_;
  std::unique_ptr<MotionServers> motionServers_;
  std::unique_ptr<sim2d::nav2::RouteServer> routes_;
  std::map<std::string, int> seenServiceCalls_;  // calls so far of the route server's services
  std::unique_ptr<Docking> docking_;
  sim2d::nav2::RobotFootprint shape_;

  const sim2d::Observation* observation_ = nullptr;
  OdomObservation odomObservation_;
  const sim2d::Observation* inOdom_ = nullptr;                   // `sensed_` in the frame odom
  sim2d::Observation sensed_;                                    // with the delayed scan
  std::deque<std::pair<std::int64_t, sim2d::LaserScan>> scans_;  // not yet arrived, by step
  std::optional<sim2d::LaserScan> scan_;                         // last one arrived
  double newestScan_ = -1.0;                                     // [s]
  std::int64_t step_ = 0;                                        // calls of sense
  double time_ = 0.0, timeBefore_ = -1.0;                        // [s]
  sim2d::nav2::OdometrySmoother odometry_{0.3};                  // of bt_navigator
  std::array<PendingRequest, kRobotActions> pending_;
  std::array<RobotOutcome, kRobotActions> results_;
  std::optional<sim2d::nav2::FollowPathGoal> nextFollow_;  // starts after the cancelled one ends
  bool isCancelling_ = false;
  std::optional<sim2d::BodyTwist> command_;       // published in this step
  std::deque<sim2d::BodyTwist> delayedCommands_;  // delayed commands, oldest first
  ProgramResults nestedResults_;
  std::optional<NestedNavigation> navigation_;  // requested by a node of the tree
  RobotOutcome navigated_;                      // its outcome
  bool isNavigating_ = false;                   // its tree is being ticked
  double acceleration_ = 0.0;                   // from the last two odometry readings [m/s²]
  std::optional<double> speedBefore_;           // [m/s], forward, previous reading
  sim2d::nav2::TrackingFeedback tracking_;      // of FollowPath
  bool hasPlanned_ = false, hasReplanned_ = false;
  bool asksRelocalization_ = false;
  sim2d::nav2::Path displayedPath_;
  std::string controllerName_;  // of the last path request
  bool recordsTrajectories_ = false;
  sim2d::nav2::SpeedLimit localLimit_, globalLimit_;  // last applied by speed filters
  Nav2Statistics counts_;
  std::optional<ActionFailure> lastFailure_;
  std::int64_t failureStep_ = 0;  // of lastFailure_
};

}  // namespace bt
