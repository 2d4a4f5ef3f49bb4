#include "sim2d/world/PersonMotion.h"

#include <algorithm>
#include <cmath>

namespace sim2d {
namespace {

constexpr double kSlowestTurn = 0.07;       // [m/s]; slower people keep their heading
constexpr double kTurnRate = base::kPi;     // [rad/s]
constexpr double kReach = 5.0;              // [m]; obstacles act up to here
constexpr double kTouching = 1.0;           // [m]; walls nearer to the body can be run into
constexpr std::size_t kWorthThreads = 200;  // people; fewer are not worth waking threads
constexpr std::size_t kSmallCrowd = 64;     // up to here everybody feels everybody

double turned(double heading, double towards, double most) {
  const double turn = base::angleDiff(towards, heading);
  return base::wrapToPi(heading + std::clamp(turn, -most, most));
}

bool isWalking(const Intent& intent) {
  return intent.motion == Motion::Walk || intent.motion == Motion::Brake;
}

double desiredSpeedOf(const FrozenWorld& world, std::size_t human, const Intent& intent) {
  const double speed = intent.motion == Motion::Walk
                           ? intent.speed
                           : world.model.people[human].constants.desiredSpeed;
  return world.state.controls[human].frozen ? 0.0 : speed < 0.0 ? 0.0 : speed;
}

Vec2 courseHeading(const Vec2& velocity, double heading) {
  const double speed = velocity.norm();
  return speed < kSlowestTurn ? base::directionOf(heading) : Vec2(velocity / speed);
}

/// A robot goes where it moves; one that stands has no goal.
Course courseOfRobot(const Vec2& velocity) {
  Course course;
  course.isRobot = true;
  course.desiredSpeed = velocity.norm();
  if (course.desiredSpeed >= kSlowestTurn) {
    course.heading = velocity / course.desiredSpeed;
    course.direction = course.heading;
  }
  return course;
}

}  // namespace

/// The others as all people of this step see them.
struct PersonMotion::Crowd {
  Crowd(const FrozenWorld& frozen, const Ways& ways, const Intents& intents,
        const std::vector<Vec2>& directions);

  /// What of the others, robots and walls acts on one person.
  Situation situationOf(std::size_t human, const Intent& intent,
                        const std::vector<Obstacles::Point>& walls) const;
  bool isVisible(std::size_t human, const Vec2& point) const;

  const FrozenWorld& world;
  std::vector<Walker> walkers;
  std::vector<Course> courses;  // beside them
  std::vector<double> room;     // of each person to the next wall [m]
  std::vector<Walker> robots;
  std::map<int, std::vector<std::size_t>> groups;
  std::size_t count = 0;
  double fastest = 0.0;  // [m/s]

 private:
  void addOthers(std::size_t human, Situation& situation) const;
  void addOther(const Walker& other, const Course& course, Situation& situation) const;
  void addRobots(const Intent& intent, Situation& situation) const;
  /// Across the seam of a closed corridor.
  Walker imageOf(Walker other, const Walker& seenFrom) const;
};

PersonMotion::Crowd::Crowd(const FrozenWorld& frozen, const Ways& ways, const Intents& intents,
                           const std::vector<Vec2>& directions)
    : world(frozen) {
  const WorldState& state = world.state;
  for (std::size_t i = 0; i < state.present.size(); ++i) {
    const ResolvedHuman& person = world.model.people[i].constants;
    walkers.push_back({person.id, state.position(i), state.velocity(i), person.radius});
    courses.push_back({directions[i], courseHeading(walkers[i].velocity, state.heading[i]),
                       desiredSpeedOf(world, i, intents.of(static_cast<int>(i))),
                       state.controls[i].group});
    room.push_back(state.present[i] != 0 ? ways.clearance(walkers[i].position) : 0.0);
    if (state.present[i] != 0) {
      ++count;
      fastest = std::max(fastest, walkers[i].velocity.norm());
      if (state.controls[i].group >= 0) {
        groups[state.controls[i].group].push_back(i);
      }
    }
  }
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    const ResolvedRobot& robot = world.model.robots[i];
    robots.push_back(
        {robot.id, state.robots[i].pose.position, state.robots[i].velocity, reachOf(robot)});
  }
}

Situation PersonMotion::Crowd::situationOf(std::size_t human, const Intent& intent,
                                           const std::vector<Obstacles::Point>& walls) const {
  const HumanControl& control = world.state.controls[human];
  Situation situation;
  situation.self = walkers[human];
  situation.course = courses[human];
  situation.direction = situation.course.direction;
  situation.desiredSpeed = situation.course.desiredSpeed;
  situation.dt = world.model.dt;
  situation.exact = world.model.exact;
  if (world.model.obstaclePoints == ObstaclePoints::Rays) {
    world.obstacles.rayPoints(situation.self.position, situation.obstacles);
  } else {
    situation.obstacles = walls;
  }
  situation.looksAtCourses = world.model.people[human].model->looksAtCourses();
  addOthers(human, situation);
  addRobots(intent, situation);
  if (control.group >= 0) {
    for (const std::size_t member : groups.at(control.group)) {
      if (member != human) {
        situation.group.push_back(imageOf(walkers[member], situation.self));
      }
    }
  }
  return situation;
}

Walker PersonMotion::Crowd::imageOf(Walker other, const Walker& seenFrom) const {
  other.position += world.model.ring.shift(other.position, seenFrom.position);
  return other;
}

void PersonMotion::Crowd::addOther(const Walker& other, const Course& course,
                                   Situation& situation) const {
  situation.others.push_back(imageOf(other, situation.self));
  if (situation.looksAtCourses) {
    situation.courses.push_back(course);
  }
}

void PersonMotion::Crowd::addOthers(std::size_t human, Situation& situation) const {
  if (world.model.exact || count <= kSmallCrowd) {
    for (std::size_t i = 0; i < walkers.size(); ++i) {
      if (i != human && world.state.present[i] != 0) {
        addOther(walkers[i], courses[i], situation);
      }
    }
    return;
  }
  const double range =
      world.model.people[human].model->range(fastest, situation.self.velocity.norm());
  const Ring& ring = world.model.ring;
  ring.forEachImage(situation.self.position, [&](const Vec2& centre) {
    world.grid.forEachNear(centre, range, [&](int other) {
      const Walker& walker = walkers[static_cast<std::size_t>(other)];
      if (static_cast<std::size_t>(other) != human &&
          ring.isNearestImage(walker.position, situation.self.position, centre)) {
        addOther(walker, courses[static_cast<std::size_t>(other)], situation);
      }
    });
  });
}

void PersonMotion::Crowd::addRobots(const Intent& intent, Situation& situation) const {
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (intent.robot == RobotTreatment::Pedestrian) {
      addOther(robots[i], courseOfRobot(robots[i].velocity), situation);
      continue;
    }
    const Obstacles::Point point =
        nearestPointOf(world.model.robots[i], world.state.robots[i].pose, situation.self.position);
    if (point.distance < kReach) {
      situation.obstacles.push_back(point);
    }
  }
}

/// Within the free room round a person nothing can be in between.
bool PersonMotion::Crowd::isVisible(std::size_t human, const Vec2& point) const {
  const Vec2& eye = walkers[human].position;
  return (point - eye).norm() < room[human] || world.obstacles.isVisible(eye, point);
}

void PersonMotion::resize(std::size_t count) {
  routes_.resize(count);
  directions_.resize(count, Vec2::Zero());
  wanted_.resize(count);
}

void PersonMotion::forget(int human) {
  routes_[static_cast<std::size_t>(human)].reset();
}

void PersonMotion::compute(const FrozenWorld& world, const Intents& intents, Ways& ways,
                           WorldState& state) {
  chooseLegs(world, intents, ways, state);
  const Crowd crowd(world, ways, intents, directions_);
  const std::function<void(std::size_t)> moveOne = [&](std::size_t human) {
    if (state.present[human] != 0) {
      move(human, world, intents, crowd);
    }
  };
  if (crowd.count >= kWorthThreads) {
    workers_.forEach(wanted_.size(), moveOne);
  } else {
    for (std::size_t human = 0; human < wanted_.size(); ++human) {
      moveOne(human);
    }
  }
  for (std::size_t human = 0; human < wanted_.size(); ++human) {
    const Intent& intent = intents.of(static_cast<int>(human));
    if (state.present[human] != 0 && intent.motion == Motion::Turn) {
      state.heading[human] = turned(state.heading[human], intent.heading,
                                    std::max(0.0, intent.turnRate) * world.model.dt);
    }
  }
}

void PersonMotion::chooseLegs(const FrozenWorld& world, const Intents& intents, Ways& ways,
                              WorldState& state) {
  for (std::size_t human = 0; human < wanted_.size(); ++human) {
    const Intent& intent = intents.of(static_cast<int>(human));
    directions_[human] = Vec2::Zero();
    if (state.present[human] == 0 || intent.motion != Motion::Walk) {
      continue;
    }
    const ResolvedHuman& person = world.model.people[human].constants;
    RouteFollower::Request request;
    request.position = state.position(human);
    request.target = intent.target;
    request.radius = person.radius;
    request.speed = state.controls[human].frozen ? 0.0 : intent.speed;
    request.time = state.time;
    request.route = person.route;
    const RouteFollower::Leg leg = routes_[human].follow(request, ways, world.obstacles);
    directions_[human] = leg.direction;
    if (leg.replanned) {
      state.emit(EventKind::Replan, person.id);
    }
    if (leg.stuck) {
      state.emit(EventKind::Stuck, person.id);
    }
  }
}

void PersonMotion::move(std::size_t human, const FrozenWorld& world, const Intents& intents,
                        const Crowd& crowd) {
  const Intent& intent = intents.of(static_cast<int>(human));
  const Person& person = world.model.people[human];
  WantedMotion& wanted = wanted_[human];
  wanted.velocity = Vec2::Zero();
  wanted.forces = ForceTerms{};
  wanted.looksAhead = isWalking(intent);
  wanted.walls.clear();
  const bool wallsAct = isWalking(intent) && world.model.obstaclePoints == ObstaclePoints::Boundary;
  world.obstacles.boundaryPoints(crowd.walkers[human].position, wanted.walls,
                                 wallsAct ? kReach : person.constants.radius + kTouching);
  if (!isWalking(intent)) {
    return;
  }
  Situation situation = crowd.situationOf(human, intent, wanted.walls);
  const std::function<bool(const Vec2&, const Vec2&)> isVisible =
      [&](const Vec2& /*own*/, const Vec2& other) { return crowd.isVisible(human, other); };
  situation.isVisible = &isVisible;
  wanted.forces = person.model->forces(situation);
  if (intent.motion == Motion::Walk) {
    wanted.forces.social += intent.extraForce;
  }
  wanted.velocity = person.model->velocity(situation, wanted.forces);
}

double headingAfter(double heading, const Vec2& velocity, double dt) {
  if (velocity.norm() < kSlowestTurn) {
    return heading;
  }
  return turned(heading, base::headingOf(velocity), kTurnRate * dt);
}

}  // namespace sim2d
