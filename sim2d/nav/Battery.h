#pragma once

#include "sim2d/nav/Body.h"

/// The battery of a robot as a store of energy: no ageing, no losses, no temperature.
namespace sim2d {

struct BatteryParameters {
  double capacity = 0.0;       // [Wh]; 0: there is no battery, the robot always has power
  double level = 1.0;          // charge at the start, 0 to 1
  double idlePower = 20.0;     // [W], while the robot stands
  double motionPower = 60.0;   // [W], in addition at top speed or top turn rate
  double chargePower = 120.0;  // [W], into the battery at a charging dock
  double emptyVoltage = 21.0;  // [V], at level 0
  double fullVoltage = 25.2;   // [V], at level 1

  bool exists() const { return capacity > 0.0; }
};

/// What a battery monitor measures.
struct BatteryState {
  double level = 1.0;    // charge, 0 to 1
  double voltage = 0.0;  // [V]
  double current = 0.0;  // [A], positive while it is charged
  bool isCharging = false;
};

/// Share of the robot's full effort that a motion takes, 0 to 1: the larger one of speed by top
/// speed and turn rate by top turn rate.
double effortOf(const BodyTwist& motion, const DriveLimits& limits);

/// Power into the battery [W]: the charge power at a charger, which then also supplies the robot,
/// else minus (idle + motion * effort).
double batteryPower(const BatteryParameters& battery, double effort, bool isCharging);

/// The level after `dt` [s]: level + power dt / (3600 capacity), kept within 0 and 1.
double levelAfter(const BatteryParameters& battery, double level, double power, double dt);

/// Voltage, linear in the level, and current.
BatteryState batteryState(const BatteryParameters& battery, double level, double power,
                          bool isCharging);

}  // namespace sim2d
