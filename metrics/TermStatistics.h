#pragma once

#include "metrics/MetricRegistry.h"

/// Accumulators that several metrics share: over a term of the samples (one template instance per
/// term, so that metrics with the same term share one), and over costs of people.
namespace metrics {

constexpr char kNoPeople[] = "no people in the recording";

double smallestGapTerm(const Instant& at);  // [m], at least 0; NaN: no people
/// Earliest collision with any person [s]; NaN: no collision course.
double timeToCollisionTerm(const Instant& at);

/// Statistics over the samples where a term is defined; NaN if there are none.
class TermStatistics : public Accumulator {
 public:
  double sum() const { return sum_; }
  double count() const { return count_; }
  double mean() const { return count_ > 0.0 ? sum_ / count_ : kNaN; }
  double least() const { return least_; }
  double largest() const { return largest_; }
  double integral() const { return integral_; }
  double time() const { return time_; }  // [s] with a defined term
  /// Weighted by the time after each sample; NaN: no time.
  double timeMean() const { return time_ > 0.0 ? integral_ / time_ : kNaN; }
  /// Empty unless created by seriesStatisticsOf.
  std::vector<double> series() const { return series_.values(); }
  MetricValue meanWithSeries() const { return withSeries(mean(), series()); }

 protected:
  void take(const Instant& at, double term);
  SeriesColumn series_;

 private:
  double sum_ = 0.0, count_ = 0.0, least_ = kNaN, largest_ = kNaN;
  double integral_ = 0.0, time_ = 0.0;
  double before_ = kNaN;  // previous term
};

template <Term kTerm, bool kKeepsSeries>
class TermStatisticsOf : public TermStatistics {
 public:
  void add(const Instant& at) override {
    const double term = at.term(kTerm);
    take(at, term);
    if (kKeepsSeries) {
      series_.add(at, term);
    }
  }
};

/// Metrics read from the statistics of a term.
template <Term kTerm, class Read>
MetricComputation statisticsOf(Read read, const char* why = nullptr) {
  return metricOf<TermStatisticsOf<kTerm, false>>(read, why);
}
template <Term kTerm, class Read>
MetricComputation seriesStatisticsOf(Read read, const char* why = nullptr) {
  return metricOf<TermStatisticsOf<kTerm, true>>(read, why);
}

/// Duration and number of samples for which a condition holds. A sample counts for the interval
/// that follows it, the last one for none.
class ConditionTime {
 public:
  /// Call once for each sample.
  void take(const Instant& at, bool holds) {
    samples_ += holds ? 1.0 : 0.0;
    time_ += held_ ? at.step() : 0.0;
    held_ = holds;
  }
  double time() const { return time_; }  // [s]
  double percentOf(double total) const { return total > 0.0 ? 100.0 * time_ / total : 0.0; }
  double percentOfTime(const Instant& last) const { return percentOf(last.elapsed()); }
  double percentOfSamples(const Instant& last) const {
    return 100.0 * samples_ / static_cast<double>(last.count());
  }

 private:
  double samples_ = 0.0;
  double time_ = 0.0;
  bool held_ = false;  // at the previous sample
};

using InstantTest = bool (*)(const Instant& at);

template <InstantTest kTest>
class ConditionTimeOf : public Accumulator, public ConditionTime {
 public:
  void add(const Instant& at) override { take(at, kTest(at)); }
};

/// Metrics read from the time for which a condition holds.
template <InstantTest kTest, class Read>
MetricComputation conditionTimeOf(Read read) {
  return metricOf<ConditionTimeOf<kTest>>(read);
}

/// Sums of several costs over samples and people. The series is per sample. In profile hunav2 it is
/// one total per index in the first sample's list of people, and fails if there are more people
/// later.
class PersonCosts : public Accumulator {
 public:
  explicit PersonCosts(std::size_t costs) : columns_(costs) {}
  void add(const Instant& at) override;
  MetricValue value(std::size_t cost, const Instant& last) const;

 protected:
  virtual void beginSample() {}
  /// The costs are 0 on entry. Returns false where HuNavSim's evaluator would fail.
  virtual bool addCosts(const Instant& at, const Pedestrian& person,
                        std::vector<double>& costs) = 0;

 private:
  struct Totals {
    SeriesSum samples;
    std::vector<double> places;  // per index in the first sample's list
  };
  void addToPlace(Totals& totals, std::size_t place, double cost);

  std::vector<Totals> columns_;
  std::vector<double> costs_, sums_;  // of one person, of one sample
  bool failed_ = false;
};

}  // namespace metrics
