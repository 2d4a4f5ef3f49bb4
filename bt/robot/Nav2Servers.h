#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt/robot/Nav2Errors.h"
#include "bt/robot/Nav2Frames.h"
#include "bt/robot/NavigatorHost.h"
#include "bt/robot/NavigatorTopics.h"
#include "bt/robot/SubNavigation.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/nav2/control/ControllerServer.h"
#include "sim2d/nav/nav2/costmap/LayeredCostmap.h"
#include "sim2d/nav/nav2/global/PlannerServer.h"
#include "sim2d/nav/nav2/params/Nav2Parameters.h"
#include "sim2d/nav/nav2/route/RouteServer.h"
#include "sim2d/nav/nav2/servers/OdometrySmoother.h"

namespace bt {

/// What the chain of a real robot takes in whole steps, as Nav2's servers here answer at once.
struct Nav2Latencies {
  double scan = 0.0;     // steps from the lidar to the costmaps
  double planner = 0.0;  // steps from the request to the path
  double command = 1.0;  // steps from the last server to the wheels
};

/// What happened in a run, for the manifest.
struct Nav2Counts {
  int replans = 0;           // paths planned after the first of a goal
  int planFailures = 0;      // of planners
  int noValidControl = 0;    // cycles of a controller without a command
  int progressFailures = 0;  // FAILED_TO_MAKE_PROGRESS
  int recoveries = 0;        // as Nav2's feedback counts them
  int clears = 0;            // of costmaps
  int cutCommands = 0;       // steps in which the robot's limits left less of a command
  int treeFailures = 0;      // runs of the tree that gave a goal up
  std::map<std::string, int> planReasons{};          // planFailures by their reasons
  std::map<std::string, int> actionReasons{};        // other actions that failed, by their reasons
  std::vector<sim2d::nav2::RouteEvent> routeEvents;  // of the route server's operations
  std::map<std::string, sim2d::nav2::BinaryState> binaryFilters;  // "local_costmap.lights"
};

/// Nav2's servers round one robot: costmaps, planners, smoothers, controllers, behaviours, velocity
/// smoother, collision monitor. In each step: `sense`, then the tree is ticked, then `act`. Rates
/// are counted in whole steps: something is due when floor(t f) has grown.
class Nav2Servers final : public NavigatorHost {
 public:
  struct Setup {
    sim2d::nav2::Nav2Parameters parameters;
    sim2d::RobotBody body;
    sim2d::OccupancyGrid map;  // known
    Nav2Latencies latencies;
    std::uint64_t seed = 1;
    int robotId = -1;
    sim2d::nav2::FilterMasks localMasks{}, globalMasks{};  // of filters
    NavigatorTopics topics{};                              // what is published in the run
    NavigatorTrees trees{};                                // that nodes of the tree ask for
    sim2d::nav2::RouteGraph graph{};                       // of the route server
    std::vector<sim2d::DockPlace> docks{};                 // of the scenario
    std::vector<std::pair<std::string, int>> names{};      // of bodies that it may follow
  };
  /// Problems of the costmaps, at the lines of the file's values.
  static base::Diagnostics costmapProblems(const Setup& setup);
  /// Problems of costmaps, controllers and other servers, at the lines of the file's values. With
  /// errors, there are no servers.
  static base::Result<std::unique_ptr<Nav2Servers>> make(Setup setup);
  ~Nav2Servers() override;
  Nav2Servers(const Nav2Servers&) = delete;
  Nav2Servers& operator=(const Nav2Servers&) = delete;
  Nav2Servers(Nav2Servers&&) = delete;
  Nav2Servers& operator=(Nav2Servers&&) = delete;

  /// Takes in the step's observation, which must live until `act` is done; costmaps are updated.
  void sense(const sim2d::Observation& observation);
  /// What the tree began is done, and what is due; the command for the wheels.
  sim2d::BodyTwist act();
  void setGoal(PathId goal) { goal_ = goal; }
  /// A new run of the tree begins: nothing is asked for any more.
  void restart();
  static const std::array<RobotAction, 5>& behaviorActions();
  /// Commands of a person are wanted: AssistedTeleop runs.
  bool wantsTeleop() const;
  /// Of docking: "docked dock1" …, since the last call.
  std::vector<std::string> takeDockEvents();
  /// Whether the controller keeps what it weighs, for display.
  void watchWays(bool wanted) { watchesWays_ = wanted; }

  const Nav2Counts& counts() const { return counts_; }
  void countTreeFailure() { ++counts_.treeFailures; }
  /// The last action that failed in this run of the tree; none: all succeeded.
  const std::optional<ActionFailure>& lastFailure() const { return lastFailure_; }
  /// Whether that was since the tick before.
  bool hasJustFailed() const { return lastFailure_ && step_ - failureStep_ <= 1; }
  bool takeReplanned() { return std::exchange(hasReplanned_, false); }
  bool takeRelocalization() { return std::exchange(asksRelocalization_, false); }
  /// The frame of local costmap, controllers and behaviours, in the map.
  const base::Pose2& localFrame() const { return inLocal().frame; }
  const sim2d::nav2::Path& shownPath() const { return shownPath_; }
  const sim2d::nav2::LayeredCostmap& localCostmap() const { return *local_; }
  const sim2d::nav2::LayeredCostmap& globalCostmap() const { return *global_; }
  sim2d::nav2::Controller* controller() const { return controllers_->controller(); }
  const std::string& controllerName() const { return controllerName_; }  // as the tree says it
  const sim2d::nav2::Nav2Parameters& parameters() const { return setup_.parameters; }

  // NavigatorHost
  sim2d::nav2::Distro distro() const override { return setup_.parameters.distro; }
  base::Pose2 pose() const override { return observation_->pose; }
  std::optional<sim2d::BatteryState> battery() const override { return observation_->battery; }
  double speed() const override;
  double goalReachedTolerance() const override {
    return setup_.parameters.btNavigator.goalReachedTol;
  }
  PathId newestGoal() const override { return goal_; }
  double time() const override { return time_; }
  sim2d::BodyTwist motion() const override { return observation_->motion; }
  double acceleration() const override { return acceleration_; }
  PathCheckResult checkPath(const PathCheck& check) const override;
  std::optional<std::uint8_t> costAt(bool isLocal, const base::Pose2& pose,
                                     bool usesFootprint) const override;
  sim2d::nav2::TrackingFeedback tracking() const override { return tracking_; }
  void monitorCollisions(bool isOn) override;
  TopicMessage lastMessage(const std::string& topic) const override {
    return setup_.topics.lastOf(topic, time_);
  }
  void begin(RobotAction action, const RobotRequest& request) override;
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
  /// A request to a server that answers once.
  struct Asked {
    RobotRequest request;
    std::int64_t step = 0;  // in which it was asked
    bool isWaiting = false;
    double waitsSince = -1.0;  // for a current costmap [s]
  };
  class Docking;  // docking and following server
  class Motions;  // behaviours, velocity smoother, collision monitor

  explicit Nav2Servers(Setup setup);
  base::Diagnostics build();

  Asked& asked(RobotAction action) { return asked_[static_cast<std::size_t>(action)]; }
  RobotOutcome& result(RobotAction action) { return results_[static_cast<std::size_t>(action)]; }
  bool isDue(double frequency) const;
  /// The step's observation in the frame of the local costmap.
  const sim2d::Observation& inLocal() const {
    return setup_.parameters.frames.isLocalInOdom && inOdom_ != nullptr ? *inOdom_ : sensed_;
  }
  void finish(RobotAction action, int errorCode, PathId path = 0, const std::string& text = {});
  void noteFailure(RobotAction action, int errorCode);
  void planIfAsked(RobotAction action);
  void planNow(RobotAction action, Asked& asked);
  sim2d::nav2::ThroughPosesResult planPath(sim2d::nav2::GlobalPlanner& planner, RobotAction action,
                                           const RobotRequest& request, const base::Pose2& start);
  void informCostmaps(const sim2d::nav2::Path& plan);
  bool waitsForCostmap(Asked& asked);
  void smoothIfAsked();
  void smoothNow(const RobotRequest& request);
  void control();
  void watchController();
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
  std::map<std::string, std::unique_ptr<sim2d::nav2::PathSmoother>> smoothers_;
  std::unique_ptr<sim2d::nav2::ControllerServer> controllers_;
  std::unique_ptr<Motions> motions_;
  std::unique_ptr<sim2d::nav2::RouteServer> routes_;
  std::map<std::string, int> heardServices_;  // of the route server: calls so far, by name
  std::unique_ptr<Docking> docking_;
  sim2d::nav2::ControlledShape shape_;

  const sim2d::Observation* observation_ = nullptr;
  OdomObservation odomObservation_;
  const sim2d::Observation* inOdom_ = nullptr;                   // `sensed_` in the frame odom
  sim2d::Observation sensed_;                                    // with the scan that has arrived
  std::deque<std::pair<std::int64_t, sim2d::LaserScan>> scans_;  // under way, by step
  std::optional<sim2d::LaserScan> scan_;                         // the last that has arrived
  double newestScan_ = -1.0;                                     // [s]
  std::int64_t step_ = 0;                                        // calls of sense
  double time_ = 0.0, timeBefore_ = -1.0;                        // [s]
  sim2d::nav2::OdometrySmoother odometry_{0.3};                  // of bt_navigator
  std::array<Asked, kRobotActions> asked_;
  std::array<RobotOutcome, kRobotActions> results_;
  std::optional<sim2d::nav2::FollowPathGoal> nextFollow_;  // once the cancelled one has ended
  bool isCancelling_ = false;
  std::optional<sim2d::BodyTwist> command_;  // published in this step
  std::deque<sim2d::BodyTwist> underWay_;    // commands, oldest first
  PathId goal_ = 0;
  std::optional<SubNavigation> navigation_;  // that a node of the tree has asked for
  RobotOutcome navigated_;                   // what came of it
  bool isNavigating_ = false;                // its tree is being ticked
  double acceleration_ = 0.0;                // by the last two readings of the odometry [m/s²]
  std::optional<double> speedBefore_;        // [m/s], forward, of the reading before
  sim2d::nav2::TrackingFeedback tracking_;   // of FollowPath
  bool hasPlanned_ = false, hasReplanned_ = false;
  bool asksRelocalization_ = false;
  sim2d::nav2::Path shownPath_;
  std::string controllerName_;  // of the path that was given last
  bool watchesWays_ = false;
  sim2d::nav2::SpeedLimit localLimit_, globalLimit_;  // of speed filters, applied
  Nav2Counts counts_;
  std::optional<ActionFailure> lastFailure_;
  std::int64_t failureStep_ = 0;  // of lastFailure_
};

}  // namespace bt
