#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt/engine/TreeState.h"
#include "bt/robot/Nav2Goals.h"
#include "bt/robot/Nav2Servers.h"
#include "sim2d/base/Math.h"
#include "sim2d/base/Text.h"

namespace bt {
namespace {

using base::NodeStatus;
using sim2d::BodyTwist;
using sim2d::Observation;

constexpr double kTick = 1e-9;        // [s], tolerance for sums of steps
constexpr double kLongestTurn = 2.0;  // [s], time in which a lidar completes its first scan

base::ParameterTable<Nav2Latencies> latencyTable() {
  constexpr base::Range kSteps{0.0, 100.0};
  base::ParameterTable<Nav2Latencies> table;
  table.addCount(&Nav2Latencies::scan, "latency_scan", kSteps,
                 "Time steps from the lidar to the costmaps.");
  table.addCount(&Nav2Latencies::planner, "latency_planner", kSteps,
                 "Time steps from a request to its path.");
  table.addCount(&Nav2Latencies::command, "latency_command", kSteps,
                 "Time steps from the last server to the wheels.");
  return table;
}

/// Parameters of the planner besides Nav2's own.
struct Nav2Options {
  Nav2Latencies latencies;
  double waypointTasks = 0.0;
};

base::ParameterTable<Nav2Options> optionTable() {
  base::ParameterTable<Nav2Options> table;
  table.include(&Nav2Options::latencies, latencyTable());
  table.addCount(&Nav2Options::waypointTasks, "waypoint_tasks", {0.0, 1.0},
                 "1: the robot drives to several goals one by one and executes the task of "
                 "waypoint_follower at each.");
  return table;
}

class Nav2Planner final : public sim2d::Planner {
 public:
  Nav2Planner(const sim2d::PlannerSetup& setup, Nav2Loaded loaded, const Nav2Options& options)
      : setup_(setup),
        loaded_(std::move(loaded)),
        latencies_(options.latencies),
        waypoints_(loaded_.parameters.waypointFollower, options.waypointTasks > 0.0),
        tree_(std::make_unique<TreeState>(loaded_.program)),
        driving_{loaded_.program->paths(), {}} {
    driving_.statuses.resize(static_cast<std::size_t>(loaded_.program->nodeCount()),
                             NodeStatus::Idle);
    results_.record(*tree_);
  }

  bool needsMap() const override { return true; }
  base::Diagnostics takeMap(const sim2d::OccupancyGrid& map) override {
    auto servers = Nav2Servers::make({loaded_.parameters, setup_.body, map, latencies_, setup_.seed,
                                      setup_.robotId, loaded_.masks.local, loaded_.masks.global,
                                      loaded_.topics, loaded_.subTrees, loaded_.graph.graph,
                                      setup_.docks, setup_.names});
    base::Diagnostics problems;
    for (const base::Diagnostic& problem : servers.diagnostics()) {
      problems.push_back(base::problem(problem.severity, "nav2.drive",
                                       {setup_.robot, problem.message}, problem.file, problem.line,
                                       problem.column));
    }
    servers_ = servers ? *std::move(servers) : nullptr;
    return problems;
  }

  base::Result<BodyTwist> command(const Observation& observation) override {
    if (observation.scan == nullptr && !hasScan_) {  // no first scan yet
      startTime_ = startTime_.value_or(observation.time);
      if (observation.time - *startTime_ > kLongestTurn) {
        return base::error("nav2.needs-lidar", {setup_.robot});
      }
      return BodyTwist();
    }
    hasScan_ = true;
    servers_->sense(observation);
    takeGoal(observation);
    if (isWaiting_) {
      rest();
    } else {
      tick();
    }
    if (const TreeFault* const fault = tree_->fault()) {
      return base::error("nav2.tree", {setup_.robot, fault->path + ": " + fault->message});
    }
    return servers_->act();
  }

  std::vector<base::Vec2> path() const override {
    return servers_ != nullptr && servers_->controller() != nullptr
               ? pointsOf(servers_->displayedPath())
               : std::vector<base::Vec2>();
  }
  std::vector<sim2d::Candidate> candidates() const override {
    std::vector<sim2d::Candidate> ways;
    if (servers_ == nullptr || servers_->controller() == nullptr) {
      return ways;
    }
    const sim2d::nav2::ControlView& view = servers_->controller()->view();
    for (const sim2d::nav2::EvaluatedTrajectory& trajectory : view.trajectories) {
      ways.push_back(toCandidate(trajectory));
      moveToMap(servers_->localFrame(), ways.back().points);
    }
    return ways;
  }
  void watch(bool costs, bool ways) override {
    watchesCosts_ = costs;
    recordsTrajectories_ = ways;
    if (servers_ != nullptr) {
      servers_->recordTrajectories(ways);
    }
  }
  sim2d::PlannerView view() const override {
    sim2d::PlannerView shown;
    if (servers_ == nullptr) {
      return shown;
    }
    if (watchesCosts_) {
      shown.localCosts =
          costsInMap(servers_->localFrame(), localCosts_.of(servers_->localCostmap()));
      shown.globalCosts = globalCosts_.of(servers_->globalCostmap());
      shown.masks = masks();
    }
    if (const sim2d::nav2::Controller* const controller = servers_->controller();
        recordsTrajectories_ && controller != nullptr) {
      shown.controller = servers_->controllerName();
      shown.lookahead = controller->view().lookahead;
      shown.predicted = pointsOf(controller->view().predicted);
      moveToMap(servers_->localFrame(), shown.lookahead);
      moveToMap(servers_->localFrame(), shown.predicted);
    }
    return shown;
  }
  bool takeReplanned() override { return servers_ != nullptr && servers_->takeReplanned(); }
  bool takeRelocalizationRequest() override {
    return servers_ != nullptr && servers_->takeRelocalizationRequest();
  }
  bool usesTeleop() const override { return servers_ != nullptr && servers_->usesTeleop(); }
  std::vector<sim2d::PlannerEvent> takeEvents() override {
    std::vector<sim2d::PlannerEvent> events = std::exchange(photos_, {});
    if (servers_ != nullptr) {
      for (std::string& text : servers_->takeDockEvents()) {
        events.push_back({sim2d::PlannerEvent::Kind::Dock, std::move(text)});
      }
    }
    return events;
  }
  std::size_t takePassedGoals() override { return route_.takePassed(); }
  bool decidesGoalEnd() const override { return true; }
  std::optional<sim2d::NavigationResult> takeNavigationResult() override {
    return std::exchange(end_, std::nullopt);
  }
  const sim2d::TreeStatus* tree() const override { return &driving_; }
  std::vector<base::TreeResults> treeResults() const override {
    std::vector<base::TreeResults> results = results_.all();
    if (servers_ != nullptr) {
      const std::vector<base::TreeResults> nested = servers_->nestedTreeResults();
      results.insert(results.end(), nested.begin(), nested.end());
    }
    return results;
  }
  std::string manifestJson() const override {
    return servers_ == nullptr ? std::string()
                               : nav2Report(loaded_, servers_->counts(), latencies_, setup_);
  }

 private:
  TickInput input() { return {step_, setup_.dt, static_cast<NavigatorHost*>(servers_.get())}; }

  /// Starts a new run of the tree for a new goal, after the task at the previous one.
  void takeGoal(const Observation& observation) {
    end_.reset();
    const bool isOrder =
        std::exchange(orders_, observation.externalGoalCount) != observation.externalGoalCount;
    const bool isNew =
        isOrder || isDone_ || !route_.continuesTo(observation.goal, observation.remainingGoals);
    const bool isReached = isNew && !isOrder && !route_.isEmpty() && !hasFailed_;
    if (isReached && !isWaiting_ && waypoints_.isOn()) {
      reach(observation);
      tree_->halt(input());
      servers_->restart();
      isWaiting_ = true;
    }
    if (isNew && (isOrder || !waypoints_.isBusy(observation.time))) {
      beginRun(observation);
      isWaiting_ = false;
    }
  }

  void reach(const Observation& observation) {
    if (std::optional<std::string> photo = waypoints_.reach(observation.time, observation.pose)) {
      photos_.push_back({sim2d::PlannerEvent::Kind::Photo, *std::move(photo)});
    }
  }

  void rest() { std::fill(driving_.statuses.begin(), driving_.statuses.end(), NodeStatus::Idle); }

  void beginRun(const Observation& observation) {
    if (!waypoints_.isOn() && route_.isEmpty() && !observation.remainingGoals.empty() &&
        loaded_.through.program != nullptr) {
      switchToThroughPosesTree();
    }
    route_.begin(observation.pose, observation.goal, observation.remainingGoals,
                 loaded_.isThroughPoses);
    tree_->halt(input());
    servers_->restart();
    const PathId goals = servers_->paths().add(route_.poses());
    tree_->set(loaded_.program->hostSlot(0), static_cast<int>(goals));
    tree_->set(loaded_.program->hostSlot(1), static_cast<int>(goals));
    tree_->set(loaded_.program->hostSlot(2), 0);
    tree_->set(loaded_.program->hostSlot(3),
               static_cast<int>(addPendingWaypoints(*servers_, route_.poses())));
    isDone_ = hasFailed_ = false;
  }

  /// Switches to the tree for several goals, before the first goal.
  void switchToThroughPosesTree() {
    loaded_.program = loaded_.through.program;
    loaded_.treeFile = loaded_.throughPosesFile;
    loaded_.isThroughPoses = true;
    tree_ = std::make_unique<TreeState>(loaded_.program);
    results_.record(*tree_);
    driving_.paths = loaded_.program->paths();
    driving_.statuses.assign(static_cast<std::size_t>(loaded_.program->nodeCount()),
                             NodeStatus::Idle);
  }

  /// Updates the number of goals left in the tree's list; after a success all but the last are
  /// passed.
  void updateGoalsLeft(NodeStatus status) {
    const Value& goals = tree_->get(loaded_.program->hostSlot(1));
    const std::size_t left = servers_->paths().get(valueAs<int>(goals).value_or(0)).size();
    route_.setGoalsLeftInTree(status == NodeStatus::Success ? 1 : left);
  }

  void tick() {
    ++step_;
    const NodeStatus status = tree_->tickOnce(input());
    driving_.statuses.assign(tree_->statuses().begin(), tree_->statuses().end());
    updateGoalsLeft(status);
    isDone_ = status == NodeStatus::Success || status == NodeStatus::Failure;
    hasFailed_ = status == NodeStatus::Failure;
    if (hasFailed_) {
      servers_->countTreeFailure();
    }
    if (isDone_) {
      end_ = endWith(status);
      tree_->halt(input());
    }
  }

  sim2d::NavigationResult endWith(NodeStatus status) const {
    sim2d::NavigationResult end;
    end.hasSucceeded = status == NodeStatus::Success;
    end.goals = route_.left();
    if (!end.hasSucceeded) {
      explainFailure(end);
    }
    return end;
  }

  /// Explains a failure by the action that just failed, otherwise by the failed node.
  void explainFailure(sim2d::NavigationResult& end) const {
    const std::optional<ActionFailure>& failure = servers_->lastFailure();
    const std::string node = failedLeaf();
    if (!failure || (!servers_->failedSinceLastTick() && !node.empty())) {
      end.reason = node.empty() ? "the tree returned FAILURE" : "node " + node;
      end.message = node.empty() ? "" : "the node returned FAILURE";
      return;
    }
    end.reason = failureReason(*failure, servers_->distro());
    end.message = failureMessage(*failure);
    end.errorCode = servers_->distro() == sim2d::nav2::Distro::Humble ? 0 : failure->errorCode;
  }

  /// Name of the last leaf that returned FAILURE in this tick; empty: none.
  std::string failedLeaf() const {
    for (int node = loaded_.program->nodeCount(); node-- > 0;) {
      const bool isLeaf = loaded_.program->node(node).children == 0;
      if (isLeaf && driving_.statuses[static_cast<std::size_t>(node)] == NodeStatus::Failure) {
        return loaded_.program->label(node);
      }
    }
    return {};
  }

  /// The masks of both costmaps, equal ones once.
  const std::vector<sim2d::MaskGrid>& masks() const {
    if (!masks_) {
      const double topSpeed = setup_.body.limits.maxVel;
      const sim2d::nav2::Nav2Parameters& parameters = loaded_.parameters;
      masks_ = maskGrids(parameters.globalCostmap, loaded_.masks.global, topSpeed);
      for (sim2d::MaskGrid& mask :
           maskGrids(parameters.localCostmap, loaded_.masks.local, topSpeed)) {
        if (std::find(masks_->begin(), masks_->end(), mask) == masks_->end()) {
          masks_->push_back(std::move(mask));
        }
      }
    }
    return *masks_;
  }

  sim2d::PlannerSetup setup_;
  Nav2Loaded loaded_;
  Nav2Latencies latencies_;
  Nav2Waypoints waypoints_;
  std::unique_ptr<TreeState> tree_;
  sim2d::TreeStatus driving_;
  ProgramResults results_;
  std::unique_ptr<Nav2Servers> servers_;
  Nav2GoalTracker route_;
  std::optional<double> startTime_;             // [s], first call
  std::int64_t step_ = 0;                       // number of ticks
  int orders_ = 0;                              // in the previous observation
  std::optional<sim2d::NavigationResult> end_;  // set in the last tick
  std::vector<sim2d::PlannerEvent> photos_;
  bool isDone_ = false, hasFailed_ = false, hasScan_ = false;
  bool isWaiting_ = false;  // at a goal, for its task
  bool watchesCosts_ = false, recordsTrajectories_ = false;
  mutable CostmapSnapshot localCosts_, globalCosts_;
  mutable std::optional<std::vector<sim2d::MaskGrid>> masks_;
};

/// Costmap errors for a file with other errors, for which no servers are created.
base::Diagnostics costmapErrors(const Nav2Loaded& loaded) {
  base::Diagnostics errors;
  if (loaded.parameters.file.empty()) {
    return errors;
  }
  for (base::Diagnostic& problem : Nav2Servers::costmapProblems(
           {loaded.parameters, {}, {}, {}, 1, -1, loaded.masks.local, loaded.masks.global})) {
    if (problem.severity == base::Severity::Error) {
      errors.push_back(std::move(problem));
    }
  }
  return errors;
}

base::Result<std::shared_ptr<sim2d::Planner>> makeNav2(const sim2d::PlannerSetup& setup,
                                                       const Nav2Folders& shipped) {
  Nav2Options options;
  optionTable().set(options, setup.parameters);
  Nav2Loaded loaded = loadNav2(setup.nav2, setup.folder, setup.robot, shipped);
  base::Diagnostics problems = loaded.problems;
  base::append(problems, loaded.invalidValues);
  base::append(problems, nav2Inconsistencies(loaded.parameters,
                                             base::hasErrors(problems) ? nullptr : &setup));
  if (base::hasErrors(problems)) {
    base::append(problems, costmapErrors(loaded));
    return problems;
  }
  return {std::shared_ptr<sim2d::Planner>(
              std::make_shared<Nav2Planner>(setup, std::move(loaded), options)),
          std::move(problems)};
}

}  // namespace

void addNav2(sim2d::PlannerRegistry& to, const Nav2Folders& shipped) {
  to.add(
      sim2d::kNav2Planner, optionTable().specs(),
      [shipped](const sim2d::PlannerSetup& setup) { return makeNav2(setup, shipped); },
      "Nav2 without ROS: uses your nav2_params.yaml and navigator tree.");
}

void Nav2GoalTracker::begin(const base::Pose2& from, const base::Vec2& goal,
                            const std::vector<base::Vec2>& after, bool isThrough) {
  isThrough_ = isThrough;
  reached_ = passed_ = 0;
  poses_.clear();
  base::Vec2 last = from.position;
  const auto add = [&](const base::Vec2& point) {
    const base::Vec2 way = point - last;
    poses_.push_back({point, base::atan2(way.y(), way.x())});
    last = point;
  };
  add(goal);
  if (isThrough) {
    std::for_each(after.begin(), after.end(), add);
  }
}

bool Nav2GoalTracker::continuesTo(const base::Vec2& goal, const std::vector<base::Vec2>& after) {
  const std::size_t wanted = isThrough_ ? after.size() + 1 : 1;
  if (wanted > poses_.size()) {
    return false;
  }
  const std::size_t first = poses_.size() - wanted;
  bool isSame = poses_[first].position == goal;
  for (std::size_t k = 1; k < wanted && isSame; ++k) {
    isSame = poses_[first + k].position == after[k - 1];
  }
  reached_ = isSame ? first : reached_;
  return isSame;
}

void Nav2GoalTracker::setGoalsLeftInTree(std::size_t count) {
  if (isThrough_ && count > 0 && count <= poses_.size()) {
    passed_ = std::max(passed_, poses_.size() - count);
  }
}

std::size_t Nav2GoalTracker::takePassed() {
  const std::size_t more = passed_ > reached_ ? passed_ - reached_ : 0;
  reached_ += more;
  return more;
}

Nav2Waypoints::Nav2Waypoints(const std::optional<sim2d::nav2::WaypointFollowerParameters>& follower,
                             bool isWanted)
    : isWanted_(isWanted) {
  if (follower) {
    task_ = follower->task;
  }
}

std::optional<std::string> Nav2Waypoints::reach(double time, const base::Pose2& pose) {
  busyUntil_ = time + sim2d::nav2::waypointTaskDuration(task_) - kTick;
  if (!task_.enabled || task_.kind != sim2d::nav2::WaypointTask::Photo) {
    return std::nullopt;
  }
  return base::formatDecimals(pose.position.x(), 2) + " " +
         base::formatDecimals(pose.position.y(), 2) + " " + base::formatDecimals(pose.heading, 2);
}

}  // namespace bt
