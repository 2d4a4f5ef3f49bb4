#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "metrics/Instant.h"

namespace metrics {

/// Groups of the metrics panel, in order.
enum class Category { Navigation, Social, Motion, Safety, Forces, DangerSurprise };
constexpr int kCategories = 6;
const char* categoryName(Category category);  // "Navigation Performance" …

enum class Better { Lower, Higher, Neutral };
const char* betterName(Better better);  // "lower" …

enum class Kind { Number, Boolean, Count };

/// Data that a recording must contain for a metric to be defined.
struct Needs {
  bool robot = true;
  bool people = false, groups = false, obstacles = false, goal = false, map = false;
};

struct MetricInfo {
  std::string key;
  std::string name;  // display name
  std::string unit;  // empty: none
  Category category = Category::Navigation;
  Better better = Better::Neutral;
  Needs needs;
  std::string formula;  // as text, for the corrected profile
  std::string source;
  std::string range = "[0, inf)";
  Kind kind = Kind::Number;
  int hunav = 0;         // number among HuNavSim's 34 keys; 0: other
  std::string partOf{};  // selected together with that key; empty: separately
  /// Maximum relative change when a record of smooth motion is sampled at twice the rate (from 20
  /// Hz on), relative to the larger value or 0.1.
  double rateBound = 0.02;
};

/// One value per sample.
struct Series {
  std::vector<double> values;  // NaN: undefined
  Kind kind = Kind::Number;
};

struct MetricValue {
  MetricValue() = default;
  MetricValue(double number);  // NaN gives an undefined value

  std::optional<double> value;  // may be infinite, never NaN; Boolean: 0 or 1
  std::string why;              // reason if undefined or infinite
  std::optional<Series> series;
};

MetricValue undefinedValue(std::string why);
constexpr char kNoRobot[] = "there is no robot";  // the reason of metrics that need one
MetricValue infiniteValue(std::string why);
MetricValue withSeries(MetricValue value, std::vector<double> series, Kind kind = Kind::Number);
MetricValue withTerms(const SeriesSum& sum, Kind kind = Kind::Number);
MetricValue meanOver(MetricValue sum, std::size_t samples);  // divided, without series

/// A metric computed sample by sample without access to past samples. Except for series, its memory
/// must not grow with the number of samples.
class Accumulator {
 public:
  virtual ~Accumulator() = default;
  /// Called once for each sample, in order.
  virtual void add(const Instant& /*at*/) {}
  /// Called for an event before the sample of its time. `elapsed`: since the first sample [s].
  virtual void note(const RunContext& /*context*/, double /*elapsed*/,
                    const sim2d::Event& /*event*/) {}
};
using AccumulatorFactory =
    std::function<std::unique_ptr<Accumulator>(const MetricParameters& parameters)>;
using AccumulatorCopier = std::function<std::unique_ptr<Accumulator>(const Accumulator&)>;

template <class Sum>
std::unique_ptr<Accumulator> copyOf(const Accumulator& sum) {
  return std::make_unique<Sum>(static_cast<const Sum&>(sum));
}

/// Creation and evaluation of an accumulator.
struct MetricComputation {
  AccumulatorFactory make;
  std::function<MetricValue(const Accumulator&, const Instant& last)> read;
  std::string shared;  // metrics with equal text share one accumulator
  AccumulatorCopier copy;
};

struct MetricEntry {
  MetricInfo info;
  MetricComputation computation;  // without `make`: the sum `info.partOf` divided by N
};

/// All known metrics. Writers, tables and panels iterate over it and do not depend on individual
/// metrics.
class MetricRegistry {
 public:
  /// Keys must be unique.
  void add(MetricInfo info, MetricComputation computation);
  /// Adds the metrics of a table, with the computations of their keys. A heading "=
  /// category|better|needs|source", optionally followed by "|rate bound", precedes lines
  /// "key|name|unit|range|formula"; lines of HuNavSim metrics start with "number ". A line that
  /// starts with a blank continues the formula. The range determines the kind.
  void add(const char* table, const std::map<std::string, MetricComputation>& computations);
  /// The same for sums over samples, with the rate bound of sums. Each gets a companion
  /// `<key>_mean` = value / number of samples, which is selected with its key.
  void addSums(const char* table, const std::map<std::string, MetricComputation>& computations);
  /// Orders HuNavSim's keys by number, followed by the others in insertion order.
  void sort();
  const std::vector<MetricEntry>& entries() const { return entries_; }
  std::vector<std::string> keys() const;  // of all entries, in their order
  const MetricEntry* find(std::string_view key) const;
  /// The parameters that a metric depends on.
  std::vector<base::ParameterSpec> parametersOf(const MetricInfo& info) const;

 private:
  std::vector<MetricEntry> entries_;
};

template <class Sum>
inline constexpr char kSumTag = 0;  // its address identifies the class

/// Computes metrics from one accumulator class, constructed from the parameters or by default,
/// shared by all metrics that read it. `read`: a member or function of the accumulator, optionally
/// with the Instant. `why`: the reason for undefined values.
template <class Sum, class Read>
MetricComputation metricOf(Read read, const char* why = nullptr) {
  return {[](const MetricParameters& parameters) -> std::unique_ptr<Accumulator> {
            if constexpr (std::is_constructible_v<Sum, const MetricParameters&>) {
              return std::make_unique<Sum>(parameters);
            } else {
              return std::make_unique<Sum>();
            }
          },
          [read, why](const Accumulator& accumulator, const Instant& last) {
            const auto& sum = static_cast<const Sum&>(accumulator);
            MetricValue value;
            if constexpr (std::is_invocable_v<Read, const Sum&, const Instant&>) {
              value = std::invoke(read, sum, last);
            } else {
              value = std::invoke(read, sum);
            }
            value.why = value.value || why == nullptr ? value.why : why;
            return value;
          },
          std::to_string(reinterpret_cast<std::uintptr_t>(&kSumTag<Sum>)), copyOf<Sum>};
}

/// Reads one of several values of an accumulator.
template <class Sum>
MetricComputation metricOfPart(std::size_t part) {
  return metricOf<Sum>(
      [part](const Sum& sum, const Instant& last) { return sum.value(part, last); });
}

/// Reads only the last sample.
template <class Read>
MetricComputation metricOfLast(Read read) {
  return metricOf<Accumulator>(
      [read](const Accumulator& /*none*/, const Instant& last) { return std::invoke(read, last); });
}

/// Generated by the build: calls add<File>() of every file in metrics/catalogue.
void addAllMetrics(MetricRegistry& to);

/// The built-in metrics, in order. Immutable, thread-safe.
const MetricRegistry& standardRegistry();

/// The text of metrics/METRICS.md, which the build embeds.
std::string metricsMarkdown();

}  // namespace metrics
