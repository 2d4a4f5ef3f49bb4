#include <algorithm>
#include <limits>

#include "metrics/MetricRegistry.h"
#include "metrics/Motion.h"

namespace metrics {

namespace {

constexpr char kNoGoal[] = "the robot has no goal";

MetricValue timeToReachGoal(const Recording& recording, const MetricParameters& parameters) {
  if (parameters.profile == Profile::Hunav2) {
    return numberValue(recording.duration());
  }
  if (recording.goals.empty()) {
    return undefinedValue(kNoGoal);
  }
  std::size_t entry = recording.size();
  while (entry > 0 && isInGoalRegion(recording, entry - 1, parameters)) {
    --entry;
  }
  if (entry == recording.size()) {
    return undefinedValue("the goal was not reached");
  }
  return numberValue(recording.samples[entry].time - recording.samples.front().time);
}

MetricValue completed(const Recording& recording, const MetricParameters& parameters) {
  return booleanValue(isCompleted(recording, parameters));
}

MetricValue goalDistance(double distance, const Recording& recording,
                         const MetricParameters& parameters) {
  if (!recording.goals.empty()) {
    return numberValue(distance);
  }
  return parameters.profile == Profile::Hunav2 ? infiniteValue(kNoGoal) : undefinedValue(kNoGoal);
}

MetricValue minimumDistance(const Recording& recording, const MetricParameters& parameters) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < recording.size(); ++i) {
    nearest = std::min(nearest, distanceToGoals(recording, i));
  }
  return goalDistance(nearest, recording, parameters);
}

MetricValue finalDistance(const Recording& recording, const MetricParameters& parameters) {
  return goalDistance(distanceToGoals(recording, recording.size() - 1), recording, parameters);
}

}  // namespace

void addGoals(MetricRegistry& to) {
  const Needs needs{true, false, false, false, true};
  const char sean[] = "Tsoi et al., SEAN 2.0, RA-L 2022";
  to.add({"time_to_reach_goal", "Time to reach the goal", "s", Category::Navigation, Better::Lower,
          needs, "t_k - t_0, k = first sample of the last stay inside the goal region",
          "Perez-Higueras, Caballero, Merino, IJSR 2018", "[0, inf)", Kind::Number, 1, ""},
         timeToReachGoal);
  to.add({"completed", "Goal reached", "", Category::Navigation, Better::Higher, needs,
          "some goal g: |p_(N-1) - g| - goal radius < goal_tolerance", sean, "0 or 1",
          Kind::Boolean, 13, ""},
         completed);
  to.add(
      {"minimum_distance_to_target", "Smallest distance to the goal", "m", Category::Navigation,
       Better::Lower, needs, "min over i, g of |p_i - g|", sean, "[0, inf)", Kind::Number, 14, ""},
      minimumDistance);
  to.add(
      {"final_distance_to_target", "Final distance to the goal", "m", Category::Navigation,
       Better::Lower, needs, "min over g of |p_(N-1) - g|", sean, "[0, inf)", Kind::Number, 15, ""},
      finalDistance);
}

}  // namespace metrics
