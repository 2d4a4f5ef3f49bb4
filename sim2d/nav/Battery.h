#pragma once

#include "sim2d/nav/Body.h"

/// Energy model of a robot battery, without ageing, losses or temperature.
namespace sim2d {

struct BatteryParameters {
  double capacity = 0.0;       // [Wh]; 0: no battery, the robot always has power
  double level = 1.0;          // charge at the start, 0 to 1
  double idlePower = 20.0;     // [W], while the robot stands still
  double motionPower = 60.0;   // [W], in addition at top speed or top turn rate
  double chargePower = 120.0;  // [W], into the battery at a charging dock
  double emptyVoltage = 21.0;  // [V], at level 0
  double fullVoltage = 25.2;   // [V], at level 1

  bool exists() const { return capacity > 0.0; }
};

/// Measurements of a battery monitor.
struct BatteryState {
  double level = 1.0;    // charge, 0 to 1
  double voltage = 0.0;  // [V]
  double current = 0.0;  // [A], positive while it is charged
  bool isCharging = false;
};

/// Drive effort of a motion, 0 to 1: the larger of speed / max speed and turn rate / max turn rate.
double driveEffort(const BodyTwist& motion, const DriveLimits& limits);

/// Power into the battery [W]: the charge power at a charger, which then also supplies the robot;
/// otherwise -(idle + motion * effort).
double batteryPower(const BatteryParameters& battery, double effort, bool isCharging);

/// Charge level after `dt` [s]: level + power dt / (3600 capacity), clamped to [0, 1].
double chargeLevelAfter(const BatteryParameters& battery, double level, double power, double dt);

/// Voltage (linear in the level) and current.
BatteryState batteryState(const BatteryParameters& battery, double level, double power,
                          bool isCharging);

}  // namespace sim2d
