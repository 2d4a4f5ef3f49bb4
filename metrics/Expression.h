#pragma once

#include <functional>
#include <string>
#include <vector>

#include "metrics/MetricRegistry.h"
#include "sim2d/base/Result.h"

namespace metrics {

/// A metric written as a formula: "integral(gap < 0.5)". The language is told in README.md.
/// Constant after parsing, any thread.
class Expression {
 public:
  /// Problems carry the column in the text (line 1).
  static base::Result<Expression> parse(const std::string& text);

  /// Undefined where the formula is (0/0, nobody there).
  MetricValue evaluate(const Recording& recording, const MetricParameters& parameters) const;
  const Needs& needs() const { return needs_; }

  /// Where a value is asked for.
  struct Place {
    const Recording& recording;
    const MetricParameters& parameters;
    const std::vector<double>& totals;  // of the inner sums over time, in order
    std::size_t sample = 0;
    const Person* person = nullptr;
  };
  using Value = std::function<double(const Place&)>;
  /// One sum (minimum, mean …) over time.
  struct Total {
    std::function<double(const Place& place, const Value& term)> reduce;
    Value term;
  };

 private:
  friend class ExpressionParser;
  std::vector<Total> totals_;
  Value result_;
  Needs needs_;
};

/// A metric of the user's: its entry for a selection.
struct UserMetric {
  std::string key, expression;
  std::string name, unit;
  Better better = Better::Neutral;
};
base::Result<MetricEntry> entryOf(const UserMetric& metric);

}  // namespace metrics
