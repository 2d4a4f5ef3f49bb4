#include "metrics/Samples.h"

#include <algorithm>
#include <cmath>

#include "metrics/Routes.h"

namespace metrics {

double lengthOf(const Vec2& vector) {
  return std::hypot(vector.x(), vector.y());
}

double distance(const Body& a, const Body& b) {
  return lengthOf(a.position - b.position);
}

double distance(const Robot& robot, const Person& person) {
  return person.pair.isKnown ? person.pair.distance : lengthOf(robot.position - person.position);
}

double gap(const Robot& robot, const Person& person) {
  return distance(robot, person) - robot.radius - person.radius;
}

Vec2 Seam::nearest(const Vec2& place, const Vec2& seenFrom) const {
  const double turns = isThere() ? std::round((seenFrom.x() - place.x()) / length) : 0.0;
  return {place.x() + turns * length, place.y()};
}

Seam seamOf(const sim2d::TraceHeader& header) {
  return header.wrapX.size() == 2 ? Seam{header.wrapX[0], header.wrapX[1] - header.wrapX[0]}
                                  : Seam();
}

bool hasJumped(const Vec2& before, const Person& now, const Seam& seam) {
  return now.isNew || seam.nearest(now.position, before) != now.position;
}

const Person* findPerson(const Sample& sample, int id) {
  for (const Person& person : sample.people) {
    if (person.id == id) {
      return &person;
    }
  }
  return nullptr;
}

namespace {

constexpr char kMapName[] = "map";
constexpr char kRecorded[] = "recorded";  // planner of a robot that no world has simulated
constexpr char kSocialFactorKey[] = "social_force_factor";
constexpr double kObstacleReach = 5.0;  // [m]

template <class Columns>
void copyMotion(const Columns& columns, std::size_t k, Body& body) {
  body.id = columns.id[k];
  body.position = Vec2(columns.x[k], columns.y[k]);
  body.heading = columns.heading[k];
  body.velocity = Vec2(columns.vx[k], columns.vy[k]);
  body.speed = lengthOf(body.velocity);
  body.omega = columns.omega[k];
}

std::optional<double> socialFactorOf(const sim2d::TraceHuman& human) {
  for (const auto& [key, value] : human.parameters) {
    if (key == kSocialFactorKey) {
      return value;
    }
  }
  return std::nullopt;
}

const sim2d::TraceRobot* robotOf(const sim2d::TraceHeader& header, int id) {
  for (const sim2d::TraceRobot& robot : header.robots) {
    if (robot.id == id) {
      return &robot;
    }
  }
  return nullptr;
}

}  // namespace

std::vector<Vec2> shortestPath(const RunContext& context, const Vec2& from, const Vec2& to) {
  return context.routes ? context.routes->shortest(from, to) : std::vector<Vec2>{from, to};
}

SampleBuilder::SampleBuilder(const sim2d::TraceHeader& header, int robotId)
    : SampleBuilder(header, robotId, {}) {}

SampleBuilder::SampleBuilder(const sim2d::TraceHeader& header, int robotId, const KnownScene& known)
    : robotId_(robotId),
      header_(header),
      knownRoutes_(known.routes),
      raysAct_(header.obstaclePoints == "rays") {
  addHumans(header.humans);
  header_.humans.clear();
  for (const sim2d::TraceObstacle& obstacle : header_.obstacles) {
    Door door;
    door.part = all_.add(obstacle.outlines);
    if (obstacle.name != kMapName) {
      door.drawnPart = drawn_.add(obstacle.outlines);
      hasDrawn_ = true;
    }
    if (obstacle.isDoor) {
      door.openAtStart = obstacle.open;
      door.toggles = obstacle.toggles;
      doors_.push_back(door);
    }
  }
  if (known.obstacles != nullptr) {
    all_ = *known.obstacles;
  } else {
    all_.build();
  }
  drawn_.build();
}

void SampleBuilder::addHumans(const std::vector<sim2d::TraceHuman>& humans) {
  for (const sim2d::TraceHuman& human : humans) {
    humans_[human.id] = {human.radius, human.behavior, socialFactorOf(human),
                         !human.goals.empty() && !human.cyclicGoals};
  }
}

RunContext SampleBuilder::context() const {
  RunContext context;
  context.map = header_.map;
  context.seam = seamOf(header_);
  context.hasObstacles = !header_.map.isEmpty() ||
                         std::any_of(header_.obstacles.begin(), header_.obstacles.end(),
                                     [](const auto& each) { return !each.outlines.empty(); });
  sim2d::Obstacles standing = all_;
  for (const Door& door : doors_) {
    standing.setEnabled(door.part, false);
  }
  context.walls = std::make_shared<const sim2d::Obstacles>(std::move(standing));
  const sim2d::TraceRobot* robot = robotOf(header_, robotId_);
  if (robot == nullptr) {
    return context;
  }
  context.hasRobot = true;
  context.robotId = robotId_;
  context.robotStartTime = robot->startTime;
  context.robotMaxSpeed = robot->maxVel;
  context.eventsTellArrivals = !robot->planner.empty() && robot->planner != kRecorded;
  context.goals = robot->goals;
  context.routes = knownRoutes_ != nullptr
                       ? knownRoutes_->of(header_, context.walls, robot->radius)
                       : std::make_shared<Routes>(header_.map, context.walls, robot->radius);
  return context;
}

void SampleBuilder::setDoors(double time) {
  for (const Door& door : doors_) {
    const auto passed = std::count_if(door.toggles.begin(), door.toggles.end(),
                                      [&](double toggle) { return toggle - kTimeSlack <= time; });
    const bool open = door.openAtStart != (passed % 2 == 1);
    all_.setEnabled(door.part, !open);
    drawn_.setEnabled(door.drawnPart, !open);
  }
}

void SampleBuilder::addObstaclePoints(Body& body) {
  buffer_.clear();
  if (raysAct_) {
    all_.rayPoints(body.position, buffer_);
  } else {
    all_.boundaryPoints(body.position, buffer_);
  }
  body.obstacles = buffer_;
}

Sample SampleBuilder::sampleOf(const sim2d::Frame& frame, std::vector<Person> people) {
  setDoors(frame.time);
  Sample sample;
  sample.time = frame.time;
  const sim2d::TraceRobot* robot = robotOf(header_, robotId_);
  for (std::size_t k = 0; robot != nullptr && k < frame.robots.size(); ++k) {
    if (frame.robots.id[k] == robotId_) {
      copyMotion(frame.robots, k, sample.robot);
      sample.robot.radius = robot->radius;
      addObstaclePoints(sample.robot);
      const double clearance = all_.clearance(sample.robot.position, kObstacleReach);
      if (clearance < kObstacleReach) {
        sample.robot.obstacleDistance = clearance;
      }
    }
  }
  sample.people = std::move(people);
  const Vec2& eye = sample.robot.position;
  for (Person& person : sample.people) {  // all first: the robot's sensors have asked that mostly
    person.screened = hasDrawn_ && robot != nullptr && !all_.isVisible(person.position, eye) &&
                      !drawn_.isVisible(person.position, eye);
  }
  return sample;
}

std::vector<Person> SampleBuilder::peopleOf(const sim2d::Frame& frame) {
  setDoors(frame.time);
  std::vector<Person> people(frame.humans.size());
  for (std::size_t k = 0; k < frame.humans.size(); ++k) {
    Person& person = people[k];
    copyMotion(frame.humans, k, person);
    person.group = frame.humans.group[k];
    person.state = frame.humans.state[k];
    const auto found = humans_.find(person.id);
    if (found != humans_.end()) {
      const Traits& traits = found->second;
      person.radius = traits.radius;
      person.behavior = traits.behavior;
      person.socialFactor = traits.socialFactor;
      person.wantsToArrive = traits.wantsToArrive;
    }
    addObstaclePoints(person);
  }
  return people;
}

}  // namespace metrics
