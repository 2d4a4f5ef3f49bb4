#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/Motion.h"

namespace metrics {

namespace {

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

}  // namespace

void addSpeedExtremes(MetricRegistry& to) {
  const char francis[] = "Francis et al. 2025; SocNavGym";
  const Category motion = Category::Motion;
  to.add({"min_robot_linear_speed", "Smallest speed of the robot", "m/s", motion, Better::Neutral,
          Needs{}, "min of |v_i|", francis, "[0, inf)", Kind::Number, 0, ""},
         streamOf<SpeedRange>(&SpeedRange::slowest));
  to.add({"max_robot_linear_speed", "Largest speed of the robot", "m/s", motion, Better::Neutral,
          Needs{}, "max of |v_i|", francis, "[0, inf)", Kind::Number, 0, ""},
         streamOf<SpeedRange>(&SpeedRange::fastest));
  to.add({"max_acceleration", "Largest acceleration of the robot", "m/s²", motion, Better::Lower,
          Needs{}, "max of |a_i|", francis, "[0, inf)", Kind::Number, 0, ""},
         streamOf<LargestChanges>(&LargestChanges::acceleration));
  to.add({"max_jerk", "Largest jerk of the robot", "m/s³", motion, Better::Lower, Needs{},
          "max of |jerk_i|", francis, "[0, inf)", Kind::Number, 0, ""},
         streamOf<LargestChanges>(&LargestChanges::jerk));
  to.add({"heading_change_smoothness", "Mean turning acceleration", "rad/s²", motion, Better::Lower,
          Needs{}, "mean of |w_(i+1) - w_i|/dt_i", "SRPB", "[0, inf)", Kind::Number, 0, ""},
         streamOf<HeadingSmoothness>(&HeadingSmoothness::mean));
  to.add({"motion_energy", "Motion energy", "m²/s²", motion, Better::Lower, Needs{},
          "sum of (|p_(i+1) - p_i|/dt_i)^2", "SocNavBench", "[0, inf)", Kind::Number, 0, ""},
         streamOf<MotionEnergy>(&MotionEnergy::value));
  to.setRateBound("motion_energy", 0.51);  // a sum over samples
}

}  // namespace metrics
