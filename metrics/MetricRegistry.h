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

/// Groups of the metrics panel, in its order.
enum class Category { Navigation, Social, Motion, Safety, Forces, DangerSurprise };
constexpr int kCategories = 6;
const char* categoryName(Category category);  // "Navigation Performance" …

enum class Better { Lower, Higher, Neutral };
const char* betterName(Better better);  // "lower" …

enum class Kind { Number, Boolean, Count };

/// What a recording must hold for a metric to say something.
struct Needs {
  bool robot = true;
  bool people = false, groups = false, obstacles = false, goal = false, map = false;
};
std::string needsText(const Needs& needs);  // "robot, people"; "nothing"

struct MetricInfo {
  std::string key;
  std::string name;  // for people
  std::string unit;  // "" = none
  Category category = Category::Navigation;
  Better better = Better::Neutral;
  Needs needs;
  std::string formula;  // as text, corrected profile
  std::string source;
  std::string range = "[0, inf)";
  Kind kind = Kind::Number;
  int hunav = 0;         // number among HuNavSim's 34 keys; 0 = ours
  std::string partOf{};  // selected together with that key; empty = on its own
  /// Largest change when a record of smooth motion is sampled twice as often (from 20 Hz on), as a
  /// share of the larger value, which counts as at least 0.1.
  double rateBound = 0.02;
};

/// One value per sample.
struct Series {
  std::vector<double> values;  // NaN = undefined there
  Kind kind = Kind::Number;
};

struct MetricValue {
  MetricValue() = default;
  MetricValue(double number);  // NaN becomes undefined

  std::optional<double> value;  // may be infinite, never NaN; Boolean: 0 or 1
  std::string why;              // when undefined or infinite
  std::optional<Series> series;
};

MetricValue undefinedValue(std::string why);
MetricValue infiniteValue(std::string why);
MetricValue withSeries(MetricValue value, std::vector<double> series, Kind kind = Kind::Number);
MetricValue withTerms(const SeriesSum& sum, Kind kind = Kind::Number);
MetricValue meanOver(MetricValue sum, std::size_t samples);  // divided, without series

/// A metric worked out sample by sample, without the samples that are past. What it holds must not
/// grow with them, but for series.
class Accumulator {
 public:
  virtual ~Accumulator() = default;
  /// Once for each sample, in order.
  virtual void add(const Instant& /*at*/) {}
  /// An event of the record, before the sample of its time; `elapsed` since the first sample [s].
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

/// How a metric is made from an accumulator.
struct Stream {
  AccumulatorFactory make;
  std::function<MetricValue(const Accumulator&, const Instant& last)> read;
  std::string shared;  // metrics with the same text share one accumulator
  AccumulatorCopier copy;
};

struct MetricEntry {
  MetricInfo info;
  Stream stream;  // nothing to make: the sum `info.partOf` divided by N
};

/// All metrics that a program knows. Writers, tables and panels walk over it and know no metric by
/// name.
class MetricRegistry {
 public:
  /// Keys are unique: adding one twice is a bug.
  void add(MetricInfo info, Stream stream);
  /// The metrics of a table, worked out by the streams of their keys. A heading
  /// "= category|better|needs|source", with "|rate bound" if it is not the usual one, stands above
  /// lines "key|name|unit|range|formula", HuNavSim's with "number " in front; a line that begins
  /// with a blank goes on with the formula. The range tells the kind.
  void add(const char* table, const std::map<std::string, Stream>& streams);
  /// The same of sums over samples, whose rate bound is that of sums, each with `<key>_mean` =
  /// value / number of samples, selected with its key.
  void addSums(const char* table, const std::map<std::string, Stream>& streams);
  /// HuNavSim's keys by number, then ours as they were added.
  void sort();
  const std::vector<MetricEntry>& entries() const { return entries_; }
  const MetricEntry* find(std::string_view key) const;
  /// Those that the value of a metric depends on.
  std::vector<base::ParameterSpec> parametersOf(const MetricInfo& info) const;

 private:
  std::vector<MetricEntry> entries_;
};

template <class Sum>
inline constexpr char kSumTag = 0;  // its address tells classes apart

/// A stream of accumulators of one class, made from the parameters or from nothing, which all
/// metrics read from it share. `read`: a member or function of the accumulator, of the Instant as
/// well if it likes; `why`: what is said where it is undefined.
template <class Sum, class Read>
Stream streamOf(Read read, const char* why = nullptr) {
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

/// One of several values of such an accumulator.
template <class Sum>
Stream streamOfPart(std::size_t part) {
  return streamOf<Sum>(
      [part](const Sum& sum, const Instant& last) { return sum.value(part, last); });
}

/// Needs no more than the last sample.
template <class Read>
Stream streamOfLast(Read read) {
  return streamOf<Accumulator>(
      [read](const Accumulator& /*none*/, const Instant& last) { return std::invoke(read, last); });
}

/// Written by the build: calls add<File>() of every file in metrics/catalogue.
void addAllMetrics(MetricRegistry& to);

/// The shipped metrics, in order. Constant, any thread.
const MetricRegistry& standardRegistry();

/// The text of metrics/METRICS.md.
std::string metricsMarkdown(const MetricRegistry& registry);

}  // namespace metrics
