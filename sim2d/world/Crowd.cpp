#include "sim2d/world/Crowd.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "sim2d/world/StepBuffers.h"

namespace sim2d {
namespace {

constexpr double kMinDisc = 0.2;         // [m]; below this, stepping along the line is too slow
constexpr std::size_t kSmallCrowd = 64;  // up to here all pairs are used, in double
constexpr std::size_t kLookSlice = 128;  // people per work slice
constexpr double kFirstReach = 3.0;      // [m]; of the search for the nearest people

Vec2 facingDirection(const Vec2& velocity, double heading) {
  const double speed = velocity.norm();
  return speed < kMinHeadingSpeed ? base::directionOf(heading) : Vec2(velocity / speed);
}

struct NearPerson {
  double squaredDistance = 0.0;  // [m²]
  int id = 0;
  std::size_t index = 0;
};

/// The top of a heap is the nearest person, of equally near ones the one with the lower id.
bool isFarther(const NearPerson& a, const NearPerson& b) {
  return b.squaredDistance < a.squaredDistance ||
         (b.squaredDistance == a.squaredDistance && b.id < a.id);
}

/// Desired motion of a robot: its current velocity; a robot that stands has no goal.
DesiredMotion desiredMotionOfRobot(const Vec2& velocity) {
  DesiredMotion desired;
  desired.isRobot = true;
  desired.desiredSpeed = velocity.norm();
  if (desired.desiredSpeed >= kMinHeadingSpeed) {
    desired.heading = velocity / desired.desiredSpeed;
    desired.direction = desired.heading;
  }
  return desired;
}

}  // namespace

void Crowd::update(const FrozenWorld& world, const StepPlans& plans, WorkerPool& workers) {
  world_ = &world;
  plans_ = &plans;
  const WorldState& state = world.state;
  const std::size_t people = state.present.size();
  cacheTraits(world.model.people);
  walkers_.resize(people);
  desiredMotions_.resize(anyUsesDesiredMotions_ ? people : 0);
  room_.resize(people);
  forceModels_.resize(people);
  summaries_.assign(workers.threadCount(), Summary{});
  workers.parallelFor(people, kLookSlice,
                      [&](std::size_t thread, std::size_t begin, std::size_t end) {
                        for (std::size_t i = begin; i < end; ++i) {
                          look(i, summaries_[thread]);
                        }
                      });
  all_ = {};
  for (const Summary& summary : summaries_) {
    all_.count += summary.count;
    all_.fastest = std::max(all_.fastest, summary.fastest);
    all_.hasGroups = all_.hasGroups || summary.hasGroups;
  }
  hasBatchForces_ = false;
  groups_.clear();
  if (all_.hasGroups) {
    findGroups();
  }
  robots_.clear();
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    const ResolvedRobot& robot = world.model.robots[i];
    robots_.push_back({robot.id, state.robots[i].pose.position, state.robots[i].velocity,
                       circumscribedRadius(robot)});
  }
}

void Crowd::cacheTraits(const std::vector<Person>& people) {
  if (traits_.empty()) {
    traits_.reserve(people.size());
  }
  for (std::size_t i = traits_.size(); i < people.size(); ++i) {
    const Person& person = people[i];
    const CrowdForceModel law = person.model->crowdForceModel();
    traits_.push_back({person.model.get(), law.parameters, person.constants.radius,
                       person.constants.id, law.goesThroughWalls,
                       person.model->usesDesiredMotions()});
    anyUsesDesiredMotions_ = anyUsesDesiredMotions_ || traits_.back().usesDesiredMotions;
  }
}

DesiredMotion Crowd::desiredMotionOf(std::size_t human) const {
  const StepPlan& plan = plans_->steps[human];
  return {plans_->directions[human],
          facingDirection(walkers_[human].velocity, world_->state.heading[human]), plan.speed,
          plan.group};
}

void Crowd::look(std::size_t human, Summary& summary) {
  const WorldState& state = world_->state;
  const Traits& traits = traits_[human];
  const StepPlan& plan = plans_->steps[human];
  const Walker& walker =
      walkers_[human] = {traits.id, state.position(human), state.velocity(human), traits.radius};
  if (anyUsesDesiredMotions_) {
    desiredMotions_[human] = desiredMotionOf(human);
  }
  assignIfChanged(forceModels_[human], isWalking(plan.motion)
                                           ? CrowdForceModel{traits.law, traits.goesThroughWalls}
                                           : CrowdForceModel{});
  const bool isPresent = state.present[human] != 0;
  assignIfChanged(room_[human], isPresent ? world_->navigation.clearance(walker.position) : 0.0);
  if (isPresent) {
    ++summary.count;
    summary.fastest = std::max(summary.fastest, walker.velocity.norm());
    summary.hasGroups = summary.hasGroups || plan.group >= 0;
  }
}

void Crowd::findGroups() {
  const WorldState& state = world_->state;
  for (std::size_t i = 0; i < state.present.size(); ++i) {
    const int group = plans_->steps[i].group;
    if (state.present[i] != 0 && group >= 0) {
      groups_.emplace_back(group, i);
    }
  }
  std::sort(groups_.begin(), groups_.end());
}

void Crowd::prefetch(std::size_t human) const {
  if (human < traits_.size()) {
    const char* const model = reinterpret_cast<const char*>(traits_[human].model);
    __builtin_prefetch(model);
    __builtin_prefetch(model + 64);
  }
}

bool Crowd::isSmall() const {
  return world_->model.exact || all_.count <= kSmallCrowd;
}

void Crowd::computeForces(WorkerPool& workers) {
  if (isSmall() || world_->model.ring.isClosed()) {
    return;
  }
  const std::function<bool(std::size_t, std::size_t)> isVisible =
      [this](std::size_t self, std::size_t other) { return sees(self, other); };
  forces_.compute({walkers_, world_->state.present, forceModels_, room_, isVisible}, workers);
  hasBatchForces_ = true;
}

bool Crowd::sees(std::size_t self, std::size_t other) const {
  const Vec2& eye = walkers_[self].position;
  const Vec2 sight = walkers_[other].position - eye;
  const double distance = sight.norm();
  if (world_->navigation.isOpenBetween(eye, walkers_[other].position)) {
    return true;
  }
  double clear = room_[self];
  while (clear < distance - room_[other]) {
    const double more = world_->navigation.clearance(eye + clear / distance * sight);
    if (more < kMinDisc) {
      return world_->obstacles.isVisible(eye, walkers_[other].position);
    }
    clear += more;
  }
  return true;
}

void Crowd::fill(std::size_t human, const std::vector<Obstacles::Point>* walls,
                 Situation& situation) const {
  situation.self = walkers_[human];
  situation.desired = desiredMotionOf(human);
  situation.dt = world_->model.dt;
  situation.exact = world_->model.exact;
  situation.obstacles.clear();
  if (world_->model.obstaclePoints == ObstaclePoints::Rays) {
    world_->obstacles.rayPoints(situation.self.position, situation.obstacles);
  } else if (walls != nullptr) {
    situation.obstacles = *walls;
  }
  situation.usesDesiredMotions = traits_[human].usesDesiredMotions;
  situation.others.clear();
  situation.desiredMotions.clear();
  situation.crowdForce.reset();
  situation.seen.reset();
  if (hasBatchForces_ && forceModels_[human].parameters != nullptr) {
    situation.crowdForce = forces_.forces()[human];
  } else {
    addOthers(human, situation);
  }
  situation.firstRobot = situation.others.size();
  addRobots(plans_->steps[human].robot, situation);
  addGroup(human, situation);
}

void Crowd::addGroup(std::size_t human, Situation& situation) const {
  situation.group.clear();
  const int group = situation.desired.group;
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
  if (world_->model.ring.isClosed()) {
    other.position += world_->model.ring.shift(other.position, seenFrom.position);
  }
  return other;
}

void Crowd::addPerson(std::size_t other, Situation& situation) const {
  situation.others.push_back(imageOf(walkers_[other], situation.self));
  if (situation.usesDesiredMotions) {
    situation.desiredMotions.push_back(desiredMotions_[other]);
  }
}

template <class Visit>
void Crowd::forEachOther(std::size_t human, double range, const Visit& visit) const {
  if (isSmall()) {
    for (std::size_t i = 0; i < walkers_.size(); ++i) {
      if (i != human && world_->state.present[i] != 0) {
        visit(i);
      }
    }
    return;
  }
  const Vec2& place = walkers_[human].position;
  const PeriodicCorridor& ring = world_->model.ring;
  ring.forEachImage(place, [&](const Vec2& centre) {
    world_->grid.forEachNear(centre, range, [&](int other) {
      const auto at = static_cast<std::size_t>(other);
      if (at != human && ring.isNearestImage(walkers_[at].position, place, centre)) {
        visit(at);
      }
    });
  });
}

void Crowd::addOthers(std::size_t human, Situation& situation) const {
  const PedestrianModel& model = *traits_[human].model;
  const double range = model.range(all_.fastest, situation.self.velocity.norm());
  if (const std::optional<std::size_t> count = model.maxNeighbors()) {
    addNearest(human, *count, range, situation);
    return;
  }
  forEachOther(human, range, [&](std::size_t other) { addPerson(other, situation); });
}

void Crowd::addNearest(std::size_t human, std::size_t count, double range,
                       Situation& situation) const {
  thread_local std::vector<NearPerson> near;
  const Vec2& place = situation.self.position;
  const bool isComplete = isSmall() || world_->model.ring.isClosed();
  for (double reach = isComplete ? range : std::min(range, kFirstReach);;
       reach = std::min(range, 2.0 * reach)) {
    near.clear();
    forEachOther(human, reach, [&](std::size_t other) {
      const Walker image = imageOf(walkers_[other], situation.self);
      const double squared = (image.position - place).squaredNorm();
      if (squared < range * range) {
        near.push_back({squared, image.id, other});
      }
    });
    std::make_heap(near.begin(), near.end(), isFarther);
    situation.others.clear();
    situation.desiredMotions.clear();
    for (auto end = near.end(); end != near.begin() && situation.others.size() < count; --end) {
      std::pop_heap(near.begin(), end, isFarther);
      const std::size_t other = std::prev(end)->index;
      if (isVisible(human, imageOf(walkers_[other], situation.self).position)) {
        addPerson(other, situation);
      }
    }
    if (situation.others.size() == count || reach >= range) {
      return;
    }
  }
}

void Crowd::addRobots(RobotTreatment treatment, Situation& situation) const {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (treatment == RobotTreatment::Pedestrian) {
      situation.others.push_back(imageOf(robots_[i], situation.self));
      if (situation.usesDesiredMotions) {
        situation.desiredMotions.push_back(desiredMotionOfRobot(robots_[i].velocity));
      }
      continue;
    }
    const double far = kObstacleRange + robots_[i].radius + 1e-6;
    if ((robots_[i].position - situation.self.position).squaredNorm() > far * far) {
      continue;
    }
    const Obstacles::Point point = nearestPointOf(
        world_->model.robots[i], world_->state.robots[i].pose, situation.self.position);
    if (point.distance < kObstacleRange) {
      situation.obstacles.push_back(point);
    }
  }
}

/// Within the clearance of a person nothing can occlude.
bool Crowd::isVisible(std::size_t human, const Vec2& point) const {
  const Vec2& eye = walkers_[human].position;
  return (point - eye).norm() < room_[human] || world_->navigation.isOpenBetween(eye, point) ||
         world_->obstacles.isVisible(eye, point);
}

}  // namespace sim2d
