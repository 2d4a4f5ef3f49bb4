#include "sim2d/nav/Body.h"

#include <algorithm>
#include <cmath>

namespace sim2d {

const char* kinematicsName(Kinematics kinematics) {
  switch (kinematics) {
    case Kinematics::Omnidirectional:
      return "omnidirectional";
    case Kinematics::Ackermann:
      return "ackermann";
    default:
      return "differential";
  }
}

double circumscribedRadius(const Footprint& footprint) {
  double reach = footprint.isDisc() ? footprint.radius : 0.0;
  for (const Vec2& corner : footprint.corners) {
    reach = std::max(reach, corner.norm());
  }
  return reach;
}

namespace {

constexpr double kSecondsPerHour = 3600.0;

double clampedRatio(double value, double most) {
  return most > 0.0 ? std::min(1.0, std::fabs(value) / most) : 0.0;
}

}  // namespace

double driveEffort(const BodyTwist& motion, const DriveLimits& limits) {
  const double speed = std::sqrt(motion.linear * motion.linear + motion.lateral * motion.lateral);
  return std::max(clampedRatio(speed, limits.maxVel),
                  clampedRatio(motion.angular, limits.maxOmega));
}

double batteryPower(const BatteryParameters& battery, double effort, bool isCharging) {
  return isCharging ? battery.chargePower : -(battery.idlePower + battery.motionPower * effort);
}

double chargeLevelAfter(const BatteryParameters& battery, double level, double power, double dt) {
  return std::clamp(level + power * dt / (kSecondsPerHour * battery.capacity), 0.0, 1.0);
}

BatteryState batteryState(const BatteryParameters& battery, double level, double power,
                          bool isCharging) {
  const double range = battery.fullVoltage - battery.emptyVoltage;
  const double voltage = battery.emptyVoltage + level * range;
  return {level, voltage, voltage > 0.0 ? power / voltage : 0.0, isCharging};
}

}  // namespace sim2d
