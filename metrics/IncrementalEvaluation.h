#pragma once

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "metrics/AccumulatorSet.h"
#include "metrics/ShortestPaths.h"

namespace metrics {

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
