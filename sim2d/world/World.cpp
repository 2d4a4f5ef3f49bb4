#include "sim2d/world/World.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "sim2d/world/StepBuffers.h"

namespace sim2d {
namespace {

/// Middle of the map, or of the people's starts: positions are rounded relative to it, and must not
/// depend on robots.
Vec2 centreOf(const WorldModel& model, const OccupancyGrid& map) {
  if (!map.isEmpty()) {
    return map.cornerToWorld(map.width() / 2.0, map.height() / 2.0);
  }
  Vec2 sum = Vec2::Zero();
  double count = 0.0;
  for (const Person& person : model.people) {
    sum += person.constants.start.position;
    count += 1.0;
  }
  for (std::size_t i = 0; model.people.empty() && i < model.robots.size(); ++i) {
    sum += model.robots[i].start.position;
    count += 1.0;
  }
  return count > 0.0 ? Vec2(sum / count) : Vec2(Vec2::Zero());
}

}  // namespace

WorldBase::WorldBase(WorldParts& parts, std::unique_ptr<HumanBehavior> humanBehavior)
    : model_(std::move(parts.model)),
      surroundings_(std::move(parts.surroundings)),
      pathWork_(surroundings_.layers->stopFlag()),
      navigation_(std::move(parts.navigation)),
      frozen_{model_, state_, grid_, surroundings_.obstacles, *navigation_},
      view_(frozen_),
      intents_(state_.controls),
      behavior_(std::move(humanBehavior)),
      motion_(model_.threads) {
  for (const Door* door : model_.doors) {
    state_.doorOpen.push_back(door->open.value_or(true) ? 1 : 0);
  }
  for (std::vector<Vec2>* column : {&state_.positions, &state_.velocities}) {
    column->reserve(model_.people.size());
  }
  state_.heading.reserve(model_.people.size());
  state_.omega.reserve(model_.people.size());
  state_.controls.reserve(model_.people.size());
  state_.events.reserve(model_.people.size());
  for (const Person& person : model_.people) {
    state_.append(person);
  }
}

World::World(WorldParts parts, std::unique_ptr<HumanBehavior> humanBehavior)
    : WorldBase(parts, std::move(humanBehavior)),
      physics_(centreOf(model_, surroundings_.grid)),
      population_(model_),
      robots_(std::move(parts.planners), model_),
      stuckRobots_(model_) {
  partNames_ = partNames(*model_.environment);
  const Obstacles& obstacles = surroundings_.obstacles;
  for (int part = 0; part < obstacles.partCount(); ++part) {
    physics_.addPart(obstacles.outlines(part), obstacles.isEnabled(part));
  }
  pastToggles_.resize(model_.doors.size(), 0);
  humans_.reserve(model_.people.size());
  physics_.reserve(model_.robots.size() + model_.people.size());
  addRobotBodies();
  StepTimer watch(nullptr);
  applyInputs(watch);
  publish();
}

void World::addRobotBodies() {
  for (const ResolvedRobot& robot : model_.robots) {
    RobotState start;
    start.pose = robot.start;
    start.pose.heading = base::wrapToPi(robot.start.heading);
    start.battery = robot.battery.level;
    state_.robots.push_back(start);
    // Outside the solver until it comes near an obstacle or body.
    physics_.addBody({start.pose, robot.radius, robot.mass, robot.footprint, false, false, true});
    robotRadii_.push_back(circumscribedRadius(robot));
  }
}

/// Toggle times have a tolerance for rounding.
void World::toggleDoors() {
  for (std::size_t door = 0; door < model_.doors.size(); ++door) {
    std::vector<double> toggles = model_.doors[door]->toggles;
    std::sort(toggles.begin(), toggles.end());
    for (std::size_t& next = pastToggles_[door];
         next < toggles.size() && toggles[next] <= state_.time + kTimeTolerance; ++next) {
      setDoor(door, state_.doorOpen[door] == 0);
    }
  }
}

void World::setDoor(std::size_t door, bool open) {
  state_.doorOpen[door] = open ? 1 : 0;
  const int part = surroundings_.firstDoorPart + static_cast<int>(door);
  surroundings_.obstacles.setEnabled(part, !open);
  physics_.setPartEnabled(part, !open);
  doorsChanged_ = true;
  state_.emit(EventKind::Door, 0, model_.doors[door]->name + (open ? " open" : " closed"));
  state_.events.back().hasId = false;
}

void World::updateNavigation() {
  if (doorsChanged_) {
    navigation_->update(surroundings_.grid, surroundings_.obstacles);
    doorsChanged_ = false;
  }
}

void World::applyInputs(StepTimer& watch) {
  toggleDoors();
  updateNavigation();
  const std::vector<std::size_t> due = population_.takeDue(model_, state_, *navigation_);
  place(due);
  intents_.reset();
  watch.lap(StepPhase::Goals);
  grid_.rebuild(state_.positions, state_.present);
  watch.lap(StepPhase::Grid);
  for (const std::size_t human : due) {
    behavior_->enter(static_cast<int>(human), view_);
  }
}

void World::place(const std::vector<std::size_t>& newcomers) {
  motion_.resize(model_.people.size());
  goals_.resize(model_.people.size());
  bodies_.resize(model_.people.size(), -1);
  for (const std::size_t human : newcomers) {
    enter(human);
  }
}

void World::enter(std::size_t human) {
  const Person& person = model_.people[human];
  const Pose2 start{person.constants.start.position,
                    base::wrapToPi(person.constants.start.heading)};
  state_.positions[human] = start.position;
  state_.heading[human] = start.heading;
  state_.velocities[human] = Vec2::Zero();
  state_.omega[human] = 0.0;
  state_.active[human] = 0;
  state_.held[human] = 0;
  state_.controls[human] = HumanControl{person.plan->goals, false, person.constants.groupId};
  motion_.enter(human);
  goals_.enter(human);
  if (bodies_[human] < 0) {
    bodies_[human] = physics_.addBody({start, person.constants.radius, person.constants.mass,
                                       std::vector<Vec2>(), true, model_.peoplePass,
                                       model_.people.size() > kSolverPeopleLimit});
    humans_.push_back(human);
  } else {
    physics_.place(bodies_[human], start);
    physics_.setPresent(bodies_[human], true);
  }
  state_.emit(EventKind::Enter, person.constants.id);
}

void World::leave(std::size_t human) {
  state_.present[human] = 0;
  physics_.setPresent(bodies_[human], false);
}

void World::handleArrivals() {
  for (const std::size_t human : goals_.takeArrived()) {
    const ResolvedHuman& person = model_.people[human].constants;
    if (state_.present[human] == 0) {
      continue;
    }
    const bool isInSink =
        std::any_of(model_.areas.begin(), model_.areas.end(), [&](const Area* area) {
          return area->kind == AreaKind::Sink && isInside(area->points, state_.position(human));
        });
    if (person.atEnd == AtEnd::Leave || isInSink) {
      leave(human);
      state_.emit(EventKind::Leave, person.id);
    } else if (person.atEnd == AtEnd::Restart) {
      leave(human);
      population_.enqueue(human);
    }
  }
}

bool World::step(const StepInputs& inputs) {
  if (!failure_.empty()) {
    return false;
  }
  StepTimer watch(times_);
  state_.events.clear();
  shrinkExcess(state_.events, frame_.events.size());
  take(inputs);
  headingsBefore_ = state_.heading;
  motion_.wakeWorkers();
  decide();
  watch.lap(StepPhase::Trees);
  const std::vector<BodyTwist>& commands = robots_.command(frozen_, state_);
  watch.lap(StepPhase::Robots);
  motion_.chooseDirections(frozen_, intents_, state_);
  watch.lap(StepPhase::Ways);
  motion_.compute(frozen_, intents_, state_, frame_.forces);
  failure_ = divergenceMessage(commands);
  if (!failure_.empty()) {
    frame_.forces = {};  // they belong to the failed step
    return false;
  }
  for (const VelocityOverride& steering : velocityOverrides_) {
    const Vec2& own = motion_.wanted()[steering.human];
    motion_.overrideVelocity(steering.human,
                             steering.isBeside ? Vec2(own + steering.velocity) : steering.velocity);
  }
  watch.lap(StepPhase::Forces);
  moveBodies(commands);
  watch.lap(StepPhase::Bodies);
  ++state_.step;
  state_.time = static_cast<double>(state_.step) * model_.dt;
  emitContacts(commands);
  watch.lap(StepPhase::Contacts);
  afterMotion();
  applyInputs(watch);
  publish();
  watch.lap(StepPhase::Frame);
  if (times_ != nullptr) {
    ++times_->steps;
  }
  return true;
}

void World::afterMotion() {
  goals_.afterMotion(model_, state_, intents_);
  robots_.afterMotion(model_, state_);
  updateBatteries(model_, state_);
  stuckRobots_.update(model_, state_, *navigation_, willDoorToggle());
  handleArrivals();
  for (std::size_t i = 0; i < model_.people.size(); ++i) {
    state_.active[i] = intents_.of(static_cast<int>(i)).active ? 1 : 0;
  }
}

bool World::willDoorToggle() const {
  for (std::size_t door = 0; door < model_.doors.size(); ++door) {
    if (pastToggles_[door] < model_.doors[door]->toggles.size()) {
      return true;
    }
  }
  return false;
}

void World::decide() {
  intents_.reset();
  behavior_->decide(view_, intents_);
  applyHolds();
  goals_.afterDecide(model_, state_, intents_, view_);
}

/// Their trees keep running; only the motion is replaced.
void World::applyHolds() {
  for (std::size_t human = 0; human < state_.held.size(); ++human) {
    if (state_.held[human] != 0) {
      Intent brake;
      brake.motion = Motion::Brake;
      brake.active = intents_.of(static_cast<int>(human)).active;
      intents_.of(static_cast<int>(human)) = brake;
    }
  }
}

std::string World::divergenceMessage(const std::vector<BodyTwist>& commands) const {
  if (!robots_.failure().empty()) {
    return robots_.failure();
  }
  const std::string when = " in step " + std::to_string(state_.step + 1);
  for (std::size_t i = 0; !motion_.isSound() && i < model_.people.size(); ++i) {
    if (state_.present[i] != 0 &&
        !(isSound(motion_.wanted()[i]) && std::isfinite(state_.heading[i]))) {
      const ResolvedHuman& person = model_.people[i].constants;
      return "person '" + person.name + "' (id " + std::to_string(person.id) + ") diverged" + when +
             ": the velocity is not finite or above 1000 m/s";
    }
  }
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (!isSound({commands[i].linear, commands[i].angular}) ||
        !isSound({commands[i].lateral, 0.0})) {
      return "robot '" + model_.robots[i].name + "' (id " + std::to_string(model_.robots[i].id) +
             ") diverged" + when + ": the command is not finite or above 1000";
    }
  }
  return {};
}

void World::publish() {
  fillFrame(model_, state_, frame_);
  std::swap(frame_.inputs, acceptedInputs_);
  frame_.robotPaths.resize(state_.robots.size());
  for (std::size_t i = 0; i < state_.robots.size(); ++i) {
    frame_.robotPaths[i] = robots_.path(i, model_, state_);
  }
  frame_.senses = robots_.senses();
  publishPaths();
  robots_.takeScans(frame_.scans);
  if (state_.step > 0) {
    behavior_->takeTreeChanges(frame_.treeChanges);
    robots_.takeTreeChanges(frame_.treeChanges);
  }
}

/// Parallel to the people in the frame.
void World::publishPaths() {
  frame_.humanPaths.reset();
  if (!publishesPaths_) {
    return;
  }
  auto ways = std::make_shared<std::vector<std::vector<Vec2>>>();
  ways->reserve(frame_.humans.size());
  for (std::size_t human = 0; human < state_.present.size(); ++human) {
    if (state_.present[human] != 0) {
      ways->push_back(motion_.remainingPath(human));
    }
  }
  frame_.humanPaths = std::move(ways);
}

/// From the scenario or from outside.
bool World::hadGoal(std::size_t robot) const {
  const RobotState& now = state_.robots[robot];
  return !model_.robots[robot].goals.empty() || now.externalGoal || now.arrivedAt >= 0.0 ||
         now.endTime >= 0.0;
}

std::optional<double> World::latestTime(
    const std::function<double(const RobotState&)>& timeOf) const {
  std::optional<double> last;
  for (std::size_t i = 0; i < model_.robots.size(); ++i) {
    if (!hadGoal(i)) {
      continue;
    }
    const double time = timeOf(state_.robots[i]);
    if (time < 0.0) {
      return std::nullopt;
    }
    last = std::max(last.value_or(time), time);
  }
  return last;
}

std::optional<double> World::arrivedAt() const {
  return latestTime([](const RobotState& robot) { return robot.arrivedAt; });
}

std::optional<double> World::finishedAt() const {
  return latestTime(
      [](const RobotState& robot) { return std::max(robot.arrivedAt, robot.endTime); });
}

std::vector<RobotStatus> World::robotStatuses() const {
  std::vector<RobotStatus> robots;
  robots.reserve(model_.robots.size());
  for (std::size_t i = 0; i < model_.robots.size(); ++i) {
    const ResolvedRobot& robot = model_.robots[i];
    RobotStatus& on = robots.emplace_back();
    on.id = robot.id;
    on.name = robot.name;
    on.hasGoal = hadGoal(i);
    on.startTime = robot.startTime;
    on.decidesGoalEnd = robots_.planners()[i]->decidesGoalEnd();
    on.goalResults = state_.robots[i].goalResults;
    if (state_.robots[i].arrivedAt >= 0.0) {
      on.arrived = state_.robots[i].arrivedAt;
    } else if (state_.robots[i].endTime >= 0.0) {
      on.ended = state_.robots[i].endTime;
    } else {
      on.stuck = stuckRobots_.stuckSince(i);
    }
  }
  return robots;
}

std::vector<base::TreeResults> World::treeResults() const {
  std::vector<base::TreeResults> results = behavior_->treeResults();
  for (std::size_t i = 0; i < robots_.planners().size(); ++i) {
    for (base::TreeResults& each : robots_.planners()[i]->treeResults()) {
      each.owner = model_.robots[i].name;
      results.push_back(std::move(each));
    }
  }
  return results;
}

TraceHeader World::header() const {
  TraceHeader header = makeHeader(model_, surroundings_);
  for (std::size_t i = 0; i < header.humans.size(); ++i) {
    header.humans[i].customTree = behavior_->hasCustomTree(static_cast<int>(i), view_);
  }
  return header;
}

std::vector<std::string> World::plannerReports() const {
  std::vector<std::string> reports;
  for (const std::shared_ptr<Planner>& planner : robots_.planners()) {
    reports.push_back(planner->manifestJson());
  }
  return reports;
}

base::Result<std::unique_ptr<World>> World::create(WorldSetup setup) {
  base::Result<std::unique_ptr<WorldParts>> parts = buildWorld(setup);
  if (!parts) {
    return parts.diagnostics();
  }
  setup.scenario = nullptr;  // releases memory, unless the caller still uses it
  return {std::make_unique<World>(std::move(**parts), std::move(setup.behavior)),
          parts.diagnostics()};
}

}  // namespace sim2d
