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
  /// The samples that were held back were not the end: the robot has arrived, at this time [s].
  void noteArrival(double time);
  std::size_t size() const { return all_.count; }
  Sample& newest() { return *all_.now; }
  /// `all`: results among all people; those that do not look at people are taken over.
  std::vector<MetricResult> values(const std::vector<MetricResult>* all = nullptr,
                                   const SeriesSink& sink = {}) const;
  /// Shortest paths for the robot's way, as far as selected keys need them.
  ShortestWays shortestWays() const;
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
    double begin = 0.0;         // [s]
    Vec2 start = Vec2::Zero();  // of the robot
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
  const Stretch& wholeWay() const { return toGoal_ ? *toGoal_ : (inTime_ ? *inTime_ : way_); }
  bool selectsOne(std::initializer_list<std::string_view> keys) const;
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
  std::optional<double> arrival_;  // of the robot [s]
  std::vector<Noted> noted_;       // since the newest sample
};

}  // namespace metrics
