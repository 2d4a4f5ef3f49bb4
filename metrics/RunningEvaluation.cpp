#include "metrics/RunningEvaluation.h"

#include <algorithm>
#include <utility>

#include "sim2d/base/Problems.h"

namespace metrics {

namespace {

std::shared_ptr<const RunContext> withReference(RunContext context, const Selection& selection) {
  if (!selection.reference.empty()) {
    context.reference = selection.reference;
  }
  return std::make_shared<const RunContext>(std::move(context));
}

Selection amongSome(Selection selection) {
  selection.series = selection.behaviorSeries;
  selection.seriesOnDisk = false;
  return selection;
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

RunningEvaluation::RunningEvaluation(const RunContext& context, const Selection& selection,
                                     const MetricParameters& parameters,
                                     const MetricRegistry& registry)
    : context_(withReference(context, selection)),
      selection_(selection),
      parameters_(parameters),
      registry_(registry),
      gate_(selection.window, context),
      all_(context_, selection, parameters, registry) {
  if (selection.behaviors) {
    beginBehaviors();
  }
}

/// All at once: who comes late was not there before.
void RunningEvaluation::beginBehaviors() {
  const Selection selection = amongSome(selection_);
  for (Behavior& behavior : behaviors_) {
    behavior.feed = std::make_unique<SampleFeed>(context_, selection, parameters_, registry_,
                                                 Among::SomePeople);
  }
}

void RunningEvaluation::note(double time, const sim2d::Event& event) {
  gate_.note(time, event);
  if (!isOver_) {
    all_.note(time, event);
  }
}

void RunningEvaluation::addToBehaviors(Sample& sample) {
  const bool anyActive = isActive(sample);
  const std::array<std::size_t, kBehaviors> counts = countBehaviors<kBehaviors>(sample);
  for (std::size_t k = 0; k < kBehaviors; ++k) {
    Behavior& behavior = behaviors_[k];
    behavior.isMet = behavior.isMet || counts[k] > 0;
    // The original leaves out types that are missing at any sample.
    if (isOriginal() && counts[k] == 0) {
      behavior.feed.reset();
    }
    if (!behavior.feed) {
      continue;
    }
    Sample part = takePeople(sample, static_cast<int>(k) + 1, counts[k]);
    if (selection_.behaviorSeries) {
      // Of the people of this type; the original looks at everybody.
      behavior.active.push_back((isOriginal() ? anyActive : isActive(part)) ? 1.0 : 0.0);
    }
    behavior.feed->add(std::move(part));
  }
}

void RunningEvaluation::add(Sample sample) {
  hasSamples_ = true;
  if (!gate_.takes(sample)) {
    isOver_ = gate_.isOver(sample.time);
    if (all_.size() == 0 || isOver_) {
      all_.forgetEvents();
    }
    return;
  }
  first_ = all_.size() == 0 ? sample.time : first_;
  if (selection_.series) {
    times_.push_back(sample.time - first_);
  }
  all_.add(std::move(sample));
  if (selection_.behaviors) {
    addToBehaviors(all_.newest());
  }
}

base::Result<Evaluation> RunningEvaluation::finish(const SeriesSink& sink) const {
  if (!hasSamples_) {
    return base::error("metrics.no-samples");
  }
  if (const std::optional<base::Diagnostic> wrong = windowProblem(selection_.window)) {
    return base::within("metrics", *wrong);
  }
  if (all_.size() == 0) {
    return base::error("metrics.empty-window", {selection_.window.from, selection_.window.until});
  }
  Evaluation evaluation;
  evaluation.parameters = parameters_;
  evaluation.tag = selection_.tag;
  evaluation.runId = selection_.runId;
  evaluation.isSelection = selection_.keys.has_value();
  evaluation.times = times_;
  evaluation.results = all_.values(nullptr, sink);
  if (all_.hasLostSeries()) {
    return base::error("metrics.series-lost");
  }
  for (std::size_t k = 0; k < kBehaviors; ++k) {
    if (!behaviors_[k].feed || !behaviors_[k].isMet) {
      continue;
    }
    BehaviorEvaluation behavior{static_cast<int>(k) + 1, behaviors_[k].active,
                                behaviors_[k].feed->values(&evaluation.results)};
    if (isOriginal() && selection_.behaviorSeries) {
      fillLeftOvers(behavior.results, evaluation.results);
    }
    evaluation.behaviors.push_back(std::move(behavior));
  }
  return evaluation;
}

FrameEvaluation::FrameEvaluation(const sim2d::TraceHeader& header, const Selection& selection,
                                 const MetricParameters& parameters)
    : builder_(header, selection.robotId), evaluation_(builder_.context(), selection, parameters) {}

}  // namespace metrics
