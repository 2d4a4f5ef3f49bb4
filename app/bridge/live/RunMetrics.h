#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/bridge/live/FoxgloveServer.h"
#include "metrics/RunningEvaluation.h"

namespace live {

/// The metrics of a run so far, each as a number on a topic of its own
/// (`/hunavsim/metrics/minimum_distance`, std_msgs/msg/Float64), which Foxglove and PlotJuggler
/// plot as they are. Those that are undefined so far are not told. Thread: one at a time.
class RunMetrics {
 public:
  RunMetrics(const sim2d::TraceHeader& header, const metrics::Selection& selection,
             const metrics::MetricParameters& parameters);

  const std::vector<Channel>& channels() const { return channels_; }
  /// Each state once, in order. `header`: asked for when somebody is new.
  void add(const sim2d::Frame& frame, const std::function<sim2d::TraceHeader()>& header);
  /// Calls tell(number of the channel in `channels`, message) for those that have a value.
  void tell(const std::function<void(std::size_t, std::string&&)>& tell) const;

 private:
  metrics::FrameEvaluation evaluation_;
  std::vector<Channel> channels_;
  std::map<std::string, std::size_t> channelOf_;  // by key
  std::set<int> known_;
};

}  // namespace live
