#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/Motion.h"
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
    return withSeries(numberValue(time), samples_.terms(), Kind::Count);
  }

 private:
  SeriesSum samples_;  // 0 or 1
  HeldTime time_;
};

class LinearSpeed : public Accumulator {
 public:
  void add(const Instant& at) override { speeds_.add(at, at.now.robot.speed); }
  MetricValue mean(const Instant& last) const {
    return withSeries(numberValue(speeds_.sum() / static_cast<double>(last.count())),
                      speeds_.terms());
  }

 private:
  SeriesSum speeds_;
};

/// Mean size of what the series has with its sign; the original divides by the samples.
class MeanSize : public Accumulator {
 public:
  MetricValue mean(const Instant& last) const {
    const std::size_t divisor = last.isOriginal() ? last.count() : count_;
    return withSeries(
        divisor == 0 ? undefinedValue(needs_) : numberValue(sum_ / static_cast<double>(divisor)),
        series_.values());
  }

 protected:
  explicit MeanSize(const char* needs = "") : needs_(needs) {}
  void take(const Instant& at, double value, bool counts) {
    sum_ += std::fabs(value);
    count_ += counts ? 1 : 0;
    series_.add(at, value);
  }

 private:
  const char* needs_;
  double sum_ = 0.0;
  std::size_t count_ = 0;
  SeriesColumn series_;
};

class AngularSpeed : public MeanSize {
 public:
  void add(const Instant& at) override { take(at, at.now.robot.omega, true); }
};

/// Of the intervals in which time passes.
class Acceleration : public MeanSize {
 public:
  Acceleration() : MeanSize("needs two samples at different times") {}
  void add(const Instant& at) override {
    changes_.add(at);
    take(at, changes_.hasAcceleration() ? changes_.acceleration() : 0.0, changes_.interval() > 0.0);
  }

 private:
  SpeedChanges changes_;
};

/// Of the jerks; the original divides the accelerations by the time once more.
class Overacceleration : public MeanSize {
 public:
  Overacceleration() : MeanSize("needs three samples at different times") {}
  void add(const Instant& at) override {
    changes_.add(at);
    const double dt = changes_.interval();
    if (at.isOriginal()) {
      take(at, dt > 0.0 ? changes_.acceleration() / dt : 0.0, false);
    } else {
      const std::optional<double> jerk = changes_.isInner() ? changes_.jerk() : std::nullopt;
      take(at, jerk.value_or(0.0), jerk.has_value());
    }
  }

 private:
  SpeedChanges changes_;
};

void addRobotMotion(MetricRegistry& to) {
  const char source[] = "Biswas et al., SocNavBench, THRI 2022";
  to.add({"time_not_moving", "Time standing still", "s", Category::Navigation, Better::Lower,
          Needs{}, "sum of dt_i with |s_i| < stop_linear_speed and |w_i| < stop_angular_speed",
          "Tsoi et al., SEAN 2.0, RA-L 2022", "[0, T]", Kind::Number, 18},
         streamOf<StandingTime>(&StandingTime::value));
  to.add({"avg_robot_linear_speed", "Mean speed of the robot", "m/s", Category::Motion,
          Better::Neutral, Needs{}, "mean of s_i", source, "[0, inf)", Kind::Number, 19},
         streamOf<LinearSpeed>(&LinearSpeed::mean));
  to.add({"avg_robot_angular_speed", "Mean turning speed of the robot", "rad/s", Category::Motion,
          Better::Neutral, Needs{}, "mean of |w_i|", source, "[0, inf)", Kind::Number, 20},
         streamOf<AngularSpeed>(&AngularSpeed::mean));
  to.add({"avg_acceleration", "Mean acceleration of the robot", "m/s²", Category::Motion,
          Better::Lower, Needs{}, "mean of |a_i|, a_i = (s_(i+1) - s_i)/dt_i", source, "[0, inf)",
          Kind::Number, 21},
         streamOf<Acceleration>(&Acceleration::mean));
  to.add({"avg_overacceleration", "Mean jerk of the robot", "m/s³", Category::Motion, Better::Lower,
          Needs{}, "mean of |jerk_i|, jerk_i = (a_i - a_(i-1))/((t_(i+1) - t_(i-1))/2)", source,
          "[0, inf)", Kind::Number, 22},
         streamOf<Overacceleration>(&Overacceleration::mean));
}

class SpeedRange : public Accumulator {
 public:
  void add(const Instant& at) override {
    const double speed = lengthOf(at.now.robot.velocity);
    slowest_ = std::min(slowest_, speed);
    fastest_ = std::max(fastest_, speed);
  }
  MetricValue slowest(const Instant& /*last*/) const { return numberValue(slowest_); }
  MetricValue fastest(const Instant& /*last*/) const { return numberValue(fastest_); }

 private:
  double slowest_ = std::numeric_limits<double>::infinity(), fastest_ = 0.0;  // [m/s]
};

class LargestChanges : public Accumulator {
 public:
  void add(const Instant& at) override {
    changes_.add(at);
    if (changes_.interval() > 0.0) {
      acceleration_ = std::max(acceleration_.value_or(0.0), std::fabs(changes_.acceleration()));
    }
    if (changes_.jerk()) {
      jerk_ = std::max(jerk_.value_or(0.0), std::fabs(*changes_.jerk()));
    }
  }
  MetricValue acceleration(const Instant& /*last*/) const {
    return acceleration_ ? numberValue(*acceleration_)
                         : undefinedValue("needs two samples at different times");
  }
  MetricValue jerk(const Instant& /*last*/) const {
    return jerk_ ? numberValue(*jerk_) : undefinedValue("needs three samples at different times");
  }

 private:
  SpeedChanges changes_;
  std::optional<double> acceleration_, jerk_;
};

class HeadingSmoothness : public Accumulator {
 public:
  void add(const Instant& at) override {
    const double dt = at.step();
    if (dt > 0.0) {
      sum_ += std::fabs(at.now.robot.omega - at.before->robot.omega) / dt;
      count_ += 1.0;
    }
  }
  MetricValue mean(const Instant& /*last*/) const {
    return count_ > 0.0 ? numberValue(sum_ / count_)
                        : undefinedValue("needs two samples at different times");
  }

 private:
  double sum_ = 0.0, count_ = 0.0;
};

class MotionEnergy : public Accumulator {
 public:
  void add(const Instant& at) override {
    const double dt = at.step();
    if (dt > 0.0) {
      const double speed = distance(at.now.robot, at.before->robot) / dt;
      sum_ += speed * speed;
    }
  }
  MetricValue value(const Instant& /*last*/) const { return numberValue(sum_); }

 private:
  double sum_ = 0.0;
};

void addSpeedExtremes(MetricRegistry& to) {
  const char francis[] = "Francis et al. 2025; SocNavGym";
  const Category motion = Category::Motion;
  to.add({"min_robot_linear_speed", "Smallest speed of the robot", "m/s", motion, Better::Neutral,
          Needs{}, "min of |v_i|", francis},
         streamOf<SpeedRange>(&SpeedRange::slowest));
  to.add({"max_robot_linear_speed", "Largest speed of the robot", "m/s", motion, Better::Neutral,
          Needs{}, "max of |v_i|", francis},
         streamOf<SpeedRange>(&SpeedRange::fastest));
  to.add({"max_acceleration", "Largest acceleration of the robot", "m/s²", motion, Better::Lower,
          Needs{}, "max of |a_i|", francis},
         streamOf<LargestChanges>(&LargestChanges::acceleration));
  to.add({"max_jerk", "Largest jerk of the robot", "m/s³", motion, Better::Lower, Needs{},
          "max of |jerk_i|", francis},
         streamOf<LargestChanges>(&LargestChanges::jerk));
  to.add({"heading_change_smoothness", "Mean turning acceleration", "rad/s²", motion, Better::Lower,
          Needs{}, "mean of |w_(i+1) - w_i|/dt_i", "SRPB"},
         streamOf<HeadingSmoothness>(&HeadingSmoothness::mean));
  to.add({"motion_energy", "Motion energy", "m²/s²", motion, Better::Lower, Needs{},
          "sum of (|p_(i+1) - p_i|/dt_i)^2", "SocNavBench"},
         streamOf<MotionEnergy>(&MotionEnergy::value));
  to.setRateBound("motion_energy", 0.51);  // a sum over samples
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
    return withSeries(divisor == 0 ? undefinedValue("nobody in the record")
                                   : numberValue(sum_ / static_cast<double>(divisor)),
                      series_.values());
  }

 private:
  SeriesColumn series_;
  double sum_ = 0.0;
  std::size_t pairs_ = 0;  // of sample and person
  std::size_t atFirst_ = 0;
};

/// Speed of the closest person; nobody there: NaN, in the original 0.
double closestSpeed(const Sample& sample, const MetricParameters& parameters) {
  const bool original = parameters.profile == Profile::Hunav2;
  double speed = original ? 0.0 : kNaN;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Person& person : sample.people) {
    const double value = original ? distance(sample.robot, person) : gap(sample.robot, person);
    if (value < nearest) {
      nearest = value;
      speed = person.speed;
    }
  }
  return speed;
}

MetricValue averageClosestSpeed(const Figures& speeds, const Instant& /*last*/) {
  return withSeries(speeds.count() > 0.0 ? numberValue(speeds.sum() / speeds.count())
                                         : undefinedValue("nobody in the record"),
                    speeds.series());
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
         figuresOf<closestSpeed>(averageClosestSpeed));
}

}  // namespace

void addSpeeds(MetricRegistry& to) {
  addRobotMotion(to);
  addPedestrianSpeeds(to);
  addSpeedExtremes(to);
}

}  // namespace metrics
