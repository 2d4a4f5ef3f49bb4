#include "metrics/SeriesMetric.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "metrics/Interaction.h"

namespace metrics {

namespace {

class SeriesAccumulator : public Accumulator {
 public:
  SeriesAccumulator(SampleTerm term, const MetricParameters& parameters)
      : term_(std::move(term)), parameters_(parameters) {}

  void add(const Recording& recording, std::size_t sample) override {
    terms_.push_back(term_(recording.samples[sample], parameters_));
  }
  const std::vector<double>& terms() const { return terms_; }

 private:
  SampleTerm term_;
  MetricParameters parameters_;
  std::vector<double> terms_;
};

/// Equal for the same plain function, empty for anything else.
std::string nameOf(const SampleTerm& term) {
  using Plain = double (*)(const Sample&, const MetricParameters&);
  const Plain* plain = term.target<Plain>();
  return plain == nullptr ? std::string()
                          : "term " + std::to_string(reinterpret_cast<std::uintptr_t>(*plain));
}

}  // namespace

void addSeriesMetric(MetricRegistry& to, MetricInfo info, SampleTerm term, Reduction reduce) {
  const std::string shared = nameOf(term);
  to.addStream(std::move(info), streamOf<SeriesAccumulator>(
                                    shared,
                                    [reduce = std::move(reduce)](
                                        const SeriesAccumulator& sum, const Recording& recording,
                                        const MetricParameters& parameters) {
                                      return reduce(sum.terms(), recording, parameters);
                                    },
                                    [term = std::move(term)](const MetricParameters& parameters) {
                                      return std::make_unique<SeriesAccumulator>(term, parameters);
                                    }));
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

double collisionTerm(const Sample& sample, const MetricParameters& /*parameters*/) {
  double soonest = std::numeric_limits<double>::quiet_NaN();
  for (const Person& person : sample.people) {
    const double time = person.pair.timeToCollision;
    if (!std::isinf(time) && !(time >= soonest)) {
      soonest = time;
    }
  }
  return soonest;
}

}  // namespace metrics
