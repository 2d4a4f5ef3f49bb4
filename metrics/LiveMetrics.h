#pragma once

#include <memory>
#include <vector>

#include "metrics/Report.h"

namespace metrics {

/// Values while the run goes on: at every moment those that evaluate() gives for the same frames
/// (without window). One thread at a time.
class LiveMetrics {
 public:
  LiveMetrics(const sim2d::TraceHeader& header, const Selection& selection,
              const MetricParameters& parameters,
              const MetricRegistry& registry = standardRegistry());
  ~LiveMetrics();
  LiveMetrics(const LiveMetrics&) = delete;
  LiveMetrics& operator=(const LiveMetrics&) = delete;
  LiveMetrics(LiveMetrics&&) = delete;
  LiveMetrics& operator=(LiveMetrics&&) = delete;

  /// People that arrived since the header was made; before the first frame with them.
  void addHumans(const std::vector<sim2d::TraceHuman>& humans);
  /// Events before the first frame of their time or a later one, in order.
  void note(double time, const sim2d::Event& event);
  void append(const sim2d::Frame& frame);
  std::size_t size() const;  // frames so far
  /// Empty before the first frame.
  std::vector<MetricResult> values() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace metrics
