#pragma once

#include "metrics/MetricRegistry.h"

namespace metrics {

/// Sum over samples and people. The series is per sample; the original's is one total per place in
/// the list of people of the first sample, and fails when there are more later.
class PersonCosts : public Accumulator {
 public:
  explicit PersonCosts(const MetricParameters& parameters) : parameters_(parameters) {}
  void add(const Recording& recording, std::size_t sample) override;
  MetricValue value(const Recording& recording) const override;

 protected:
  virtual void beginSample() {}
  /// Nothing: the original would fail here.
  virtual std::optional<double> costOf(const Recording& recording, const Sample& sample,
                                       const Person& person) = 0;
  const MetricParameters& parameters() const { return parameters_; }
  bool isOriginal() const { return parameters_.profile == Profile::Hunav2; }

 private:
  MetricParameters parameters_;
  std::vector<double> series_;        // per sample
  std::vector<double> personTotals_;  // per place in the first sample's list
  double sum_ = 0.0;
  bool failed_ = false;
};

}  // namespace metrics
