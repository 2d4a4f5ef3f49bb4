#pragma once

#include "sim2d/base/Registry.h"

namespace sim2d {

/// Parameters of the dynamic window planner (planners/Dwa.cpp).
struct DwaParameters {
  double linearSamples = 20.0;
  double angularSamples = 20.0;
  double window = 0.25;    // [s]
  double horizon = 2.0;    // [s]
  double step = 0.1;       // [s]
  double margin = 0.1;     // [m]
  double clearance = 0.6;  // [m]
  double goalWeight = 1.0;
  double headingWeight = 0.4;
  double clearanceWeight = 0.3;
  double velocityWeight = 0.1;
  double smoothnessWeight = 0.05;
  double slowDistance = 0.8;  // [m]
  double slowShare = 0.4;
  double standingSpeed = 0.25;   // [m/s]
  double patience = 4.0;         // [s]
  double reverseDistance = 0.4;  // [m]
};

base::ParameterTable<DwaParameters> dwaTable();

}  // namespace sim2d
