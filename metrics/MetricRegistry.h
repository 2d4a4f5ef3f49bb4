#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "metrics/MetricParameters.h"
#include "metrics/Recording.h"

namespace metrics {

/// Groups of the metrics panel, in its order.
enum class Category { Navigation, Social, Motion, Safety, Forces, DangerSurprise };
constexpr int kCategories = 6;
const char* categoryName(Category category);  // "Navigation Performance" …

enum class Better { Lower, Higher, Neutral };
const char* betterName(Better better);  // "lower" …

enum class Kind { Number, Boolean, Count };
const char* kindName(Kind kind);  // "number" …

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
  std::string range;  // "[0, 100]"
  Kind kind = Kind::Number;
  int hunav = 0;       // number among HuNavSim's 34 keys; 0 = ours
  std::string partOf;  // selected together with that key; empty = on its own
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
  std::optional<double> value;  // may be infinite, never NaN; Boolean: 0 or 1
  std::string why;              // when undefined or infinite
  Kind kind = Kind::Number;
  std::optional<Series> series;
};

MetricValue numberValue(double value);  // NaN becomes undefined
MetricValue countValue(double value);
MetricValue booleanValue(bool value);
MetricValue undefinedValue(std::string why);
MetricValue infiniteValue(std::string why);
MetricValue withSeries(MetricValue value, std::vector<double> series, Kind kind = Kind::Number);
MetricValue meanOver(MetricValue sum, std::size_t samples);  // divided, without series
double sumOf(const std::vector<double>& values);             // in order, from the first

/// One metric: recording in, value out. Sees at least one sample, and a robot if it needs one.
using MetricFunction = std::function<MetricValue(const Recording&, const MetricParameters&)>;

/// A metric computed sample by sample: all that look at people, for the people of a long run are
/// not kept. Live values come from the same code.
class Accumulator {
 public:
  Accumulator() = default;
  Accumulator(const Accumulator&) = delete;
  Accumulator& operator=(const Accumulator&) = delete;
  Accumulator(Accumulator&&) = delete;
  Accumulator& operator=(Accumulator&&) = delete;
  virtual ~Accumulator() = default;
  /// Sample number `sample`, the newest; called once for each, in order. Of the samples before,
  /// the people are there in the last one only. With a robot, Person::pair is known.
  virtual void add(const Recording& recording, std::size_t sample) = 0;
};
using AccumulatorFactory =
    std::function<std::unique_ptr<Accumulator>(const MetricParameters& parameters)>;

/// How a metric is made from an accumulator. The recording may have no people any more.
struct Stream {
  AccumulatorFactory make;  // empty: a plain function
  std::function<MetricValue(const Accumulator&, const Recording&, const MetricParameters&)> read;
  std::string shared;  // metrics with the same text share one accumulator; empty = its own
};

struct MetricEntry {
  MetricInfo info;
  MetricFunction compute;
  Stream stream;
  std::string meanOf;  // key of the sum that this one divides by N; empty = none
};

/// All metrics that a program knows. Writers, tables and panels walk over it and know no metric by
/// name.
class MetricRegistry {
 public:
  /// Keys are unique: adding one twice is a bug.
  void add(MetricInfo info, MetricFunction compute);
  void addStream(MetricInfo info, Stream stream);
  /// `<key>_mean` = value / number of samples, for sums over samples; selected with its key.
  void addMeanOf(const std::string& key);
  void setRateBound(const std::string& key, double bound);
  /// HuNavSim's keys by number, then ours as they were added.
  void sort();
  const std::vector<MetricEntry>& entries() const { return entries_; }
  const MetricEntry* find(std::string_view key) const;
  std::vector<std::string> keys() const;

 private:
  std::vector<MetricEntry> entries_;
};

/// A stream of accumulators of one class, made from the parameters.
template <class Sum>
Stream streamOf(
    std::string shared,
    std::function<MetricValue(const Sum&, const Recording&, const MetricParameters&)> read,
    std::function<std::unique_ptr<Accumulator>(const MetricParameters&)> make) {
  return {std::move(make),
          [read = std::move(read)](const Accumulator& sum, const Recording& recording,
                                   const MetricParameters& parameters) {
            return read(static_cast<const Sum&>(sum), recording, parameters);
          },
          std::move(shared)};
}

/// Written by the build: calls add<File>() of every file in metrics/catalogue.
void addAllMetrics(MetricRegistry& to);

/// The shipped metrics, in order. Constant, any thread.
const MetricRegistry& standardRegistry();

/// The text of metrics/METRICS.md.
std::string metricsMarkdown(const MetricRegistry& registry);

}  // namespace metrics
