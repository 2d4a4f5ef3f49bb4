#include "app/bridge/live/RunMetrics.h"

#include <algorithm>
#include <cmath>

#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/Definition.h"

namespace live {

namespace {

struct Float64 {
  static constexpr const char* kType = "std_msgs/msg/Float64";

  double data = 0;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("data", self.data);
  }
};

/// Values so far, of everybody; nothing that grows with the run.
metrics::Selection soFar(metrics::Selection selection) {
  selection.window = {};
  selection.series = selection.seriesOnDisk = false;
  selection.behaviors = selection.behaviorSeries = false;
  selection.everyRobot = false;
  return selection;
}

}  // namespace

RunMetrics::RunMetrics(const sim2d::TraceHeader& header, const metrics::Selection& selection,
                       const metrics::MetricParameters& parameters)
    : evaluation_(header, soFar(selection), parameters) {
  for (const metrics::MetricEntry& entry : selection.entries(metrics::standardRegistry())) {
    channelOf_[entry.info.key] = channels_.size();
    channels_.push_back({"/hunavsim/metrics/" + entry.info.key, Float64::kType,
                         bridge::definition<Float64>(), false});
  }
}

void RunMetrics::add(const sim2d::Frame& frame, const std::function<sim2d::TraceHeader()>& header) {
  const std::vector<int>& ids = frame.humans.id;
  if (!std::all_of(ids.begin(), ids.end(), [this](int id) { return known_.count(id) > 0; })) {
    const sim2d::TraceHeader now = header();
    evaluation_.addHumans(now.humans);
    for (const sim2d::TraceHuman& human : now.humans) {
      known_.insert(human.id);
    }
  }
  for (const sim2d::Event& event : frame.events) {
    evaluation_.note(frame.time, event);
  }
  evaluation_.append(frame);
}

void RunMetrics::tell(const std::function<void(std::size_t, std::string&&)>& tell) const {
  for (const metrics::MetricResult& result : evaluation_.values()) {
    const auto channel = channelOf_.find(result.info.key);
    if (channel != channelOf_.end() && result.value.value) {
      tell(channel->second, bridge::encode(Float64{*result.value.value}));
    }
  }
}

}  // namespace live
