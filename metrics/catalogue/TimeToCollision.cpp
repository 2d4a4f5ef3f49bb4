#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "metrics/RobotMotion.h"
#include "metrics/TermStatistics.h"

/// Threat and comfort: time to collision, passing distance, lateral acceleration.
namespace metrics {

namespace {

/// Caps distant times, which would dominate the mean.
double cappedTime(const Instant& at) {
  const double time = at.term(timeToCollisionTerm);
  return std::isnan(time) ? kNaN : std::min(time, at.parameters.collisionCap);
}

MetricValue averageTime(const TermStatistics& times) {
  return times.count() > 0.0 ? times.meanWithSeries() : kNaN;
}

bool isThreat(const Instant& at) {
  return at.term(timeToCollisionTerm) < at.parameters.collisionHorizon;
}

/// Amount by which the time to collision is below the horizon.
double threat(const Instant& at) {
  return isThreat(at) ? at.parameters.collisionHorizon - at.term(timeToCollisionTerm) : 0.0;
}

/// The smallest gap of each person who comes near.
class PassingDistance : public Accumulator {
 public:
  void add(const Instant& at) override {
    const Sample& now = at.now;
    for (const Pedestrian& person : now.people) {
      if (isWithin(now.robot, person, at.parameters.socialDistance)) {
        const double space = gap(now.robot, person);
        double& closest = closest_.emplace(person.id, space).first->second;
        closest = std::min(closest, space);
      }
    }
  }

  double mean() const {
    double sum = 0.0;
    for (const auto& [id, space] : closest_) {
      sum += space;
    }
    return closest_.empty() ? kNaN : sum / static_cast<double>(closest_.size());
  }

 private:
  std::map<int, double> closest_;  // smallest gap [m], by id
};

/// Approach speed of the closest person and the robot, for samples in personal space.
double approach(const Instant& at) {
  const Robot& robot = at.now.robot;
  double closest = std::numeric_limits<double>::infinity();
  double value = kNaN;
  for (const Pedestrian& person : at.now.people) {
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

double fastest(const TermStatistics& speeds) {
  return speeds.count() > 0.0 ? std::fmax(speeds.largest(), 0.0) : kNaN;
}

double sideways(const Instant& at) {
  return std::fabs(at.now.robot.speed * at.now.robot.omega);
}

MetricValue largestValue(const TermStatistics& figures) {
  return withSeries(figures.largest(), figures.series());
}

constexpr char kTimeToCollisionMetrics[] = R"(
= Safety & Collisions|higher|robot, people|Francis et al. 2025; SocNavGym
avg_time_to_collision|Mean time to collision|s|[0, inf)|mean over the samples at which a person is on a collision course of min(min over a of ttc,
  collision_cap)
= Safety & Collisions|lower|robot, people|Minderhoud and Bovy 2001
time_exposed_to_collision|Time exposed to collisions|s|[0, T]|time with min over a of ttc < collision_horizon
time_integrated_to_collision|Time-integrated threat of collisions|s²|[0, inf)|sum over i < N-1 of (collision_horizon - m_i) dt_i where m_i = min over a of ttc <
  collision_horizon
= Social Behavior|higher|robot, people|Pacchierotti et al. 2006
avg_passing_distance|Mean passing distance|m|(-inf, social_distance)|mean over the people whose gap is < social_distance at some sample of their
  smallest gap (not cut at 0)
= Social Behavior|lower|robot, people|Butler and Agah 2001
max_approach_speed|Largest approach speed|m/s|[0, inf)|max over the samples with a gap < personal_distance (d > 0) of C V/d of the person with the smallest gap,
  not below 0; undefined if there is none
= Motion Analysis|lower|robot|ISO 2631, ride comfort
max_lateral_acceleration|Largest lateral acceleration|m/s²|[0, inf)|max over i of |s_i w_i|
)";

}  // namespace

void addTimeToCollision(MetricRegistry& to) {
  to.add(kTimeToCollisionMetrics,
         {{"avg_time_to_collision",
           seriesStatisticsOf<cappedTime>(averageTime, "never on a collision course")},
          {"time_exposed_to_collision", conditionTimeOf<isThreat>(&ConditionTime::time)},
          {"time_integrated_to_collision", statisticsOf<threat>(&TermStatistics::integral)},
          {"avg_passing_distance",
           metricOf<PassingDistance>(&PassingDistance::mean, "no person was passed")},
          {"max_approach_speed", statisticsOf<approach>(fastest, "no person in personal space")},
          {"max_lateral_acceleration", seriesStatisticsOf<sideways>(largestValue)}});
}

}  // namespace metrics
