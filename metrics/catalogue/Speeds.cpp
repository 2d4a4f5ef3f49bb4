#include <cmath>
#include <limits>

#include "metrics/RobotMotion.h"
#include "metrics/TermStatistics.h"

/// Speeds, accelerations and jerks of the robot, speeds of people.
namespace metrics {

namespace {

class StandingTime : public Accumulator {
 public:
  void add(const Instant& at) override {
    const Robot& robot = at.now.robot;
    const double turning = at.usesHunavProfile() ? robot.omega : std::fabs(robot.omega);
    const bool stands = std::fabs(robot.speed) < at.parameters.stopLinearSpeed &&
                        turning < at.parameters.stopAngularSpeed;
    samples_.add(at, stands ? 1.0 : 0.0);
    time_.take(at, stands);
  }
  MetricValue value(const Instant& last) const {
    const double time = last.usesHunavProfile()
                            ? last.elapsed() / static_cast<double>(last.count()) * samples_.sum()
                            : time_.time();
    return withSeries(time, samples_.terms(), Kind::Count);
  }

 private:
  SeriesSum samples_;  // 0 or 1
  ConditionTime time_;
};

double drivenSpeed(const Instant& at) {
  return at.now.robot.speed;
}

double turningSpeed(const Instant& at) {
  return at.now.robot.omega;
}

constexpr char kNeedsTwo[] = "at least two samples at different times are needed";
constexpr char kNeedsThree[] =
    "at least three samples at different times are needed, and jerk_window if they are dense";

/// Of the interval that ends here [m/s^2]; NaN if its duration is 0.
double acceleration(const Instant& at) {
  return at.step() > 0.0 ? (at.now.robot.speed - at.before->robot.speed) / at.step() : kNaN;
}

/// As in HuNavSim's evaluator, which divides the acceleration by the time again [m/s^3].
double originalJerk(const Instant& at) {
  return at.term(acceleration) / at.step();
}

/// Second difference around the previous sample [m/s^3]; NaN if an interval has duration 0.
double secondDifferenceJerk(const Instant& at) {
  if (at.earlier == nullptr) {
    return kNaN;
  }
  const double former = at.before->time - at.earlier->time;
  if (!(former > 0.0) || !(at.step() > 0.0)) {
    return kNaN;
  }
  const double accelerationBefore = (at.before->robot.speed - at.earlier->robot.speed) / former;
  const double span = at.now.time - at.earlier->time;
  return (at.term(acceleration) - accelerationBefore) / (span / 2.0);
}

/// The jerks of the robot. The series contains that of sample i at i + 1, and 0 where it is
/// undefined. In profile hunav2 the maximum is of second differences.
class JerkStatistics : public Accumulator {
 public:
  explicit JerkStatistics(const MetricParameters& parameters)
      : jerk_(0.5 * parameters.jerkWindow) {}

  void add(const Instant& at) override {
    if (at.usesHunavProfile()) {
      take(at, originalJerk(at));
      plainLargest_ = std::fmax(plainLargest_, std::fabs(secondDifferenceJerk(at)));
      return;
    }
    if (at.before == nullptr || at.earlier == nullptr) {
      series_.add(at, 0.0);  // entry of the first sample, and the first sample's jerk
    }
    jerk_.add(
        at.now.time, at.now.robot.speed, [&](double jerk) { take(at, jerk); },
        [&](double jerk) { largest_ = std::fmax(largest_, std::fabs(jerk)); });
  }
  MetricValue mean(const Instant& last) const {
    const std::size_t divisor = last.usesHunavProfile() ? last.count() : count_;
    std::vector<double> series = series_.values();
    series.resize(last.keepsSeries ? last.count() : 0, 0.0);  // samples with an incomplete window
    return withSeries(divisor > 0 ? sum_ / static_cast<double>(divisor) : kNaN, std::move(series));
  }
  double largest(const Instant& last) const {
    return last.usesHunavProfile() ? plainLargest_ : largest_;
  }

 private:
  void take(const Instant& at, double jerk) {
    const bool isKnown = !std::isnan(jerk);
    sum_ += isKnown ? std::fabs(jerk) : 0.0;
    count_ += isKnown ? 1 : 0;
    largest_ = std::fmax(largest_, std::fabs(jerk));
    series_.add(at, isKnown ? jerk : 0.0);
  }

  Jerk jerk_;
  double sum_ = 0.0, largest_ = kNaN, plainLargest_ = kNaN;
  std::size_t count_ = 0;
  SeriesColumn series_;
};

/// Mean magnitude of a term. The series contains the signed values, 0 where undefined. HuNavSim's
/// evaluator divides by the number of samples.
template <Term kTerm>
class MeanMagnitude : public Accumulator {
 public:
  void add(const Instant& at) override {
    const double value = at.term(kTerm);
    const bool isKnown = !std::isnan(value);
    sum_ += isKnown ? std::fabs(value) : 0.0;
    count_ += isKnown ? 1 : 0;
    series_.add(at, isKnown ? value : 0.0);
  }
  MetricValue mean(const Instant& last) const {
    const std::size_t divisor = last.usesHunavProfile() ? last.count() : count_;
    return withSeries(divisor > 0 ? sum_ / static_cast<double>(divisor) : kNaN, series_.values());
  }

 private:
  double sum_ = 0.0;
  std::size_t count_ = 0;
  SeriesColumn series_;
};

template <Term kTerm>
MetricComputation meanMagnitudeOf(const char* why = nullptr) {
  return metricOf<MeanMagnitude<kTerm>>(&MeanMagnitude<kTerm>::mean, why);
}

double speed(const Instant& at) {
  return lengthOf(at.now.robot.velocity);
}

double accelerationSize(const Instant& at) {
  return std::fabs(at.term(acceleration));
}

double turningAcceleration(const Instant& at) {
  return at.step() > 0.0 ? std::fabs(at.now.robot.omega - at.before->robot.omega) / at.step()
                         : kNaN;
}

double energy(const Instant& at) {
  if (!(at.step() > 0.0)) {
    return kNaN;
  }
  const double travelled = distance(at.now.robot, at.before->robot) / at.step();
  return travelled * travelled;
}

class SpeedSum : public Accumulator {
 public:
  void add(const Instant& at) override {
    const std::vector<Pedestrian>& people = at.now.people;
    double speeds = 0.0;
    for (const Pedestrian& person : people) {
      speeds += person.speed;
    }
    sum_ += speeds;
    pairs_ += people.size();
    atFirst_ = at.before == nullptr ? people.size() : atFirst_;
    const double none = at.usesHunavProfile() ? 0.0 : kNaN;
    series_.add(at, people.empty() ? none : speeds / static_cast<double>(people.size()));
  }

  /// HuNavSim's evaluator divides by the number of people at the first sample.
  MetricValue mean(const Instant& last) const {
    const std::size_t divisor = last.usesHunavProfile() ? last.count() * atFirst_ : pairs_;
    if (divisor == 0 && last.usesHunavProfile()) {
      return undefinedValue("ZeroDivisionError: no people at the first sample");
    }
    return withSeries(divisor > 0 ? sum_ / static_cast<double>(divisor) : undefinedValue(kNoPeople),
                      series_.values());
  }

 private:
  SeriesColumn series_;
  double sum_ = 0.0;
  std::size_t pairs_ = 0;  // number of (sample, person) pairs
  std::size_t atFirst_ = 0;
};

/// Speed of the closest person; without people NaN, in profile hunav2 0.
double closestSpeed(const Instant& at) {
  const Robot& robot = at.now.robot;
  double speed = at.usesHunavProfile() ? 0.0 : kNaN;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Pedestrian& person : at.now.people) {
    const double value = at.usesHunavProfile() ? distance(robot, person) : gap(robot, person);
    if (value < nearest) {
      nearest = value;
      speed = person.speed;
    }
  }
  return speed;
}

/// motion_energy is a sum over samples: it doubles with the sampling rate.
constexpr char kSpeedsMetrics[] = R"(
= Navigation Performance|lower|robot|Tsoi et al., SEAN 2.0, RA-L 2022
18 time_not_moving|Time standing still|s|[0, T]|time with s_i < stop_linear_speed and |w_i| < stop_angular_speed
= Motion Analysis|neutral|robot|Biswas et al., SocNavBench, THRI 2022
19 avg_robot_linear_speed|Mean speed of the robot|m/s|[0, inf)|mean over i of s_i
20 avg_robot_angular_speed|Mean turn rate of the robot|rad/s|[0, inf)|mean over i of |w_i|
= Motion Analysis|lower|robot|Biswas et al., SocNavBench, THRI 2022
21 avg_acceleration|Mean acceleration of the robot|m/s²|[0, inf)|mean of |a_i|, a_i = (s_(i+1) - s_i)/dt_i, over the i with dt_i > 0
22 avg_overacceleration|Mean jerk of the robot|m/s³|[0, inf)|mean of |J_i| over the samples that have a jerk J_i (window jerk_window; METRICS.md, Sampling)
= Social Behavior|neutral|people|Katyal et al., IROS 2022
23 avg_pedestrian_velocity|Mean speed of people|m/s|[0, inf)|mean over i, a of |u|, each pair of sample and person once
= Social Behavior|neutral|robot, people|Katyal et al., IROS 2022
24 avg_closest_pedestrian_velocity|Mean speed of the closest person|m/s|[0, inf)|mean over the samples with people of |u| of the person with the
  smallest gap (not cut at 0), of equal gaps the first in trajectory.csv
= Motion Analysis|neutral|robot|Francis et al. 2025; SocNavGym
min_robot_linear_speed|Smallest speed of the robot|m/s|[0, inf)|min over i of s_i
max_robot_linear_speed|Largest speed of the robot|m/s|[0, inf)|max over i of s_i
= Motion Analysis|lower|robot|Francis et al. 2025; SocNavGym
max_acceleration|Largest acceleration of the robot|m/s²|[0, inf)|max of |a_i|, a_i as in avg_acceleration
max_jerk|Largest jerk of the robot|m/s³|[0, inf)|max of the jerks |J| at the samples and in the middle of each dt_i (jerk_window; METRICS.md, Sampling)
= Motion Analysis|lower|robot|SRPB
heading_change_smoothness|Mean angular acceleration of the robot|rad/s²|[0, inf)|mean of |w_(i+1) - w_i|/dt_i over the i with dt_i > 0
= Motion Analysis|lower|robot|SocNavBench|0.51
motion_energy|Motion energy|m²/s²|[0, inf)|sum of (|p_(i+1) - p_i|/dt_i)^2 over the i with dt_i > 0
)";

}  // namespace

void addSpeeds(MetricRegistry& to) {
  to.add(
      kSpeedsMetrics,
      {{"time_not_moving", metricOf<StandingTime>(&StandingTime::value)},
       {"avg_robot_linear_speed", seriesStatisticsOf<drivenSpeed>(&TermStatistics::meanWithSeries)},
       {"avg_robot_angular_speed", meanMagnitudeOf<turningSpeed>()},
       {"avg_acceleration", meanMagnitudeOf<acceleration>(kNeedsTwo)},
       {"avg_overacceleration", metricOf<JerkStatistics>(&JerkStatistics::mean, kNeedsThree)},
       {"avg_pedestrian_velocity", metricOf<SpeedSum>(&SpeedSum::mean)},
       {"avg_closest_pedestrian_velocity",
        seriesStatisticsOf<closestSpeed>(&TermStatistics::meanWithSeries, kNoPeople)},
       {"min_robot_linear_speed", statisticsOf<speed>(&TermStatistics::least)},
       {"max_robot_linear_speed", statisticsOf<speed>(&TermStatistics::largest)},
       {"max_acceleration", statisticsOf<accelerationSize>(&TermStatistics::largest, kNeedsTwo)},
       {"max_jerk", metricOf<JerkStatistics>(&JerkStatistics::largest, kNeedsThree)},
       {"heading_change_smoothness",
        statisticsOf<turningAcceleration>(&TermStatistics::mean, kNeedsTwo)},
       {"motion_energy", statisticsOf<energy>(&TermStatistics::sum)}});
}

}  // namespace metrics
