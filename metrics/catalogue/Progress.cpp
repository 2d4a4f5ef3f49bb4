#include "metrics/RobotMotion.h"
#include "metrics/TermStatistics.h"

/// Progress towards the goals.
namespace metrics {

namespace {

/// HuNavSim's evaluator uses the duration of the record.
MetricValue timeToGoal(const ArrivalTime& arriving, const Instant& last) {
  if (last.usesHunavProfile()) {
    return last.elapsed();
  }
  if (last.context.goals.empty()) {
    return undefinedValue(kNoGoal);
  }
  const std::optional<double> time = arriving.time(last);
  return time ? *time : undefinedValue("the goal was not reached");
}

MetricValue goalDistance(double distance, const Instant& last) {
  if (!last.context.goals.empty()) {
    return distance;
  }
  return last.usesHunavProfile() ? infiniteValue(kNoGoal) : undefinedValue(kNoGoal);
}

double toNearestGoal(const Instant& at) {
  return distanceToGoals(at.context, at.now.robot.position);
}

MetricValue smallestDistance(const TermStatistics& distances, const Instant& last) {
  return goalDistance(distances.least(), last);
}

MetricValue finalDistance(const Instant& last) {
  return goalDistance(toNearestGoal(last), last);
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
  double first_ = 0.0, before_ = 0.0;  // [m] at the first and newest sample
  double worse_ = 0.0;
};

bool isStalled(const Instant& at) {
  return lengthOf(at.now.robot.velocity) < at.parameters.stallSpeed;
}

MetricValue finalDistanceOverLength(const RobotPath& way, const Instant& last) {
  if (last.context.goals.empty()) {
    return undefinedValue(kNoGoal);
  }
  return way.length() > 0.0 ? toNearestGoal(last) / way.length()
                            : undefinedValue("the robot did not move");
}

/// failure_to_progress counts samples: it doubles with the sampling rate.
constexpr char kProgressMetrics[] = R"(
= Navigation Performance|lower|robot, goal|Perez-Higueras, Caballero, Merino, IJSR 2018
1 time_to_reach_goal|Time to reach the goal|s|[0, inf)|time of arrival - t_0 (METRICS.md, Evaluation interval), 0 if it is before t_0; undefined if the robot
  does not arrive by the last sample
= Navigation Performance|higher|robot, goal|Tsoi et al., SEAN 2.0, RA-L 2022
13 completed|Goal reached||0 or 1|1 if the robot has arrived by the last sample (METRICS.md, Evaluation interval), else 0
= Navigation Performance|lower|robot, goal|Tsoi et al., SEAN 2.0, RA-L 2022
14 minimum_distance_to_target|Smallest distance to the goal|m|[0, inf)|min over i and goals g of |p_i - g|, to the centre
15 final_distance_to_target|Final distance to the goal|m|[0, inf)|min over goals g of |p_(N-1) - g|, to the centre
= Navigation Performance|lower|robot, goal|Francis et al. 2025; SocNavGym|0.51
failure_to_progress|Steps away from the goal||0, 1, ...|number of i > 0 with |p_i - g| > |p_(i-1) - g| + progress_tolerance, g = first goal
= Navigation Performance|lower|robot|Francis et al. 2025; SocNavGym
stalled_time|Time stalled|s|[0, T]|time with |v_i| < stall_speed, turning or not
= Navigation Performance|lower|robot, goal|SocNavBench
goal_traversal_ratio|Remaining share of the distance||[0, inf)||p_(N-1) - g| / |p_0 - g|, g = first goal; undefined if |p_0 - g| <= 1e-9
= Navigation Performance|lower|robot, goal|SEAN 2.0
targ_dist_norm|Final distance per path length||[0, inf)|final_distance_to_target / L, L = path_length; undefined if L = 0
)";

}  // namespace

void addProgress(MetricRegistry& to) {
  to.add(kProgressMetrics,
         {{"time_to_reach_goal", metricOf<ArrivalTime>(timeToGoal)},
          {"completed", metricOfLast(isCompleted)},
          {"minimum_distance_to_target", statisticsOf<toNearestGoal>(smallestDistance)},
          {"final_distance_to_target", metricOfLast(finalDistance)},
          {"failure_to_progress", metricOf<GoalProgress>(&GoalProgress::failures, kNoGoal)},
          {"stalled_time", conditionTimeOf<isStalled>(&ConditionTime::time)},
          {"goal_traversal_ratio", metricOf<GoalProgress>(&GoalProgress::ratioLeft)},
          {"targ_dist_norm", metricOf<RobotPath>(finalDistanceOverLength)}});
}

}  // namespace metrics
