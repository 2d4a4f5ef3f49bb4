#include "metrics/RobotMotion.h"
#include "metrics/TermStatistics.h"

namespace metrics {

namespace {

constexpr char kNoObstacle[] = "no obstacle in range of the robot";

double clearance(const Instant& at) {
  const Robot& robot = at.now.robot;
  return robot.obstacleDistance ? *robot.obstacleDistance - robot.radius : kNaN;
}

bool isTooClose(const Instant& at) {
  return at.term(clearance) < at.parameters.safetyDistance;
}

MetricValue timeTooClose(const ConditionTime& times, const Instant& last) {
  return last.context.hasObstacles ? times.percentOfTime(last) : undefinedValue(kNoObstacles);
}

constexpr char kClearanceMetrics[] = R"(
= Safety & Collisions|higher|robot, obstacles|Francis et al. 2025; SocNavGym; bench-mr
clearing_distance_min|Smallest clearance|m|(-inf, inf)|min over the samples with an edge within 5 m of the clearance (distance from the centre - r_r,
  negative inside)
clearing_distance_avg|Mean clearance|m|(-inf, inf)|mean over the same samples of the clearance
= Safety & Collisions|lower|robot, obstacles|MRPB; SRPB
obstacle_safety|Time too close to obstacles|%|[0, 100]|share of time with clearance < safety_distance; false where no edge is within 5 m
)";

}  // namespace

void addClearance(MetricRegistry& to) {
  to.add(kClearanceMetrics,
         {{"clearing_distance_min", statisticsOf<clearance>(&TermStatistics::least, kNoObstacle)},
          {"clearing_distance_avg", statisticsOf<clearance>(&TermStatistics::mean, kNoObstacle)},
          {"obstacle_safety", conditionTimeOf<isTooClose>(timeTooClose)}});
}

}  // namespace metrics
