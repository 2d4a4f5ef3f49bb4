#include "metrics/LiveMetrics.h"

#include <utility>

namespace metrics {

/// The metrics of the selection; costly ones with their sums so far.
struct LiveMetrics::State {
  struct Live {
    MetricEntry entry;
    std::unique_ptr<Accumulator> sum;  // null: computed when asked
  };

  RecordingBuilder builder;
  Recording recording;
  MetricParameters parameters;
  std::vector<Live> metrics;

  bool isMeasurable(const MetricInfo& info) const {
    return recording.hasRobot || !info.needs.robot;
  }
};

LiveMetrics::LiveMetrics(const sim2d::TraceHeader& header, const Selection& selection,
                         const MetricParameters& parameters, const MetricRegistry& registry)
    : state_(std::make_unique<State>(
          State{RecordingBuilder(header, selection.robotId), {}, parameters, {}})) {
  state_->recording = state_->builder.emptyRecording();
  for (const MetricEntry& entry : selection.entries(registry)) {
    const bool sums = entry.accumulate && state_->isMeasurable(entry.info);
    state_->metrics.push_back({entry, sums ? entry.accumulate(parameters) : nullptr});
  }
}

LiveMetrics::~LiveMetrics() = default;

void LiveMetrics::addHumans(const std::vector<sim2d::TraceHuman>& humans) {
  state_->builder.addHumans(humans);
}

void LiveMetrics::append(const sim2d::Frame& frame) {
  Recording& recording = state_->recording;
  recording.samples.push_back(state_->builder.sampleOf(frame));
  for (const sim2d::Event& event : frame.events) {
    recording.events.emplace_back(frame.time, event);
  }
  for (State::Live& metric : state_->metrics) {
    if (metric.sum) {
      metric.sum->add(recording, recording.size() - 1);
    }
  }
}

std::size_t LiveMetrics::size() const {
  return state_->recording.size();
}

std::vector<MetricResult> LiveMetrics::values() const {
  std::vector<MetricResult> results;
  if (state_->recording.samples.empty()) {
    return results;
  }
  for (const State::Live& metric : state_->metrics) {
    const MetricInfo& info = metric.entry.info;
    const std::string& meanOf = metric.entry.meanOf;
    const MetricResult* sum = meanOf.empty() ? nullptr : findResult(results, meanOf);
    if (!state_->isMeasurable(info)) {
      results.push_back({info, undefinedValue("there is no robot")});
    } else if (sum != nullptr) {
      results.push_back({info, meanOver(sum->value, state_->recording.size())});
    } else if (metric.sum) {
      results.push_back({info, metric.sum->value(state_->recording)});
    } else {
      results.push_back({info, metric.entry.compute(state_->recording, state_->parameters)});
    }
  }
  return results;
}

}  // namespace metrics
