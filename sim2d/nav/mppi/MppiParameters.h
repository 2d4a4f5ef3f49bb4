#pragma once

#include "sim2d/base/Registry.h"

/// Parameters of the planners `mppi` and `social_mppi`; units and sources are in the tables.
namespace sim2d {

struct MppiParameters {
  double samples = 2000.0;
  double steps = 56.0;
  double modelDt = 0.05;
  double temperature = 0.3;
  double gamma = 0.015;
  double linearNoise = 0.2;
  double angularNoise = 0.4;
  double lateralNoise = 0.2;
  double noiseTime = 0.3;
  double goal = 5.0;
  double end = 2.0;
  double heading = 3.0;
  double reverse = 15.0;
  double stop = 10.0;
  double wall = 8.0;
  double wallRange = 0.3;
  double person = 4.0;
  double personRange = 0.6;
  double personMargin = 0.1;
  double hit = 1000.0;
  double smoothness = 0.3;
};

base::ParameterTable<MppiParameters> mppiTable();

/// Weights of the comfort costs.
struct SocialMppiParameters {
  MppiParameters mppi;
  double prediction = 1.0;
  double intimate = 6.0;
  double personal = 4.0;
  double space = 3.0;
  double touchTime = 2.0;
  double fromTouchTime = 3.0;
  double relativeSpeed = 1.0;
  double strip = 3.0;
  double stripTime = 2.0;
  double group = 6.0;
  double legibility = 1.0;
  double patience = 40.0;
  double patienceTime = 15.0;
  double waitDistance = 1.2;
};

base::ParameterTable<SocialMppiParameters> socialMppiTable();

}  // namespace sim2d
