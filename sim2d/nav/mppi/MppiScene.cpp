#include "sim2d/nav/mppi/MppiScene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "sim2d/nav/SocialForce.h"

namespace sim2d {
namespace {

constexpr std::size_t kMaxBodies = 30;
constexpr double kForceShare = 0.01;  // of k_s; weaker forces are ignored
constexpr double kStillSpeed = 0.05;  // [m/s]
constexpr int kForceStride = 2;       // plan steps per step of the forces

/// State of all bodies and the robot at one moment of the prediction.
class SocialPrediction {
 public:
  SocialPrediction(const std::vector<PredictedBody>& bodies, const PredictedBody& robot,
                   const ClearanceGrid& clearance)
      : clearance_(clearance), cutOff_(cutOff(kForceShare)) {
    walkers_.reserve(bodies.size() + 1);
    wanted_.reserve(bodies.size());
    reacts_.reserve(bodies.size());
    for (const PredictedBody& body : bodies) {
      // The list index distinguishes bodies at the same position, since track ids may be equal.
      walkers_.emplace_back(static_cast<int>(walkers_.size()), body.now.position, body.now.velocity,
                            body.now.radius);
      wanted_.push_back(body.now.velocity);
      reacts_.push_back(body.now.kind == BodyKind::Person);
    }
    walkers_.emplace_back(static_cast<int>(walkers_.size()), robot.now.position, robot.now.velocity,
                          robot.now.radius);
  }

  void advance(double time) {
    std::vector<Vec2> velocities;
    velocities.reserve(wanted_.size());
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      velocities.push_back(velocityOf(i, time));
    }
    for (std::size_t i = 0; i < velocities.size(); ++i) {
      walkers_[i].velocity = velocities[i];
      walkers_[i].position += velocities[i] * time;
    }
  }

  void moveRobot(const Vec2& position, const Vec2& velocity) {
    walkers_.back().position = position;
    walkers_.back().velocity = velocity;
  }

  const Walker& walker(std::size_t i) const { return walkers_[i]; }

 private:
  Vec2 velocityOf(std::size_t i, double time) const {
    const Walker& self = walkers_[i];
    if (!reacts_[i]) {
      return self.velocity;
    }
    const double speed = wanted_[i].norm();
    const Vec2 direction = speed > kStillSpeed ? Vec2(wanted_[i] / speed) : Vec2(Vec2::Zero());
    const Vec2 others = socialForces(i) + wallForce(self);
    const Vec2 goal = meanGoalForce(parameters_, self.velocity, direction, speed, others, time);
    Vec2 velocity = self.velocity + (goal + others) * time;
    const double most = std::max(speed, kMinSpeedLimit);
    if (velocity.norm() > most) {
      velocity *= most / velocity.norm();
    }
    return velocity;
  }

  Vec2 socialForces(std::size_t i) const {
    Vec2 sum = Vec2::Zero();
    for (std::size_t j = 0; j < walkers_.size(); ++j) {
      if (j != i && !isNegligible(parameters_, walkers_[i], walkers_[j], cutOff_)) {
        sum += socialForce(parameters_, walkers_[i], walkers_[j]);
      }
    }
    return sum;
  }

  Vec2 wallForce(const Walker& self) const {
    const double room = clearance_.at(self.position);
    if (room >= ClearanceGrid::kMaxClearance) {
      return Vec2::Zero();
    }
    const Vec2 slope = clearance_.slopeAt(self.position);
    Obstacles::Point nearest;
    nearest.position = self.position - room * slope / std::max(slope.norm(), 1e-6);
    nearest.distance = std::max(room, 0.0);
    nearest.inside = room < 0.0;
    return obstacleForce(parameters_, self, {nearest});
  }

  static constexpr double kMinSpeedLimit = 0.3;  // [m/s]; a standing person can still step aside

  ForceParameters parameters_;
  const ClearanceGrid& clearance_;
  double cutOff_;
  std::vector<Walker> walkers_;  // the robot is last
  std::vector<Vec2> wanted_;     // velocities
  std::vector<bool> reacts_;
};

}  // namespace

std::vector<PredictedBody> bodiesNear(const Observation& observation, double range) {
  std::vector<std::pair<double, std::size_t>> near;
  near.reserve(observation.bodies.size());
  for (std::size_t i = 0; i < observation.bodies.size(); ++i) {
    const double distance = (observation.bodies[i].position - observation.pose.position).norm();
    if (distance <= range) {
      near.emplace_back(distance, i);
    }
  }
  std::sort(near.begin(), near.end());
  near.resize(std::min(near.size(), kMaxBodies));
  std::sort(near.begin(), near.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });
  std::vector<PredictedBody> bodies;
  bodies.reserve(near.size());
  for (const auto& [distance, i] : near) {
    bodies.push_back({observation.bodies[i], {}, {}});
  }
  return bodies;
}

void predictConstant(std::vector<PredictedBody>& bodies, int steps, double dt) {
  for (PredictedBody& body : bodies) {
    body.velocities.assign(static_cast<std::size_t>(steps), body.now.velocity);
    body.positions.clear();
    body.positions.reserve(static_cast<std::size_t>(steps));
    for (int step = 1; step <= steps; ++step) {
      body.positions.push_back(body.now.position + step * dt * body.now.velocity);
    }
  }
}

void predictSocial(std::vector<PredictedBody>& bodies, const PredictedBody& robot, int steps,
                   double dt, const ClearanceGrid& clearance) {
  SocialPrediction prediction(bodies, robot, clearance);
  for (PredictedBody& body : bodies) {
    body.positions.assign(static_cast<std::size_t>(steps), body.now.position);
    body.velocities.assign(static_cast<std::size_t>(steps), body.now.velocity);
  }
  for (int step = 0; step < steps; step += kForceStride) {
    const int count = std::min(kForceStride, steps - step);
    prediction.advance(count * dt);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Walker& walker = prediction.walker(i);
      for (int k = step; k < step + count; ++k) {
        const auto at = static_cast<std::size_t>(k);
        bodies[i].positions[at] = walker.position - (step + count - 1 - k) * dt * walker.velocity;
        bodies[i].velocities[at] = walker.velocity;
      }
    }
    const auto last = static_cast<std::size_t>(step + count - 1);
    prediction.moveRobot(robot.positions[last], robot.velocities[last]);
  }
}

namespace {

constexpr double kWalkingSpeed = 0.15;  // [m/s]
constexpr double kLog2e = 1.4426950408889634;
constexpr double kMaxDiscs = 5.0;
constexpr double kMinCostBand = 0.05;   // [m], between contact and no cost
constexpr double kGroupDistance = 2.0;  // [m], between two people in conversation
constexpr double kGroupRadius = 0.6;    // [m], minimum radius of the space between them
constexpr double kFacing = 0.5;         // minimum cosine between heading and direction to the other
constexpr double kNarrowFrom = 0.3, kNarrowTo = 4.0, kNarrowStep = 0.1;  // [m], along the route
constexpr double kBesideRay = 2.5;                                       // [m]
constexpr double kApproachTime = 4.0;                                    // [s]
constexpr double kMinApproachSpeed = 0.2;                                // [m/s]
constexpr double kPassedDistance = 0.6;  // [m], on the robot's side of the place

Vec2 headingOfBody(const Vec2& velocity, double heading) {
  const double speed = velocity.norm();
  return speed > kWalkingSpeed ? Vec2(velocity / speed) : base::directionOf(heading);
}

MppiPerson personAt(const PredictedBody& body, std::size_t step, const Vec2& origin,
                    const MppiRanges& ranges) {
  const Vec2 place = body.positions[step] - origin;
  const Vec2& velocity = body.velocities[step];
  const double speed = velocity.norm();
  const double radii = body.now.radius + ranges.robotRadius;
  const double touch = radii + ranges.margin;
  const double far = std::max(radii + ranges.range, touch + kMinCostBand);
  const Vec2 heading = headingOfBody(velocity, body.now.heading);
  // Variances of Kirby 2010: largest ahead, two thirds to the sides, half behind.
  const double variance = std::max(2.0 * speed, 0.5);
  const double walks = std::clamp((speed - kWalkingSpeed) / kWalkingSpeed, 0.0, 1.0);
  MppiPerson person;
  person.x = static_cast<float>(place.x());
  person.y = static_cast<float>(place.y());
  person.far2 = static_cast<float>(far * far);
  person.perBand = static_cast<float>(1.0 / (far * far - touch * touch));
  person.touch = static_cast<float>(body.now.radius + ranges.reach);
  person.vx = static_cast<float>(velocity.x());
  person.vy = static_cast<float>(velocity.y());
  person.hx = static_cast<float>(heading.x());
  person.hy = static_cast<float>(heading.y());
  person.front = static_cast<float>(kLog2e / (2.0 * variance));
  person.side = static_cast<float>(kLog2e / (2.0 * variance * 2.0 / 3.0));
  person.rear = static_cast<float>(kLog2e / (2.0 * variance / 2.0));
  person.perStrip = static_cast<float>(1.0 / (radii + speed * ranges.stripTime));
  person.walks = static_cast<float>(walks);
  person.comfort = body.now.kind == BodyKind::Person ? 1.0F : 0.0F;
  return person;
}

double passageWidthAt(const Obstacles& obstacles, const Vec2& point, const Vec2& direction) {
  const Vec2 left(-direction.y(), direction.x());
  return obstacles.raycast(point, left, kBesideRay) + obstacles.raycast(point, -left, kBesideRay);
}

}  // namespace

std::vector<MppiDisc> discsCovering(const Footprint& footprint) {
  if (footprint.isDisc()) {
    return {{0.0F, 0.0F, static_cast<float>(footprint.radius)}};
  }
  Vec2 low = footprint.corners.front();
  Vec2 high = low;
  for (const Vec2& corner : footprint.corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const Vec2 size = high - low;
  const int along = size.x() >= size.y() ? 0 : 1;
  const double shorter = std::max(size[1 - along], 1e-3);
  const auto count =
      static_cast<int>(std::clamp(std::ceil(size[along] / shorter + 0.5), 1.0, kMaxDiscs));
  const double slab = size[along] / count;
  const double radius = 0.5 * std::sqrt(slab * slab + shorter * shorter);
  std::vector<MppiDisc> discs;
  discs.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    Vec2 centre = 0.5 * (low + high);
    centre[along] = low[along] + (i + 0.5) * slab;
    discs.push_back({static_cast<float>(centre.x()), static_cast<float>(centre.y()),
                     static_cast<float>(radius)});
  }
  return discs;
}

void addBodies(const std::vector<PredictedBody>& bodies, const Vec2& origin, double dt,
               const MppiRanges& ranges, MppiScene& scene) {
  const std::size_t steps = bodies.empty() ? 0 : bodies.front().positions.size();
  scene.people.reserve(steps * bodies.size());
  for (std::size_t step = 0; step < steps; ++step) {
    scene.firstPerson[step] = static_cast<int>(scene.people.size());
    const double travel = ranges.speed * dt * static_cast<double>(step + 1) + ranges.reach;
    for (const PredictedBody& body : bodies) {
      const double near = std::max(ranges.range, ranges.margin + kMinCostBand);
      const double cares = body.now.kind == BodyKind::Person ? ranges.comfortRange : 0.0;
      const double range = travel + body.now.radius + ranges.robotRadius + std::max(near, cares);
      if ((body.positions[step] - origin).norm() < range) {
        scene.people.push_back(personAt(body, step, origin, ranges));
      }
    }
  }
  std::fill(scene.firstPerson.begin() + static_cast<std::ptrdiff_t>(steps), scene.firstPerson.end(),
            static_cast<int>(scene.people.size()));
}

std::vector<SlowDisc> standingBodies(const std::vector<PredictedBody>& bodies, double room) {
  std::vector<SlowDisc> discs;
  discs.reserve(bodies.size());
  for (const PredictedBody& body : bodies) {
    if (body.now.velocity.norm() < kWalkingSpeed) {
      discs.push_back({body.now.position, body.now.radius + room});
    }
  }
  return discs;
}

void addGroups(const std::vector<PredictedBody>& bodies, const Vec2& origin, double weight,
               std::vector<MppiZone>& zones) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const TrackedBody& a = bodies[i].now;
      const TrackedBody& b = bodies[j].now;
      const Vec2 apart = b.position - a.position;
      const double distance = apart.norm();
      const bool arePeople = a.kind == BodyKind::Person && b.kind == BodyKind::Person;
      const bool stand = a.velocity.norm() < kWalkingSpeed && b.velocity.norm() < kWalkingSpeed;
      if (!arePeople || !stand || distance > kGroupDistance || distance < 1e-3 ||
          base::directionOf(a.heading).dot(apart) < kFacing * distance ||
          base::directionOf(b.heading).dot(-apart) < kFacing * distance) {
        continue;
      }
      const Vec2 middle = 0.5 * (a.position + b.position) - origin;
      const double radius = std::max(0.5 * distance, kGroupRadius);
      zones.push_back({static_cast<float>(middle.x()), static_cast<float>(middle.y()),
                       static_cast<float>(1.0 / (radius * radius)), static_cast<float>(weight)});
    }
  }
}

NarrowPlace narrowPlaceAhead(const RobotRoute& route, const Vec2& position,
                             const Obstacles& obstacles, double width) {
  NarrowPlace place;
  const double rest = std::min(route.remainingLength(position), kNarrowTo);
  const auto count = static_cast<int>(std::floor((rest - kNarrowFrom) / kNarrowStep));
  Vec2 before = route.pointAhead(position, kNarrowFrom - kNarrowStep);
  for (int i = 0; i <= count; ++i) {
    const Vec2 point = route.pointAhead(position, kNarrowFrom + i * kNarrowStep);
    const Vec2 way = point - before;
    before = point;
    const double length = way.norm();
    if (length < 1e-6) {
      continue;
    }
    const double room = passageWidthAt(obstacles, point, way / length);
    if (room < width && (!place.isFound || room < place.width)) {
      place = {true, point, way / length, room};
    } else if (place.isFound && room >= width) {
      break;  // beyond the first narrow place
    }
  }
  return place;
}

bool isComingThrough(const TrackedBody& body, const NarrowPlace& place) {
  const Vec2 from = body.position - place.position;
  const double beyond = from.dot(place.direction);
  const double speed = -body.velocity.dot(place.direction);
  if (body.kind != BodyKind::Person || speed < kMinApproachSpeed || beyond < -kPassedDistance ||
      beyond > kApproachTime * speed) {
    return false;
  }
  const Vec2 there = from + std::max(beyond, 0.0) / speed * body.velocity;
  return std::fabs(base::cross(place.direction, there)) < 0.5 * place.width + body.radius;
}

}  // namespace sim2d
