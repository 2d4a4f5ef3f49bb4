#include "metrics/SeriesMetric.h"

#include <limits>

namespace metrics {

namespace {

class SeriesAccumulator : public Accumulator {
 public:
  SeriesAccumulator(SampleTerm term, Reduction reduce, const MetricParameters& parameters)
      : term_(std::move(term)), reduce_(std::move(reduce)), parameters_(parameters) {}

  void add(const Recording& recording, std::size_t sample) override {
    terms_.push_back(term_(recording.samples[sample], parameters_));
  }
  MetricValue value(const Recording& recording) const override {
    return reduce_(terms_, recording, parameters_);
  }

 private:
  SampleTerm term_;
  Reduction reduce_;
  MetricParameters parameters_;
  std::vector<double> terms_;
};

}  // namespace

void addSeriesMetric(MetricRegistry& to, MetricInfo info, SampleTerm term, Reduction reduce) {
  to.addAccumulated(std::move(info), [term = std::move(term), reduce = std::move(reduce)](
                                         const MetricParameters& parameters) {
    return std::make_unique<SeriesAccumulator>(term, reduce, parameters);
  });
}

double closestGapTerm(const Sample& sample, const MetricParameters& /*parameters*/) {
  return closestGap(sample).value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace metrics
