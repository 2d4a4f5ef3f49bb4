#include <cmath>
#include <limits>
#include <map>

#include "metrics/TermSums.h"

/// Threat and comfort: collisions ahead, passing, sideways acceleration.
namespace metrics {

namespace {

MetricValue average(const Figures& times) {
  return times.count() > 0.0 ? times.meanWithSeries() : kNaN;
}

bool isThreat(const Instant& at) {
  return at.term(collisionTerm) < at.parameters.collisionHorizon;
}

/// How far the time to collision stays below the horizon.
double threat(const Instant& at) {
  return isThreat(at) ? at.parameters.collisionHorizon - at.term(collisionTerm) : 0.0;
}

/// The smallest gap of each person who comes near.
class PassingDistance : public Accumulator {
 public:
  explicit PassingDistance(const MetricParameters& parameters)
      : limit_(parameters.socialDistance) {}

  void add(const Instant& at) override {
    const Sample& now = at.now;
    for (const Person& person : now.people) {
      const double reach = limit_ + now.robot.radius + person.radius + 1e-6;
      if ((person.position - now.robot.position).squaredNorm() > reach * reach) {
        continue;
      }
      const double space = gap(now.robot, person);
      const auto [found, isNew] = closest_.emplace(person.id, space);
      found->second = space < found->second ? space : found->second;
    }
  }

  double mean() const {
    double sum = 0.0;
    double count = 0.0;
    for (const auto& [id, space] : closest_) {
      sum += space < limit_ ? space : 0.0;
      count += space < limit_ ? 1.0 : 0.0;
    }
    return count > 0.0 ? sum / count : kNaN;
  }

 private:
  double limit_;
  std::map<int, double> closest_;
};

/// Speed at which the closest person and the robot near each other, of samples in personal space.
double approach(const Instant& at) {
  const Robot& robot = at.now.robot;
  double closest = std::numeric_limits<double>::infinity();
  double value = kNaN;
  for (const Person& person : at.now.people) {
    const double space = gap(robot, person);
    const Vec2 between = person.position - robot.position;
    const double separation = lengthOf(between);
    if (space < closest && space < at.parameters.personalDistance && separation > 0.0) {
      closest = space;
      value = between.dot(robot.velocity - person.velocity) / separation;
    }
  }
  return value;
}

double fastest(const Figures& speeds) {
  return speeds.count() > 0.0 ? std::fmax(speeds.largest(), 0.0) : kNaN;
}

double sideways(const Instant& at) {
  return std::fabs(at.now.robot.speed * at.now.robot.omega);
}

MetricValue largest(const Figures& figures) {
  return withSeries(figures.largest(), figures.series());
}

}  // namespace

void addTimeToCollision(MetricRegistry& to) {
  const Needs needs{true, true};
  to.add({"avg_time_to_collision", "Mean time to collision", "s", Category::Safety, Better::Higher,
          needs, "mean over the samples on a collision course of min over a of ttc",
          "Francis et al. 2025; SocNavGym"},
         seriesFiguresOf<collisionTerm>(average, "never on a collision course"));
  const char source[] = "Minderhoud and Bovy 2001";
  to.add({"time_exposed_to_collision", "Time with a collision ahead", "s", Category::Safety,
          Better::Lower, needs, "sum of dt_i with min over a of ttc < collision_horizon", source,
          "[0, T]"},
         timesOf<isThreat>(&Times::time));
  to.add({"time_integrated_to_collision", "Threat of collisions", "s²", Category::Safety,
          Better::Lower, needs,
          "sum of (collision_horizon - ttc) dt_i where ttc < collision_horizon", source},
         figuresOf<threat>(&Figures::integral));
  to.add({"avg_passing_distance", "Mean passing distance", "m", Category::Social, Better::Higher,
          needs, "mean over people of their smallest gap, of those with it < social_distance",
          "Pacchierotti et al. 2006", "(-inf, social_distance)"},
         streamOf<PassingDistance>(&PassingDistance::mean, "nobody was passed"));
  to.add(
      {"max_approach_speed", "Largest speed of approach", "m/s", Category::Social, Better::Lower,
       needs,
       "max of the closing speed with the closest person, of samples with gap < personal_distance",
       "Butler and Agah 2001"},
      figuresOf<approach>(fastest, "nobody in personal space"));
  to.add({"max_lateral_acceleration", "Largest sideways acceleration", "m/s²", Category::Motion,
          Better::Lower, Needs{}, "max of |s_i w_i|", "ISO 2631, comfort of rides"},
         seriesFiguresOf<sideways>(largest));
}

}  // namespace metrics
