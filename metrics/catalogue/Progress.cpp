#include "metrics/Motion.h"

namespace metrics {

namespace {

constexpr char kNoGoal[] = "the robot has no goal";
constexpr double kSamePlace = 1e-9;  // [m]

/// Distances to the first goal.
class GoalProgress : public Accumulator {
 public:
  void add(const Instant& at) override {
    if (at.context.goals.empty()) {
      return;
    }
    const double now = lengthOf(at.now.robot.position - at.context.goals.front().position);
    first_ = at.before == nullptr ? now : first_;
    const bool isWorse = now > before_ + at.parameters.progressTolerance;
    worse_ += at.before != nullptr && isWorse ? 1.0 : 0.0;
    before_ = now;
  }
  MetricValue failures(const Instant& last) const {
    return last.context.goals.empty() ? undefinedValue(kNoGoal) : countValue(worse_);
  }
  MetricValue ratioLeft(const Instant& last) const {
    if (last.context.goals.empty()) {
      return undefinedValue(kNoGoal);
    }
    return first_ > kSamePlace ? numberValue(before_ / first_)
                               : undefinedValue("the robot starts at its goal");
  }

 private:
  double first_ = 0.0, before_ = 0.0;  // [m] at the first and the newest sample
  double worse_ = 0.0;
};

class StalledTime : public Accumulator {
 public:
  void add(const Instant& at) override {
    time_.add(at, lengthOf(at.now.robot.velocity) < at.parameters.stallSpeed);
  }
  MetricValue value(const Instant& /*last*/) const { return numberValue(time_.value()); }

 private:
  HeldTime time_;
};

MetricValue finalDistanceOverLength(const RobotWay& way, const Instant& last) {
  if (last.context.goals.empty()) {
    return undefinedValue(kNoGoal);
  }
  const double distance = distanceToGoals(last.context, last.now.robot.position);
  return way.length() > 0.0 ? numberValue(distance / way.length())
                            : undefinedValue("the robot did not move");
}

}  // namespace

void addProgress(MetricRegistry& to) {
  const Needs goal{true, false, false, false, true};
  to.add(
      {"failure_to_progress", "Steps away from the goal", "", Category::Navigation, Better::Lower,
       goal, "number of i with |p_i - g| > |p_(i-1) - g| + progress_tolerance, g = first goal",
       "Francis et al. 2025; SocNavGym", "0, 1, ...", Kind::Count, 0, ""},
      streamOf<GoalProgress>(&GoalProgress::failures));
  to.add({"stalled_time", "Time stalled", "s", Category::Navigation, Better::Lower, Needs{},
          "sum of dt_i with |v_i| < stall_speed", "Francis et al. 2025; SocNavGym", "[0, T]",
          Kind::Number, 0, ""},
         streamOf<StalledTime>(&StalledTime::value));
  to.add({"goal_traversal_ratio", "Share of the distance left", "", Category::Navigation,
          Better::Lower, goal, "|p_(N-1) - g| / |p_0 - g|, g = first goal", "SocNavBench",
          "[0, inf)", Kind::Number, 0, ""},
         streamOf<GoalProgress>(&GoalProgress::ratioLeft));
  to.add(
      {"targ_dist_norm", "Final distance per path length", "", Category::Navigation, Better::Lower,
       goal, "final_distance_to_target / L", "SEAN 2.0", "[0, inf)", Kind::Number, 0, ""},
      streamOf<RobotWay>(finalDistanceOverLength));
  to.setRateBound("failure_to_progress", 0.51);  // counts samples
}

}  // namespace metrics
