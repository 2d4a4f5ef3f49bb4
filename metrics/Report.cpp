#include "metrics/Report.h"

#include <cmath>
#include <set>

#include "metrics/RunningEvaluation.h"

namespace metrics {

bool Selection::selects(const MetricInfo& info) const {
  if (!keys) {
    return true;
  }
  const std::string& key = info.partOf.empty() ? info.key : info.partOf;
  const bool isHunav = info.hunav > 0 || !info.partOf.empty();
  return isHunav ? keys->off.count(key) == 0 : keys->on.count(key) > 0;
}

std::vector<MetricEntry> Selection::entries(const MetricRegistry& registry) const {
  std::vector<MetricEntry> selected;
  for (const MetricEntry& entry : registry.entries()) {
    if (selects(entry.info)) {
      selected.push_back(entry);
    }
  }
  selected.insert(selected.end(), own.begin(), own.end());
  return selected;
}

const MetricResult* Evaluation::find(std::string_view key) const {
  return findResult(results, key);
}

const MetricResult* findResult(const std::vector<MetricResult>& results, std::string_view key) {
  for (const MetricResult& result : results) {
    if (result.info.key == key) {
      return &result;
    }
  }
  return nullptr;
}

namespace {

/// Feeds the events up to a time; `next` = the first one that was not fed.
template <class Evaluation, class Event, class TimeOf>
void noteUntil(double time, const std::vector<Event>& events, std::size_t& next, TimeOf timeOf,
               Evaluation& to) {
  for (; next < events.size() && timeOf(events[next]) <= time + kTimeSlack; ++next) {
    to.note(timeOf(events[next]), events[next].second);
  }
}

double timeOfEvent(const std::pair<double, sim2d::Event>& event) {
  return event.first;
}

}  // namespace

MetricValue valueOf(const MetricEntry& entry, const SampledRun& recording,
                    const MetricParameters& parameters, const MetricRegistry& registry) {
  Selection selection;
  if (const MetricEntry* sum = registry.find(entry.meanOf)) {
    selection.own.push_back(*sum);
  }
  selection.own.push_back(entry);
  SampleFeed feed(std::make_shared<const RunContext>(recording), selection, parameters, {});
  std::size_t next = 0;
  for (const Sample& sample : recording.samples) {
    noteUntil(sample.time, recording.events, next, timeOfEvent, feed);
    feed.add(sample);
  }
  return feed.values().back().value;
}

base::Result<Evaluation> evaluate(const SampledRun& recording, const Selection& selection,
                                  const MetricParameters& parameters,
                                  const MetricRegistry& registry) {
  RunningEvaluation evaluation(recording, selection, parameters, registry);
  std::size_t next = 0;
  for (const Sample& sample : recording.samples) {
    noteUntil(sample.time, recording.events, next, timeOfEvent, evaluation);
    evaluation.add(sample);
  }
  noteUntil(HUGE_VAL, recording.events, next, timeOfEvent, evaluation);
  return evaluation.finish();
}

base::Result<Evaluation> evaluate(const sim2d::Trace& trace, const Selection& selection,
                                  const MetricParameters& parameters) {
  FrameEvaluation evaluation(trace.header, selection, parameters);
  std::size_t next = 0;
  const auto timeOf = [&trace](const auto& event) {
    return static_cast<double>(event.first) * trace.header.dt;
  };
  for (const sim2d::Frame& frame : trace.frames) {
    noteUntil(frame.time, trace.events, next, timeOf, evaluation);
    evaluation.append(frame);
  }
  noteUntil(HUGE_VAL, trace.events, next, timeOf, evaluation);
  return evaluation.finish();
}

}  // namespace metrics
