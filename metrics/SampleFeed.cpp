#include "metrics/SampleFeed.h"

#include <algorithm>
#include <utility>

namespace metrics {

namespace {

bool looksAtPeople(const MetricInfo& info) {
  return info.needs.people || info.needs.groups;
}

}  // namespace

SampleFeed::SampleFeed(std::shared_ptr<const RunContext> context, const Selection& selection,
                       const MetricParameters& parameters, const MetricRegistry& registry,
                       Among among)
    : context_(std::move(context)),
      parameters_(parameters),
      keepsSeries_(selection.series),
      store_(selection.seriesOnDisk ? std::make_unique<NumberStore>() : nullptr) {
  for (MetricEntry& entry : selection.entries(registry)) {
    addItem(std::move(entry), among);
  }
}

void SampleFeed::addItem(MetricEntry entry, Among among) {
  Item item{std::move(entry)};
  const MetricInfo& info = item.entry.info;
  const Stream& stream = item.entry.stream;
  const bool isAsked = among == Among::All || looksAtPeople(info);
  if (stream.make && isAsked && (context_->hasRobot || !info.needs.robot)) {
    Stretch& stretch = info.needs.robot ? way_ : all_;
    std::shared_ptr<Accumulator>& sum = stretch.sums[stream.shared];
    if (!sum) {
      sum = stream.make(parameters_);
    }
    item.hasSum = true;
  }
  needsMap_ = needsMap_ || info.needs.map;
  items_.push_back(std::move(item));
}

Instant SampleFeed::newestInstant(const Stretch& stretch, TermMemory* memory) const {
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

/// Those since the beginning; what was noted too early waits for the next sample.
void SampleFeed::passEvents() {
  const double now = all_.now->time + kTimeSlack;
  const auto later = std::find_if(noted_.begin(), noted_.end(),
                                  [now](const Noted& noted) { return noted.time > now; });
  const auto pass = [&](const Stretch& stretch, const Noted& noted) {
    if (stretch.count > 0 && noted.time >= stretch.begin - kTimeSlack) {
      for (const auto& [shared, sum] : stretch.sums) {
        sum->note(*context_, noted.time - stretch.begin, noted.event);
      }
    }
  };
  for (auto noted = noted_.begin(); noted != later; ++noted) {
    pass(all_, *noted);
    if (noted->isOnWay) {  // also between its last sample and the arrival
      pass(way_, *noted);
    }
  }
  noted_.erase(noted_.begin(), later);
}

void SampleFeed::lengthen(Stretch& stretch, const std::shared_ptr<Sample>& sample) {
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

/// The end of the way as far as known.
const SampleFeed::Stretch& SampleFeed::stretchOf(const MetricInfo& info) const {
  return info.needs.robot ? wholeWay() : all_;
}

SampleFeed::Stretch SampleFeed::copyOfWay() const {
  Stretch copy = way_;
  for (const Item& item : items_) {
    const Stream& stream = item.entry.stream;
    if (!item.hasSum || !item.entry.info.needs.robot) {
      continue;
    }
    const std::shared_ptr<Accumulator>& sum = way_.sums.at(stream.shared);
    std::shared_ptr<Accumulator>& its = copy.sums.at(stream.shared);
    if (its == sum) {
      its = stream.copy(*sum);
    }
  }
  return copy;
}

void SampleFeed::keepAside(const OnWay& onWay) {
  if (!onWay.isAtGoal) {
    toGoal_.reset();
  } else if (!toGoal_) {
    toGoal_ = copyOfWay();
  }
  if (onWay.isTooLate && !inTime_) {
    inTime_ = copyOfWay();
  }
}

void SampleFeed::noteArrival(double time) {
  arrival_ = time;
  toGoal_.reset();
  inTime_.reset();
}

void SampleFeed::add(Sample sample, const OnWay& onWay) {
  const auto newest = std::make_shared<Sample>(std::move(sample));
  if (onWay.is) {
    lengthen(way_, newest);
    workOutPairs(*newest, needsMap_ ? &context_->map : nullptr, parameters_);
  }
  lengthen(all_, newest);
  passEvents();
  for (Stretch* stretch : {&all_, &way_}) {
    if (stretch->now == newest) {
      const Instant instant = newestInstant(*stretch, &stretch->terms);
      for (const auto& [shared, sum] : stretch->sums) {
        sum->add(instant);
      }
    }
  }
  if (onWay.is) {
    keepAside(onWay);
  }
}

bool SampleFeed::selectsOne(std::initializer_list<std::string_view> keys) const {
  return std::any_of(items_.begin(), items_.end(), [&keys](const Item& item) {
    return std::find(keys.begin(), keys.end(), item.entry.info.key) != keys.end();
  });
}

ShortestWays SampleFeed::shortestWays() const {
  ShortestWays ways;
  const Stretch& way = wholeWay();
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

MetricValue SampleFeed::valueOf(const Item& item, const std::vector<MetricResult>& before) const {
  const MetricEntry& entry = item.entry;
  if (entry.info.needs.robot && !context_->hasRobot) {
    return undefinedValue("there is no robot");
  }
  const Stretch& stretch = stretchOf(entry.info);
  if (stretch.count == 0) {
    return undefinedValue("the robot does not set off");
  }
  return item.hasSum ? entry.stream.read(*stretch.sums.at(entry.stream.shared),
                                         newestInstant(stretch, nullptr))
                     : meanOver(findResult(before, entry.info.partOf)->value, stretch.count);
}

/// One value per sample of the run: undefined before the robot sets off and after it has arrived.
void SampleFeed::alignSeries(const Item& item, std::optional<Series>& series) const {
  const Stretch& stretch = stretchOf(item.entry.info);
  if (!series || series->values.size() != stretch.count || stretch.count == all_.count) {
    return;
  }
  std::vector<double>& values = series->values;
  values.insert(values.begin(), stretch.first, kNaN);
  values.resize(all_.count, kNaN);
}

std::vector<MetricResult> SampleFeed::values(const std::vector<MetricResult>* all,
                                             const SeriesSink& sink) const {
  std::vector<MetricResult> results;
  for (const Item& item : items_) {
    const bool isSame = all != nullptr && !looksAtPeople(item.entry.info);
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
