#include <cmath>

#include "metrics/MetricRegistry.h"
#include "metrics/Motion.h"

namespace metrics {

namespace {

constexpr char kNoGoal[] = "the robot has no goal";
constexpr double kSamePlace = 1e-9;  // [m]

double distanceToFirstGoal(const Recording& recording, std::size_t sample) {
  return lengthOf(recording.samples[sample].robot.position - recording.goals.front().position);
}

MetricValue failureToProgress(const Recording& recording, const MetricParameters& parameters) {
  if (recording.goals.empty()) {
    return undefinedValue(kNoGoal);
  }
  double count = 0.0;
  for (std::size_t i = 1; i < recording.size(); ++i) {
    const double before = distanceToFirstGoal(recording, i - 1);
    count += distanceToFirstGoal(recording, i) > before + parameters.progressTolerance ? 1.0 : 0.0;
  }
  return countValue(count);
}

MetricValue stalledTime(const Recording& recording, const MetricParameters& parameters) {
  return numberValue(timeWhere(recording, [&](std::size_t i) {
    return lengthOf(recording.samples[i].robot.velocity) < parameters.stallSpeed;
  }));
}

MetricValue goalTraversalRatio(const Recording& recording, const MetricParameters& /*parameters*/) {
  if (recording.goals.empty()) {
    return undefinedValue(kNoGoal);
  }
  const double first = distanceToFirstGoal(recording, 0);
  if (first <= kSamePlace) {
    return undefinedValue("the robot starts at its goal");
  }
  return numberValue(distanceToFirstGoal(recording, recording.size() - 1) / first);
}

MetricValue finalDistanceOverLength(const Recording& recording,
                                    const MetricParameters& /*parameters*/) {
  if (recording.goals.empty()) {
    return undefinedValue(kNoGoal);
  }
  const double length = pathLength(recording);
  return length > 0.0 ? numberValue(distanceToGoals(recording, recording.size() - 1) / length)
                      : undefinedValue("the robot did not move");
}

}  // namespace

void addProgress(MetricRegistry& to) {
  const Needs goal{true, false, false, false, true};
  to.add(
      {"failure_to_progress", "Steps away from the goal", "", Category::Navigation, Better::Lower,
       goal, "number of i with |p_i - g| > |p_(i-1) - g| + progress_tolerance, g = first goal",
       "Francis et al. 2025; SocNavGym", "0, 1, ...", Kind::Count, 0, ""},
      failureToProgress);
  to.add({"stalled_time", "Time stalled", "s", Category::Navigation, Better::Lower, Needs{},
          "sum of dt_i with |v_i| < stall_speed", "Francis et al. 2025; SocNavGym", "[0, T]",
          Kind::Number, 0, ""},
         stalledTime);
  to.add({"goal_traversal_ratio", "Share of the distance left", "", Category::Navigation,
          Better::Lower, goal, "|p_(N-1) - g| / |p_0 - g|, g = first goal", "SocNavBench",
          "[0, inf)", Kind::Number, 0, ""},
         goalTraversalRatio);
  to.add(
      {"targ_dist_norm", "Final distance per path length", "", Category::Navigation, Better::Lower,
       goal, "final_distance_to_target / L", "SEAN 2.0", "[0, inf)", Kind::Number, 0, ""},
      finalDistanceOverLength);
  to.setRateBound("failure_to_progress", 0.51);  // counts samples
}

}  // namespace metrics
