#pragma once

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "metrics/Routes.h"
#include "metrics/SampleFeed.h"

namespace metrics {

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

/// The names of the robots, each once and such that files can be called by them.
std::vector<std::string> robotNames(const std::vector<sim2d::TraceRobot>& robots);

/// Takes the series of results, which then have none, with the name of the robot.
using RobotSeriesSink =
    std::function<void(const std::string& robot, const MetricInfo& info, const Series& series)>;

/// The same from frames, as the world makes them or as a recording gives them; of one robot or, if
/// the selection asks for it, of each.
class FrameEvaluation {
 public:
  FrameEvaluation(const sim2d::TraceHeader& header, const Selection& selection,
                  const MetricParameters& parameters, const KnownScene& known = {});
  /// People that arrived since the header was made; before the first frame with them.
  void addHumans(const std::vector<sim2d::TraceHuman>& humans);
  void note(double time, const sim2d::Event& event);
  void append(const sim2d::Frame& frame);
  base::Result<Evaluation> finish(const RobotSeriesSink& sink = {}) const;
  /// So far; empty before the first sample.
  std::vector<MetricResult> values() const {
    base::Result<Evaluation> evaluation = robots_.front().finish({});
    return evaluation ? std::move(evaluation->results) : std::vector<MetricResult>();
  }

 private:
  struct OfRobot {
    OfRobot(std::string its, const sim2d::TraceHeader& header, const Selection& selection,
            const MetricParameters& parameters, const KnownScene& known);
    base::Result<Evaluation> finish(const RobotSeriesSink& sink) const;
    Evaluation without(const Evaluation& first, const base::Diagnostics& why) const;

    std::string name;
    int id;
    SampleBuilder builder;
    RunningEvaluation running;
  };
  std::vector<OfRobot> robots_;  // the selection's first, which is there without a robot too
};

}  // namespace metrics
