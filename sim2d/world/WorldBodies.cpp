#include <algorithm>
#include <cmath>

#include "sim2d/base/Text.h"
#include "sim2d/world/WorldInside.h"

/// How one step moves the bodies: kept apart ahead of time, then by the solver, which is asked only
/// for those who may meet something.
namespace sim2d {
namespace {

constexpr double kNearWall = 0.1;   // [m]
constexpr double kNearBody = 0.05;  // [m]; more than a touch takes to end
constexpr double kNearRobot = 0.5;  // [m]
constexpr int kPolygonSubSteps = 4;

bool isNearWall(const MovingDisc& disc, double reach) {
  return disc.walls != nullptr && std::any_of(disc.walls->begin(), disc.walls->end(),
                                              [reach](const Obstacles::Point& point) {
                                                return point.inside || point.distance < reach;
                                              });
}

}  // namespace

void World::State::placeDiscs(const std::vector<base::Twist2>& commands) {
  discs_.resize(owners.size());
  std::vector<MovingDisc>& discs = discs_;
  chords_.assign(commands.size(), Vec2::Zero());
  robotWalls_.resize(commands.size());
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
    robotWalls_[i].clear();
    discs[i].walls = &robotWalls_[i];
    if (model.robots[i].footprint.empty()) {
      surroundings.obstacles.boundaryPoints(robot.pose.position, robotWalls_[i],
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
    disc.position = state.position(i);
    disc.velocity = motion.wanted()[i];
    disc.radius = model.people[i].constants.radius;
    disc.mass = model.people[i].constants.mass;
    disc.walls = motion.wallsNear(i);
  }
}

Vec2 World::State::wantedVelocity(std::size_t body,
                                  const std::vector<base::Twist2>& commands) const {
  const auto at = static_cast<std::size_t>(owners[body].index);
  return owners[body].isRobot ? Vec2(commands[at].linear * chords_[at]) : motion.wanted()[at];
}

void World::State::moveBodies(const std::vector<base::Twist2>& commands) {
  placeDiscs(commands);
  std::vector<MovingDisc>& discs = discs_;
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
  physics.step(model.dt, subSteps());
  readPeople();
  readRobots(commands);
}

/// Polygons have no contact ahead of time.
int World::State::subSteps() const {
  for (std::size_t i = 0; i < model.robots.size(); ++i) {
    if (!model.robots[i].footprint.empty() && nearness_[i] != Nearness::Nothing) {
      return kPolygonSubSteps;
    }
  }
  return 1;
}

bool World::State::isNearWallOrRobot(const MovingDisc& person) const {
  const double reach = person.radius + person.velocity.norm() * model.dt + kNearWall;
  bool isNear = isNearWall(person, reach);
  for (std::size_t i = 0; i < state.robots.size() && !isNear; ++i) {
    const double near = reach + robotReaches_[i] + kNearRobot;
    isNear = (state.robots[i].pose.position - person.position).squaredNorm() < near * near;
  }
  return isNear;
}

/// Who meets nothing in this step. Small worlds leave all people to the solver.
void World::State::findNearness() {
  nearness_.assign(owners.size(), owners.size() - state.robots.size() > kSmallWorld
                                      ? Nearness::Nothing
                                      : Nearness::Solid);
  for (std::size_t body = 0; body < owners.size(); ++body) {
    if (owners[body].isRobot) {
      nearness_[body] = meetsSomething(body) ? Nearness::Solid : Nearness::Nothing;
    } else if (isNearWallOrRobot(discs_[body])) {
      nearness_[body] = Nearness::Solid;
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
  const Vec2 apart = b.position + Vec2(pair.shift, 0.0) - a.position;
  const Vec2 travel = (b.velocity - a.velocity) * model.dt;
  const double nearest =
      std::clamp(-apart.dot(travel) / std::max(travel.squaredNorm(), 1e-12), 0.0, 1.0);
  const double gap = a.radius + b.radius + kNearBody;
  return (apart + nearest * travel).squaredNorm() < gap * gap;
}

/// The solver does not know a robot while nothing is near it, so that it cannot change the order in
/// which the solver looks at people, and with it their last digits. A polygon counts as the circle
/// around it.
bool World::State::meetsSomething(std::size_t robot) const {
  const MovingDisc& self = discs_[robot];
  const double reach = robotReaches_[robot] + self.velocity.norm() * model.dt;
  const double wall = reach + kNearWall;
  if (model.robots[robot].footprint.empty()
          ? isNearWall(self, wall)
          : surroundings.obstacles.clearance(self.position, wall) < wall) {
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
        owner.isRobot ? robotReaches_[static_cast<std::size_t>(owner.index)] : disc.radius;
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
          pairs.push_back({static_cast<int>(body), other, discs[body].position.x() - centre.x()});
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
    if (isWalking(intents.of(static_cast<int>(i)).motion)) {
      state.heading[i] = headingAfter(state.heading[i], velocity, model.dt);
    }
    state.omega[i] = base::angleDiff(state.heading[i], headingsBefore_[i]) / model.dt;
  }
}

/// A person who passed an end of a closed corridor comes in at the other and looks for the way
/// anew.
Vec2 World::State::aroundTheRing(std::size_t human, const Pose2& pose) {
  Vec2 inside = model.ring.inside(pose.position);
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

int World::State::idOf(const BodyOwner& owner) const {
  const auto at = static_cast<std::size_t>(owner.index);
  return owner.isRobot ? model.robots[at].id : model.people[at].constants.id;
}

/// When two bodies, or a body and an obstacle, begin to touch: one event per pair until they have
/// parted, with the speed at which contacts stopped them.
void World::State::tellContacts(const std::vector<base::Twist2>& commands) {
  std::swap(touchesBefore_, touches_);
  touches_.reserve(owners.size());
  physics.touches(touchesBefore_, touches_);
  for (const Touch& touch : touches_) {
    if (std::binary_search(touchesBefore_.begin(), touchesBefore_.end(), touch)) {
      continue;
    }
    const auto body = static_cast<std::size_t>(touch.body);
    Vec2 relative = wantedVelocity(body, commands);
    Event event;
    event.kind = EventKind::Contact;
    event.id = idOf(owners[body]);
    if (touch.other >= 0) {
      const auto other = static_cast<std::size_t>(touch.other);
      relative -= wantedVelocity(other, commands);
      event.other = idOf(owners[other]);
      event.hasOther = true;
      const bool otherIsFirst = owners[other].isRobot == owners[body].isRobot
                                    ? event.other < event.id && !owners[body].isRobot
                                    : owners[other].isRobot;
      if (otherIsFirst) {
        std::swap(event.id, event.other);
      }
    }
    event.text = base::formatDouble(std::max(0.0, relative.dot(touch.normal)));
    const auto part = static_cast<std::size_t>(std::max(touch.part, 0));
    if (part > 0 && !partNames_[part].empty()) {  // walls of the map have no name in events
      event.text += " " + partNames_[part];
    }
    state.events.push_back(std::move(event));
  }
}

}  // namespace sim2d
