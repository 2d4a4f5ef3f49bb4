#include <algorithm>
#include <cmath>

#include "metrics/TermSums.h"

namespace metrics {

namespace {

MetricValue minimumTimeToCollision(const Figures& times, const Instant& /*last*/) {
  return times.count() > 0.0 ? numberValue(times.least())
                             : infiniteValue("never on a collision course");
}

bool complies(double distance, const MetricParameters& parameters) {
  return std::isnan(distance) || distance >= parameters.complianceDistance;
}

bool isUncomfortable(double distance, const MetricParameters& parameters) {
  return distance < parameters.discomfortDistance;
}

template <TermTest kTest>
Stream percentOfGaps() {
  return streamOf<WhereTerm<closestGapTerm, kTest>>(&WhereTerm<closestGapTerm, kTest>::percent);
}

class DiscomfortDistance : public Accumulator {
 public:
  void add(const Instant& at) override {
    const double distance = at.term(closestGapTerm);
    if (isUncomfortable(distance, at.parameters)) {
      sum_ += distance;
      count_ += 1.0;
    }
  }
  MetricValue mean(const Instant& /*last*/) const {
    return count_ > 0.0 ? numberValue(sum_ / count_) : undefinedValue("nobody came that close");
  }

 private:
  double sum_ = 0.0, count_ = 0.0;
};

/// While a person's centre lies within the personal radius.
class InPersonalSpace : public Accumulator {
 public:
  void add(const Instant& at) override {
    const std::vector<Person>& people = at.now.people;
    const bool isNear = std::any_of(people.begin(), people.end(), [&at](const Person& person) {
      return distance(at.now.robot, person) <= at.parameters.personalRadius;
    });
    time_.add(at, isNear);
    speeds_ += isNear ? lengthOf(at.now.robot.velocity) : 0.0;
    samples_ += isNear ? 1.0 : 0.0;
  }
  MetricValue time(const Instant& /*last*/) const { return numberValue(time_.value()); }
  MetricValue speed(const Instant& /*last*/) const {
    return numberValue(samples_ > 0.0 ? speeds_ / samples_ : 0.0);
  }

 private:
  HeldTime time_;
  double speeds_ = 0.0, samples_ = 0.0;
};

class SpeedInIntimateSpace : public Accumulator {
 public:
  void add(const Instant& at) override {
    if (at.term(closestGapTerm) < at.parameters.intimateDistance) {
      fastest_ = std::max(fastest_, lengthOf(at.now.robot.velocity));
    }
  }
  MetricValue value(const Instant& /*last*/) const { return numberValue(fastest_); }

 private:
  double fastest_ = 0.0;  // [m/s]
};

void addTimesAndSpeeds(MetricRegistry& to) {
  const Needs needs{true, true};
  to.add({"time_in_personal_space", "Time in somebody's personal space", "s", Category::Social,
          Better::Lower, needs,
          "sum of dt_i with a person's centre within personal_radius of the robot's", "Arena",
          "[0, T]", Kind::Number, 0, ""},
         streamOf<InPersonalSpace>(&InPersonalSpace::time));
  to.add({"avg_speed_in_personal_space", "Mean speed in personal space", "m/s", Category::Social,
          Better::Lower, needs, "mean of |v_i| over those samples, 0 if none", "Arena", "[0, inf)",
          Kind::Number, 0, ""},
         streamOf<InPersonalSpace>(&InPersonalSpace::speed));
  to.add(
      {"max_speed_in_intimate_space", "Largest speed in intimate space", "m/s", Category::Social,
       Better::Lower, needs, "max of |v_i| where the smallest gap < intimate_distance, 0 if none",
       "Arena", "[0, inf)", Kind::Number, 0, ""},
      streamOf<SpeedInIntimateSpace>(&SpeedInIntimateSpace::value));
}

}  // namespace

void addPersonalSpace(MetricRegistry& to) {
  const Needs needs{true, true};
  to.add({"min_time_to_collision", "Smallest time to collision", "s", Category::Safety,
          Better::Higher, needs, "min over i, a of ttc, infinite if never on a collision course",
          "Francis et al. 2025; SocNavBench; SocNavGym", "[0, inf]", Kind::Number, 0, ""},
         figuresOf<collisionTerm>(minimumTimeToCollision));
  to.add({"space_compliance", "Personal space kept", "%", Category::Social, Better::Higher, needs,
          "share of samples with the smallest gap >= compliance_distance or nobody there",
          "Francis et al. 2025; SocNavGym", "[0, 100]", Kind::Number, 0, ""},
         percentOfGaps<complies>());
  to.add({"discomfort_frequency", "Uncomfortably close", "%", Category::Social, Better::Lower,
          needs, "share of samples with the smallest gap < discomfort_distance", "CrowdNav",
          "[0, 100]", Kind::Number, 0, ""},
         percentOfGaps<isUncomfortable>());
  to.add({"discomfort_distance_avg", "Mean distance when uncomfortably close", "m",
          Category::Social, Better::Higher, needs,
          "mean of the smallest gap over the samples with it < discomfort_distance", "CrowdNav",
          "[0, inf)", Kind::Number, 0, ""},
         streamOf<DiscomfortDistance>(&DiscomfortDistance::mean));
  addTimesAndSpeeds(to);
}

}  // namespace metrics
