#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "sim2d/base/Rng.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/nav/DriveKinematics.h"
#include "sim2d/nav/FootprintGap.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/SocialForce.h"

/// A small closed loop: one robot with its planner, people who walk to their goals by the social
/// force model or straight on without looking.
namespace mppitest {

using sim2d::Vec2;

constexpr double kDt = 0.05;  // [s]

struct Human {
  Vec2 position = Vec2::Zero();
  Vec2 velocity = Vec2::Zero();
  std::vector<Vec2> way;  // goals, one after the other
  double speed = 1.2;     // [m/s]
  bool reacts = true;
  double heading = 0.0;
  double radius = 0.3;
};

/// How a run went.
struct Outcome {
  bool arrived = false;
  double time = 0.0;          // [s]
  double leastGap = 1e9;      // to people [m]
  double leastWallGap = 1e9;  // [m]
  double intimate = 0.0;      // share of the steps with a gap below 0.45 m
  double personal = 0.0;      // idem below 1.2 m
  std::vector<Vec2> way;
};

class World {
 public:
  World(std::vector<sim2d::Outline> outlines, std::vector<Vec2> places)
      : navigation_(nullptr), places_(std::move(places)) {
    if (!outlines.empty()) {
      obstacles_.add(std::move(outlines));
    }
    obstacles_.build();
    navigation_ =
        std::make_unique<sim2d::NavigationMap>(sim2d::OccupancyGrid{}, obstacles_, places_);
  }

  Outcome run(sim2d::Planner& planner, const sim2d::RobotBody& body, sim2d::Pose2 pose,
              const Vec2& goal, std::vector<Human> people, double longest);

  const sim2d::Obstacles& obstacles() const { return obstacles_; }
  sim2d::Observation observe(const sim2d::Pose2& pose, const sim2d::BodyTwist& motion,
                             const Vec2& goal, const std::vector<Human>& people, double time) const;

 private:
  void walk(std::vector<Human>& people, const sim2d::Walker& robot) const;
  Vec2 velocityOf(std::size_t self, const std::vector<Human>& people,
                  const sim2d::Walker& robot) const;

  sim2d::Obstacles obstacles_;
  std::unique_ptr<sim2d::NavigationMap> navigation_;
  std::vector<Vec2> places_;
};

inline sim2d::Observation World::observe(const sim2d::Pose2& pose, const sim2d::BodyTwist& motion,
                                         const Vec2& goal, const std::vector<Human>& people,
                                         double time) const {
  sim2d::Observation observation;
  observation.pose = pose;
  observation.motion = motion;
  observation.goal = goal;
  observation.goalRadius = 0.25;
  observation.time = time;
  observation.dt = kDt;
  observation.obstacles = &obstacles_;
  observation.navigation = navigation_.get();
  int id = 0;
  for (const Human& human : people) {
    sim2d::TrackedBody body;
    body.id = id++;
    body.position = human.position;
    body.velocity = human.velocity;
    body.heading = human.heading;
    body.radius = human.radius;
    observation.bodies.push_back(body);
  }
  return observation;
}

inline Vec2 World::velocityOf(std::size_t self, const std::vector<Human>& people,
                              const sim2d::Walker& robot) const {
  const Human& human = people[self];
  const sim2d::ForceParameters parameters;
  Vec2 direction =
      human.way.empty() ? Vec2(Vec2::Zero()) : Vec2(human.way.front() - human.position);
  if (direction.norm() > 0.0) {
    direction.normalize();
  }
  if (!human.reacts) {
    return human.speed * direction;
  }
  const sim2d::Walker walker(static_cast<int>(self), human.position, human.velocity, human.radius);
  Vec2 force = sim2d::socialForce(parameters, walker, robot);
  for (std::size_t i = 0; i < people.size(); ++i) {
    if (i != self) {
      force += sim2d::socialForce(
          parameters, walker,
          {static_cast<int>(i), people[i].position, people[i].velocity, people[i].radius});
    }
  }
  std::vector<sim2d::Obstacles::Point> points;
  obstacles_.boundaryPoints(human.position, points, 2.0);
  force += sim2d::obstacleForce(parameters, walker, points);
  force += sim2d::goalForce(parameters, human.velocity, direction, human.speed);
  Vec2 velocity = human.velocity + force * kDt;
  const double most = std::max(human.speed, 0.3);
  return velocity.norm() > most ? Vec2(velocity * (most / velocity.norm())) : velocity;
}

inline void World::walk(std::vector<Human>& people, const sim2d::Walker& robot) const {
  std::vector<Vec2> velocities;
  velocities.reserve(people.size());
  for (std::size_t i = 0; i < people.size(); ++i) {
    velocities.push_back(velocityOf(i, people, robot));
  }
  for (std::size_t i = 0; i < people.size(); ++i) {
    Human& human = people[i];
    human.velocity = velocities[i];
    human.position += kDt * velocities[i];
    if (velocities[i].norm() > 0.1) {
      human.heading = base::headingOf(velocities[i]);
    }
    if (!human.way.empty() && (human.way.front() - human.position).norm() < 0.4) {
      human.way.erase(human.way.begin());
    }
  }
}

inline Outcome World::run(sim2d::Planner& planner, const sim2d::RobotBody& body, sim2d::Pose2 pose,
                          const Vec2& goal, std::vector<Human> people, double longest) {
  Outcome outcome;
  sim2d::BodyTwist motion;
  const int steps = static_cast<int>(longest / kDt);
  int near = 0;
  int personal = 0;
  int step = 0;
  for (; step < steps && !outcome.arrived; ++step) {
    const auto command = planner.command(observe(pose, motion, goal, people, step * kDt));
    motion = sim2d::reached(body, motion, *command, kDt);
    const sim2d::Pose2 next = sim2d::propagated(pose, motion, kDt);
    walk(people, {-1, pose.position, (next.position - pose.position) / kDt,
                  sim2d::circumscribedRadius(body.footprint)});
    pose = next;
    outcome.way.push_back(pose.position);
    double gap = 1e9;
    for (const Human& human : people) {
      gap = std::min(gap, sim2d::gapToDisc(body.footprint, pose, human.position, human.radius));
    }
    outcome.leastGap = std::min(outcome.leastGap, gap);
    outcome.leastWallGap =
        std::min(outcome.leastWallGap, sim2d::gapToWalls(body.footprint, pose, obstacles_, 2.0));
    near += gap < 0.45 ? 1 : 0;
    personal += gap < 1.2 ? 1 : 0;
    outcome.arrived = (pose.position - goal).norm() < 0.25;
  }
  outcome.time = step * kDt;
  outcome.intimate = static_cast<double>(near) / std::max(step, 1);
  outcome.personal = static_cast<double>(personal) / std::max(step, 1);
  return outcome;
}

/// A planner with 600 samples.
inline std::shared_ptr<sim2d::Planner> plannerOf(void (*add)(sim2d::PlannerRegistry&),
                                                 const sim2d::RobotBody& body, std::uint64_t seed) {
  sim2d::PlannerRegistry registry;
  add(registry);
  sim2d::PlannerSetup setup;
  setup.robot = "r";
  setup.body = body;
  setup.seed = seed;
  setup.robotId = 0;
  setup.parameters = {{"samples", 600.0}};
  return *registry.entries().front().make(setup);
}

inline sim2d::RobotBody discRobot(sim2d::Kinematics kinematics) {
  sim2d::RobotBody body;
  body.kinematics = kinematics;
  body.footprint.radius = 0.3;
  body.limits = {1.0, 0.5, 1.0, 1.5, 3.0, kinematics == sim2d::Kinematics::Ackermann ? 0.6 : 0.0};
  return body;
}

inline sim2d::Outline box(double left, double bottom, double right, double top) {
  return sim2d::boxOutline({Vec2(0.5 * (left + right), 0.5 * (bottom + top)), 0.0}, right - left,
                           top - bottom);
}

}  // namespace mppitest
