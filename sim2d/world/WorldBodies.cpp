#include <algorithm>
#include <cmath>

#include "sim2d/base/Text.h"
#include "sim2d/trace/ContactMarks.h"
#include "sim2d/world/World.h"
#include "sim2d/world/WorldInternal.h"

/// Motion of the bodies in one step: velocities are limited in advance, then the solver handles
/// only bodies that may have contacts.
namespace sim2d {
namespace {

constexpr double kNearWall = 0.1;   // [m]
constexpr double kNearBody = 0.05;  // [m]; larger than the end distance of a contact
constexpr double kNearRobot = 0.5;  // [m]
constexpr int kPolygonSubSteps = 4;
constexpr double kClearance = 0.0005;      // [m]; smaller than the skin of discs in Physics
constexpr double kExcessTolerance = 1e-6;  // [m/s]
constexpr int kMostRounds = 20;

bool isNearWall(const MovingDisc& disc, double reach) {
  return disc.walls != nullptr && std::any_of(disc.walls->begin(), disc.walls->end(),
                                              [reach](const Obstacles::Point& point) {
                                                return point.inside || point.distance < reach;
                                              });
}

/// Closing speed in excess of what the gap allows [m/s].
double excess(double closingSpeed, double gap, double dt) {
  return closingSpeed - std::max(gap - kClearance, 0.0) / dt;
}

bool limitAtWalls(MovingDisc& disc, double dt) {
  bool changed = false;
  if (disc.walls == nullptr) {
    return changed;
  }
  for (const Obstacles::Point& point : *disc.walls) {
    if (point.inside || point.distance < 1e-9) {
      continue;
    }
    const Vec2 toWall = (point.position - disc.position) / point.distance;
    const double tooFast = excess(disc.velocity.dot(toWall), point.distance - disc.radius, dt);
    if (tooFast > kExcessTolerance) {
      disc.velocity -= tooFast * toWall;
      changed = true;
    }
  }
  return changed;
}

bool limitPair(MovingDisc& first, MovingDisc& second, const Vec2& shift, double dt) {
  const Vec2 apart = second.position + shift - first.position;
  const double distance = apart.norm();
  if (distance < 1e-9) {
    return false;
  }
  const Vec2 normal = apart / distance;
  const double closing = (first.velocity - second.velocity).dot(normal);
  const double tooFast = excess(closing, distance - first.radius - second.radius, dt);
  if (tooFast <= kExcessTolerance) {
    return false;
  }
  const double share = second.mass / (first.mass + second.mass);
  first.velocity -= share * tooFast * normal;
  second.velocity += (1.0 - share) * tooFast * normal;
  return true;
}

/// World velocity of a robot whose mean heading is `chord`.
Vec2 velocityAlong(const Vec2& chord, const BodyTwist& twist) {
  const Vec2 ahead = twist.linear * chord;
  return twist.lateral == 0.0 ? ahead : Vec2(ahead + twist.lateral * Vec2(-chord.y(), chord.x()));
}

/// A robot pushed from behind does not drive faster, a blocked one drives slower.
double wheelSpeed(double speed, double commanded) {
  return std::clamp(speed, std::min(commanded, 0.0), std::max(commanded, 0.0));
}

/// Direction of a contact relative to a robot.
const char* sideOf(const Pose2& robot, const Vec2& direction) {
  const double bearing = base::angleDiff(base::headingOf(direction), robot.heading);
  if (std::fabs(bearing) <= base::kPi / 4.0) {
    return "ahead";
  }
  if (std::fabs(bearing) >= 3.0 * base::kPi / 4.0) {
    return "behind";
  }
  return bearing > 0.0 ? "left" : "right";
}

}  // namespace

void keepApart(std::vector<MovingDisc>& discs, const std::vector<DiscPair>& pairs, double dt) {
  bool changed = true;
  for (int round = 0; round < kMostRounds && changed; ++round) {
    changed = false;
    for (const DiscPair& pair : pairs) {
      changed |= limitPair(discs[static_cast<std::size_t>(pair.first)],
                           discs[static_cast<std::size_t>(pair.second)], Vec2(pair.shift, 0.0), dt);
    }
    for (MovingDisc& disc : discs) {
      changed |= limitAtWalls(disc, dt);
    }
  }
}

void World::placeDiscs(const std::vector<BodyTwist>& commands) {
  discs_.resize(commands.size() + humans_.size());
  chords_.assign(commands.size(), Vec2::Zero());
  robotWalls_.resize(commands.size());
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const RobotState& robot = state_.robots[i];
    const ResolvedRobot& constants = model_.robots[i];
    const double middle = robot.pose.heading + commands[i].angular * model_.dt / 2.0;
    chords_[i] = base::directionOf(base::wrapToPi(middle));
    const bool stands = commands[i] == BodyTwist{};
    physics_.setBraked(static_cast<int>(i), stands);
    robotWalls_[i].clear();
    if (constants.footprint.empty()) {
      surroundings_.obstacles.boundaryPoints(robot.pose.position, robotWalls_[i],
                                             constants.radius + 1.0);
    }
    discs_[i] = {robot.pose.position, velocityAlong(chords_[i], commands[i]), constants.radius,
                 constants.mass * (stands ? kBrakedMassFactor : 1.0), &robotWalls_[i]};
  }
  for (std::size_t k = 0; k < humans_.size(); ++k) {
    const std::size_t human = humans_[k];
    const ResolvedHuman& person = model_.people[human].constants;
    discs_[commands.size() + k] =
        state_.present[human] == 0
            ? MovingDisc{}
            : MovingDisc{state_.position(human), motion_.wanted()[human], person.radius,
                         person.mass, motion_.wallsNear(human)};
  }
}

Vec2 World::wantedVelocity(std::size_t body, const std::vector<BodyTwist>& commands) const {
  return isRobot(body) ? velocityAlong(chords_[body], commands[body])
                       : motion_.wanted()[humanOf(body)];
}

void World::moveBodies(const std::vector<BodyTwist>& commands) {
  placeDiscs(commands);
  findPairs();
  keepApart(discs_, pairs_, model_.dt);
  findNearness();
  for (std::size_t body = 0; body < discs_.size(); ++body) {
    const double omega = isRobot(body) ? commands[body].angular : 0.0;
    physics_.setIsolated(static_cast<int>(body), nearness_[body] == Nearness::Nothing);
    physics_.setVelocity(static_cast<int>(body), discs_[body].velocity, omega);
  }
  physics_.step(model_.dt, subSteps());
  readPeople();
  readRobots(commands);
}

/// Polygons are not limited in advance.
int World::subSteps() const {
  for (std::size_t i = 0; i < model_.robots.size(); ++i) {
    if (!model_.robots[i].footprint.empty() && nearness_[i] != Nearness::Nothing) {
      return kPolygonSubSteps;
    }
  }
  return 1;
}

bool World::isNearWallOrRobot(const MovingDisc& person) const {
  const double reach = person.radius + person.velocity.norm() * model_.dt + kNearWall;
  bool isNear = isNearWall(person, reach);
  for (std::size_t i = 0; i < state_.robots.size() && !isNear; ++i) {
    const double near = reach + robotRadii_[i] + kNearRobot;
    isNear = (state_.robots[i].pose.position - person.position).squaredNorm() < near * near;
  }
  return isNear;
}

/// Classifies the bodies by what they may touch in this step. In small worlds the solver handles
/// all people.
void World::findNearness() {
  nearness_.assign(discs_.size(),
                   humans_.size() > kSolverPeopleLimit ? Nearness::Nothing : Nearness::Solid);
  for (std::size_t body = 0; body < discs_.size(); ++body) {
    if (isRobot(body)) {
      nearness_[body] = mayTouchAnything(body) ? Nearness::Solid : Nearness::Nothing;
    } else if (isNearWallOrRobot(discs_[body])) {
      nearness_[body] = Nearness::Solid;
    }
  }
  for (const DiscPair& pair : pairs_) {
    if (!mayTouch(pair)) {
      continue;
    }
    for (const int body : {pair.first, pair.second}) {
      Nearness& nearness = nearness_[static_cast<std::size_t>(body)];
      nearness = nearness == Nearness::Solid ? nearness : Nearness::Person;
    }
  }
}

/// True if two people come near each other in this step, or one of them may be pushed by something
/// else.
bool World::mayTouch(const DiscPair& pair) const {
  const auto first = static_cast<std::size_t>(pair.first);
  const auto second = static_cast<std::size_t>(pair.second);
  if (nearness_[first] == Nearness::Solid || nearness_[second] == Nearness::Solid) {
    return true;
  }
  const MovingDisc& a = discs_[first];
  const MovingDisc& b = discs_[second];
  const Vec2 apart = b.position + Vec2(pair.shift, 0.0) - a.position;
  const Vec2 travel = (b.velocity - a.velocity) * model_.dt;
  const double nearest =
      std::clamp(-apart.dot(travel) / std::max(travel.squaredNorm(), 1e-12), 0.0, 1.0);
  const double gap = a.radius + b.radius + kNearBody;
  return (apart + nearest * travel).squaredNorm() < gap * gap;
}

/// The solver does not contain a robot while nothing is near it, so that it cannot change the
/// processing order of people, and with it their rounding. A polygon counts as its circumscribed
/// circle.
bool World::mayTouchAnything(std::size_t robot) const {
  const MovingDisc& self = discs_[robot];
  const double reach = robotRadii_[robot] + self.velocity.norm() * model_.dt;
  const double wall = reach + kNearWall;
  if (model_.robots[robot].footprint.empty()
          ? isNearWall(self, wall)
          : surroundings_.obstacles.clearance(self.position, wall) < wall) {
    return true;
  }
  for (std::size_t body = 0; body < discs_.size(); ++body) {
    if (body == robot || (!isRobot(body) && state_.present[humanOf(body)] == 0)) {
      continue;
    }
    const MovingDisc& disc = discs_[body];
    const double size = isRobot(body) ? robotRadii_[body] : disc.radius;
    const double near = reach + size + disc.velocity.norm() * model_.dt + kNearRobot;
    if ((disc.position - self.position).squaredNorm() < near * near) {
      return true;
    }
  }
  return false;
}

void World::findPairs() {
  pairs_.clear();
  pairs_.reserve(2 * discs_.size());
  double fastest = 0.0;
  double largest = 0.0;
  for (const MovingDisc& disc : discs_) {
    fastest = std::max(fastest, disc.velocity.norm());
    largest = std::max(largest, disc.radius);
  }
  for (std::size_t body = 0; body < discs_.size(); ++body) {
    if (isRobot(body) ? !model_.robots[body].footprint.empty()
                      : state_.present[humanOf(body)] == 0) {
      continue;
    }
    const MovingDisc& disc = discs_[body];
    const double range = disc.radius + largest + 2.0 * fastest * model_.dt + 0.01;
    model_.ring.forEachImage(disc.position, [&](const Vec2& centre) {
      grid_.forEachNear(centre, range, [&](int human) {
        const int other = bodyOf(static_cast<std::size_t>(human));
        const bool isDone =
            !isRobot(body) && (model_.peoplePass || other <= static_cast<int>(body));
        if (!isDone) {
          pairs_.push_back({static_cast<int>(body), other, disc.position.x() - centre.x()});
        }
      });
    });
    for (std::size_t robot = body + 1; robot < state_.robots.size(); ++robot) {
      if (model_.robots[robot].footprint.empty()) {
        pairs_.push_back({static_cast<int>(body), static_cast<int>(robot)});
      }
    }
  }
}

void World::readPeople() {
  for (std::size_t i = 0; i < model_.people.size(); ++i) {
    if (state_.present[i] == 0) {
      continue;
    }
    const Vec2 velocity = physics_.velocity(bodyOf(i));
    state_.positions[i] = wrapIntoCorridor(i, physics_.pose(bodyOf(i)));
    state_.velocities[i] = velocity;
    if (isWalking(intents_.of(static_cast<int>(i)).motion)) {
      state_.heading[i] = turnedHeading(state_.heading[i], velocity, model_.dt);
    }
    state_.omega[i] = base::angleDiff(state_.heading[i], headingsBefore_[i]) / model_.dt;
  }
}

/// A person who passes an end of a closed corridor re-enters at the other end and replans.
Vec2 World::wrapIntoCorridor(std::size_t human, const Pose2& pose) {
  Vec2 inside = model_.ring.inside(pose.position);
  if (inside != pose.position) {
    physics_.place(bodyOf(human), {inside, pose.heading});
    motion_.forget(human);
  }
  return inside;
}

void World::readRobots(const std::vector<BodyTwist>& commands) {
  for (std::size_t i = 0; i < commands.size(); ++i) {
    RobotState& robot = state_.robots[i];
    const int body = static_cast<int>(i);
    robot.pose = physics_.pose(body);
    robot.velocity = physics_.velocity(body);
    robot.linear = wheelSpeed(robot.velocity.dot(chords_[i]), commands[i].linear);
    robot.lateral = wheelSpeed(base::cross(chords_[i], robot.velocity), commands[i].lateral);
    robot.omega = physics_.omega(body);
  }
}

int World::idOf(std::size_t body) const {
  return isRobot(body) ? model_.robots[body].id : model_.people[humanOf(body)].constants.id;
}

/// Which of the two approached the other, and on which side of the robot: " person behind".
std::string World::contactDescription(const Contact& touch,
                                      const std::vector<BodyTwist>& commands) const {
  const auto robot = static_cast<std::size_t>(touch.body);
  const auto other = static_cast<std::size_t>(touch.other);
  const ContactInitiator initiator =
      contactInitiator(discs_[robot].position, wantedVelocity(robot, commands),
                       discs_[other].position, wantedVelocity(other, commands));
  std::string fault = " both ";
  if (initiator != ContactInitiator::Both) {
    fault = initiator == ContactInitiator::First ? " robot "
                                                 : (isRobot(other) ? " other " : " person ");
  }
  return fault + sideOf(state_.robots[robot].pose, touch.normal);
}

/// Emits one event per pair when two bodies, or a body and an obstacle, begin to touch, until they
/// have separated, with the closing speed that the contact stopped.
void World::emitContacts(const std::vector<BodyTwist>& commands) {
  std::swap(contactsBefore_, contacts_);
  contacts_.reserve(discs_.size());
  physics_.currentContacts(contactsBefore_, contacts_);
  for (const Contact& touch : contacts_) {
    if (std::binary_search(contactsBefore_.begin(), contactsBefore_.end(), touch)) {
      continue;
    }
    const auto body = static_cast<std::size_t>(touch.body);
    Vec2 relative = wantedVelocity(body, commands);
    Event event;
    event.kind = EventKind::Contact;
    event.id = idOf(body);
    if (touch.other >= 0) {
      const auto other = static_cast<std::size_t>(touch.other);
      relative -= wantedVelocity(other, commands);
      event.other = idOf(other);
      event.hasOther = true;
      if (!isRobot(body) && event.other < event.id) {  // people by id, after robots
        std::swap(event.id, event.other);
      }
    }
    event.text = base::formatDouble(std::max(0.0, relative.dot(touch.normal)));
    if (isRobot(body) && touch.other >= 0 && !model_.compatibility.hunav2()) {
      event.text += contactDescription(touch, commands);
    }
    const auto part = static_cast<std::size_t>(std::max(touch.part, 0));
    if (part > 0 && !partNames_[part].empty()) {  // walls of the map have no name in events
      event.text += " " + partNames_[part];
    }
    state_.events.push_back(std::move(event));
  }
}

}  // namespace sim2d
