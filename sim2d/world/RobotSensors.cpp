#include "sim2d/world/RobotSensors.h"

namespace sim2d {

RobotSensors::RobotSensors(const WorldModel& model) {
  robots_.reserve(model.robots.size());
  for (const ResolvedRobot& robot : model.robots) {
    Sensors sensors{Odometry(robot.odometry, model.seed, robot.id, robot.start), std::nullopt,
                    PeopleDetector(robot.detector, model.seed, robot.id), bodyOf(robot).footprint,
                    false};
    if (robot.lidar.beams > 0) {
      sensors.lidar.emplace(robot.lidar, model.seed, robot.id);
    }
    robots_.push_back(std::move(sensors));
  }
}

void RobotSensors::reseed(std::uint64_t seed) {
  for (Sensors& robot : robots_) {
    robot.odometry.reseed(seed);
    robot.detector.reseed(seed);
    if (robot.lidar) {
      robot.lidar->reseed(seed);
    }
  }
}

/// People by id, then robots by id.
void RobotSensors::gatherBodies(const FrozenWorld& world) {
  const WorldState& state = world.state;
  bodies_.clear();
  for (std::size_t i = 0; i < state.present.size(); ++i) {
    if (state.present[i] != 0) {
      const ResolvedHuman& person = world.model.people[i].constants;
      bodies_.push_back({person.id, BodyKind::Person, state.position(i), state.heading[i],
                         state.velocity(i), person.radius, nullptr});
    }
  }
  for (std::size_t i = robots_.size(); i-- > 0;) {  // -1 is the last one
    const RobotState& robot = state.robots[i];
    bodies_.push_back({world.model.robots[i].id, BodyKind::Robot, robot.pose.position,
                       robot.pose.heading, robot.velocity, reachOf(world.model.robots[i]),
                       &robots_[i].footprint});
  }
}

void RobotSensors::updateOdometry(Sensors& sensors, const RobotState& now,
                                  const FrozenWorld& world) const {
  if (hasBegun_) {
    sensors.odometry.advance(now.pose, {now.linear, now.omega, now.lateral}, world.model.dt,
                             static_cast<std::uint64_t>(world.state.step));
  } else {
    sensors.odometry.reset(now.pose);
  }
}

void RobotSensors::update(const FrozenWorld& world, const std::vector<char>& isScanRead) {
  gatherBodies(world);
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Sensors& sensors = robots_[i];
    const RobotState& now = world.state.robots[i];
    updateOdometry(sensors, now, world);
    const SensedWorld sensed{now.pose, sensors.odometry.pose(), world.obstacles, bodies_,
                             world.state.time};
    sensors.detector.update(sensed);
    sensors.hasTurned = sensors.lidar && sensors.lidar->update(sensed, isScanRead[i] != 0);
  }
  hasBegun_ = true;
}

}  // namespace sim2d
