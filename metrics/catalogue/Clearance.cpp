#include "metrics/TermSums.h"

namespace metrics {

namespace {

constexpr char kNoObstacle[] = "no obstacle in reach of the robot";

double clearance(const Instant& at) {
  const Robot& robot = at.now.robot;
  return robot.obstacleDistance ? *robot.obstacleDistance - robot.radius : kNaN;
}

bool isTooClose(const Instant& at) {
  return at.term(clearance) < at.parameters.safetyDistance;
}

}  // namespace

void addClearance(MetricRegistry& to) {
  const Needs needs{true, false, false, true};
  const char source[] = "Francis et al. 2025; SocNavGym; bench-mr";
  const MetricFamily own{to, Category::Safety, Better::Higher, needs, source, "(-inf, inf)"};
  own.add("clearing_distance_min", "Smallest clearance", "m",
          "min over samples with an obstacle in reach of (its distance - r_r)",
          figuresOf<clearance>(&Figures::least, kNoObstacle));
  own.add("clearing_distance_avg", "Mean clearance", "m",
          "mean over samples with an obstacle in reach of (its distance - r_r)",
          figuresOf<clearance>(&Figures::mean, kNoObstacle));
  to.add({"obstacle_safety", "Time too close to obstacles", "%", Category::Safety, Better::Lower,
          needs, "share of time with clearance < safety_distance", "MRPB; SRPB", "[0, 100]"},
         timesOf<isTooClose>(&Times::percentOfTime));
}

}  // namespace metrics
