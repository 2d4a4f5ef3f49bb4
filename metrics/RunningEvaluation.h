#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "metrics/Report.h"

namespace metrics {

/// Takes the series of results one by one, which then have none.
using SeriesSink = std::function<void(const MetricInfo& info, const Series& series)>;

/// Whose metrics are summed up.
enum class Among { All, SomePeople };  // SomePeople: only what looks at people

/// The robot at one sample.
struct OnWay {
  bool is = false;         // it has set off and has not arrived
  bool isAtGoal = false;   // stands in the goal region after it moved, and no arrival was told
  bool isTooLate = false;  // the time limit is over, and no arrival was told
};

/// A run that goes on and the metrics of a selection. Of its samples the newest three are kept.
/// Metrics of the robot look at samples of their own: those of its way. It ends with the arrival
/// that was told, else where it came to stand in the goal region and still does, else with the time
/// limit: the sums at those two are kept aside. One thread at a time.
class SampleFeed {
 public:
  SampleFeed(std::shared_ptr<const RunContext> context, const Selection& selection,
             const MetricParameters& parameters, const MetricRegistry& registry,
             Among among = Among::All);
  /// Events before the sample of their time, in order.
  void note(double time, const sim2d::Event& event, bool isOnWay) {
    noted_.push_back({time, event, isOnWay});
  }
  /// The run has not begun yet.
  void forgetEvents() { noted_.clear(); }
  void add(Sample sample, const OnWay& onWay);
  /// What was kept aside was not the end: the robot has arrived.
  void tellArrival();
  std::size_t size() const { return all_.count; }
  Sample& newest() { return *all_.now; }
  /// `all`: results among all people; those that do not look at people are taken over.
  std::vector<MetricResult> values(const std::vector<MetricResult>* all = nullptr,
                                   const SeriesSink& sink = {}) const;
  /// Series put aside could not be read back.
  bool hasLostSeries() const { return store_ && store_->hasFailed(); }

 private:
  struct Item {
    MetricEntry entry;
    bool hasSum = false;  // in the stretch
  };
  struct Noted {
    double time = 0.0;  // [s]
    sim2d::Event event;
    bool isOnWay = false;
  };
  /// The samples that some of the metrics look at.
  struct Stretch {
    std::shared_ptr<Sample> now, before, earlier;
    std::size_t first = 0;  // of them, among all
    std::size_t count = 0;
    double begin = 0.0;  // [s]
    TermMemory terms;
    std::map<std::string, std::shared_ptr<Accumulator>> sums;  // by Stream::shared
  };
  void addItem(MetricEntry entry, Among among);
  void lengthen(Stretch& stretch, const std::shared_ptr<Sample>& sample);
  void passEvents();
  Instant newestInstant(const Stretch& stretch, TermMemory* memory) const;
  Stretch copyOfWay() const;
  void keepAside(const OnWay& onWay);
  const Stretch& stretchOf(const MetricInfo& info) const;
  MetricValue valueOf(const Item& item, const std::vector<MetricResult>& before) const;
  void alignSeries(const Item& item, std::optional<Series>& series) const;

  std::shared_ptr<const RunContext> context_;
  MetricParameters parameters_;
  bool keepsSeries_;
  std::unique_ptr<NumberStore> store_;  // null: series stay in memory
  std::vector<Item> items_;
  bool needsMap_ = false;
  Stretch all_, way_;
  std::optional<Stretch> toGoal_;  // the way until it came to stand in the goal region
  std::optional<Stretch> inTime_;  // until the time limit
  std::vector<Noted> noted_;       // since the newest sample
};

/// An evaluation that is fed while the record is made: the same results as evaluate() of the whole
/// record. What it holds grows with the samples by their series alone; not at all where the
/// selection wants none and no metric wants the whole record. One thread at a time.
class RunningEvaluation {
 public:
  /// A wrong window is told by finish().
  RunningEvaluation(const RunContext& context, const Selection& selection,
                    const MetricParameters& parameters,
                    const MetricRegistry& registry = standardRegistry());
  /// Events before the sample of their time, in order.
  void note(double time, const sim2d::Event& event);
  void add(Sample sample);
  /// Error when the record or the window holds no sample. With `sink` the results among all people
  /// have no series: it takes them.
  base::Result<Evaluation> finish(const SeriesSink& sink = {}) const;

 private:
  static constexpr std::size_t kBehaviors = 6;
  struct Behavior {
    std::unique_ptr<SampleFeed> feed;
    bool isMet = false;          // somebody of the type was there
    std::vector<double> active;  // 0/1 per sample
  };
  void addToBehaviors(Sample& sample, const OnWay& onWay);
  void markNew(Sample& sample);
  bool isOnWay(double time) const;
  OnWay onWayOf(const Sample& sample);
  bool isWholeRecord() const;
  bool isOriginal() const { return parameters_.profile == Profile::Hunav2; }

  std::shared_ptr<const RunContext> context_;
  Selection selection_;
  MetricParameters parameters_;
  WindowGate gate_;
  std::vector<double> times_;  // of the samples taken, from the first [s], with series
  double first_ = 0.0;
  bool hasSamples_ = false;        // of the record, taken or not
  bool isOver_ = false;            // no more samples will be taken
  std::optional<double> arrival_;  // of the robot [s]
  bool isAtGoal_ = false;          // a sample at or after the arrival was taken
  std::optional<double> setOff_;   // first sample of the way [s]
  bool hasMoved_ = false;          // on the way
  std::set<int> entered_;          // people, since the newest sample that was taken
  SampleFeed all_;
  std::array<Behavior, kBehaviors> behaviors_;  // of types 1..6; no feed: not wanted
};

/// The same from frames, as the world makes them or as a recording gives them.
class FrameEvaluation {
 public:
  FrameEvaluation(const sim2d::TraceHeader& header, const Selection& selection,
                  const MetricParameters& parameters);
  /// People that arrived since the header was made; before the first frame with them.
  void addHumans(const std::vector<sim2d::TraceHuman>& humans) { builder_.addHumans(humans); }
  void note(double time, const sim2d::Event& event) { evaluation_.note(time, event); }
  void append(const sim2d::Frame& frame) { evaluation_.add(builder_.sampleOf(frame)); }
  base::Result<Evaluation> finish(const SeriesSink& sink = {}) const {
    return evaluation_.finish(sink);
  }
  /// So far; empty before the first sample.
  std::vector<MetricResult> values() const {
    base::Result<Evaluation> evaluation = finish();
    return evaluation ? std::move(evaluation->results) : std::vector<MetricResult>();
  }

 private:
  SampleBuilder builder_;
  RunningEvaluation evaluation_;
};

}  // namespace metrics
