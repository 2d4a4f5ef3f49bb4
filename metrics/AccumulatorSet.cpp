#include <algorithm>
#include <utility>

#include "metrics/IncrementalEvaluation.h"

namespace metrics {

namespace {

bool needsPeople(const MetricInfo& info) {
  return info.needs.people || info.needs.groups;
}

}  // namespace

AccumulatorSet::AccumulatorSet(std::shared_ptr<const RunContext> context,
                               const Selection& selection, const MetricParameters& parameters,
                               const MetricRegistry& registry, PeopleFilter among)
    : context_(std::move(context)),
      parameters_(parameters),
      keepsSeries_(selection.series),
      store_(selection.seriesOnDisk ? std::make_unique<SeriesStorage>() : nullptr) {
  for (MetricEntry& entry : selection.entries(registry)) {
    addItem(std::move(entry), among);
  }
}

void AccumulatorSet::addItem(MetricEntry entry, PeopleFilter among) {
  Item item{std::move(entry)};
  const MetricInfo& info = item.entry.info;
  const MetricComputation& computation = item.entry.computation;
  const bool isAsked = among == PeopleFilter::All || needsPeople(info);
  if (computation.make && isAsked && (context_->hasRobot || !info.needs.robot)) {
    SampleRange& stretch = info.needs.robot ? path_ : all_;
    std::shared_ptr<Accumulator>& sum = stretch.sums[computation.shared];
    if (!sum) {
      sum = computation.make(parameters_);
    }
    item.hasSum = true;
  }
  needsMap_ = needsMap_ || info.needs.map;
  items_.push_back(std::move(item));
}

Instant AccumulatorSet::newestInstant(const SampleRange& stretch, TermCache* memory) const {
  const bool isArrived = arrival_ && *arrival_ <= stretch.now->time + kTimeSlack;
  return {*context_,
          parameters_,
          *stretch.now,
          stretch.before.get(),
          stretch.earlier.get(),
          stretch.count - 1,
          stretch.begin,
          isArrived ? arrival_ : std::nullopt,
          keepsSeries_,
          store_.get(),
          memory};
}

/// Passes the events up to the newest sample; later events wait for the next sample.
void AccumulatorSet::deliverEvents() {
  const double now = all_.now->time + kTimeSlack;
  const auto later = std::find_if(pendingEvents_.begin(), pendingEvents_.end(),
                                  [now](const PendingEvent& noted) { return noted.time > now; });
  const auto pass = [&](const SampleRange& stretch, const PendingEvent& noted) {
    if (stretch.count > 0 && noted.time >= stretch.begin - kTimeSlack) {
      for (const auto& [shared, sum] : stretch.sums) {
        sum->note(*context_, noted.time - stretch.begin, noted.event);
      }
    }
  };
  for (auto noted = pendingEvents_.begin(); noted != later; ++noted) {
    pass(all_, *noted);
    if (noted->isOnPath) {  // also between its last sample and the arrival
      pass(path_, *noted);
    }
  }
  pendingEvents_.erase(pendingEvents_.begin(), later);
}

void AccumulatorSet::extend(SampleRange& stretch, const std::shared_ptr<Sample>& sample) {
  stretch.earlier = std::move(stretch.before);
  stretch.before = std::move(stretch.now);
  stretch.now = sample;
  if (stretch.count == 0) {
    stretch.begin = sample->time;
    stretch.start = sample->robot.position;
    stretch.first = all_.count;
  }
  ++stretch.count;
  stretch.terms.forget();
}

/// Uses the end of the path as far as it is known.
const AccumulatorSet::SampleRange& AccumulatorSet::rangeOf(const MetricInfo& info) const {
  return info.needs.robot ? completePath() : all_;
}

AccumulatorSet::SampleRange AccumulatorSet::copyOfPath() const {
  SampleRange copy = path_;
  for (const Item& item : items_) {
    const MetricComputation& computation = item.entry.computation;
    if (!item.hasSum || !item.entry.info.needs.robot) {
      continue;
    }
    const std::shared_ptr<Accumulator>& sum = path_.sums.at(computation.shared);
    std::shared_ptr<Accumulator>& its = copy.sums.at(computation.shared);
    if (its == sum) {
      its = computation.copy(*sum);
    }
  }
  return copy;
}

void AccumulatorSet::saveSums(const RobotPathState& onWay) {
  if (!onWay.isAtGoal) {
    untilStop_.reset();
  } else if (!untilStop_) {
    untilStop_ = copyOfPath();
  }
  if (onWay.isTooLate && !untilTimeLimit_) {
    untilTimeLimit_ = copyOfPath();
  }
}

void AccumulatorSet::addArrivalEvent(double time) {
  arrival_ = time;
  untilStop_.reset();
  untilTimeLimit_.reset();
}

void AccumulatorSet::add(Sample sample, const RobotPathState& onWay) {
  const auto newest = std::make_shared<Sample>(std::move(sample));
  if (onWay.is) {
    extend(path_, newest);
    computePairs(*newest, needsMap_ ? &context_->map : nullptr, parameters_);
  }
  extend(all_, newest);
  deliverEvents();
  for (SampleRange* stretch : {&all_, &path_}) {
    if (stretch->now == newest) {
      const Instant instant = newestInstant(*stretch, &stretch->terms);
      for (const auto& [shared, sum] : stretch->sums) {
        sum->add(instant);
      }
    }
  }
  if (onWay.is) {
    saveSums(onWay);
  }
}

bool AccumulatorSet::selectsOne(std::initializer_list<std::string_view> keys) const {
  return std::any_of(items_.begin(), items_.end(), [&keys](const Item& item) {
    return std::find(keys.begin(), keys.end(), item.entry.info.key) != keys.end();
  });
}

EvaluatedPaths AccumulatorSet::evaluatedPaths() const {
  EvaluatedPaths ways;
  const SampleRange& way = completePath();
  if (!context_->hasRobot || way.count == 0) {
    return ways;
  }
  const bool wantsGoal = selectsOne({"spl", "stl", "ade", "fde", "dtw", "path_deviation"});
  if (wantsGoal && !context_->goals.empty()) {
    ways.toGoal = shortestPath(*context_, way.start, context_->goals.front().position);
  }
  if (selectsOne({"path_efficiency", "path_irregularity"})) {
    ways.toEnd = shortestPath(*context_, way.start, way.now->robot.position);
  }
  return ways;
}

MetricValue AccumulatorSet::valueOf(const Item& item,
                                    const std::vector<MetricResult>& before) const {
  const MetricEntry& entry = item.entry;
  if (entry.info.needs.robot && !context_->hasRobot) {
    return undefinedValue(kNoRobot);
  }
  const SampleRange& stretch = rangeOf(entry.info);
  if (stretch.count == 0) {
    return undefinedValue("the robot does not start moving");
  }
  return item.hasSum ? entry.computation.read(*stretch.sums.at(entry.computation.shared),
                                              newestInstant(stretch, nullptr))
                     : meanOver(findResult(before, entry.info.partOf)->value, stretch.count);
}

/// Expands a series to all samples of the run: undefined before the robot starts and after it
/// arrives.
void AccumulatorSet::alignSeries(const Item& item, std::optional<Series>& series) const {
  const SampleRange& stretch = rangeOf(item.entry.info);
  if (!series || series->values.size() != stretch.count || stretch.count == all_.count) {
    return;
  }
  std::vector<double>& values = series->values;
  values.insert(values.begin(), stretch.first, kNaN);
  values.resize(all_.count, kNaN);
}

std::vector<MetricResult> AccumulatorSet::values(const std::vector<MetricResult>* all,
                                                 const SeriesSink& sink) const {
  std::vector<MetricResult> results;
  for (const Item& item : items_) {
    const bool isSame = all != nullptr && !needsPeople(item.entry.info);
    results.push_back(
        {item.entry.info, isSame ? (*all)[results.size()].value : valueOf(item, results)});
    std::optional<Series>& series = results.back().value.series;
    if (!isSame) {
      alignSeries(item, series);
    }
    if (sink && series && keepsSeries_) {
      sink(item.entry.info, *series);
    }
    if (sink || !keepsSeries_) {
      series.reset();
    }
  }
  return results;
}

}  // namespace metrics
