#include "metrics/RunningEvaluation.h"

#include <algorithm>
#include <utility>

namespace metrics {

namespace {

Recording withReference(Recording empty, const Selection& selection) {
  if (!selection.reference.empty()) {
    empty.reference = selection.reference;
  }
  return empty;
}

/// How many people there are of each type.
template <std::size_t kCount>
std::array<std::size_t, kCount> countBehaviors(const Sample& sample) {
  std::array<std::size_t, kCount> counts{};
  for (const Person& person : sample.people) {
    if (person.behavior >= 1 && person.behavior <= static_cast<int>(kCount)) {
      ++counts[static_cast<std::size_t>(person.behavior) - 1];
    }
  }
  return counts;
}

bool isActive(const Sample& sample) {
  return std::any_of(sample.people.begin(), sample.people.end(),
                     [](const Person& person) { return person.state != 0; });
}

/// Without the people of other types. The obstacle points go along and are not left behind.
Sample takePeople(Sample& sample, int behavior, std::size_t count) {
  Sample part;
  part.people.reserve(count);
  part.time = sample.time;
  part.robot = sample.robot;
  for (Person& person : sample.people) {
    if (person.behavior == behavior) {
      std::vector<ObstaclePoint> points = std::move(person.obstacles);
      person.obstacles.clear();
      part.people.push_back(person);
      part.people.back().obstacles = std::move(points);
    }
  }
  return part;
}

/// The original writes the series of the pass over all people when a metric has none of its own.
void fillLeftOvers(std::vector<MetricResult>& results, const std::vector<MetricResult>& all) {
  for (std::size_t k = 0; k < results.size(); ++k) {
    if (!results[k].value.series) {
      results[k].value.series = all[k].value.series;
    }
  }
}

}  // namespace

RunningEvaluation::RunningEvaluation(const Recording& empty, const Selection& selection,
                                     const MetricParameters& parameters,
                                     const MetricRegistry& registry)
    : empty_(withReference(empty, selection)),
      selection_(selection),
      parameters_(parameters),
      registry_(registry),
      gate_(selection.window, empty),
      all_(empty_, selection, parameters, registry) {}

void RunningEvaluation::note(double time, const sim2d::Event& event) {
  gate_.note(time, event);
  all_.note(time, event);
}

/// With the samples before the newest one, in which nobody of the type was there.
void RunningEvaluation::begin(std::size_t behavior) {
  Behavior& made = behaviors_[behavior];
  made.feed = std::make_unique<SampleFeed>(empty_, selection_, parameters_, registry_);
  const std::vector<Sample>& samples = all_.recording().samples;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    Sample nobody;
    nobody.time = samples[i].time;
    nobody.robot = samples[i].robot;
    made.feed->add(std::move(nobody));
    made.active.push_back(0.0);
  }
}

void RunningEvaluation::addToBehaviors(Sample& sample) {
  const bool anyActive = isActive(sample);
  const std::array<std::size_t, kBehaviors> counts = countBehaviors<kBehaviors>(sample);
  for (std::size_t k = 0; k < kBehaviors; ++k) {
    const int type = static_cast<int>(k) + 1;
    Behavior& behavior = behaviors_[k];
    const bool isPresent = counts[k] > 0;
    // The original leaves out types that are missing at any sample.
    if (isOriginal() && !isPresent) {
      behavior.feed.reset();
    } else if (isPresent && !behavior.feed && (!isOriginal() || times_.size() == 1)) {
      begin(k);
    }
    if (behavior.feed) {
      Sample part = takePeople(sample, type, counts[k]);
      // Of the people of this type; the original looks at everybody.
      behavior.active.push_back((isOriginal() ? anyActive : isActive(part)) ? 1.0 : 0.0);
      behavior.feed->add(std::move(part));
    }
  }
}

void RunningEvaluation::add(Sample sample) {
  hasSamples_ = true;
  if (!gate_.takes(sample)) {
    return;
  }
  first_ = times_.empty() ? sample.time : first_;
  times_.push_back(sample.time - first_);
  all_.add(std::move(sample));
  if (!selection_.totalsOnly) {
    addToBehaviors(all_.newest());
  }
}

base::Result<Evaluation> RunningEvaluation::finish() const {
  if (!hasSamples_) {
    return base::makeError("the record has no samples, so there is nothing to measure");
  }
  if (const std::string problem = windowProblem(selection_.window); !problem.empty()) {
    return base::makeError("metrics: " + problem);
  }
  if (times_.empty()) {
    return base::makeError("no sample lies between '" + selection_.window.from + "' and '" +
                           selection_.window.until + "'");
  }
  Evaluation evaluation;
  evaluation.parameters = parameters_;
  evaluation.tag = selection_.tag;
  evaluation.runId = selection_.runId;
  evaluation.isSelection = selection_.keys.has_value();
  evaluation.times = times_;
  evaluation.results = all_.values();
  for (std::size_t k = 0; k < kBehaviors; ++k) {
    if (!behaviors_[k].feed) {
      continue;
    }
    BehaviorEvaluation behavior{static_cast<int>(k) + 1, behaviors_[k].active,
                                behaviors_[k].feed->values(&evaluation.results)};
    if (isOriginal()) {
      fillLeftOvers(behavior.results, evaluation.results);
    }
    for (std::size_t i = 0; !selection_.behaviorSeries && i < behavior.results.size(); ++i) {
      behavior.results[i].value.series.reset();
    }
    evaluation.behaviors.push_back(std::move(behavior));
  }
  return evaluation;
}

FrameEvaluation::FrameEvaluation(const sim2d::TraceHeader& header, const Selection& selection,
                                 const MetricParameters& parameters)
    : builder_(header, selection.robotId),
      evaluation_(builder_.emptyRecording(), selection, parameters) {}

}  // namespace metrics
