#include "sim2d/world/WorldInside.h"

#include <algorithm>
#include <cmath>

#include "sim2d/world/WorldFrame.h"
#include "sim2d/world/WorldHeader.h"

namespace sim2d {
namespace {

constexpr double kFastest = 1e3;         // [m/s]; beyond it a run has diverged
constexpr std::size_t kSmallWorld = 65;  // people
constexpr double kNearWall = 0.1;        // [m]
constexpr double kNearBody = 0.05;       // [m]; more than a touch takes to end
constexpr double kNearRobot = 0.5;       // [m]
constexpr int kPolygonSubSteps = 4;      // polygons have no contact ahead of time

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

std::vector<std::string> namesInContacts(const Scenario& scenario) {
  std::vector<std::string> names = partNames(scenario);
  names.front().clear();  // walls of the map have no name in events
  return names;
}

bool isNearWall(const MovingDisc& disc, double reach) {
  return std::any_of(disc.walls.begin(), disc.walls.end(), [reach](const Obstacles::Point& point) {
    return point.inside || point.distance < reach;
  });
}

bool isSound(const Vec2& velocity) {
  return velocity.allFinite() && velocity.norm() <= kFastest;
}

}  // namespace

World::State::State(WorldParts parts, std::unique_ptr<HumanBehavior> minds)
    : model(std::move(parts.model)),
      surroundings(std::move(parts.surroundings)),
      ways(std::move(parts.ways)),
      physics(centreOf(model, surroundings.grid)),
      view(model, state, grid, surroundings.obstacles, *ways),
      intents(state.controls),
      behavior(std::move(minds)),
      motion(model.threads),
      doors(model),
      population(model),
      robots(std::move(parts.controllers)),
      contacts(namesInContacts(*model.scenario)) {
  const Obstacles& obstacles = surroundings.obstacles;
  for (int part = 0; part < obstacles.partCount(); ++part) {
    physics.addPart(obstacles.outlines(part), obstacles.isEnabled(part));
  }
  for (const Door* door : model.doors) {
    state.doorOpen.push_back(door->open.value_or(true) ? 1 : 0);
  }
  addRobotBodies();
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
    physics.setLonely(body, robot.footprint.empty());  // until it comes near something
    physics.setPresent(body, true);
    owners.push_back({true, static_cast<int>(owners.size())});
    subSteps_ = robot.footprint.empty() ? subSteps_ : kPolygonSubSteps;
  }
}

void World::State::applyInputs(StepWatch& watch) {
  const std::vector<int> switched = doors.advance(model, state);
  for (const int door : switched) {
    const int part = surroundings.firstDoorPart + door;
    const bool isClosed = state.doorOpen[static_cast<std::size_t>(door)] == 0;
    surroundings.obstacles.setEnabled(part, isClosed);
    physics.setPartEnabled(part, isClosed);
  }
  if (!switched.empty()) {
    ways->rebuild(surroundings.grid, surroundings.obstacles);
  }
  const std::vector<int> due = population.dueNow(model, state, *ways);
  motion.resize(model.people.size());
  goals.resize(model.people.size());
  bodies_.resize(model.people.size(), -1);
  intents.reset();
  for (const int human : due) {
    enter(human);
  }
  watch.lap(StepPhase::Goals);
  grid.rebuild(state.x, state.y, state.present);
  watch.lap(StepPhase::Grid);
  for (const int human : due) {
    behavior->enter(human, view);
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
  state.controls[at] = HumanControl{person.goals, false, person.constants.groupId};
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

bool World::State::step() {
  if (!failure.empty()) {
    return false;
  }
  StepWatch watch(times);
  state.events.clear();
  headingsBefore_ = state.heading;
  decide();
  watch.lap(StepPhase::Trees);
  const FrozenWorld frozen{model, state, grid, surroundings.obstacles};
  const std::vector<base::Twist2>& commands = robots.command(frozen, *ways, state);
  watch.lap(StepPhase::Robots);
  motion.chooseLegs(frozen, intents, *ways, state);
  watch.lap(StepPhase::Ways);
  motion.compute(frozen, intents, *ways, state);
  failure = trouble(commands);
  if (!failure.empty()) {
    return false;
  }
  watch.lap(StepPhase::Forces);
  moveBodies(commands);
  watch.lap(StepPhase::Bodies);
  ++state.step;
  state.time = static_cast<double>(state.step) * model.dt;
  contacts.update(physics, owners, wantedVelocities_, model, state);
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
  for (std::size_t i = 0; i < model.people.size(); ++i) {
    if (state.present[i] != 0 &&
        !(isSound(motion.wanted()[i].velocity) && std::isfinite(state.heading[i]))) {
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

void World::State::placeDiscs(const std::vector<base::Twist2>& commands) {
  discs_.resize(owners.size());
  std::vector<MovingDisc>& discs = discs_;
  chords_.assign(commands.size(), Vec2::Zero());
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const RobotState& robot = state.robots[i];
    const double middle = robot.pose.heading + commands[i].angular * model.dt / 2.0;
    chords_[i] = base::directionOf(base::wrapToPi(middle));
    discs[i].position = robot.pose.position;
    discs[i].velocity = commands[i].linear * chords_[i];
    discs[i].radius = model.robots[i].radius;
    const bool stands = commands[i].linear == 0.0 && commands[i].angular == 0.0;
    discs[i].mass = model.robots[i].mass * (stands ? kBrakedMass : 1.0);
    physics.setBraked(static_cast<int>(i), stands);
    discs[i].walls.clear();
    if (model.robots[i].footprint.empty()) {
      surroundings.obstacles.boundaryPoints(robot.pose.position, discs[i].walls,
                                            discs[i].radius + 1.0);
    }
  }
  for (std::size_t i = 0; i < model.people.size(); ++i) {
    if (bodyOf(i) < 0) {
      continue;
    }
    if (state.present[i] == 0) {
      discs[static_cast<std::size_t>(bodyOf(i))] = MovingDisc{};
      continue;
    }
    MovingDisc& disc = discs[static_cast<std::size_t>(bodyOf(i))];
    const WantedMotion& wanted = motion.wanted()[i];
    disc.position = state.position(i);
    disc.velocity = wanted.velocity;
    disc.radius = model.people[i].constants.radius;
    disc.mass = model.people[i].constants.mass;
    disc.walls = wanted.walls;
  }
}

void World::State::moveBodies(const std::vector<base::Twist2>& commands) {
  placeDiscs(commands);
  std::vector<MovingDisc>& discs = discs_;
  wantedVelocities_.resize(discs.size(), Vec2::Zero());
  for (std::size_t body = 0; body < discs.size(); ++body) {
    wantedVelocities_[body] = discs[body].velocity;
  }
  findPairs();
  keepApart(discs, pairs_, model.dt);
  findNearness();
  for (std::size_t body = 0; body < discs.size(); ++body) {
    const BodyOwner& owner = owners[body];
    const double omega =
        owner.isRobot ? commands[static_cast<std::size_t>(owner.index)].angular : 0.0;
    physics.setLonely(static_cast<int>(body), nearness_[body] == Nearness::Nothing);
    physics.setVelocity(static_cast<int>(body), discs[body].velocity, omega);
  }
  physics.step(model.dt, subSteps_);
  readPeople();
  readRobots(commands);
}

/// Who meets nothing in this step. Small worlds leave all people to the solver.
void World::State::findNearness() {
  nearness_.assign(owners.size(), owners.size() - state.robots.size() > kSmallWorld
                                      ? Nearness::Nothing
                                      : Nearness::Solid);
  for (std::size_t body = 0; body < owners.size(); ++body) {
    const MovingDisc& disc = discs_[body];
    if (owners[body].isRobot) {
      nearness_[body] = meetsSomething(body) ? Nearness::Solid : Nearness::Nothing;
      continue;
    }
    const double reach = disc.radius + disc.velocity.norm() * model.dt + kNearWall;
    nearness_[body] = isNearWall(disc, reach) ? Nearness::Solid : nearness_[body];
    for (std::size_t i = 0; i < state.robots.size(); ++i) {
      const double near = reach + reachOf(model.robots[i]) + kNearRobot;
      const Vec2 apart = state.robots[i].pose.position - disc.position;
      nearness_[body] = apart.squaredNorm() < near * near ? Nearness::Solid : nearness_[body];
    }
  }
  for (const DiscPair& pair : pairs_) {
    if (!mayMeet(pair)) {
      continue;
    }
    for (const int body : {pair.first, pair.second}) {
      Nearness& nearness = nearness_[static_cast<std::size_t>(body)];
      nearness = nearness == Nearness::Solid ? nearness : Nearness::Person;
    }
  }
}

/// Two people come near each other in this step, or one of them may be pushed by something else.
bool World::State::mayMeet(const DiscPair& pair) const {
  const auto first = static_cast<std::size_t>(pair.first);
  const auto second = static_cast<std::size_t>(pair.second);
  if (nearness_[first] == Nearness::Solid || nearness_[second] == Nearness::Solid) {
    return true;
  }
  const MovingDisc& a = discs_[first];
  const MovingDisc& b = discs_[second];
  const Vec2 apart = b.position + pair.shift - a.position;
  const Vec2 travel = (b.velocity - a.velocity) * model.dt;
  const double nearest =
      std::clamp(-apart.dot(travel) / std::max(travel.squaredNorm(), 1e-12), 0.0, 1.0);
  const double gap = a.radius + b.radius + kNearBody;
  return (apart + nearest * travel).squaredNorm() < gap * gap;
}

/// The solver does not know a robot while nothing is near it, so that it cannot change the order in
/// which the solver looks at people, and with it their last digits. Discs alone: who comes near a
/// polygon is not looked up.
bool World::State::meetsSomething(std::size_t robot) const {
  const MovingDisc& self = discs_[robot];
  const double reach = self.radius + self.velocity.norm() * model.dt;
  if (!model.robots[robot].footprint.empty() || isNearWall(self, reach + kNearWall)) {
    return true;
  }
  for (std::size_t body = 0; body < owners.size(); ++body) {
    const BodyOwner& owner = owners[body];
    if (body == robot ||
        (!owner.isRobot && state.present[static_cast<std::size_t>(owner.index)] == 0)) {
      continue;
    }
    const MovingDisc& disc = discs_[body];
    const double size =
        owner.isRobot ? reachOf(model.robots[static_cast<std::size_t>(owner.index)]) : disc.radius;
    const double near = reach + size + disc.velocity.norm() * model.dt + kNearRobot;
    if ((disc.position - self.position).squaredNorm() < near * near) {
      return true;
    }
  }
  return false;
}

void World::State::findPairs() {
  const std::vector<MovingDisc>& discs = discs_;
  std::vector<DiscPair>& pairs = pairs_;
  pairs.clear();
  pairs.reserve(2 * discs.size());
  double fastest = 0.0;
  double largest = 0.0;
  for (const MovingDisc& disc : discs) {
    fastest = std::max(fastest, disc.velocity.norm());
    largest = std::max(largest, disc.radius);
  }
  for (std::size_t body = 0; body < discs.size(); ++body) {
    const BodyOwner& owner = owners[body];
    const auto at = static_cast<std::size_t>(owner.index);
    if (owner.isRobot ? !model.robots[at].footprint.empty() : state.present[at] == 0) {
      continue;
    }
    const double range = discs[body].radius + largest + 2.0 * fastest * model.dt + 0.01;
    model.ring.forEachImage(discs[body].position, [&](const Vec2& centre) {
      grid.forEachNear(centre, range, [&](int human) {
        const int other = bodyOf(static_cast<std::size_t>(human));
        const bool isDone = !owner.isRobot && (model.peoplePass || other <= static_cast<int>(body));
        if (!isDone) {
          pairs.push_back({static_cast<int>(body), other, discs[body].position - centre});
        }
      });
    });
    for (std::size_t robot = body + 1; robot < state.robots.size(); ++robot) {
      if (model.robots[robot].footprint.empty()) {
        pairs.push_back({static_cast<int>(body), static_cast<int>(robot)});
      }
    }
  }
}

void World::State::readPeople() {
  for (std::size_t i = 0; i < model.people.size(); ++i) {
    if (state.present[i] == 0) {
      continue;
    }
    const Vec2 velocity = physics.velocity(bodyOf(i));
    const Vec2 position = aroundTheRing(i, physics.pose(bodyOf(i)));
    state.x[i] = position.x();
    state.y[i] = position.y();
    state.vx[i] = velocity.x();
    state.vy[i] = velocity.y();
    if (motion.wanted()[i].looksAhead) {
      state.heading[i] = headingAfter(state.heading[i], velocity, model.dt);
    }
    state.omega[i] = base::angleDiff(state.heading[i], headingsBefore_[i]) / model.dt;
  }
}

/// A person who passed an end of a closed corridor comes in at the other and looks for the way
/// anew.
Vec2 World::State::aroundTheRing(std::size_t human, const Pose2& pose) {
  const Vec2 inside = model.ring.inside(pose.position);
  if (inside != pose.position) {
    physics.place(bodyOf(human), {inside, pose.heading});
    motion.forget(static_cast<int>(human));
  }
  return inside;
}

void World::State::readRobots(const std::vector<base::Twist2>& commands) {
  for (std::size_t i = 0; i < commands.size(); ++i) {
    RobotState& robot = state.robots[i];
    const int body = static_cast<int>(i);
    robot.pose = physics.pose(body);
    robot.velocity = physics.velocity(body);
    // The wheels hold: who is pushed from behind does not drive faster, who is blocked drives
    // slower.
    const double commanded = commands[i].linear;
    robot.linear = std::clamp(robot.velocity.dot(chords_[i]), std::min(commanded, 0.0),
                              std::max(commanded, 0.0));
    robot.omega = physics.omega(body);
  }
}

void World::State::publish() {
  fillFrame(model, state, motion.wanted(), frame);
  frame.robotPaths.resize(state.robots.size());
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    frame.robotPaths[i] = robots.path(i, model, state);
  }
  if (state.step > 0) {
    behavior->takeTreeChanges(frame.treeChanges);
  }
}

}  // namespace sim2d
