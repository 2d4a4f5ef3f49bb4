#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "metrics/Report.h"

/// Results of a run besides its metrics.
namespace metrics {

/// Effect of the robot on people: compares a run with the same run without the robot.

/// Difference with - without robot for one person. Detour and delay are taken up to the last goal
/// that is reached in both runs, or up to the last common instant if there is none; the other
/// values over all common instants.
struct PersonEffect {
  int id = 0;
  double detour = 0.0;       // [m] additional path length
  double delay = kNaN;       // [s] later arrival; NaN: goals reached, but none in common
  double extraForce = 0.0;   // [m/s] sum of |change of velocity with - without|
  double slowedTime = 0.0;   // [s] slower by more than 0.1 m/s
  double disturbance = 0.0;  // [rad] mean |heading with - without|
};

/// The people present in both records, by id.
std::vector<PersonEffect> personEffects(const sim2d::Trace& with, const sim2d::Trace& without);
/// Descriptions of the sums, in order.
std::vector<MetricInfo> effectInfos();
/// Sums over the people, with keys that start with counterfactual_.
std::vector<MetricResult> effectSums(const std::vector<PersonEffect>& effects);
/// Content of counterfactual.csv: one row per person.
std::string effectsCsv(const std::vector<PersonEffect>& effects);

/// Wall-clock timing of a run. It is not reproducible, so records, metrics and batches do not
/// contain it; only the program that executes the run reports it.

/// Wall time of the robots' planning per step [s].
class PlanningTime {
 public:
  void add(double seconds);
  std::int64_t steps() const { return steps_; }
  /// Results for planningTimeInfos(): mean and sample standard deviation; undefined without
  /// measurements.
  std::vector<MetricResult> results() const;

 private:
  std::int64_t steps_ = 0;
  double mean_ = 0.0;
  double squares_ = 0.0;  // sum of squared deviations
};

/// planning_time_mean, planning_time_std.
std::vector<MetricInfo> planningTimeInfos();

/// Positions on the robot's path, from the same samples as its metrics. If the record has no robot
/// with the selected id, its first robot is used.

/// The part of the robot's path that its metrics use, with times from its start; empty: none.
TimedPath robotPathOf(const sim2d::Trace& trace, const Selection& selection,
                      const MetricParameters& parameters);

/// The start of a contact of the robot.
struct RobotContact {
  double time = 0.0;            // in the record [s]
  Vec2 place = Vec2::Zero();    // position of the robot
  std::optional<int> person{};  // null: an obstacle
};

/// The contacts that `success` counts, in order: with people whose gap falls below
/// contact_distance, and with obstacles.
std::vector<RobotContact> robotContacts(const sim2d::Trace& trace, const Selection& selection,
                                        const MetricParameters& parameters);

}  // namespace metrics
