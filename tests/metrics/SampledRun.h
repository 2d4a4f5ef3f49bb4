#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "metrics/IncrementalEvaluation.h"

/// Whole records by samples instead of frames.
namespace metrics {

/// A run with all its samples, in time order.
struct SampledRun : RunContext {
  std::vector<Sample> samples;
  std::vector<std::pair<double, sim2d::Event>> events;  // time [s], all events of the run
};

inline SampledRun sampledRunOf(const sim2d::Trace& trace, int robotId = -1) {
  SampleBuilder builder(trace.header, robotId);
  SampledRun recording;
  static_cast<RunContext&>(recording) = builder.context();
  for (const sim2d::Frame& frame : trace.frames) {
    recording.samples.push_back(builder.sampleOf(frame));
  }
  for (const auto& [step, event] : trace.events) {
    recording.events.emplace_back(static_cast<double>(step) * trace.header.dt, event);
  }
  return recording;
}

inline base::Result<Evaluation> evaluate(const SampledRun& recording, const Selection& selection,
                                         const MetricParameters& parameters,
                                         const MetricRegistry& registry = standardRegistry()) {
  IncrementalEvaluation evaluation(recording, selection, parameters, registry);
  auto event = recording.events.begin();
  const auto noteUntil = [&](double time) {
    for (; event != recording.events.end() && event->first <= time + kTimeSlack; ++event) {
      evaluation.note(event->first, event->second);
    }
  };
  for (const Sample& sample : recording.samples) {
    noteUntil(sample.time);
    evaluation.add(sample);
  }
  noteUntil(HUGE_VAL);
  return evaluation.finish();
}

/// One metric of a record with samples.
inline MetricValue valueOf(const MetricEntry& entry, const SampledRun& recording,
                           const MetricParameters& parameters) {
  Selection selection;
  selection.behaviors = false;
  if (const MetricEntry* sum = standardRegistry().find(entry.info.partOf)) {
    selection.own.push_back(*sum);
  }
  selection.own.push_back(entry);
  return evaluate(recording, selection, parameters, MetricRegistry())->results.back().value;
}

}  // namespace metrics
