#include <cmath>

#include "metrics/Expression.h"

namespace metrics {

MetricValue Expression::evaluate(const Recording& recording,
                                 const MetricParameters& parameters) const {
  std::vector<double> totals;
  totals.reserve(totals_.size());
  for (const Total& total : totals_) {
    totals.push_back(total.reduce({recording, parameters, totals, 0, nullptr}, total.term));
  }
  const double value = result_({recording, parameters, totals, 0, nullptr});
  if (std::isnan(value)) {
    return undefinedValue("the formula is undefined here");
  }
  return std::isinf(value) ? infiniteValue("the formula has no finite value") : numberValue(value);
}

base::Result<MetricEntry> entryOf(const UserMetric& metric) {
  const base::Result<Expression> expression = Expression::parse(metric.expression);
  if (!expression) {
    return expression.diagnostics();
  }
  MetricEntry entry;
  entry.info.key = metric.key;
  entry.info.name = metric.name.empty() ? metric.key : metric.name;
  entry.info.unit = metric.unit;
  entry.info.category = Category::Navigation;
  entry.info.better = metric.better;
  entry.info.needs = expression->needs();
  entry.info.formula = metric.expression;
  entry.info.source = "own";
  entry.info.range = "(-inf, inf)";
  entry.compute = [formula = *expression](const Recording& recording,
                                          const MetricParameters& parameters) {
    return formula.evaluate(recording, parameters);
  };
  return entry;
}

}  // namespace metrics
