#include "sim2d/world/RobotDrive.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "sim2d/nav/Motion.h"
#include "sim2d/nav/Teleop.h"
#include "sim2d/trace/Arrival.h"
#include "sim2d/world/GoalEnding.h"
#include "sim2d/world/RobotBatteries.h"

namespace sim2d {
namespace {

/// Whether its planner is asked.
bool wantsToBeAsked(const Planner& planner, const ResolvedRobot& robot, const RobotState& state,
                    double time) {
  const bool hasGoal = currentGoal(robot, state) || !planner.needsGoal();
  return hasGoal && time >= robot.startTime - kTick;
}

bool drives(const ResolvedRobot& robot, const RobotState& state, double time) {
  return currentGoal(robot, state) && time >= robot.startTime - kTick;
}

bool isFinite(const BodyTwist& twist) {
  return std::isfinite(twist.linear) && std::isfinite(twist.angular) &&
         std::isfinite(twist.lateral);
}

/// A step to a position that is not finite is refused here, so planners need not check it.
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

/// Turns that nobody looks at are not made: they take more time than most planners.
void RobotDrive::sense(const FrozenWorld& world) {
  const std::vector<ResolvedRobot>& robots = world.model.robots;
  scanUses_.resize(robots.size());
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const bool isUnderWay =
        currentGoal(robots[i], world.state.robots[i]) || !planners_[i]->needsGoal();
    const bool readsScan = planners_[i]->readsScan();
    const bool isRead = wantsSenses_ || robots[i].recordsScans || (isUnderWay && readsScan);
    // A planner that waits sets off with the last turn.
    const bool mayBeRead = wantsScans_ || readsScan;
    scanUses_[i] = isRead ? ScanUse::Now : mayBeRead ? ScanUse::Later : ScanUse::None;
  }
  sensors_.update(world, scanUses_);
  scans_.clear();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (robots[i].recordsScans && sensors_.hasTurned(i)) {
      scans_.push_back({world.state.step, robots[i].id, shownScan(*sensors_.scan(i))});
    }
  }
}

void RobotDrive::steer(std::size_t robot, const BodyTwist& command) {
  if (auto* const teleop = dynamic_cast<TeleopPlanner*>(planners_[robot].get())) {
    teleop->input()->drive(command);
  } else {
    steered_[robot] = command;
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
  observation_.goalsAfter.clear();
  for (std::size_t later = now.goal + 1; !now.order && later < constants.goals.size(); ++later) {
    observation_.goalsAfter.push_back(constants.goals[later]);
  }
  observation_.orders = now.orders;
  observation_.goalRadius = constants.goalRadius;
  observation_.time = world.state.time;
  observation_.dt = world.model.dt;
  observation_.bodies = sensors_.bodies(robot);
  observation_.scan = sensors_.scan(robot);
  observation_.battery = batteryOf(constants, now);
  observation_.docks = docksSeen(world.model.docks, now.pose, observation_.pose);
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

BodyTwist RobotDrive::ask(std::size_t robot, const std::string& name) {
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

/// A node of a tree that was not ticked is IDLE.
void RobotDrive::noteTree(std::size_t robot, int id, bool isAsked) {
  const DrivingTree* const tree = planners_[robot]->tree();
  if (tree == nullptr) {
    return;
  }
  statuses_.resize(planners_.size());
  std::vector<base::NodeStatus>& before = statuses_[robot];
  before.resize(tree->statuses.size(), base::NodeStatus::Idle);
  for (std::size_t node = 0; node < before.size(); ++node) {
    const base::NodeStatus now = isAsked ? tree->statuses[node] : base::NodeStatus::Idle;
    if (now != before[node]) {
      treeChanges_.add(id, tree->paths, static_cast<int>(node), now);
      before[node] = now;
    }
  }
}

void RobotDrive::addSenses(std::size_t robot, bool isAsked) {
  if (senses_ == nullptr) {
    return;
  }
  RobotSenses& senses = (*senses_)[robot];
  senses.believed = sensors_.pose(robot);
  if (const Localizer& localizer = sensors_.localizer(robot); localizer.isActive()) {
    senses.localizer = {localizer.isLocalized(), localizer.mapToOdom()};
  }
  senses.laterScan = sensors_.laterScan(robot);
  if (const LaserScan* const scan = sensors_.scan(robot);
      scan != nullptr && senses.laterScan == nullptr) {
    senses.scan = shownScan(*scan);
  }
  if (!wantsSenses_) {
    return;
  }
  for (const TrackedBody& body : sensors_.bodies(robot)) {
    senses.bodies.push_back(
        {body.id, body.kind == BodyKind::Robot, body.position, body.velocity, body.radius});
  }
  if (isAsked) {
    addPlanner(senses, *planners_[robot]);
  }
}

void RobotDrive::addPlanner(RobotSenses& senses, const Planner& planner) const {
  for (Candidate& way : planner.candidates()) {
    senses.ways.push_back({std::move(way.points), way.cost, way.isChosen, std::move(way.scores)});
  }
  if (watch_ != nullptr) {
    PlannerView view = planner.view();
    senses.localCosts = std::move(view.localCosts);
    senses.globalCosts = std::move(view.globalCosts);
    senses.controller = std::move(view.controller);
    senses.lookahead = std::move(view.lookahead);
    senses.predicted = std::move(view.predicted);
  }
}

void RobotDrive::watch(Planner& planner) const {
  const bool isWatched = wantsSenses_ && watch_ != nullptr;
  planner.watch(isWatched && watch_->costs, isWatched && watch_->ways);
}

void RobotDrive::takeEvents(std::size_t robot, int id, WorldState& state) {
  for (PlannerEvent& event : planners_[robot]->takeEvents()) {
    const bool isPhoto = event.kind == PlannerEvent::Kind::Photo;
    state.emit(isPhoto ? EventKind::Photo : EventKind::Dock, id, std::move(event.text));
  }
}

/// Goals that its planner drove through, all but the last one.
void RobotDrive::passGoals(std::size_t robot, const ResolvedRobot& constants, WorldState& state) {
  RobotState& now = state.robots[robot];
  for (std::size_t n = planners_[robot]->takePassedGoals(); n > 0; --n) {
    if (!now.order && now.goal + 1 < constants.goals.size()) {
      emitGoal(constants, now.goal, state);
      ++now.goal;
    }
  }
}

void RobotDrive::noteEnd(std::size_t robot) {
  endings_[robot] = {planners_[robot]->endsGoals(), planners_[robot]->takeEnd()};
}

const std::vector<BodyTwist>& RobotDrive::command(const FrozenWorld& world, WorldState& state) {
  commands_.assign(state.robots.size(), BodyTwist{});
  endings_.assign(state.robots.size(), Ending());
  const double dt = world.model.dt;
  senses_.reset();
  if (wantsSenses_ || wantsScans_) {
    senses_ = std::make_shared<std::vector<RobotSenses>>(state.robots.size());
  }
  sense(world);
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    const ResolvedRobot& robot = world.model.robots[i];
    const RobotState& now = state.robots[i];
    BodyTwist wanted;
    bool isAsked = false;
    const auto steered = steered_.find(i);
    const bool isSteered = steered != steered_.end();
    const bool wantsPlanner = wantsToBeAsked(*planners_[i], robot, now, state.time);
    if (isSteered && !(wantsPlanner && planners_[i]->wantsTeleop())) {
      wanted = steered->second;
    } else if (wantsPlanner) {
      observe(world, i);
      if (isSteered) {
        observation_.teleop = steered->second;
      }
      watch(*planners_[i]);
      wanted = ask(i, robot.name);
      isAsked = true;
      if (planners_[i]->takeReplanned()) {
        state.emit(EventKind::Replan, robot.id);
      }
      if (planners_[i]->takeRelocalization()) {
        sensors_.relocalize(i);
      }
      takeEvents(i, robot.id, state);
      passGoals(i, robot, state);
      noteEnd(i);
    }
    if (robot.battery.exists() && now.battery <= 0.0) {
      wanted = {};  // it has no power
    }
    noteTree(i, robot.id, isAsked);
    addSenses(i, isAsked);
    commands_[i] = reached(bodies_[i], {now.linear, now.omega, now.lateral}, wanted, dt);
  }
  steered_.clear();
  return commands_;
}

void RobotDrive::afterMotion(const WorldModel& model, WorldState& state) {
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    const ResolvedRobot& robot = model.robots[i];
    RobotState& now = state.robots[i];
    if (!drives(robot, now, state.time)) {
      continue;
    }
    if (endings_[i].isDecided) {
      if (endings_[i].end) {
        endGoals(robot, *endings_[i].end, now, state);
      }
      continue;
    }
    if ((*currentGoal(robot, now) - now.pose.position).norm() > robot.goalRadius) {
      continue;
    }
    const bool isOrder = std::exchange(now.order, std::nullopt).has_value();
    if (isOrder) {
      state.emit(EventKind::Goal, robot.id);
    } else {
      emitGoal(robot, now.goal, state);
      ++now.goal;
    }
    if (now.goal == robot.goals.size()) {
      now.arrivedAt = state.time;
      state.emit(EventKind::Arrived, robot.id, isOrder ? kAtOrder : "");
    }
  }
}

std::vector<Vec2> RobotDrive::path(std::size_t robot, const WorldModel& model,
                                   const WorldState& state) const {
  const bool isOnTheWay =
      wantsToBeAsked(*planners_[robot], model.robots[robot], state.robots[robot], state.time);
  return isOnTheWay ? planners_[robot]->path() : std::vector<Vec2>{};
}

}  // namespace sim2d
