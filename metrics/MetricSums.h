#pragma once

#include <memory>
#include <vector>

#include "metrics/Report.h"

namespace metrics {

/// The metrics of a selection, fed sample by sample. One thread at a time.
class MetricSums {
 public:
  MetricSums(const Selection& selection, const MetricParameters& parameters, bool hasRobot,
             const MetricRegistry& registry);
  /// The newest sample of the recording.
  void add(const Recording& recording, std::size_t sample);
  /// `all`: results among all people; those that do not look at people are taken over.
  std::vector<MetricResult> values(const Recording& recording,
                                   const std::vector<MetricResult>* all = nullptr) const;
  /// Some metric reads the people of the whole record at the end.
  bool needsAllPeople() const;
  bool needsMap() const;

 private:
  struct Item {
    MetricEntry entry;
    const Accumulator* sum = nullptr;  // one of sums_
  };
  MetricValue valueOf(const Item& item, const Recording& recording,
                      const std::vector<MetricResult>& before) const;

  MetricParameters parameters_;
  bool hasRobot_;
  bool keepsSeries_;
  std::vector<Item> items_;
  std::vector<std::unique_ptr<Accumulator>> sums_;
};

/// A recording that grows and its metrics. People are forgotten when the next sample but one comes,
/// unless a metric needs them to the end: what stays of a sample is the robot.
class SampleFeed {
 public:
  SampleFeed(Recording empty, const Selection& selection, const MetricParameters& parameters,
             const MetricRegistry& registry);
  void add(Sample sample);
  void note(double time, const sim2d::Event& event);
  const Recording& recording() const { return recording_; }
  Sample& newest() { return recording_.samples.back(); }
  std::vector<MetricResult> values(const std::vector<MetricResult>* all = nullptr) const;

 private:
  Recording recording_;
  MetricSums sums_;
  MetricParameters parameters_;
  bool keepsPeople_, looks_;
};

}  // namespace metrics
