#include <cmath>
#include <limits>

#include "metrics/TermSums.h"

/// Speeds, accelerations and jerks of the robot, speeds of people.
namespace metrics {

namespace {

class StandingTime : public Accumulator {
 public:
  void add(const Instant& at) override {
    const Robot& robot = at.now.robot;
    const double turning = at.isOriginal() ? robot.omega : std::fabs(robot.omega);
    const bool stands = std::fabs(robot.speed) < at.parameters.stopLinearSpeed &&
                        turning < at.parameters.stopAngularSpeed;
    samples_.add(at, stands ? 1.0 : 0.0);
    time_.add(at, stands);
  }
  MetricValue value(const Instant& last) const {
    const double time = last.isOriginal()
                            ? last.elapsed() / static_cast<double>(last.count()) * samples_.sum()
                            : time_.value();
    return withSeries(time, samples_.terms(), Kind::Count);
  }

 private:
  SeriesSum samples_;  // 0 or 1
  HeldTime time_;
};

double drivenSpeed(const Instant& at) {
  return at.now.robot.speed;
}

double turningSpeed(const Instant& at) {
  return at.now.robot.omega;
}

constexpr char kNeedsTwo[] = "needs two samples at different times";
constexpr char kNeedsThree[] = "needs three samples at different times";

/// Of the interval that ends here [m/s^2], if time passes in it.
double acceleration(const Instant& at) {
  return at.step() > 0.0 ? (at.now.robot.speed - at.before->robot.speed) / at.step() : kNaN;
}

/// Around the sample before [m/s^3], if time passes on both sides of it.
double jerk(const Instant& at) {
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

/// The jerk; the original divides the acceleration by the time once more.
double overacceleration(const Instant& at) {
  return at.isOriginal() ? at.term(acceleration) / at.step() : at.term(jerk);
}

/// Mean size of a term that the series has with its sign, 0 where it is undefined; the original
/// divides by the samples.
template <Term kTerm>
class MeanSize : public Accumulator {
 public:
  void add(const Instant& at) override {
    const double value = at.term(kTerm);
    const bool isKnown = !std::isnan(value);
    sum_ += isKnown ? std::fabs(value) : 0.0;
    count_ += isKnown ? 1 : 0;
    series_.add(at, isKnown ? value : 0.0);
  }
  MetricValue mean(const Instant& last) const {
    const std::size_t divisor = last.isOriginal() ? last.count() : count_;
    return withSeries(divisor > 0 ? sum_ / static_cast<double>(divisor) : kNaN, series_.values());
  }

 private:
  double sum_ = 0.0;
  std::size_t count_ = 0;
  SeriesColumn series_;
};

template <Term kTerm>
Stream meanSizeOf(const char* why = nullptr) {
  return streamOf<MeanSize<kTerm>>(&MeanSize<kTerm>::mean, why);
}

void addRobotMotion(MetricRegistry& to) {
  to.add({"time_not_moving", "Time standing still", "s", Category::Navigation, Better::Lower,
          Needs{}, "sum of dt_i with |s_i| < stop_linear_speed and |w_i| < stop_angular_speed",
          "Tsoi et al., SEAN 2.0, RA-L 2022", "[0, T]", Kind::Number, 18},
         streamOf<StandingTime>(&StandingTime::value));
  const char source[] = "Biswas et al., SocNavBench, THRI 2022";
  const MetricFamily means{to, Category::Motion, Better::Neutral, {}, source};
  means.add("avg_robot_linear_speed", "Mean speed of the robot", "m/s", "mean of s_i",
            seriesFiguresOf<drivenSpeed>(&Figures::meanWithSeries), 19);
  means.add("avg_robot_angular_speed", "Mean turning speed of the robot", "rad/s", "mean of |w_i|",
            meanSizeOf<turningSpeed>(), 20);
  const MetricFamily changes{to, Category::Motion, Better::Lower, {}, source};
  changes.add("avg_acceleration", "Mean acceleration of the robot", "m/s²",
              "mean of |a_i|, a_i = (s_(i+1) - s_i)/dt_i", meanSizeOf<acceleration>(kNeedsTwo), 21);
  changes.add("avg_overacceleration", "Mean jerk of the robot", "m/s³",
              "mean of |jerk_i|, jerk_i = (a_i - a_(i-1))/((t_(i+1) - t_(i-1))/2)",
              meanSizeOf<overacceleration>(kNeedsThree), 22);
}

double speed(const Instant& at) {
  return lengthOf(at.now.robot.velocity);
}

double accelerationSize(const Instant& at) {
  return std::fabs(at.term(acceleration));
}

double jerkSize(const Instant& at) {
  return std::fabs(at.term(jerk));
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

void addSpeedExtremes(MetricRegistry& to) {
  const char francis[] = "Francis et al. 2025; SocNavGym";
  const MetricFamily speeds{to, Category::Motion, Better::Neutral, {}, francis};
  speeds.add("min_robot_linear_speed", "Smallest speed of the robot", "m/s", "min of |v_i|",
             figuresOf<speed>(&Figures::least));
  speeds.add("max_robot_linear_speed", "Largest speed of the robot", "m/s", "max of |v_i|",
             figuresOf<speed>(&Figures::largest));
  const MetricFamily changes{to, Category::Motion, Better::Lower, {}, francis};
  changes.add("max_acceleration", "Largest acceleration of the robot", "m/s²", "max of |a_i|",
              figuresOf<accelerationSize>(&Figures::largest, kNeedsTwo));
  changes.add("max_jerk", "Largest jerk of the robot", "m/s³", "max of |jerk_i|",
              figuresOf<jerkSize>(&Figures::largest, kNeedsThree));
  to.add({"heading_change_smoothness", "Mean turning acceleration", "rad/s²", Category::Motion,
          Better::Lower, Needs{}, "mean of |w_(i+1) - w_i|/dt_i", "SRPB"},
         figuresOf<turningAcceleration>(&Figures::mean, kNeedsTwo));
  to.add({"motion_energy", "Motion energy", "m²/s²", Category::Motion, Better::Lower, Needs{},
          "sum of (|p_(i+1) - p_i|/dt_i)^2", "SocNavBench", "[0, inf)", Kind::Number, 0, "",
          0.51},  // a sum over samples
         figuresOf<energy>(&Figures::sum));
}

class SpeedSum : public Accumulator {
 public:
  void add(const Instant& at) override {
    const std::vector<Person>& people = at.now.people;
    double speeds = 0.0;
    for (const Person& person : people) {
      speeds += person.speed;
    }
    sum_ += speeds;
    pairs_ += people.size();
    atFirst_ = at.before == nullptr ? people.size() : atFirst_;
    const double none = at.isOriginal() ? 0.0 : kNaN;
    series_.add(at, people.empty() ? none : speeds / static_cast<double>(people.size()));
  }

  /// The original divides by the number of people at the first sample.
  MetricValue mean(const Instant& last) const {
    const std::size_t divisor = last.isOriginal() ? last.count() * atFirst_ : pairs_;
    if (divisor == 0 && last.isOriginal()) {
      return undefinedValue("ZeroDivisionError: nobody at the first sample");
    }
    return withSeries(divisor > 0 ? sum_ / static_cast<double>(divisor) : undefinedValue(kNobody),
                      series_.values());
  }

 private:
  SeriesColumn series_;
  double sum_ = 0.0;
  std::size_t pairs_ = 0;  // of sample and person
  std::size_t atFirst_ = 0;
};

/// Speed of the closest person; nobody there: NaN, in the original 0.
double closestSpeed(const Instant& at) {
  const Robot& robot = at.now.robot;
  double speed = at.isOriginal() ? 0.0 : kNaN;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Person& person : at.now.people) {
    const double value = at.isOriginal() ? distance(robot, person) : gap(robot, person);
    if (value < nearest) {
      nearest = value;
      speed = person.speed;
    }
  }
  return speed;
}

void addPedestrianSpeeds(MetricRegistry& to) {
  const char source[] = "Katyal et al., IROS 2022";
  to.add({"avg_pedestrian_velocity", "Mean speed of people", "m/s", Category::Social,
          Better::Neutral, Needs{false, true}, "mean of |u_a| over all samples and people", source,
          "[0, inf)", Kind::Number, 23},
         streamOf<SpeedSum>(&SpeedSum::mean));
  to.add({"avg_closest_pedestrian_velocity", "Mean speed of the closest person", "m/s",
          Category::Social, Better::Neutral, Needs{true, true},
          "mean of |u_a| of the person with the smallest gap, over the samples with people", source,
          "[0, inf)", Kind::Number, 24},
         seriesFiguresOf<closestSpeed>(&Figures::meanWithSeries, kNobody));
}

}  // namespace

void addSpeeds(MetricRegistry& to) {
  addRobotMotion(to);
  addPedestrianSpeeds(to);
  addSpeedExtremes(to);
}

}  // namespace metrics
