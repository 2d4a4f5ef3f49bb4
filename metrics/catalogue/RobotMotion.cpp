#include <cmath>

#include "metrics/Motion.h"

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

class AngularSpeed : public Accumulator {
 public:
  void add(const Instant& at) override {
    sum_ += std::fabs(at.now.robot.omega);
    signed_.add(at, at.now.robot.omega);
  }
  MetricValue mean(const Instant& last) const {
    return withSeries(numberValue(sum_ / static_cast<double>(last.count())), signed_.values());
  }

 private:
  double sum_ = 0.0;
  SeriesColumn signed_;
};

/// Mean size of the accelerations; the original divides by the samples.
class Acceleration : public Accumulator {
 public:
  void add(const Instant& at) override {
    changes_.add(at);
    const double value = changes_.hasAcceleration() ? changes_.acceleration() : 0.0;
    sum_ += std::fabs(value);
    series_.add(at, value);
    intervals_ += changes_.interval() > 0.0 ? 1 : 0;
  }
  MetricValue mean(const Instant& last) const {
    const std::size_t divisor = last.isOriginal() ? last.count() : intervals_;
    return withSeries(divisor == 0 ? undefinedValue("needs two samples at different times")
                                   : numberValue(sum_ / static_cast<double>(divisor)),
                      series_.values());
  }

 private:
  SpeedChanges changes_;
  double sum_ = 0.0;
  std::size_t intervals_ = 0;  // in which time passes
  SeriesColumn series_;
};

/// Mean size of the jerks; the original divides the accelerations by the time once more.
class Overacceleration : public Accumulator {
 public:
  void add(const Instant& at) override {
    changes_.add(at);
    double value = 0.0;
    if (at.isOriginal()) {
      const double dt = changes_.interval();
      value = dt > 0.0 ? changes_.acceleration() / dt : 0.0;
    } else if (changes_.isInner()) {
      value = changes_.jerk().value_or(0.0);
      jerks_ += changes_.jerk() ? 1 : 0;
    }
    sum_ += std::fabs(value);
    series_.add(at, value);
  }
  MetricValue mean(const Instant& last) const {
    const std::size_t divisor = last.isOriginal() ? last.count() : jerks_;
    return withSeries(divisor == 0 ? undefinedValue("needs three samples at different times")
                                   : numberValue(sum_ / static_cast<double>(divisor)),
                      series_.values());
  }

 private:
  SpeedChanges changes_;
  double sum_ = 0.0;
  std::size_t jerks_ = 0;
  SeriesColumn series_;
};

}  // namespace

void addRobotMotion(MetricRegistry& to) {
  const char source[] = "Biswas et al., SocNavBench, THRI 2022";
  to.add({"time_not_moving", "Time standing still", "s", Category::Navigation, Better::Lower,
          Needs{}, "sum of dt_i with |s_i| < stop_linear_speed and |w_i| < stop_angular_speed",
          "Tsoi et al., SEAN 2.0, RA-L 2022", "[0, T]", Kind::Number, 18, ""},
         streamOf<StandingTime>(&StandingTime::value));
  to.add({"avg_robot_linear_speed", "Mean speed of the robot", "m/s", Category::Motion,
          Better::Neutral, Needs{}, "mean of s_i", source, "[0, inf)", Kind::Number, 19, ""},
         streamOf<LinearSpeed>(&LinearSpeed::mean));
  to.add({"avg_robot_angular_speed", "Mean turning speed of the robot", "rad/s", Category::Motion,
          Better::Neutral, Needs{}, "mean of |w_i|", source, "[0, inf)", Kind::Number, 20, ""},
         streamOf<AngularSpeed>(&AngularSpeed::mean));
  to.add({"avg_acceleration", "Mean acceleration of the robot", "m/s²", Category::Motion,
          Better::Lower, Needs{}, "mean of |a_i|, a_i = (s_(i+1) - s_i)/dt_i", source, "[0, inf)",
          Kind::Number, 21, ""},
         streamOf<Acceleration>(&Acceleration::mean));
  to.add({"avg_overacceleration", "Mean jerk of the robot", "m/s³", Category::Motion, Better::Lower,
          Needs{}, "mean of |jerk_i|, jerk_i = (a_i - a_(i-1))/((t_(i+1) - t_(i-1))/2)", source,
          "[0, inf)", Kind::Number, 22, ""},
         streamOf<Overacceleration>(&Overacceleration::mean));
}

}  // namespace metrics
