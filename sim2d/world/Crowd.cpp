#include "sim2d/world/Crowd.h"

#include <algorithm>

namespace sim2d {
namespace {

constexpr double kSlowestTurn = 0.07;    // [m/s]; slower people look where they look
constexpr double kReach = 5.0;           // [m]; robots as obstacles act up to here
constexpr double kSmallDisc = 0.2;       // [m]; smaller steps along a line cost too much
constexpr std::size_t kSmallCrowd = 64;  // up to here everybody feels everybody, in double

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

void Crowd::update(const FrozenWorld& world, const Ways& ways, const Intents& intents,
                   const std::vector<Vec2>& directions) {
  world_ = &world;
  ways_ = &ways;
  const WorldState& state = world.state;
  walkers_.clear();
  courses_.clear();
  room_.clear();
  robots_.clear();
  groups_.clear();
  count_ = 0;
  fastest_ = 0.0;
  for (std::size_t i = 0; i < state.present.size(); ++i) {
    const ResolvedHuman& person = world.model.people[i].constants;
    walkers_.push_back({person.id, state.position(i), state.velocity(i), person.radius});
    courses_.push_back({directions[i], courseHeading(walkers_[i].velocity, state.heading[i]),
                        desiredSpeedOf(world, i, intents.of(static_cast<int>(i))),
                        state.controls[i].group});
    room_.push_back(state.present[i] != 0 ? ways.clearance(walkers_[i].position) : 0.0);
    if (state.present[i] != 0) {
      ++count_;
      fastest_ = std::max(fastest_, walkers_[i].velocity.norm());
      if (state.controls[i].group >= 0) {
        groups_.emplace_back(state.controls[i].group, i);
      }
    }
  }
  std::sort(groups_.begin(), groups_.end());
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    const ResolvedRobot& robot = world.model.robots[i];
    robots_.push_back(
        {robot.id, state.robots[i].pose.position, state.robots[i].velocity, reachOf(robot)});
  }
}

void Crowd::computeForces(const Intents& intents, WorkerPool& workers) {
  laws_.clear();
  const WorldModel& model = world_->model;
  if (model.exact || count_ <= kSmallCrowd || model.ring.isClosed()) {
    return;
  }
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    const Motion motion = intents.of(static_cast<int>(i)).motion;
    const bool walks = motion == Motion::Walk || motion == Motion::Brake;
    laws_.push_back(walks ? model.people[i].model->socialLaw() : SocialLaw{});
  }
  const std::function<bool(std::size_t, std::size_t)> isVisible =
      [this](std::size_t self, std::size_t other) { return sees(self, other); };
  forces_.compute({walkers_, world_->state.present, laws_, room_, isVisible}, workers);
}

bool Crowd::sees(std::size_t self, std::size_t other) const {
  const Vec2& eye = walkers_[self].position;
  const Vec2 sight = walkers_[other].position - eye;
  const double distance = sight.norm();
  double clear = room_[self];
  while (clear < distance - room_[other]) {
    const double more = ways_->clearance(eye + clear / distance * sight);
    if (more < kSmallDisc) {
      return world_->obstacles.isVisible(eye, walkers_[other].position);
    }
    clear += more;
  }
  return true;
}

bool Crowd::hasForce(std::size_t human) const {
  return !laws_.empty() && laws_[human].parameters != nullptr;
}

void Crowd::fill(std::size_t human, const Intent& intent,
                 const std::vector<Obstacles::Point>& walls, Situation& situation) const {
  situation.self = walkers_[human];
  situation.course = courses_[human];
  situation.direction = situation.course.direction;
  situation.desiredSpeed = situation.course.desiredSpeed;
  situation.dt = world_->model.dt;
  situation.exact = world_->model.exact;
  situation.obstacles.clear();
  if (world_->model.obstaclePoints == ObstaclePoints::Rays) {
    world_->obstacles.rayPoints(situation.self.position, situation.obstacles);
  } else {
    situation.obstacles = walls;
  }
  situation.looksAtCourses = world_->model.people[human].model->looksAtCourses();
  situation.others.clear();
  situation.courses.clear();
  situation.ofCrowd.reset();
  if (hasForce(human)) {
    situation.ofCrowd = forces_.forces()[human];
  } else {
    addOthers(human, situation);
  }
  addRobots(intent, situation);
  addGroup(human, situation);
}

void Crowd::addGroup(std::size_t human, Situation& situation) const {
  situation.group.clear();
  const int group = world_->state.controls[human].group;
  if (group < 0) {
    return;
  }
  auto member =
      std::lower_bound(groups_.begin(), groups_.end(), std::pair<int, std::size_t>(group, 0));
  for (; member != groups_.end() && member->first == group; ++member) {
    if (member->second != human) {
      situation.group.push_back(imageOf(walkers_[member->second], situation.self));
    }
  }
}

Walker Crowd::imageOf(Walker other, const Walker& seenFrom) const {
  other.position += world_->model.ring.shift(other.position, seenFrom.position);
  return other;
}

void Crowd::addOther(const Walker& other, const Course& course, Situation& situation) const {
  situation.others.push_back(imageOf(other, situation.self));
  if (situation.looksAtCourses) {
    situation.courses.push_back(course);
  }
}

void Crowd::addOthers(std::size_t human, Situation& situation) const {
  if (world_->model.exact || count_ <= kSmallCrowd) {
    for (std::size_t i = 0; i < walkers_.size(); ++i) {
      if (i != human && world_->state.present[i] != 0) {
        addOther(walkers_[i], courses_[i], situation);
      }
    }
    return;
  }
  const double range =
      world_->model.people[human].model->range(fastest_, situation.self.velocity.norm());
  const Ring& ring = world_->model.ring;
  ring.forEachImage(situation.self.position, [&](const Vec2& centre) {
    world_->grid.forEachNear(centre, range, [&](int other) {
      const Walker& walker = walkers_[static_cast<std::size_t>(other)];
      if (static_cast<std::size_t>(other) != human &&
          ring.isNearestImage(walker.position, situation.self.position, centre)) {
        addOther(walker, courses_[static_cast<std::size_t>(other)], situation);
      }
    });
  });
}

void Crowd::addRobots(const Intent& intent, Situation& situation) const {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (intent.robot == RobotTreatment::Pedestrian) {
      addOther(robots_[i], courseOfRobot(robots_[i].velocity), situation);
      continue;
    }
    const Obstacles::Point point = nearestPointOf(
        world_->model.robots[i], world_->state.robots[i].pose, situation.self.position);
    if (point.distance < kReach) {
      situation.obstacles.push_back(point);
    }
  }
}

/// Within the free room round a person nothing can be in between.
bool Crowd::isVisible(std::size_t human, const Vec2& point) const {
  const Vec2& eye = walkers_[human].position;
  return (point - eye).norm() < room_[human] || world_->obstacles.isVisible(eye, point);
}

}  // namespace sim2d
