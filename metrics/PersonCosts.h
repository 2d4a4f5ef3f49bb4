#pragma once

#include "metrics/MetricRegistry.h"

namespace metrics {

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
