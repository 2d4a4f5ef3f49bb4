#pragma once

#include "metrics/MetricRegistry.h"

/// Accumulators that several metrics are made of: over a term of the samples (a template per term,
/// so that metrics of the same term share one), over costs of the people.
namespace metrics {

constexpr char kNobody[] = "nobody in the record";

double closestGapTerm(const Instant& at);  // [m], clamped at 0; NaN: nobody
/// Soonest collision with anybody [s]; NaN: on no collision course.
double collisionTerm(const Instant& at);

/// Figures of the samples where a term is defined; NaN where it never is.
class Figures : public Accumulator {
 public:
  double sum() const { return sum_; }
  double count() const { return count_; }
  double mean() const { return count_ > 0.0 ? sum_ / count_ : kNaN; }
  double least() const { return least_; }
  double largest() const { return largest_; }
  double integral() const { return integral_; }
  double time() const { return time_; }  // [s] with the term
  /// Weighted with the time after each sample; NaN: no time.
  double timeMean() const { return time_ > 0.0 ? integral_ / time_ : kNaN; }
  /// Empty unless the figures are those of seriesFiguresOf.
  std::vector<double> series() const { return series_.values(); }
  MetricValue meanWithSeries() const { return withSeries(mean(), series()); }

 protected:
  void take(const Instant& at, double term);
  SeriesColumn series_;

 private:
  double sum_ = 0.0, count_ = 0.0, least_ = kNaN, largest_ = kNaN;
  double integral_ = 0.0, time_ = 0.0;
  double before_ = kNaN;  // term of the sample before
};

template <Term kTerm, bool kKeepsSeries>
class FiguresOf : public Figures {
 public:
  void add(const Instant& at) override {
    const double term = at.term(kTerm);
    take(at, term);
    if (kKeepsSeries) {
      series_.add(at, term);
    }
  }
};

/// Streams that read the figures of a term.
template <Term kTerm, class Read>
Stream figuresOf(Read read, const char* why = nullptr) {
  return streamOf<FiguresOf<kTerm, false>>(read, why);
}
template <Term kTerm, class Read>
Stream seriesFiguresOf(Read read, const char* why = nullptr) {
  return streamOf<FiguresOf<kTerm, true>>(read, why);
}

/// How long and at how many samples something holds: the intervals after them count, the last
/// sample for none.
class Times {
 public:
  /// Once for each sample.
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
  bool held_ = false;  // at the sample before
};

using InstantTest = bool (*)(const Instant& at);

template <InstantTest kTest>
class TimesOf : public Accumulator, public Times {
 public:
  void add(const Instant& at) override { take(at, kTest(at)); }
};

/// A stream that reads how long a test holds.
template <InstantTest kTest, class Read>
Stream timesOf(Read read) {
  return streamOf<TimesOf<kTest>>(read);
}

/// Sums over samples and people of several costs at once. The series is per sample; the original's
/// is one total per place in the list of people of the first sample, and fails when there are more
/// later.
class PersonCosts : public Accumulator {
 public:
  explicit PersonCosts(std::size_t costs) : columns_(costs) {}
  void add(const Instant& at) override;
  MetricValue value(std::size_t cost, const Instant& last) const;

 protected:
  virtual void beginSample() {}
  /// The costs are 0 before. False: the original would fail here.
  virtual bool addCosts(const Instant& at, const Person& person, std::vector<double>& costs) = 0;

 private:
  struct Totals {
    SeriesSum samples;
    std::vector<double> places;  // per place in the first sample's list
  };
  void addToPlace(Totals& totals, std::size_t place, double cost);

  std::vector<Totals> columns_;
  std::vector<double> costs_, sums_;  // of a person, of a sample
  bool failed_ = false;
};

}  // namespace metrics
