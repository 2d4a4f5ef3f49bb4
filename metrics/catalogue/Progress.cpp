#include "metrics/Motion.h"
#include "metrics/TermSums.h"

/// On the way to the goals.
namespace metrics {

namespace {

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
      return last.elapsed();
    }
    if (last.context.goals.empty()) {
      return undefinedValue(kNoGoal);
    }
    return since_ ? *since_ : undefinedValue("the goal was not reached");
  }

 private:
  std::optional<double> since_;  // [s]
};

MetricValue completed(const Instant& last) {
  return isCompleted(last) ? 1.0 : 0.0;
}

MetricValue goalDistance(double distance, const Instant& last) {
  if (!last.context.goals.empty()) {
    return distance;
  }
  return last.isOriginal() ? infiniteValue(kNoGoal) : undefinedValue(kNoGoal);
}

double toNearestGoal(const Instant& at) {
  return distanceToGoals(at.context, at.now.robot.position);
}

MetricValue smallestDistance(const Figures& distances, const Instant& last) {
  return goalDistance(distances.least(), last);
}

MetricValue finalDistance(const Instant& last) {
  return goalDistance(toNearestGoal(last), last);
}

void addGoals(MetricRegistry& to) {
  const Needs needs{true, false, false, false, true};
  const char sean[] = "Tsoi et al., SEAN 2.0, RA-L 2022";
  to.add({"time_to_reach_goal", "Time to reach the goal", "s", Category::Navigation, Better::Lower,
          needs, "t_k - t_0, k = first sample of the last stay inside the goal region",
          "Perez-Higueras, Caballero, Merino, IJSR 2018", "[0, inf)", Kind::Number, 1},
         streamOf<GoalStay>(&GoalStay::time));
  to.add({"completed", "Goal reached", "", Category::Navigation, Better::Higher, needs,
          "some goal g: |p_(N-1) - g| - goal radius < goal_tolerance", sean, "0 or 1",
          Kind::Boolean, 13},
         streamOfLast(completed));
  to.add({"minimum_distance_to_target", "Smallest distance to the goal", "m", Category::Navigation,
          Better::Lower, needs, "min over i, g of |p_i - g|", sean, "[0, inf)", Kind::Number, 14},
         figuresOf<toNearestGoal>(smallestDistance));
  to.add({"final_distance_to_target", "Final distance to the goal", "m", Category::Navigation,
          Better::Lower, needs, "min over g of |p_(N-1) - g|", sean, "[0, inf)", Kind::Number, 15},
         streamOfLast(finalDistance));
}

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
  double failures(const Instant& last) const { return last.context.goals.empty() ? kNaN : worse_; }
  MetricValue ratioLeft(const Instant& last) const {
    if (last.context.goals.empty()) {
      return undefinedValue(kNoGoal);
    }
    return first_ > kSamePlace ? before_ / first_ : undefinedValue("the robot starts at its goal");
  }

 private:
  double first_ = 0.0, before_ = 0.0;  // [m] at the first and the newest sample
  double worse_ = 0.0;
};

bool isStalled(const Instant& at) {
  return lengthOf(at.now.robot.velocity) < at.parameters.stallSpeed;
}

MetricValue finalDistanceOverLength(const RobotWay& way, const Instant& last) {
  if (last.context.goals.empty()) {
    return undefinedValue(kNoGoal);
  }
  return way.length() > 0.0 ? toNearestGoal(last) / way.length()
                            : undefinedValue("the robot did not move");
}

void addOwnProgress(MetricRegistry& to) {
  const Needs goal{true, false, false, false, true};
  to.add(
      {"failure_to_progress", "Steps away from the goal", "", Category::Navigation, Better::Lower,
       goal, "number of i with |p_i - g| > |p_(i-1) - g| + progress_tolerance, g = first goal",
       "Francis et al. 2025; SocNavGym", "0, 1, ...", Kind::Count, 0, "", 0.51},  // counts samples
      streamOf<GoalProgress>(&GoalProgress::failures, kNoGoal));
  to.add({"stalled_time", "Time stalled", "s", Category::Navigation, Better::Lower, Needs{},
          "sum of dt_i with |v_i| < stall_speed", "Francis et al. 2025; SocNavGym", "[0, T]"},
         timesOf<isStalled>(&Times::time));
  to.add({"goal_traversal_ratio", "Share of the distance left", "", Category::Navigation,
          Better::Lower, goal, "|p_(N-1) - g| / |p_0 - g|, g = first goal", "SocNavBench"},
         streamOf<GoalProgress>(&GoalProgress::ratioLeft));
  to.add({"targ_dist_norm", "Final distance per path length", "", Category::Navigation,
          Better::Lower, goal, "final_distance_to_target / L", "SEAN 2.0"},
         streamOf<RobotWay>(finalDistanceOverLength));
}

}  // namespace

void addProgress(MetricRegistry& to) {
  addGoals(to);
  addOwnProgress(to);
}

}  // namespace metrics
