#pragma once

#include "metrics/MetricRegistry.h"

namespace metrics {

/// Sums over samples and people of several costs at once. The series is per sample; the original's
/// is one total per place in the list of people of the first sample, and fails when there are more
/// later.
class PersonCosts : public Accumulator {
 public:
  PersonCosts(std::size_t costs, const MetricParameters& parameters)
      : parameters_(parameters), columns_(costs) {}
  void add(const Recording& recording, std::size_t sample) override;
  MetricValue value(std::size_t cost) const;

 protected:
  virtual void beginSample() {}
  /// The costs are 0 before. False: the original would fail here.
  virtual bool addCosts(const Recording& recording, const Sample& sample, const Person& person,
                        std::vector<double>& costs) = 0;
  const MetricParameters& parameters() const { return parameters_; }
  bool isOriginal() const { return parameters_.profile == Profile::Hunav2; }

 private:
  struct Column {
    std::vector<double> series;        // per sample
    std::vector<double> personTotals;  // per place in the first sample's list
    double sum = 0.0;
  };
  void addTo(Column& column, std::size_t place, double cost);

  MetricParameters parameters_;
  std::vector<Column> columns_;
  std::vector<double> costs_;
  bool failed_ = false;
};

}  // namespace metrics
