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

base::Result<Evaluation> evaluate(const sim2d::Trace& trace, const Selection& selection,
                                  const MetricParameters& parameters) {
  FrameEvaluation evaluation(trace.header, selection, parameters);
  auto event = trace.events.begin();
  const auto noteUntil = [&](double time) {
    for (; event != trace.events.end(); ++event) {
      const double itsTime = static_cast<double>(event->first) * trace.header.dt;
      if (itsTime > time + kTimeSlack) {
        return;
      }
      evaluation.note(itsTime, event->second);
    }
  };
  for (const sim2d::Frame& frame : trace.frames) {
    noteUntil(frame.time);
    evaluation.append(frame);
  }
  noteUntil(HUGE_VAL);
  return evaluation.finish();
}

}  // namespace metrics
