#include <cassert>
#include <cmath>

#include "metrics/Expression.h"

namespace metrics {

MetricValue Expression::valueOf(const Instant& last, const std::vector<double>& totals) const {
  const double value = result_({last, last, 0.0, totals});
  if (std::isnan(value)) {
    return undefinedValue("the formula is undefined here");
  }
  return std::isinf(value) ? infiniteValue("the formula has no finite value") : numberValue(value);
}

MetricValue Expression::evaluate(const SampledRun& recording,
                                 const MetricParameters& parameters) const {
  const std::vector<Sample>& samples = recording.samples;
  const auto instantAt = [&](std::size_t i) {
    return Instant{recording, parameters,          samples[i], i > 0 ? &samples[i - 1] : nullptr,
                   i,         samples.front().time};
  };
  const Instant last = instantAt(samples.size() - 1);
  std::vector<double> totals;
  for (const Total& total : totals_) {
    Collected collected;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double dt = i + 1 < samples.size() ? samples[i + 1].time - samples[i].time : 0.0;
      collected.take(total.term({instantAt(i), last, dt, totals}), dt);
    }
    totals.push_back(total.result(collected));
  }
  return valueOf(last, totals);
}

/// Each sample is taken when the next one tells how long it lasted.
class Expression::Sums : public Accumulator {
 public:
  explicit Sums(const Expression& expression)
      : expression_(expression), collected_(expression.totals_.size()) {}

  void add(const Instant& at) override {
    if (at.before != nullptr) {
      const Instant then{at.context, at.parameters, *at.before, nullptr, at.index - 1, at.begin};
      take(then, at.step(), collected_);
    }
  }
  MetricValue value(const Instant& last) const {
    std::vector<Collected> collected = collected_;
    take(last, 0.0, collected);
    std::vector<double> totals;
    for (std::size_t k = 0; k < collected.size(); ++k) {
      totals.push_back(expression_.totals_[k].result(collected[k]));
    }
    return expression_.valueOf(last, totals);
  }

 private:
  void take(const Instant& at, double dt, std::vector<Collected>& to) const {
    static const std::vector<double> kNoTotals;
    for (std::size_t k = 0; k < to.size(); ++k) {
      to[k].take(expression_.totals_[k].term({at, at, dt, kNoTotals}), dt);
    }
  }

  Expression expression_;
  std::vector<Collected> collected_;
};

Stream Expression::stream() const {
  assert(!needsRecord_);
  return {[expression = *this](const MetricParameters& /*parameters*/) {
            return std::make_unique<Sums>(expression);
          },
          [](const Accumulator& sums, const Instant& last) {
            return static_cast<const Sums&>(sums).value(last);
          },
          ""};
}

base::Result<MetricEntry> entryOf(const UserMetric& metric) {
  const base::Result<Expression> expression = Expression::parse(metric.expression);
  if (!expression) {
    return expression.diagnostics();
  }
  MetricEntry entry;
  entry.info = {metric.key,        metric.name.empty() ? metric.key : metric.name,
                metric.unit,       Category::Navigation,
                metric.better,     expression->needs(),
                metric.expression, "own",
                "(-inf, inf)"};
  if (!expression->needsRecord()) {
    entry.stream = expression->stream();
    entry.stream.shared = "formula " + metric.key;
    return entry;
  }
  entry.compute = [formula = *expression](const SampledRun& recording,
                                          const MetricParameters& parameters) {
    return formula.evaluate(recording, parameters);
  };
  return entry;
}

}  // namespace metrics
