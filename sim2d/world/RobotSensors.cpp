#include "sim2d/world/RobotSensors.h"

#include <mutex>
#include <utility>

namespace sim2d {

RobotSenses::Scan shownScan(LaserScan scan) {
  return {scan.sensor,  scan.time,  scan.angleMin,
          scan.perBeam, scan.range, std::move(scan.distances)};
}

RobotSensors::RobotSensors(const WorldModel& model) {
  std::vector<Footprint> footprints;
  footprints.reserve(model.robots.size());
  robots_.reserve(model.robots.size());
  for (const ResolvedRobot& robot : model.robots) {
    footprints.push_back(bodyOf(robot).footprint);
    Sensors sensors{Odometry(robot.odometry, model.seed, robot.id, robot.start),
                    Localizer(robot.localization, model.seed, robot.id),
                    std::nullopt,
                    PeopleDetector(robot.detector, model.seed, robot.id),
                    nullptr,
                    false};
    if (robot.lidar.beams > 0) {
      sensors.lidar.emplace(robot.lidar, model.seed, robot.id);
    }
    robots_.push_back(std::move(sensors));
  }
  footprints_ = std::make_shared<const std::vector<Footprint>>(std::move(footprints));
}

void RobotSensors::reseed(std::uint64_t seed) {
  for (Sensors& robot : robots_) {
    robot.odometry.reseed(seed);
    robot.localizer.reseed(seed);
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
                       &(*footprints_)[i]});
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
  sensors.localizer.update(now.pose, sensors.odometry.pose(), world.state.time);
}

/// Footprints are those of the turn's bodies.
std::shared_ptr<const RobotSenses::LaterScan> RobotSensors::laterScanOf(
    const Lidar& lidar, std::shared_ptr<const std::vector<Footprint>> footprints) {
  struct Made {
    std::once_flag flag;
    RobotSenses::Scan scan;
  };
  const std::shared_ptr<const LidarTurn>& turn = lidar.laterTurn();
  auto make = [turn, caster = lidar.caster(), footprints = std::move(footprints),
               made = std::make_shared<Made>()]() -> const RobotSenses::Scan& {
    std::call_once(made->flag, [&] {
      LaserScan scan;
      caster->cast(*turn, scan);
      made->scan = shownScan(std::move(scan));
    });
    return made->scan;
  };
  return std::make_shared<const RobotSenses::LaterScan>(
      RobotSenses::LaterScan{turn->time, std::move(make)});
}

void RobotSensors::updateLidar(Sensors& sensors, const SensedWorld& world, ScanUse use) const {
  Lidar& lidar = *sensors.lidar;
  sensors.hasTurned = lidar.update(world, use);
  if (lidar.laterTurn() == nullptr) {
    sensors.laterScan.reset();
  } else if (lidar.laterTurn()->time == world.time) {
    sensors.laterScan = laterScanOf(lidar, footprints_);
  }
}

void RobotSensors::update(const FrozenWorld& world, const std::vector<ScanUse>& scans) {
  gatherBodies(world);
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Sensors& sensors = robots_[i];
    const RobotState& now = world.state.robots[i];
    updateOdometry(sensors, now, world);
    const SensedWorld sensed{now.pose, pose(i),          world.obstacles,
                             bodies_,  world.state.time, sensors.localizer.mapToOdom()};
    sensors.detector.update(sensed);
    if (sensors.lidar) {
      updateLidar(sensors, sensed, scans[i]);
    }
  }
  hasBegun_ = true;
}

}  // namespace sim2d
