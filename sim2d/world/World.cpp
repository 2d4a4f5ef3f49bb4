#include "sim2d/world/World.h"

#include <algorithm>
#include <cmath>

#include "sim2d/world/StepBuffers.h"
#include "sim2d/world/WorldInside.h"

namespace sim2d {
namespace {

/// Middle of the map, or of the people's starts: places are rounded relative to it, and a robot
/// must not change how.
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

World::State::State(WorldParts parts, std::unique_ptr<HumanBehavior> minds)
    : model(std::move(parts.model)),
      surroundings(std::move(parts.surroundings)),
      navigation(std::move(parts.navigation)),
      physics(centreOf(model, surroundings.grid)),
      view(model, state, grid, surroundings.obstacles, *navigation),
      intents(state.controls),
      behavior(std::move(minds)),
      motion(model.threads),
      population(model),
      robots(std::move(parts.controllers)) {
  partNames_ = partNames(*model.environment);
  const Obstacles& obstacles = surroundings.obstacles;
  for (int part = 0; part < obstacles.partCount(); ++part) {
    physics.addPart(obstacles.outlines(part), obstacles.isEnabled(part));
  }
  for (const Door* door : model.doors) {
    state.doorOpen.push_back(door->open.value_or(true) ? 1 : 0);
  }
  toggled_.resize(model.doors.size(), 0);
  owners.reserve(model.robots.size() + model.people.size());
  physics.reserve(model.robots.size() + model.people.size());
  addRobotBodies();
  for (std::vector<double>* column :
       {&state.x, &state.y, &state.vx, &state.vy, &state.heading, &state.omega}) {
    column->reserve(model.people.size());
  }
  state.controls.reserve(model.people.size());
  state.events.reserve(model.people.size());
  for (const Person& person : model.people) {
    state.append(person);
  }
  StepWatch watch(nullptr);
  applyInputs(watch);
  publish();
}

void World::State::addRobotBodies() {
  for (const ResolvedRobot& robot : model.robots) {
    RobotState start;
    start.pose = robot.start;
    start.pose.heading = base::wrapToPi(robot.start.heading);
    state.robots.push_back(start);
    const int body =
        physics.addBody({start.pose, robot.radius, robot.mass, robot.footprint}, false);
    physics.setLonely(body, true);  // until it comes near something
    physics.setPresent(body, true);
    owners.push_back({true, static_cast<int>(owners.size())});
    robotReaches_.push_back(reachOf(robot));
  }
}

/// Their times come so much early that rounding does not delay them.
void World::State::toggleDoors() {
  for (std::size_t door = 0; door < model.doors.size(); ++door) {
    std::vector<double> toggles = model.doors[door]->toggles;
    std::sort(toggles.begin(), toggles.end());
    for (std::size_t& next = toggled_[door];
         next < toggles.size() && toggles[next] <= state.time + kTick; ++next) {
      setDoor(door, state.doorOpen[door] == 0);
    }
  }
}

void World::State::setDoor(std::size_t door, bool open) {
  state.doorOpen[door] = open ? 1 : 0;
  const int part = surroundings.firstDoorPart + static_cast<int>(door);
  surroundings.obstacles.setEnabled(part, !open);
  physics.setPartEnabled(part, !open);
  doorsChanged_ = true;
  state.emit(EventKind::Door, 0, model.doors[door]->name + (open ? " open" : " closed"));
  state.events.back().hasId = false;
}

void World::State::updateNavigation() {
  if (doorsChanged_) {
    navigation->update(surroundings.grid, surroundings.obstacles);
    doorsChanged_ = false;
  }
}

void World::State::applyInputs(StepWatch& watch) {
  toggleDoors();
  updateNavigation();
  const std::vector<int> due = population.dueNow(model, state, *navigation);
  place(due);
  intents.reset();
  watch.lap(StepPhase::Goals);
  grid.rebuild(state.x, state.y, state.present);
  watch.lap(StepPhase::Grid);
  for (const int human : due) {
    behavior->enter(human, view);
  }
}

void World::State::place(const std::vector<int>& newcomers) {
  motion.resize(model.people.size());
  goals.resize(model.people.size());
  bodies_.resize(model.people.size(), -1);
  for (const int human : newcomers) {
    enter(human);
  }
}

void World::State::enter(int human) {
  const auto at = static_cast<std::size_t>(human);
  const Person& person = model.people[at];
  const Pose2 start{person.constants.start.position,
                    base::wrapToPi(person.constants.start.heading)};
  state.x[at] = start.position.x();
  state.y[at] = start.position.y();
  state.heading[at] = start.heading;
  state.vx[at] = state.vy[at] = state.omega[at] = 0.0;
  state.active[at] = 0;
  state.controls[at] = HumanControl{person.plan->goals, false, person.constants.groupId};
  motion.enter(human);
  goals.enter(human);
  if (bodies_[at] < 0) {
    BodySpec body{start, person.constants.radius, person.constants.mass, {}, true};
    body.passesItsKind = model.peoplePass;
    body.lonely = model.people.size() > kSmallWorld;
    bodies_[at] = physics.addBody(body, true);
    owners.push_back({false, human});
  } else {
    physics.place(bodies_[at], start);
    physics.setPresent(bodies_[at], true);
  }
  state.emit(EventKind::Enter, person.constants.id);
}

void World::State::leave(int human) {
  const auto at = static_cast<std::size_t>(human);
  state.present[at] = 0;
  physics.setPresent(bodies_[at], false);
}

void World::State::finishRounds() {
  for (const int human : goals.takeArrived()) {
    const auto at = static_cast<std::size_t>(human);
    const ResolvedHuman& person = model.people[at].constants;
    if (state.present[at] == 0) {
      continue;
    }
    const bool isInSink =
        std::any_of(model.areas.begin(), model.areas.end(), [&](const Area* area) {
          return area->kind == AreaKind::Sink && isInside(area->points, state.position(at));
        });
    if (person.atEnd == AtEnd::Leave || isInSink) {
      leave(human);
      state.emit(EventKind::Leave, person.id);
    } else if (person.atEnd == AtEnd::Restart) {
      leave(human);
      population.enqueue(human);
    }
  }
}

bool World::State::step(const StepInputs& inputs) {
  if (!failure.empty()) {
    return false;
  }
  StepWatch watch(times);
  state.events.clear();
  dropExcess(state.events, frame.events.size());
  take(inputs);
  headingsBefore_ = state.heading;
  motion.expectWork();
  decide();
  watch.lap(StepPhase::Trees);
  const FrozenWorld frozen{model, state, grid, surroundings.obstacles};
  const std::vector<base::Twist2>& commands = robots.command(frozen, *navigation, state);
  watch.lap(StepPhase::Robots);
  motion.chooseLegs(frozen, intents, *navigation, state);
  watch.lap(StepPhase::Ways);
  motion.compute(frozen, intents, *navigation, state, frame.forces);
  failure = trouble(commands);
  if (!failure.empty()) {
    frame.forces = {};  // they are of the step that failed
    return false;
  }
  for (const Steering& steering : steerings_) {
    const Vec2& own = motion.wanted()[steering.human];
    motion.steer(steering.human,
                 steering.isBeside ? Vec2(own + steering.velocity) : steering.velocity);
  }
  watch.lap(StepPhase::Forces);
  moveBodies(commands);
  watch.lap(StepPhase::Bodies);
  ++state.step;
  state.time = static_cast<double>(state.step) * model.dt;
  tellContacts(commands);
  watch.lap(StepPhase::Contacts);
  afterMotion();
  applyInputs(watch);
  publish();
  watch.lap(StepPhase::Frame);
  if (times != nullptr) {
    ++times->steps;
  }
  return true;
}

void World::State::afterMotion() {
  goals.afterMotion(model, state, intents);
  RobotDrive::afterMotion(model, state);
  finishRounds();
  for (std::size_t i = 0; i < model.people.size(); ++i) {
    state.active[i] = intents.of(static_cast<int>(i)).active ? 1 : 0;
  }
}

void World::State::decide() {
  intents.reset();
  behavior->decide(view, intents);
  goals.afterDecide(model, state, intents, view);
  std::move(intents.events().begin(), intents.events().end(), std::back_inserter(state.events));
  intents.events().clear();
}

std::string World::State::trouble(const std::vector<base::Twist2>& commands) const {
  const std::string when = " in step " + std::to_string(state.step + 1);
  for (std::size_t i = 0; !motion.isSound() && i < model.people.size(); ++i) {
    if (state.present[i] != 0 &&
        !(isSound(motion.wanted()[i]) && std::isfinite(state.heading[i]))) {
      const ResolvedHuman& person = model.people[i].constants;
      return "person '" + person.name + "' (id " + std::to_string(person.id) + ") diverged" + when +
             ": the velocity is not finite or above 1000 m/s";
    }
  }
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (!isSound({commands[i].linear, commands[i].angular})) {
      return "robot '" + model.robots[i].name + "' (id " + std::to_string(model.robots[i].id) +
             ") diverged" + when + ": the command is not finite or above 1000";
    }
  }
  return {};
}

void World::State::publish() {
  fillFrame(model, state, frame);
  std::swap(frame.inputs, taken_);
  frame.robotPaths.resize(state.robots.size());
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    frame.robotPaths[i] = robots.path(i, model, state);
  }
  if (state.step > 0) {
    behavior->takeTreeChanges(frame.treeChanges);
  }
}

base::Result<std::unique_ptr<World>> World::create(WorldSetup setup) {
  base::Result<std::unique_ptr<WorldParts>> parts = buildWorld(setup);
  if (!parts) {
    return parts.diagnostics();
  }
  setup.scenario = nullptr;  // people need the memory, unless the caller still uses it
  auto state = std::make_unique<State>(std::move(**parts), std::move(setup.behavior));
  return {std::unique_ptr<World>(new World(std::move(state))), parts.diagnostics()};
}

World::World(std::unique_ptr<State> state) : state_(std::move(state)) {}
World::~World() = default;

bool World::step(const StepInputs& inputs) {
  return state_->step(inputs);
}
const base::Diagnostics& World::refused() const {
  return state_->refused;
}
void World::measure(StepTimes* times) {
  state_->times = times;
}
const std::string& World::failure() const {
  return state_->failure;
}
const Frame& World::frame() const {
  return state_->frame;
}
std::int64_t World::stepIndex() const {
  return state_->state.step;
}
double World::time() const {
  return state_->state.time;
}
double World::dt() const {
  return state_->model.dt;
}

std::optional<double> World::arrivedAt() const {
  std::optional<double> last;
  for (std::size_t i = 0; i < state_->model.robots.size(); ++i) {
    if (state_->model.robots[i].goals.empty()) {
      continue;
    }
    const double arrived = state_->state.robots[i].arrivedAt;
    if (arrived < 0.0) {
      return std::nullopt;
    }
    last = std::max(last.value_or(arrived), arrived);
  }
  return last;
}

TraceHeader World::header() const {
  return makeHeader(state_->model, state_->surroundings);
}
const WorldView& World::view() const {
  return state_->view;
}
HumanBehavior& World::behavior() {
  return *state_->behavior;
}

}  // namespace sim2d
