#pragma once

#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "metrics/Report.h"

namespace metrics {

/// Receives the series of results one by one; the results then contain none.
using SeriesSink = std::function<void(const MetricInfo& info, const Series& series)>;

/// The people that metrics are computed for.
enum class PeopleFilter { All, Subset };  // Subset: only metrics of people

/// State of the robot at one sample.
struct RobotPathState {
  bool is = false;         // started and not arrived
  bool isAtGoal = false;   // stopped in the goal region without an arrival event
  bool isTooLate = false;  // time limit exceeded without an arrival event
};

/// The metrics of a selection during a run. Keeps the newest three samples. Metrics of the robot
/// use only the samples of its path, which ends with the reported arrival, otherwise where it stops
/// in the goal region and remains, otherwise at the time limit. The sums at the latter two points
/// are saved until the end is known. Not synchronised.
class AccumulatorSet {
 public:
  AccumulatorSet(std::shared_ptr<const RunContext> context, const Selection& selection,
                 const MetricParameters& parameters, const MetricRegistry& registry,
                 PeopleFilter among = PeopleFilter::All);
  /// Call for events in order, before the sample of their time.
  void note(double time, const sim2d::Event& event, bool isOnPath) {
    pendingEvents_.push_back({time, event, isOnPath});
  }
  /// Drops events from before the start of the run.
  void forgetEvents() { pendingEvents_.clear(); }
  void add(Sample sample, const RobotPathState& onWay);
  /// Discards the saved sums: the robot arrived at this time [s].
  void addArrivalEvent(double time);
  std::size_t size() const { return all_.count; }
  Sample& newest() { return *all_.now; }
  /// `all`: results for all people, reused for metrics that do not depend on people.
  std::vector<MetricResult> values(const std::vector<MetricResult>* all = nullptr,
                                   const SeriesSink& sink = {}) const;
  /// Shortest paths for the robot's path, as far as the selected keys need them.
  EvaluatedPaths evaluatedPaths() const;
  /// Whether series on disk could not be read.
  bool hasLostSeries() const { return store_ && store_->hasFailed(); }

 private:
  struct Item {
    MetricEntry entry;
    bool hasSum = false;  // in the segment
  };
  struct PendingEvent {
    double time = 0.0;  // [s]
    sim2d::Event event;
    bool isOnPath = false;
  };
  /// The samples that a group of metrics uses.
  struct SampleRange {
    std::shared_ptr<Sample> now, before, earlier;
    std::size_t first = 0;  // index of the first one in the record
    std::size_t count = 0;
    double begin = 0.0;         // [s]
    Vec2 start = Vec2::Zero();  // position of the robot
    TermCache terms;
    std::map<std::string, std::shared_ptr<Accumulator>> sums;  // by Stream::shared
  };
  void addItem(MetricEntry entry, PeopleFilter among);
  void extend(SampleRange& stretch, const std::shared_ptr<Sample>& sample);
  void deliverEvents();
  Instant newestInstant(const SampleRange& stretch, TermCache* memory) const;
  SampleRange copyOfPath() const;
  void saveSums(const RobotPathState& onWay);
  const SampleRange& rangeOf(const MetricInfo& info) const;
  const SampleRange& completePath() const {
    return untilStop_ ? *untilStop_ : (untilTimeLimit_ ? *untilTimeLimit_ : path_);
  }
  bool selectsOne(std::initializer_list<std::string_view> keys) const;
  MetricValue valueOf(const Item& item, const std::vector<MetricResult>& before) const;
  void alignSeries(const Item& item, std::optional<Series>& series) const;

  std::shared_ptr<const RunContext> context_;
  MetricParameters parameters_;
  bool keepsSeries_;
  std::unique_ptr<SeriesStorage> store_;  // null: series are in memory
  std::vector<Item> items_;
  bool needsMap_ = false;
  SampleRange all_, path_;
  std::optional<SampleRange> untilStop_;       // up to the stop in the goal region
  std::optional<SampleRange> untilTimeLimit_;  // up to the time limit
  std::optional<double> arrival_;              // of the robot [s]
  std::vector<PendingEvent> pendingEvents_;    // since the newest sample
};

}  // namespace metrics
