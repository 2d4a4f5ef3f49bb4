#include <algorithm>

#include "metrics/MetricRegistry.h"

namespace metrics {

namespace {

constexpr char kNoObstacle[] = "no obstacle in reach of the robot";

std::optional<double> clearanceOf(const Robot& robot) {
  return robot.obstacleDistance ? std::optional<double>(*robot.obstacleDistance - robot.radius)
                                : std::nullopt;
}

class Clearances : public Accumulator {
 public:
  void add(const Instant& at) override {
    const std::optional<double> clearance = clearanceOf(at.now.robot);
    if (clearance) {
      smallest_ = count_ > 0.0 ? std::min(smallest_, *clearance) : *clearance;
      sum_ += *clearance;
      count_ += 1.0;
    }
    tooClose_.add(at, clearance && *clearance < at.parameters.safetyDistance);
  }
  MetricValue smallest(const Instant& /*last*/) const {
    return count_ > 0.0 ? numberValue(smallest_) : undefinedValue(kNoObstacle);
  }
  MetricValue average(const Instant& /*last*/) const {
    return count_ > 0.0 ? numberValue(sum_ / count_) : undefinedValue(kNoObstacle);
  }
  MetricValue safety(const Instant& last) const {
    return numberValue(tooClose_.percentOf(last.elapsed()));
  }

 private:
  double smallest_ = 0.0, sum_ = 0.0, count_ = 0.0;
  HeldTime tooClose_;
};

}  // namespace

void addClearance(MetricRegistry& to) {
  const Needs needs{true, false, false, true};
  const char source[] = "Francis et al. 2025; SocNavGym; bench-mr";
  to.add(
      {"clearing_distance_min", "Smallest clearance", "m", Category::Safety, Better::Higher, needs,
       "min over samples with an obstacle in reach of (its distance - r_r)", source, "(-inf, inf)"},
      streamOf<Clearances>(&Clearances::smallest));
  to.add({"clearing_distance_avg", "Mean clearance", "m", Category::Safety, Better::Higher, needs,
          "mean over samples with an obstacle in reach of (its distance - r_r)", source,
          "(-inf, inf)"},
         streamOf<Clearances>(&Clearances::average));
  to.add({"obstacle_safety", "Time too close to obstacles", "%", Category::Safety, Better::Lower,
          needs, "share of time with clearance < safety_distance", "MRPB; SRPB", "[0, 100]"},
         streamOf<Clearances>(&Clearances::safety));
}

}  // namespace metrics
