#pragma once

#include <functional>
#include <string>
#include <vector>

#include "metrics/MetricRegistry.h"
#include "sim2d/base/Result.h"

namespace metrics {

/// A metric defined by a formula: "integral(gap < 0.5)". README.md describes the language.
/// Immutable after parsing, thread-safe.
class Expression {
 public:
  /// Problems contain the column in the text (line 1).
  static base::Result<Expression> parse(const std::string& text);

  /// Undefined where the formula is undefined (0/0, no people). Requires at least one sample.
  MetricValue evaluate(const std::vector<Sample>& samples, const Instant& last) const;
  /// Streaming evaluation with the same values. Keeps no samples unless needsRecord().
  MetricComputation computation() const;
  const Needs& needs() const { return needs_; }
  /// Whether a sum over time uses values that are known only at the end: another sum, `duration`,
  /// `samples`.
  bool needsRecord() const { return needsRecord_; }

  /// Evaluation context of a value.
  struct EvaluationPoint {
    const Instant& at;
    const Instant& last;                // of the run
    double dt = 0.0;                    // to the next sample [s]
    const std::vector<double>& totals;  // of the inner sums over time, in order
    const Pedestrian* person = nullptr;
  };
  using Value = std::function<double(const EvaluationPoint&)>;

  /// Sum, count and extremes of the defined values of a term.
  struct Aggregate {
    double sum = 0.0, integral = 0.0, count = 0.0, holding = 0.0;
    double least = kNaN, largest = kNaN, first = kNaN, last = kNaN;

    void take(double value, double weight);
  };
  using Result = double (*)(const Aggregate&);
  /// One aggregate over time (minimum, mean …).
  struct TimeAggregate {
    Result result;
    Value term;
  };

 private:
  friend class ExpressionParser;
  class TimeSums;
  MetricValue valueOf(const Instant& last, const std::vector<double>& totals) const;

  std::vector<TimeAggregate> totals_;
  Value result_;
  Needs needs_;
  bool needsRecord_ = false;
};

/// A user-defined metric, as an entry for a selection.
struct UserMetric {
  std::string key, expression;
  std::string name, unit;
  Better better = Better::Neutral;
};
base::Result<MetricEntry> entryOf(const UserMetric& metric);

// Names that an expression can use.

enum class Scope { Run, Sample, Pedestrian };  // how often a value changes

struct VariableName {
  std::string name;
  Scope scope = Scope::Run;
  Expression::Value value;
  bool needsRobot = false, needsPeople = false;
  bool isKnownAtEnd = false;  // known only at the end of the run
};
const std::vector<VariableName>& variableNames();

/// Functions of numbers: abs(x) …
struct FunctionName {
  std::string name;
  std::size_t arguments = 1;
  double (*apply)(const double* arguments) = nullptr;
};
const std::vector<FunctionName>& functionNames();

/// Aggregates over time: min, max, mean, sum, integral, count, first, last.
struct AggregateName {
  std::string name;
  Expression::Result result;
};
const std::vector<AggregateName>& aggregateNames();
/// Aggregates over the people of a sample: people_min …, any, all.
const std::vector<AggregateName>& peopleAggregateNames();
double aggregateOverPeople(const Expression::EvaluationPoint& place, const Expression::Value& term,
                           Expression::Result result);

}  // namespace metrics
