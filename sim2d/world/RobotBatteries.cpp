#include "sim2d/world/RobotBatteries.h"

#include <cmath>

namespace sim2d {
namespace {

double effortOf(const ResolvedRobot& robot, const RobotState& state) {
  return effortOf({state.linear, state.omega, state.lateral}, bodyOf(robot).limits);
}

void updateBattery(const ResolvedRobot& robot, const WorldModel& model, WorldState& state,
                   RobotState& now) {
  const Dock* const dock = dockAt(model.docks, now.pose);
  const bool wasCharging = now.isCharging;
  const double before = now.battery;
  now.isCharging = dock != nullptr && dock->kind == DockKind::Charging;
  const double power = batteryPower(robot.battery, effortOf(robot, now), now.isCharging);
  now.battery = levelAfter(robot.battery, before, power, model.dt);
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

std::vector<DockPlace> docksSeen(const std::vector<const Dock*>& docks, const Pose2& truth,
                                 const Pose2& believed) {
  std::vector<DockPlace> seen;
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

std::optional<BatteryState> batteryOf(const ResolvedRobot& robot, const RobotState& state) {
  if (!robot.battery.exists()) {
    return std::nullopt;
  }
  const double power = batteryPower(robot.battery, effortOf(robot, state), state.isCharging);
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
