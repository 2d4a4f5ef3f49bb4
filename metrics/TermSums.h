#pragma once

#include <cmath>

#include "metrics/MetricRegistry.h"

/// Accumulators that several metrics are made of: over a term of the samples (a template per term,
/// so that metrics of the same term share one), over costs of the people.
namespace metrics {

double closestGapTerm(const Sample& sample, const MetricParameters& parameters);  // NaN: nobody
/// Soonest collision with anybody [s]; NaN: on no collision course.
double collisionTerm(const Sample& sample, const MetricParameters& parameters);

/// Figures of the samples where a term is defined.
class Figures : public Accumulator {
 public:
  double sum() const { return sum_; }
  double count() const { return count_; }
  double least() const { return least_; }      // NaN: nowhere defined
  double largest() const { return largest_; }  // NaN: nowhere defined
  /// Weighted with the time after each sample; NaN: no time.
  double timeMean() const { return time_ > 0.0 ? integral_ / time_ : kNaN; }
  double integral() const { return integral_; }
  double time() const { return time_; }  // [s] with the term
  std::vector<double> series() const { return series_.values(); }

 protected:
  void take(const Instant& at, double term);

 private:
  double sum_ = 0.0, count_ = 0.0, least_ = kNaN, largest_ = kNaN;
  double integral_ = 0.0, time_ = 0.0;
  double before_ = kNaN;  // term of the sample before
  SeriesColumn series_;
};

template <Term kTerm>
class FiguresOf : public Figures {
 public:
  void add(const Instant& at) override { take(at, at.term(kTerm)); }
};

/// A stream that reads the figures of a term.
template <Term kTerm>
Stream figuresOf(MetricValue (*read)(const Figures& figures, const Instant& last)) {
  return streamOf<FiguresOf<kTerm>>(
      [read](const Figures& figures, const Instant& last) { return read(figures, last); });
}

using TermTest = bool (*)(double term, const MetricParameters& parameters);

/// Where a test of the term holds: for how many samples and how long.
template <Term kTerm, TermTest kTest>
class WhereTerm : public Accumulator {
 public:
  void add(const Instant& at) override {
    const bool holds = kTest(at.term(kTerm), at.parameters);
    samples_ += holds ? 1.0 : 0.0;
    time_.add(at, holds);
  }
  MetricValue time(const Instant& /*last*/) const { return numberValue(time_.value()); }
  MetricValue percent(const Instant& last) const {
    return numberValue(100.0 * samples_ / static_cast<double>(last.count()));
  }

 private:
  double samples_ = 0.0;
  HeldTime time_;
};

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
