#include "sim2d/world/RobotSensors.h"

#include <cmath>
#include <mutex>
#include <utility>

namespace sim2d {

RobotTelemetry::Scan toFrameScan(LaserScan scan) {
  return {scan.sensor,         scan.time,  scan.angleMin,
          scan.angleIncrement, scan.range, std::move(scan.distances)};
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

/// People sorted by id, then robots sorted by id.
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
                       robot.pose.heading, robot.velocity,
                       circumscribedRadius(world.model.robots[i]), &(*footprints_)[i]});
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

/// Keeps the footprints alive to which the bodies of the snapshot refer.
std::shared_ptr<const RobotTelemetry::DeferredScan> RobotSensors::deferredScanOf(
    const Lidar& lidar, std::shared_ptr<const std::vector<Footprint>> footprints) {
  struct Made {
    std::once_flag flag;
    RobotTelemetry::Scan scan;
  };
  const std::shared_ptr<const LidarSnapshot>& turn = lidar.deferredSnapshot();
  auto make = [turn, caster = lidar.caster(), footprints = std::move(footprints),
               made = std::make_shared<Made>()]() -> const RobotTelemetry::Scan& {
    std::call_once(made->flag, [&] {
      LaserScan scan;
      caster->cast(*turn, scan);
      made->scan = toFrameScan(std::move(scan));
    });
    return made->scan;
  };
  return std::make_shared<const RobotTelemetry::DeferredScan>(
      RobotTelemetry::DeferredScan{turn->time, std::move(make)});
}

void RobotSensors::updateLidar(Sensors& sensors, const SensedWorld& world, ScanDemand use) const {
  Lidar& lidar = *sensors.lidar;
  sensors.hasTurned = lidar.update(world, use);
  if (lidar.deferredSnapshot() == nullptr) {
    sensors.deferredScan.reset();
  } else if (lidar.deferredSnapshot()->time == world.time) {
    sensors.deferredScan = deferredScanOf(lidar, footprints_);
  }
}

void RobotSensors::update(const FrozenWorld& world, const std::vector<ScanDemand>& scans) {
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

namespace {

double driveEffort(const ResolvedRobot& robot, const RobotState& state) {
  return driveEffort({state.linear, state.omega, state.lateral}, bodyOf(robot).limits);
}

void updateBattery(const ResolvedRobot& robot, const WorldModel& model, WorldState& state,
                   RobotState& now) {
  const Dock* const dock = dockAt(model.docks, now.pose);
  const bool wasCharging = now.isCharging;
  const double before = now.battery;
  now.isCharging = dock != nullptr && dock->kind == DockKind::Charging;
  const double power = batteryPower(robot.battery, driveEffort(robot, now), now.isCharging);
  now.battery = chargeLevelAfter(robot.battery, before, power, model.dt);
  if (now.isCharging && !wasCharging) {
    state.emit(EventKind::Battery, robot.id, "charging");
  }
  if (now.battery >= 1.0 && before < 1.0) {
    state.emit(EventKind::Battery, robot.id, "full");
  }
  if (now.battery <= 0.0 && before > 0.0) {
    state.emit(EventKind::Battery, robot.id, "empty");
  }
}

}  // namespace

const Dock* dockAt(const std::vector<const Dock*>& docks, const Pose2& pose) {
  for (const Dock* const dock : docks) {
    const double turn = std::fabs(base::wrapToPi(pose.heading - dock->pose.heading));
    const bool isAligned = turn < kDockAngle || turn > base::kPi - kDockAngle;
    if (isAligned && (dock->pose.position - pose.position).norm() <= kDockReach) {
      return dock;
    }
  }
  return nullptr;
}

std::vector<DockPose> detectedDocks(const std::vector<const Dock*>& docks, const Pose2& truth,
                                    const Pose2& believed) {
  std::vector<DockPose> seen;
  for (const Dock* const dock : docks) {
    if ((dock->pose.position - truth.position).norm() <= kDockSight) {
      const Vec2 place = believed.toWorld(truth.toLocal(dock->pose.position));
      const double turn = dock->pose.heading - truth.heading;
      seen.push_back({dock->name,
                      {place, base::wrapToPi(believed.heading + turn)},
                      dock->kind == DockKind::Charging});
    }
  }
  return seen;
}

std::optional<BatteryState> measuredBattery(const ResolvedRobot& robot, const RobotState& state) {
  if (!robot.battery.exists()) {
    return std::nullopt;
  }
  const double power = batteryPower(robot.battery, driveEffort(robot, state), state.isCharging);
  return batteryState(robot.battery, state.battery, power, state.isCharging);
}

void updateBatteries(const WorldModel& model, WorldState& state) {
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    if (model.robots[i].battery.exists()) {
      updateBattery(model.robots[i], model, state, state.robots[i]);
    }
  }
}

}  // namespace sim2d
