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

  /// Undefined where the formula is (0/0, nobody there). Sees at least one sample.
  MetricValue evaluate(const std::vector<Sample>& samples, const Instant& last) const;
  /// With the same values. Keeps no samples, but for those that need the record.
  Stream stream() const;
  const Needs& needs() const { return needs_; }
  /// A sum over time is of what is known at the end: another sum, `duration`, `samples`.
  bool needsRecord() const { return needsRecord_; }

  /// Where a value is asked for.
  struct Place {
    const Instant& at;
    const Instant& last;                // of the run
    double dt = 0.0;                    // to the next sample [s]
    const std::vector<double>& totals;  // of the inner sums over time, in order
    const Person* person = nullptr;
  };
  using Value = std::function<double(const Place&)>;

  /// Sum, count and extremes of the defined values of a term.
  struct Collected {
    double sum = 0.0, integral = 0.0, count = 0.0, holding = 0.0;
    double least = kNaN, largest = kNaN, first = kNaN, last = kNaN;

    void take(double value, double weight);
  };
  using Result = double (*)(const Collected&);
  /// One sum (minimum, mean …) over time.
  struct Total {
    Result result;
    Value term;
  };

 private:
  friend class ExpressionParser;
  class Sums;
  MetricValue valueOf(const Instant& last, const std::vector<double>& totals) const;

  std::vector<Total> totals_;
  Value result_;
  Needs needs_;
  bool needsRecord_ = false;
};

/// A metric of the user's: its entry for a selection.
struct UserMetric {
  std::string key, expression;
  std::string name, unit;
  Better better = Better::Neutral;
};
base::Result<MetricEntry> entryOf(const UserMetric& metric);

// What an expression can name.

enum class Scope { Run, Sample, Person };  // how often a value may differ

struct VariableName {
  std::string name;
  Scope scope = Scope::Run;
  Expression::Value value;
  bool needsRobot = false, needsPeople = false;
  bool isOfEnd = false;  // known when the run is over
};
const std::vector<VariableName>& variableNames();

/// Of numbers: abs(x) …
struct FunctionName {
  std::string name;
  std::size_t arguments = 1;
  double (*apply)(const double* arguments) = nullptr;
};
const std::vector<FunctionName>& functionNames();

/// Over time: min, max, mean, sum, integral, count, first, last.
struct TotalName {
  std::string name;
  Expression::Result result;
};
const std::vector<TotalName>& totalNames();
/// Over the people of a sample: people_min …, any, all.
const std::vector<TotalName>& peopleTotalNames();
double overPeople(const Expression::Place& place, const Expression::Value& term,
                  Expression::Result result);

}  // namespace metrics
