#pragma once

#include <array>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "metrics/Report.h"
#include "metrics/ShortestPaths.h"

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
    std::map<std::string, std::shared_ptr<Accumulator>> sums;  // by MetricComputation::shared
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

/// Incremental evaluation of a record while it is created; gives the same results as evaluate() of
/// the whole record. Memory grows only with series; it is constant if none are selected and no
/// metric needs the whole record. Not synchronised.
class IncrementalEvaluation {
 public:
  /// An invalid window is reported by finish().
  IncrementalEvaluation(const RunContext& context, const Selection& selection,
                        const MetricParameters& parameters,
                        const MetricRegistry& registry = standardRegistry());
  /// Call for events in order, before the sample of their time.
  void note(double time, const sim2d::Event& event);
  void add(Sample sample);
  /// Returns an error if the record or the window contains no sample. With `sink`, the series of
  /// the results for all people go to it and the results contain none.
  base::Result<Evaluation> finish(const SeriesSink& sink = {}) const;

 private:
  static constexpr std::size_t kBehaviors = 6;
  struct Behavior {
    std::unique_ptr<AccumulatorSet> feed;
    bool isMet = false;          // a person of the type was present
    std::vector<double> active;  // 0/1 per sample
  };
  void addToBehaviors(Sample& sample, const RobotPathState& onWay);
  void markNew(Sample& sample);
  bool isOnPath(double time) const;
  RobotPathState pathStateOf(const Sample& sample);
  bool isWholeRecord() const;
  bool usesHunavProfile() const { return parameters_.profile == Profile::Hunav2; }

  std::shared_ptr<const RunContext> context_;
  Selection selection_;
  MetricParameters parameters_;
  WindowFilter gate_;
  std::vector<double> times_;  // of the used samples, from the first [s], if series are selected
  double first_ = 0.0;
  bool hasSamples_ = false;          // in the record, used or not
  bool isOver_ = false;              // no more samples are used
  std::optional<double> arrival_;    // of the robot [s]
  bool isAtGoal_ = false;            // a sample at or after the arrival was used
  std::optional<double> pathStart_;  // first sample of the path [s]
  bool hasMoved_ = false;            // on its path
  std::set<int> entered_;            // people entered since the newest used sample
  AccumulatorSet all_;
  std::array<Behavior, kBehaviors> behaviors_;  // types 1..6; without feed: not selected
};

/// Unique names of the robots that are valid in file names.
std::vector<std::string> robotNames(const std::vector<sim2d::TraceRobot>& robots);

/// Receives the series of results, which then contain none, with the robot's name.
using RobotSeriesSink =
    std::function<void(const std::string& robot, const MetricInfo& info, const Series& series)>;

/// The same from frames of a world or a recording, for one robot or, if selected, for each robot.
class FrameEvaluation {
 public:
  FrameEvaluation(const sim2d::TraceHeader& header, const Selection& selection,
                  const MetricParameters& parameters, const PrecomputedScene& known = {});
  /// Adds people who appear after the header was created, before the first frame with them.
  void addHumans(const std::vector<sim2d::TraceHuman>& humans);
  void note(double time, const sim2d::Event& event);
  void append(const sim2d::Frame& frame);
  base::Result<Evaluation> finish(const RobotSeriesSink& sink = {}) const;
  /// Results so far; empty before the first sample.
  std::vector<MetricResult> values() const {
    base::Result<Evaluation> evaluation = robots_.front().finish({});
    return evaluation ? std::move(evaluation->results) : std::vector<MetricResult>();
  }

 private:
  struct RobotEvaluation {
    RobotEvaluation(std::string its, const sim2d::TraceHeader& header, const Selection& selection,
                    const MetricParameters& parameters, const PrecomputedScene& known);
    base::Result<Evaluation> finish(const RobotSeriesSink& sink) const;
    Evaluation without(const Evaluation& first, const base::Diagnostics& why) const;

    std::string name;
    int id;
    SampleBuilder builder;
    IncrementalEvaluation running;
  };
  std::vector<RobotEvaluation> robots_;  // first that of the selection, even without a robot
};

}  // namespace metrics
