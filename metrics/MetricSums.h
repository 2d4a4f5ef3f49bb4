#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "metrics/Report.h"

namespace metrics {

/// Takes the series of results one by one, which then have none.
using SeriesSink = std::function<void(const MetricInfo& info, const Series& series)>;

/// Whose metrics are summed up.
enum class Among { All, SomePeople };  // SomePeople: only what looks at people

/// The metrics of a selection, fed sample by sample. One thread at a time.
class MetricSums {
 public:
  MetricSums(const Selection& selection, const MetricParameters& parameters, bool hasRobot,
             const MetricRegistry& registry, Among among);
  void note(const RunContext& context, double elapsed, const sim2d::Event& event);
  void add(const Instant& at);
  /// `whole`: the record, where needsRecord(). `all`: results among all people; those that do not
  /// look at people are taken over.
  std::vector<MetricResult> values(const Instant& last, const SampledRun* whole,
                                   const std::vector<MetricResult>* all,
                                   const SeriesSink& sink) const;
  /// Some metric wants the whole record at the end.
  bool needsRecord() const;
  bool needsMap() const;

 private:
  struct Item {
    MetricEntry entry;
    const Accumulator* sum = nullptr;  // one of sums_
  };
  MetricValue valueOf(const Item& item, const Instant& last, const SampledRun* whole,
                      const std::vector<MetricResult>& before) const;

  bool hasRobot_;
  std::vector<Item> items_;
  std::vector<std::unique_ptr<Accumulator>> sums_;
};

/// A run that goes on and its metrics. Of its samples the newest two are kept, unless a metric
/// wants them all. One thread at a time.
class SampleFeed {
 public:
  SampleFeed(std::shared_ptr<const RunContext> context, const Selection& selection,
             const MetricParameters& parameters, const MetricRegistry& registry,
             Among among = Among::All);
  /// Events before the sample of their time, in order.
  void note(double time, const sim2d::Event& event) { noted_.emplace_back(time, event); }
  /// The run has not begun yet.
  void forgetEvents() { noted_.clear(); }
  void add(Sample sample);
  std::size_t size() const { return count_; }
  Sample& newest() { return now_; }
  std::vector<MetricResult> values(const std::vector<MetricResult>* all = nullptr,
                                   const SeriesSink& sink = {}) const;
  /// Series put aside could not be read back.
  bool hasLostSeries() const { return store_ && store_->hasFailed(); }

 private:
  void takeEvents();
  Instant newestInstant(TermMemory* memory) const;

  std::shared_ptr<const RunContext> context_;
  MetricParameters parameters_;
  bool keepsSeries_;
  std::unique_ptr<NumberStore> store_;  // null: series stay in memory
  MetricSums sums_;
  bool looks_;
  Sample now_, before_;
  std::size_t count_ = 0;
  double begin_ = 0.0;  // [s]
  TermMemory terms_;
  std::vector<std::pair<double, sim2d::Event>> noted_;  // since the newest sample
  std::unique_ptr<SampledRun> whole_;                   // null: nobody wants it
};

}  // namespace metrics
