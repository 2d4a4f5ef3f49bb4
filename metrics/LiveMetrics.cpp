#include "metrics/LiveMetrics.h"

#include <utility>

#include "metrics/MetricSums.h"

namespace metrics {

struct LiveMetrics::State {
  SampleBuilder builder;
  SampleFeed feed;
};

LiveMetrics::LiveMetrics(const sim2d::TraceHeader& header, const Selection& selection,
                         const MetricParameters& parameters, const MetricRegistry& registry) {
  SampleBuilder builder(header, selection.robotId);
  SampleFeed feed(std::make_shared<const RunContext>(builder.context()), selection, parameters,
                  registry);
  state_ = std::make_unique<State>(State{std::move(builder), std::move(feed)});
}

LiveMetrics::~LiveMetrics() = default;

void LiveMetrics::addHumans(const std::vector<sim2d::TraceHuman>& humans) {
  state_->builder.addHumans(humans);
}

void LiveMetrics::note(double time, const sim2d::Event& event) {
  state_->feed.note(time, event);
}

void LiveMetrics::append(const sim2d::Frame& frame) {
  state_->feed.add(state_->builder.sampleOf(frame));
}

std::size_t LiveMetrics::size() const {
  return state_->feed.size();
}

std::vector<MetricResult> LiveMetrics::values() const {
  return size() == 0 ? std::vector<MetricResult>() : state_->feed.values();
}

}  // namespace metrics
