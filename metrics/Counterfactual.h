#pragma once

#include <string>
#include <vector>

#include "metrics/Report.h"

/// What the robot did to people: a run against the same one without it.
namespace metrics {

/// With - without, of one person. Detour and delay up to the last goal that was reached in both
/// runs, without one up to the last instant that both have; the rest over all such instants.
struct PersonEffect {
  int id = 0;
  double detour = 0.0;       // [m] more walked
  double delay = kNaN;       // [s] later there; NaN: a goal was reached in one run alone
  double extraForce = 0.0;   // [m/s] sum of |change of velocity with - without|
  double slowedTime = 0.0;   // [s] slower by more than 0.1 m/s
  double disturbance = 0.0;  // [rad] mean |heading with - without|
};

/// The people of both records, by id.
std::vector<PersonEffect> personEffects(const sim2d::Trace& with, const sim2d::Trace& without);
/// What the sums are, in their order.
std::vector<MetricInfo> effectInfos();
/// Sums over the people, under keys that begin with counterfactual_.
std::vector<MetricResult> effectSums(const std::vector<PersonEffect>& effects);
/// counterfactual.csv: one row per person.
std::string effectsCsv(const std::vector<PersonEffect>& effects);

}  // namespace metrics
