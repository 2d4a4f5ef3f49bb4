#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "sim2d/nav/DriveKinematics.h"
#include "sim2d/nav/FootprintGap.h"
#include "sim2d/nav/Planner.h"

/// A robot that drives by a planner among walls and people who go on at constant velocity and give
/// way to nobody, for tests of planners.
namespace drive {

using namespace sim2d;

inline RobotBody robotBody(Kinematics kinematics, double radius = 0.3) {
  RobotBody body;
  body.kinematics = kinematics;
  body.footprint.radius = radius;
  body.limits = {1.0, 0.5, 1.0, 1.5, 3.0, kinematics == Kinematics::Ackermann ? 0.8 : 0.0};
  return body;
}

inline Outline wall(double left, double bottom, double right, double top) {
  return boxOutline({Vec2(0.5 * (left + right), 0.5 * (bottom + top)), 0.0}, right - left,
                    top - bottom);
}

inline TrackedBody person(int id, const Vec2& position, const Vec2& velocity = Vec2::Zero()) {
  TrackedBody body;
  body.id = id;
  body.position = position;
  body.velocity = velocity;
  body.heading = base::headingOf(velocity);
  body.radius = 0.3;
  return body;
}

constexpr double kOwnApproach = 1e-3;  // [m] in a step; less is no motion towards somebody

class World {
 public:
  World(RobotBody body, const Pose2& start, const Vec2& goal,
        const std::vector<Outline>& walls = {})
      : body_(std::move(body)) {
    for (const Outline& outline : walls) {
      obstacles_.add({outline});
    }
    obstacles_.build();
    navigation_ = std::make_unique<NavigationMap>(OccupancyGrid{}, obstacles_,
                                                  std::vector<Vec2>{start.position, goal});
    observation_.pose = start;
    observation_.goal = goal;
    observation_.obstacles = &obstacles_;
    observation_.navigation = navigation_.get();
  }

  Observation& observation() { return observation_; }
  const Obstacles& obstacles() const { return obstacles_; }

  /// One step: the planner's command within what the drive can do, then people and robot move.
  void step(Planner& planner) {
    const base::Result<BodyTwist> command = planner.command(observation_);
    isGood_ = isGood_ && static_cast<bool>(command);
    const BodyTwist wanted = command ? *command : BodyTwist{};
    commands_.push_back(wanted);
    areFeasible_ = areFeasible_ && clampedToLimits(body_, wanted) == wanted;
    Observation& now = observation_;
    const Pose2 before = now.pose;
    now.motion = reached(body_, now.motion, wanted, now.dt);
    now.pose = propagated(now.pose, now.motion, now.dt);
    now.time += now.dt;
    for (TrackedBody& other : now.bodies) {
      other.position += now.dt * other.velocity;
      const double gap = gapToDisc(body_.footprint, now.pose, other.position, other.radius);
      const double stayed = gapToDisc(body_.footprint, before, other.position, other.radius);
      if (gap < stayed - kOwnApproach) {
        personGap_ = std::min(personGap_, gap);
      }
    }
    wallGap_ = std::min(wallGap_, gapToWalls(body_.footprint, now.pose, obstacles_, 1.0));
    track_.push_back(now.pose);
  }

  /// Until it stands inside the goal's radius; false when it does not within `seconds`.
  bool arrives(Planner& planner, double seconds) {
    const double end = observation_.time + seconds;
    while (observation_.time < end) {
      step(planner);
      const BodyTwist& motion = observation_.motion;
      const bool stands = std::fabs(motion.linear) + std::fabs(motion.lateral) < 1e-3;
      if (stands && distanceLeft() <= observation_.goalRadius) {
        return true;
      }
    }
    return false;
  }

  double distanceLeft() const { return (observation_.goal - observation_.pose.position).norm(); }
  /// Least room to walls; to people in steps in which the robot came nearer by its own motion [m].
  double wallGap() const { return wallGap_; }
  double personGap() const { return personGap_; }
  bool isGood() const { return isGood_ && areFeasible_; }
  const std::vector<BodyTwist>& commands() const { return commands_; }
  const std::vector<Pose2>& track() const { return track_; }
  double time() const { return observation_.time; }

 private:
  RobotBody body_;
  Obstacles obstacles_;
  std::unique_ptr<NavigationMap> navigation_;
  Observation observation_;
  std::vector<BodyTwist> commands_;
  std::vector<Pose2> track_;
  double wallGap_ = 1.0;
  double personGap_ = std::numeric_limits<double>::infinity();
  bool isGood_ = true;
  bool areFeasible_ = true;
};

inline std::shared_ptr<Planner> planner(
    void (*add)(PlannerRegistry&), const RobotBody& body,
    std::vector<std::pair<std::string, double>> parameters = {}) {
  PlannerRegistry registry;
  add(registry);
  PlannerSetup setup;
  setup.robot = "robot";
  setup.body = body;
  setup.parameters = std::move(parameters);
  return *registry.entries().front().make(setup);
}

}  // namespace drive
