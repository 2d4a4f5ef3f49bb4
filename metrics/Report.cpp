#include "metrics/Report.h"

#include <algorithm>
#include <set>

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

constexpr int kBehaviors = 6;

base::Result<Selection> checked(const Selection& selection) {
  if (const std::string problem = windowProblem(selection.window); !problem.empty()) {
    return base::makeError("metrics: " + problem);
  }
  return selection;
}

bool hasBehavior(const Sample& sample, int behavior) {
  return std::any_of(sample.people.begin(), sample.people.end(),
                     [behavior](const Person& person) { return person.behavior == behavior; });
}

/// Of the people of this type; the original looks at everybody.
std::vector<double> activeSeries(const Recording& people) {
  std::vector<double> active;
  for (const Sample& sample : people.samples) {
    active.push_back(std::any_of(sample.people.begin(), sample.people.end(),
                                 [](const Person& person) { return person.state != 0; })
                         ? 1.0
                         : 0.0);
  }
  return active;
}

/// The original writes the series of the pass over all people when a metric has none of its own.
void fillLeftOvers(std::vector<MetricResult>& results, const std::vector<MetricResult>& all) {
  for (std::size_t k = 0; k < results.size(); ++k) {
    if (!results[k].value.series) {
      results[k].value.series = all[k].value.series;
    }
  }
}

class BehaviorPass {
 public:
  BehaviorPass(const Recording& recording, const Selection& selection,
               const MetricParameters& parameters, const MetricRegistry& registry)
      : recording_(recording),
        selection_(selection),
        parameters_(parameters),
        registry_(registry) {}

  bool isPresent(int behavior) const {
    const auto has = [behavior](const Sample& sample) { return hasBehavior(sample, behavior); };
    const std::vector<Sample>& samples = recording_.samples;
    return parameters_.profile == Profile::Hunav2
               ? std::all_of(samples.begin(), samples.end(), has)
               : std::any_of(samples.begin(), samples.end(), has);
  }

  BehaviorEvaluation run(int behavior, const std::vector<MetricResult>& all) const {
    const Recording part = withBehavior(recording_, behavior);
    const bool original = parameters_.profile == Profile::Hunav2;
    BehaviorEvaluation evaluation;
    evaluation.behavior = behavior;
    evaluation.active = activeSeries(original ? recording_ : part);
    evaluation.results = computeMetrics(part, selection_, parameters_, registry_);
    if (original) {
      fillLeftOvers(evaluation.results, all);
    }
    return evaluation;
  }

 private:
  const Recording& recording_;
  const Selection& selection_;
  const MetricParameters& parameters_;
  const MetricRegistry& registry_;
};

}  // namespace

std::vector<MetricResult> computeMetrics(const Recording& recording, const Selection& selection,
                                         const MetricParameters& parameters,
                                         const MetricRegistry& registry) {
  std::vector<MetricResult> results;
  for (const MetricEntry& entry : selection.entries(registry)) {
    const MetricResult* sum = entry.meanOf.empty() ? nullptr : findResult(results, entry.meanOf);
    if (entry.info.needs.robot && !recording.hasRobot) {
      results.push_back({entry.info, undefinedValue("there is no robot")});
    } else if (sum != nullptr) {
      results.push_back({entry.info, meanOver(sum->value, recording.size())});
    } else {
      results.push_back({entry.info, entry.compute(recording, parameters)});
    }
  }
  return results;
}

base::Result<Evaluation> evaluate(const Recording& recording, const Selection& selection,
                                  const MetricParameters& parameters,
                                  const MetricRegistry& registry) {
  if (recording.samples.empty()) {
    return base::makeError("the record has no samples, so there is nothing to measure");
  }
  const base::Result<Selection> valid = checked(selection);
  if (!valid) {
    return valid.diagnostics();
  }
  const Window whole;
  const bool isWhole = selection.window.from == whole.from &&
                       selection.window.until == whole.until && selection.window.frequency <= 0.0;
  const Recording window = isWhole ? Recording{} : cut(recording, selection.window);
  const Recording& part = isWhole ? recording : window;
  if (part.samples.empty()) {
    return base::makeError("no sample lies between '" + selection.window.from + "' and '" +
                           selection.window.until + "'");
  }
  Evaluation evaluation;
  evaluation.parameters = parameters;
  evaluation.tag = selection.tag;
  evaluation.runId = selection.runId;
  for (const Sample& sample : part.samples) {
    evaluation.times.push_back(sample.time - part.samples.front().time);
  }
  evaluation.results = computeMetrics(part, selection, parameters, registry);
  const BehaviorPass pass(part, selection, parameters, registry);
  for (int behavior = 1; behavior <= kBehaviors; ++behavior) {
    if (pass.isPresent(behavior)) {
      evaluation.behaviors.push_back(pass.run(behavior, evaluation.results));
    }
  }
  return evaluation;
}

base::Result<Evaluation> evaluate(const sim2d::Trace& trace, const Selection& selection,
                                  const MetricParameters& parameters) {
  return evaluate(recordingOf(trace, selection.robotId), selection, parameters, standardRegistry());
}

}  // namespace metrics
