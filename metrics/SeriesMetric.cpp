#include "metrics/SeriesMetric.h"

#include <cmath>
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

double timeMean(const std::vector<double>& terms, const Recording& recording) {
  double sum = 0.0;
  double time = 0.0;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (!std::isnan(terms[i])) {
      sum += terms[i] * recording.interval(i);
      time += recording.interval(i);
    }
  }
  return time > 0.0 ? sum / time : std::numeric_limits<double>::quiet_NaN();
}

double largestTerm(const std::vector<double>& terms) {
  double largest = std::numeric_limits<double>::quiet_NaN();
  for (const double term : terms) {
    largest = term <= largest || std::isnan(term) ? largest : term;
  }
  return largest;
}

double closestGapTerm(const Sample& sample, const MetricParameters& /*parameters*/) {
  return closestGap(sample).value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace metrics
