#include "sim2d/nav/mppi/MppiPeople.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "sim2d/nav/SocialForce.h"

namespace sim2d {
namespace {

constexpr std::size_t kMostBodies = 30;
constexpr double kForceShare = 0.01;   // of k_s: weaker forces are left out
constexpr double kStandsBelow = 0.05;  // [m/s]
constexpr int kForceStride = 2;        // steps of the plan per step of the forces

/// All bodies and the robot at one moment of the prediction.
class SocialPrediction {
 public:
  SocialPrediction(const std::vector<PredictedBody>& bodies, const PredictedBody& robot,
                   const ClearanceGrid& clearance)
      : clearance_(clearance), cutOff_(cutOff(kForceShare)) {
    walkers_.reserve(bodies.size() + 1);
    wanted_.reserve(bodies.size());
    feels_.reserve(bodies.size());
    for (const PredictedBody& body : bodies) {
      // The place in the list tells bodies in one place apart, as ids of tracks may be equal.
      walkers_.emplace_back(static_cast<int>(walkers_.size()), body.now.position, body.now.velocity,
                            body.now.radius);
      wanted_.push_back(body.now.velocity);
      feels_.push_back(body.now.kind == BodyKind::Person);
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
    if (!feels_[i]) {
      return self.velocity;
    }
    const double speed = wanted_[i].norm();
    const Vec2 direction = speed > kStandsBelow ? Vec2(wanted_[i] / speed) : Vec2(Vec2::Zero());
    const Vec2 others = forceOfOthers(i) + forceOfWall(self);
    const Vec2 goal = meanGoalForce(parameters_, self.velocity, direction, speed, others, time);
    Vec2 velocity = self.velocity + (goal + others) * time;
    const double most = std::max(speed, kLeastMost);
    if (velocity.norm() > most) {
      velocity *= most / velocity.norm();
    }
    return velocity;
  }

  Vec2 forceOfOthers(std::size_t i) const {
    Vec2 sum = Vec2::Zero();
    for (std::size_t j = 0; j < walkers_.size(); ++j) {
      if (j != i && !isNegligible(parameters_, walkers_[i], walkers_[j], cutOff_)) {
        sum += socialForce(parameters_, walkers_[i], walkers_[j]);
      }
    }
    return sum;
  }

  Vec2 forceOfWall(const Walker& self) const {
    const double room = clearance_.at(self.position);
    if (room >= ClearanceGrid::kMost) {
      return Vec2::Zero();
    }
    const Vec2 slope = clearance_.slopeAt(self.position);
    Obstacles::Point nearest;
    nearest.position = self.position - room * slope / std::max(slope.norm(), 1e-6);
    nearest.distance = std::max(room, 0.0);
    nearest.inside = room < 0.0;
    return obstacleForce(parameters_, self, {nearest});
  }

  static constexpr double kLeastMost = 0.3;  // [m/s]; who stands can still step aside

  ForceParameters parameters_;
  const ClearanceGrid& clearance_;
  double cutOff_;
  std::vector<Walker> walkers_;  // the robot last
  std::vector<Vec2> wanted_;     // velocities
  std::vector<bool> feels_;
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
  near.resize(std::min(near.size(), kMostBodies));
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

}  // namespace sim2d
