#include <algorithm>
#include <cmath>

#include "metrics/TermStatistics.h"

namespace metrics {

namespace {

constexpr double kSmallSine = 1e-6;  // smaller sines are noise around 0

/// 1 / time to collision, capped; 0 without a collision course.
double fearCost(const Body& robot, const Pedestrian& person, const MetricParameters& parameters) {
  if (parameters.profile == Profile::Hunav2) {
    const Vec2 centres = person.position - robot.position;
    const Vec2 closing = robot.velocity - person.velocity;
    return centres.dot(closing) > 0.0 ? lengthOf(closing) / lengthOf(centres) : 0.0;
  }
  const double time = person.pair.timeToCollision;
  return time * parameters.fearCap <= 1.0 ? parameters.fearCap : 1.0 / time;
}

/// Cost of approaching pairs that narrowly miss each other.
double panicCost(const Body& robot, const Body& person, const MetricParameters& parameters) {
  const Vec2 centres = person.position - robot.position;
  const Vec2 closing = robot.velocity - person.velocity;
  const double radii = robot.radius + person.radius;
  const double along = centres.dot(closing);
  if (along <= 0.0) {
    return 0.0;
  }
  if (parameters.profile == Profile::Hunav2) {
    const double speed = lengthOf(closing);
    const double separation = lengthOf(centres);
    const double sine = std::fabs(base::cross(centres, closing)) / (separation * speed);
    const double miss = separation * sine;
    return miss > radii && sine > kSmallSine ? speed / ((miss - radii) * sine) : 0.0;
  }
  // This order of operations reproduces the last digits of the published reference values.
  const double speed2 = closing.squaredNorm();
  const double squared = centres.squaredNorm();
  const double aside = std::sqrt(std::max(speed2 * squared - along * along, 0.0));  // g
  const double margin = aside - std::sqrt(speed2) * radii;  // <= 0 on a collision course
  return margin > parameters.panicEpsilon ? std::sqrt(speed2 / squared) * aside / margin : 0.0;
}

class DangerSum : public PersonCosts {
 public:
  DangerSum() : PersonCosts(2) {}

 protected:
  bool addCosts(const Instant& at, const Pedestrian& person, std::vector<double>& costs) override {
    costs[0] = fearCost(at.now.robot, person, at.parameters);
    costs[1] = panicCost(at.now.robot, person, at.parameters);
    return true;
  }
};

constexpr char kDangerMetrics[] = R"(
= Danger & Surprise Metrics|lower|robot, people|Singamaneni, Favier, Alami, RO-MAN 2023
30 danger_fear_cost|Danger: fear|1/s|[0, inf)|sum over i, a of min(1/ttc, fear_cap), fear_cap for ttc = 0, 0 without a collision course
31 danger_panic_cost|Danger: panic|1/s|[0, inf)|sum over i, a with C V > 0 and M = g - |V| R > panic_epsilon of (|V|/d) g/M, g = sqrt(max(|V|^2 d^2 -
  (C V)^2, 0)); near misses, g/|V| being the miss distance
)";

}  // namespace

void addDanger(MetricRegistry& to) {
  to.addSums(kDangerMetrics, {{"danger_fear_cost", metricOfPart<DangerSum>(0)},
                              {"danger_panic_cost", metricOfPart<DangerSum>(1)}});
}

}  // namespace metrics
