#include <algorithm>
#include <limits>

#include "metrics/Motion.h"

namespace metrics {

namespace {

constexpr char kNoGoal[] = "the robot has no goal";

/// Begin of the stay inside the goal region that still lasts.
class GoalStay : public Accumulator {
 public:
  void add(const Instant& at) override {
    if (!isInGoalRegion(at.context, at.now.robot.position, at.parameters)) {
      since_.reset();
    } else if (!since_) {
      since_ = at.elapsed();
    }
  }
  MetricValue time(const Instant& last) const {
    if (last.isOriginal()) {
      return numberValue(last.elapsed());
    }
    if (last.context.goals.empty()) {
      return undefinedValue(kNoGoal);
    }
    return since_ ? numberValue(*since_) : undefinedValue("the goal was not reached");
  }

 private:
  std::optional<double> since_;  // [s]
};

MetricValue completed(const Instant& last) {
  return booleanValue(isCompleted(last));
}

MetricValue goalDistance(double distance, const Instant& last) {
  if (!last.context.goals.empty()) {
    return numberValue(distance);
  }
  return last.isOriginal() ? infiniteValue(kNoGoal) : undefinedValue(kNoGoal);
}

class NearestGoal : public Accumulator {
 public:
  void add(const Instant& at) override {
    nearest_ = std::min(nearest_, distanceToGoals(at.context, at.now.robot.position));
  }
  MetricValue value(const Instant& last) const { return goalDistance(nearest_, last); }

 private:
  double nearest_ = std::numeric_limits<double>::infinity();  // [m]
};

MetricValue finalDistance(const Instant& last) {
  return goalDistance(distanceToGoals(last.context, last.now.robot.position), last);
}

}  // namespace

void addGoals(MetricRegistry& to) {
  const Needs needs{true, false, false, false, true};
  const char sean[] = "Tsoi et al., SEAN 2.0, RA-L 2022";
  to.add({"time_to_reach_goal", "Time to reach the goal", "s", Category::Navigation, Better::Lower,
          needs, "t_k - t_0, k = first sample of the last stay inside the goal region",
          "Perez-Higueras, Caballero, Merino, IJSR 2018", "[0, inf)", Kind::Number, 1, ""},
         streamOf<GoalStay>(&GoalStay::time));
  to.add({"completed", "Goal reached", "", Category::Navigation, Better::Higher, needs,
          "some goal g: |p_(N-1) - g| - goal radius < goal_tolerance", sean, "0 or 1",
          Kind::Boolean, 13, ""},
         streamOfLast(completed));
  to.add(
      {"minimum_distance_to_target", "Smallest distance to the goal", "m", Category::Navigation,
       Better::Lower, needs, "min over i, g of |p_i - g|", sean, "[0, inf)", Kind::Number, 14, ""},
      streamOf<NearestGoal>(&NearestGoal::value));
  to.add(
      {"final_distance_to_target", "Final distance to the goal", "m", Category::Navigation,
       Better::Lower, needs, "min over g of |p_(N-1) - g|", sean, "[0, inf)", Kind::Number, 15, ""},
      streamOfLast(finalDistance));
}

}  // namespace metrics
