#include <algorithm>
#include <cmath>

#include "metrics/TermSums.h"

/// How near people are.
namespace metrics {

namespace {

MetricValue nobody(const Instant& last) {
  return undefinedValue(last.isOriginal() ? "ValueError: nobody in the record"
                                          : "nobody in the record");
}

/// The original's series leaves out samples without people.
MetricValue averageDistance(const Figures& closest, const Instant& last) {
  std::vector<double> series = closest.series();
  if (last.isOriginal()) {
    series.erase(std::remove_if(series.begin(), series.end(),
                                [](double distance) { return std::isnan(distance); }),
                 series.end());
  }
  const double divisor = last.isOriginal() ? static_cast<double>(last.count()) : closest.count();
  MetricValue value =
      divisor > 0.0 ? numberValue(closest.sum() / divisor) : undefinedValue("nobody in the record");
  return withSeries(std::move(value), std::move(series));
}

MetricValue minimumDistance(const Figures& closest, const Instant& last) {
  return closest.count() > 0.0 ? numberValue(closest.least()) : nobody(last);
}

double farthestGap(const Sample& sample, const MetricParameters& /*parameters*/) {
  double farthest = kNaN;
  for (const Person& person : sample.people) {
    const double value = gap(sample.robot, person);
    farthest = value <= farthest ? farthest : value;
  }
  return farthest;
}

MetricValue maximumDistance(const Figures& farthest, const Instant& last) {
  if (!(farthest.count() > 0.0)) {
    return nobody(last);
  }
  return numberValue(last.isOriginal() ? farthest.largest() : std::max(farthest.largest(), 0.0));
}

void addPeopleDistances(MetricRegistry& to) {
  const Needs needs{true, true};
  const char source[] = "Perez-Higueras, Caballero, Merino, IJSR 2018";
  to.add({"avg_distance_to_closest_person", "Mean distance to the closest person", "m",
          Category::Social, Better::Higher, needs,
          "mean of c_i over the samples with people; c_i = min over a of max(gap(i,a), 0)", source,
          "[0, inf)", Kind::Number, 4},
         figuresOf<closestGapTerm>(averageDistance));
  to.add({"minimum_distance_to_people", "Smallest distance to people", "m", Category::Social,
          Better::Higher, needs, "min over i, a of max(gap(i,a), 0)", source, "[0, inf)",
          Kind::Number, 5},
         figuresOf<closestGapTerm>(minimumDistance));
  to.add({"maximum_distance_to_people", "Largest distance to people", "m", Category::Navigation,
          Better::Neutral, needs, "max over i, a of max(gap(i,a), 0)", source, "[0, inf)",
          Kind::Number, 6},
         figuresOf<farthestGap>(maximumDistance));
}

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
          "[0, T]"},
         streamOf<InPersonalSpace>(&InPersonalSpace::time));
  to.add({"avg_speed_in_personal_space", "Mean speed in personal space", "m/s", Category::Social,
          Better::Lower, needs, "mean of |v_i| over those samples, 0 if none", "Arena"},
         streamOf<InPersonalSpace>(&InPersonalSpace::speed));
  to.add({"max_speed_in_intimate_space", "Largest speed in intimate space", "m/s", Category::Social,
          Better::Lower, needs,
          "max of |v_i| where the smallest gap < intimate_distance, 0 if none", "Arena"},
         streamOf<SpeedInIntimateSpace>(&SpeedInIntimateSpace::value));
}

void addOwnPersonalSpace(MetricRegistry& to) {
  const Needs needs{true, true};
  to.add({"min_time_to_collision", "Smallest time to collision", "s", Category::Safety,
          Better::Higher, needs, "min over i, a of ttc, infinite if never on a collision course",
          "Francis et al. 2025; SocNavBench; SocNavGym", "[0, inf]"},
         figuresOf<collisionTerm>(minimumTimeToCollision));
  to.add({"space_compliance", "Personal space kept", "%", Category::Social, Better::Higher, needs,
          "share of samples with the smallest gap >= compliance_distance or nobody there",
          "Francis et al. 2025; SocNavGym", "[0, 100]"},
         percentOfGaps<complies>());
  to.add(
      {"discomfort_frequency", "Uncomfortably close", "%", Category::Social, Better::Lower, needs,
       "share of samples with the smallest gap < discomfort_distance", "CrowdNav", "[0, 100]"},
      percentOfGaps<isUncomfortable>());
  to.add({"discomfort_distance_avg", "Mean distance when uncomfortably close", "m",
          Category::Social, Better::Higher, needs,
          "mean of the smallest gap over the samples with it < discomfort_distance", "CrowdNav"},
         streamOf<DiscomfortDistance>(&DiscomfortDistance::mean));
  addTimesAndSpeeds(to);
}

}  // namespace

void addPersonalSpace(MetricRegistry& to) {
  addPeopleDistances(to);
  addOwnPersonalSpace(to);
}

}  // namespace metrics
