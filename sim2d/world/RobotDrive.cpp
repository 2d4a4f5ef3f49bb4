#include "sim2d/world/RobotDrive.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/map/PathPlanner.h"
#include "sim2d/nav/DriveKinematics.h"
#include "sim2d/nav/Teleop.h"
#include "sim2d/trace/Frame.h"
#include "sim2d/world/RobotSensors.h"

namespace sim2d {
namespace {

/// Whether the planner is called in this step.
bool isPlannerDue(const Planner& planner, const ResolvedRobot& robot, const RobotState& state,
                  double time) {
  const bool hasGoal = currentGoal(robot, state) || !planner.needsGoal();
  return hasGoal && time >= robot.startTime - kTimeTolerance;
}

bool drives(const ResolvedRobot& robot, const RobotState& state, double time) {
  return currentGoal(robot, state) && time >= robot.startTime - kTimeTolerance;
}

bool isFinite(const BodyTwist& twist) {
  return std::isfinite(twist.linear) && std::isfinite(twist.angular) &&
         std::isfinite(twist.lateral);
}

/// Rejects non-finite observations (after a step to such a position), so that planners need not
/// check.
bool isFinite(const Observation& observation) {
  const auto isFiniteBody = [](const TrackedBody& body) {
    return body.position.allFinite() && body.velocity.allFinite() && std::isfinite(body.heading);
  };
  return observation.pose.position.allFinite() && std::isfinite(observation.pose.heading) &&
         isFinite(observation.motion) &&
         std::all_of(observation.bodies.begin(), observation.bodies.end(), isFiniteBody);
}

}  // namespace

RobotDrive::RobotDrive(std::vector<std::shared_ptr<Planner>> planners, const WorldModel& model)
    : planners_(std::move(planners)), sensors_(model) {
  std::transform(model.robots.begin(), model.robots.end(), std::back_inserter(bodies_), bodyOf);
}

/// Scans that are not read are not computed: they take more time than most planners.
void RobotDrive::sense(const FrozenWorld& world) {
  const std::vector<ResolvedRobot>& robots = world.model.robots;
  scanUses_.resize(robots.size());
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const bool isUnderWay =
        currentGoal(robots[i], world.state.robots[i]) || !planners_[i]->needsGoal();
    const bool readsScan = planners_[i]->readsScan();
    const bool isRead = publishesSensors_ || robots[i].recordsScans || (isUnderWay && readsScan);
    // A waiting planner starts with the last scan.
    const bool mayBeRead = publishesScans_ || readsScan;
    scanUses_[i] = isRead ? ScanDemand::Now : mayBeRead ? ScanDemand::Later : ScanDemand::None;
  }
  sensors_.update(world, scanUses_);
  scans_.clear();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (robots[i].recordsScans && sensors_.hasTurned(i)) {
      scans_.push_back({world.state.step, robots[i].id, toFrameScan(*sensors_.scan(i))});
    }
  }
}

void RobotDrive::steer(std::size_t robot, const BodyTwist& command) {
  if (auto* const teleop = dynamic_cast<TeleopPlanner*>(planners_[robot].get())) {
    teleop->input()->drive(command);
  } else {
    overrides_[robot] = command;
  }
}

void RobotDrive::observe(const FrozenWorld& world, std::size_t robot) {
  const ResolvedRobot& constants = world.model.robots[robot];
  const RobotState& now = world.state.robots[robot];
  observation_.pose = sensors_.pose(robot);
  observation_.mapToOdom = sensors_.localizer(robot).mapToOdom();
  observation_.isLocalized = sensors_.localizer(robot).isLocalized();
  observation_.canRelocalize = sensors_.localizer(robot).canRelocalize();
  observation_.motion = sensors_.odometry(robot).motion();
  observation_.goal = currentGoal(constants, now).value_or(observation_.pose.position);
  observation_.remainingGoals.clear();
  for (std::size_t later = now.goal + 1; !now.externalGoal && later < constants.goals.size();
       ++later) {
    observation_.remainingGoals.push_back(constants.goals[later]);
  }
  observation_.externalGoalCount = now.externalGoalCount;
  observation_.goalRadius = constants.goalRadius;
  observation_.time = world.state.time;
  observation_.dt = world.model.dt;
  observation_.bodies = sensors_.bodies(robot);
  observation_.scan = sensors_.scan(robot);
  observation_.battery = measuredBattery(constants, now);
  observation_.docks = detectedDocks(world.model.docks, now.pose, observation_.pose);
  observation_.teleop.reset();
  observation_.obstacles = &world.obstacles;
  observation_.navigation = &world.navigation;
}

void RobotDrive::reseed(std::uint64_t seed) {
  sensors_.reseed(seed);
  for (const std::shared_ptr<Planner>& planner : planners_) {
    planner->reseed(seed);
  }
}

BodyTwist RobotDrive::callPlanner(std::size_t robot, const std::string& name) {
  if (!isFinite(observation_)) {
    failure_ = base::error("world.observation-not-finite", {name}).message;
    return {};
  }
  const base::Result<BodyTwist> wanted = planners_[robot]->command(observation_);
  if (wanted && isFinite(*wanted)) {
    return *wanted;
  }
  if (wanted) {
    failure_ = base::error("world.command-not-finite", {name}).message;
    return {};
  }
  const std::string& said = wanted.diagnostics().front().message;
  const std::string who = "robot '" + name + "': ";
  failure_ = said.rfind(who, 0) == 0 ? said : who + said;
  return {};
}

/// Nodes that were not ticked are IDLE.
void RobotDrive::recordTreeStatus(std::size_t robot, int id, bool isCalled) {
  const TreeStatus* const tree = planners_[robot]->tree();
  if (tree == nullptr) {
    return;
  }
  statuses_.resize(planners_.size());
  std::vector<base::NodeStatus>& before = statuses_[robot];
  before.resize(tree->statuses.size(), base::NodeStatus::Idle);
  for (std::size_t node = 0; node < before.size(); ++node) {
    const base::NodeStatus now = isCalled ? tree->statuses[node] : base::NodeStatus::Idle;
    if (now != before[node]) {
      treeChanges_.add(id, tree->paths, static_cast<int>(node), now);
      before[node] = now;
    }
  }
}

void RobotDrive::addPerception(std::size_t robot, bool isCalled) {
  if (senses_ == nullptr) {
    return;
  }
  RobotTelemetry& senses = (*senses_)[robot];
  senses.believed = sensors_.pose(robot);
  if (const Localizer& localizer = sensors_.localizer(robot); localizer.isActive()) {
    senses.localizer = {localizer.isLocalized(), localizer.mapToOdom()};
  }
  senses.deferredScan = sensors_.deferredScan(robot);
  if (const LaserScan* const scan = sensors_.scan(robot);
      scan != nullptr && senses.deferredScan == nullptr) {
    senses.scan = toFrameScan(*scan);
  }
  if (!publishesSensors_) {
    return;
  }
  for (const TrackedBody& body : sensors_.bodies(robot)) {
    senses.bodies.push_back(
        {body.id, body.kind == BodyKind::Robot, body.position, body.velocity, body.radius});
  }
  if (isCalled) {
    addPlanner(senses, *planners_[robot]);
  }
}

void RobotDrive::addPlanner(RobotTelemetry& senses, const Planner& planner) const {
  for (Candidate& way : planner.candidates()) {
    senses.ways.push_back({std::move(way.points), way.cost, way.isChosen, std::move(way.scores)});
  }
  if (watch_ != nullptr) {
    PlannerView view = planner.view();
    senses.localCosts = std::move(view.localCosts);
    senses.globalCosts = std::move(view.globalCosts);
    senses.masks = std::move(view.masks);
    senses.controller = std::move(view.controller);
    senses.lookahead = std::move(view.lookahead);
    senses.predicted = std::move(view.predicted);
  }
}

void RobotDrive::watch(Planner& planner) const {
  const bool isWatched = publishesSensors_ && watch_ != nullptr;
  planner.watch(isWatched && watch_->costs, isWatched && watch_->ways);
}

void RobotDrive::takeEvents(std::size_t robot, int id, WorldState& state) {
  for (PlannerEvent& event : planners_[robot]->takeEvents()) {
    const bool isPhoto = event.kind == PlannerEvent::Kind::Photo;
    state.emit(isPhoto ? EventKind::Photo : EventKind::Dock, id, std::move(event.text));
  }
}

/// Marks goals as reached that the planner passed, except the last one.
void RobotDrive::passGoals(std::size_t robot, const ResolvedRobot& constants, WorldState& state) {
  RobotState& now = state.robots[robot];
  for (std::size_t n = planners_[robot]->takePassedGoals(); n > 0; --n) {
    if (!now.externalGoal && now.goal + 1 < constants.goals.size()) {
      emitGoal(constants, now.goal, state);
      ++now.goal;
    }
  }
}

void RobotDrive::recordNavigationResult(std::size_t robot) {
  goalDecisions_[robot] = {planners_[robot]->decidesGoalEnd(),
                           planners_[robot]->takeNavigationResult()};
}

const std::vector<BodyTwist>& RobotDrive::command(const FrozenWorld& world, WorldState& state) {
  commands_.assign(state.robots.size(), BodyTwist{});
  goalDecisions_.assign(state.robots.size(), GoalDecision());
  const double dt = world.model.dt;
  senses_.reset();
  if (publishesSensors_ || publishesScans_) {
    senses_ = std::make_shared<std::vector<RobotTelemetry>>(state.robots.size());
  }
  sense(world);
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    const ResolvedRobot& robot = world.model.robots[i];
    const RobotState& now = state.robots[i];
    BodyTwist wanted;
    bool isCalled = false;
    const auto steered = overrides_.find(i);
    const bool isSteered = steered != overrides_.end();
    const bool wantsPlanner = isPlannerDue(*planners_[i], robot, now, state.time);
    if (isSteered && !(wantsPlanner && planners_[i]->usesTeleop())) {
      wanted = steered->second;
    } else if (wantsPlanner) {
      observe(world, i);
      if (isSteered) {
        observation_.teleop = steered->second;
      }
      watch(*planners_[i]);
      wanted = callPlanner(i, robot.name);
      isCalled = true;
      if (planners_[i]->takeReplanned()) {
        state.emit(EventKind::Replan, robot.id);
      }
      if (planners_[i]->takeRelocalizationRequest()) {
        sensors_.relocalize(i);
      }
      takeEvents(i, robot.id, state);
      passGoals(i, robot, state);
      recordNavigationResult(i);
    }
    if (robot.battery.exists() && now.battery <= 0.0) {
      wanted = {};  // no power
    }
    recordTreeStatus(i, robot.id, isCalled);
    addPerception(i, isCalled);
    commands_[i] = reached(bodies_[i], {now.linear, now.omega, now.lateral}, wanted, dt);
  }
  overrides_.clear();
  return commands_;
}

void RobotDrive::afterMotion(const WorldModel& model, WorldState& state) {
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    const ResolvedRobot& robot = model.robots[i];
    RobotState& now = state.robots[i];
    if (!drives(robot, now, state.time)) {
      continue;
    }
    if (goalDecisions_[i].isDecided) {
      if (goalDecisions_[i].end) {
        completeGoals(robot, *goalDecisions_[i].end, now, state);
      }
      continue;
    }
    if ((*currentGoal(robot, now) - now.pose.position).norm() > robot.goalRadius) {
      continue;
    }
    const bool isExternal = std::exchange(now.externalGoal, std::nullopt).has_value();
    if (isExternal) {
      state.emit(EventKind::Goal, robot.id);
    } else {
      emitGoal(robot, now.goal, state);
      ++now.goal;
    }
    if (now.goal == robot.goals.size()) {
      now.arrivedAt = state.time;
      state.emit(EventKind::Arrived, robot.id, isExternal ? kOrderText : "");
    }
  }
}

std::vector<Vec2> RobotDrive::path(std::size_t robot, const WorldModel& model,
                                   const WorldState& state) const {
  const bool isOnTheWay =
      isPlannerDue(*planners_[robot], model.robots[robot], state.robots[robot], state.time);
  return isOnTheWay ? planners_[robot]->path() : std::vector<Vec2>{};
}

namespace {

constexpr double kMillimetres = 1000.0;

GoalResult goalResultOf(const ResolvedRobot& robot, const NavigationResult& end,
                        const RobotState& now, double time) {
  const std::size_t left = robot.goals.size() - std::min(now.goal, robot.goals.size());
  GoalResult over;
  over.result = end;
  over.time = time;
  over.isExternal = now.externalGoal.has_value();
  Vec2 goal = now.externalGoal.value_or(now.pose.position);
  if (!over.isExternal && left > 0) {
    const std::size_t last = now.goal + std::clamp(end.goals, std::size_t{1}, left) - 1;
    goal = robot.goals[last];
    over.goal = std::max(robot.goalIds[last], 0);
    over.number = static_cast<int>(last) + 1;
    over.isOneOfMany = robot.goals.size() > 1;
  }
  over.distance = (goal - now.pose.position).norm();
  over.isReached = end.hasSucceeded &&
                   over.distance <= robot.goalRadius + kGoalReachedTolerance + kTimeTolerance;
  return over;
}

/// Ends an external goal; more of them may follow.
void completeExternalGoal(const ResolvedRobot& robot, bool isReached, RobotState& now,
                          WorldState& state) {
  now.externalGoal.reset();
  if (!isReached) {
    now.endTime = state.time;
    return;
  }
  now.arrivedAt = state.time;
  state.emit(EventKind::Goal, robot.id);
  state.emit(EventKind::Arrived, robot.id, kOrderText);
}

void completeListedGoals(const ResolvedRobot& robot, const GoalResult& over, RobotState& now,
                         WorldState& state) {
  const std::size_t end = static_cast<std::size_t>(over.number);
  for (; now.goal < end; ++now.goal) {
    if (over.isReached) {
      emitGoal(robot, now.goal, state);
    }
  }
  if (now.goal < robot.goals.size()) {
    return;
  }
  if (std::all_of(now.goalResults.begin(), now.goalResults.end(),
                  [](const GoalResult& each) { return each.isReached || each.isExternal; })) {
    now.arrivedAt = state.time;
    state.emit(EventKind::Arrived, robot.id);
  } else {
    now.endTime = state.time;
  }
}

std::string distanceText(const GoalResult& end) {
  const double rounded = std::round(end.distance * kMillimetres) / kMillimetres;
  return base::formatDouble(rounded) + " m from the goal";
}

}  // namespace

std::string goalResultText(const GoalResult& end) {
  const std::string reason = goalResultReason(end);
  return end.result.hasSucceeded ? reason : reason + ", " + distanceText(end);
}

std::string goalResultReason(const GoalResult& end) {
  std::string text;
  if (end.isOneOfMany) {
    text = "goal " + std::to_string(end.goal > 0 ? end.goal : end.number) + ": ";
  }
  return text + (end.result.hasSucceeded ? distanceText(end) : end.result.reason);
}

void emitGoal(const ResolvedRobot& robot, std::size_t goal, WorldState& state) {
  const int id = robot.goalIds[goal];
  state.emit(EventKind::Goal, robot.id, id > 0 ? std::to_string(id) : "");
}

void completeGoals(const ResolvedRobot& robot, const NavigationResult& end, RobotState& now,
                   WorldState& state) {
  if (!currentGoal(robot, now)) {
    return;
  }
  const GoalResult over = goalResultOf(robot, end, now, state.time);
  now.goalResults.push_back(over);
  state.emit(end.hasSucceeded ? EventKind::NavigationSucceeded : EventKind::NavigationFailed,
             robot.id, goalResultText(over));
  if (over.isExternal) {
    completeExternalGoal(robot, over.isReached, now, state);
  } else {
    completeListedGoals(robot, over, now, state);
  }
}

namespace {

constexpr double kStuckCheckInterval =
    0.1;  // [s]; planning a path costs more than a step of a few people

}  // namespace

StuckRobots::StuckRobots(const WorldModel& model) {
  if (model.stuckAfter > 0.0) {
    robots_.resize(model.robots.size(), unstuck(model));
  }
}

/// The recovery is done by the robot's planner, so its distance is 0 here.
StuckRobots::MonitoredRobot StuckRobots::unstuck(const WorldModel& model) {
  return {StuckDetector(model.stuckAfter - kTimeTolerance, 0.0), {}};
}

void StuckRobots::update(const WorldModel& model, WorldState& state,
                         const NavigationMap& navigation, bool willDoorToggle) {
  if (robots_.empty() || state.time < nextCheck_ - kTimeTolerance) {
    return;
  }
  nextCheck_ = state.time + kStuckCheckInterval;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const ResolvedRobot& robot = model.robots[i];
    const RobotState& now = state.robots[i];
    MonitoredRobot& watched = robots_[i];
    const std::optional<Vec2> current = currentGoal(robot, now);
    if (!current) {
      watched = unstuck(model);  // it may get another goal
      continue;
    }
    if (state.time < robot.startTime - kTimeTolerance) {
      continue;
    }
    const Vec2& place = now.pose.position;
    const Vec2& goal = *current;
    const std::vector<Vec2> way = navigation.plan(circumscribedRadius(robot), place, goal);
    if (way.empty() && willDoorToggle) {
      watched = unstuck(model);
      continue;
    }
    // Without a path some planners drive up to the obstacle.
    watched.watch.update(state.time, place, goal,
                         way.empty() ? (goal - place).norm() : polylineLength(way));
    if (watched.watch.tries() == 0) {
      watched.since.reset();
    } else if (!watched.since) {
      watched.since = state.time;
      state.emit(EventKind::Stuck, robot.id);
    }
  }
}

std::optional<double> StuckRobots::stuckSince(std::size_t robot) const {
  return robots_.empty() ? std::nullopt : robots_[robot].since;
}

}  // namespace sim2d
