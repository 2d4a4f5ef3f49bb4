#include "metrics/RunningEvaluation.h"

#include <algorithm>
#include <utility>

#include "metrics/Motion.h"

namespace metrics {

namespace {

bool looksAtPeople(const MetricInfo& info) {
  return info.needs.people || info.needs.groups;
}

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

bool isActive(const Sample& sample) {
  return std::any_of(sample.people.begin(), sample.people.end(),
                     [](const Person& person) { return person.state != 0; });
}

/// Without the people of other types. The obstacle points go along and are not left behind.
Sample takePeople(Sample& sample, int behavior) {
  const auto isOne = [behavior](const Person& person) { return person.behavior == behavior; };
  Sample part;
  part.people.reserve(
      static_cast<std::size_t>(std::count_if(sample.people.begin(), sample.people.end(), isOne)));
  part.time = sample.time;
  part.robot = sample.robot;
  for (Person& person : sample.people) {
    if (isOne(person)) {
      std::vector<sim2d::Obstacles::Point> points = std::move(person.obstacles);
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

/// Puts down where the robot is.
class Places : public Accumulator {
 public:
  void add(const Instant& at) override { way_.emplace_back(at.elapsed(), at.now.robot.position); }
  const TimedWay& way() const { return way_; }

 private:
  TimedWay way_;
};

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
  return {
      *context_,         parameters_,   *stretch.now, stretch.before.get(), stretch.earlier.get(),
      stretch.count - 1, stretch.begin, keepsSeries_, store_.get(),         memory};
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
    stretch.first = all_.count;
  }
  ++stretch.count;
  stretch.terms.forget();
}

/// The end of the way as far as known.
const SampleFeed::Stretch& SampleFeed::stretchOf(const MetricInfo& info) const {
  if (!info.needs.robot) {
    return all_;
  }
  return toGoal_ ? *toGoal_ : (inTime_ ? *inTime_ : way_);
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

void SampleFeed::tellArrival() {
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

RunningEvaluation::RunningEvaluation(const RunContext& context, const Selection& selection,
                                     const MetricParameters& parameters,
                                     const MetricRegistry& registry)
    : context_(withReference(context, selection)),
      selection_(selection),
      parameters_(parameters),
      gate_(selection.window, context),
      all_(context_, selection, parameters, registry) {
  // All types at once: who comes late was not there before.
  for (std::size_t k = 0; selection.behaviors && k < kBehaviors; ++k) {
    behaviors_[k].feed = std::make_unique<SampleFeed>(context_, amongSome(selection), parameters,
                                                      registry, Among::SomePeople);
  }
}

void RunningEvaluation::note(double time, const sim2d::Event& event) {
  gate_.note(time, event);
  const bool isRobot = event.hasId && event.id == context_->robotId;
  if (event.kind == sim2d::EventKind::Arrived && isRobot && !arrival_) {
    arrival_ = time;
    all_.tellArrival();
    for (Behavior& behavior : behaviors_) {
      if (behavior.feed) {
        behavior.feed->tellArrival();
      }
    }
  }
  if (event.kind == sim2d::EventKind::Enter && event.hasId) {
    entered_.insert(event.id);
  }
  if (!isOver_) {
    all_.note(time, event, isOnWay(time));
  }
}

/// A window that says itself where to begin or to end is heeded instead of both ends of the way.
bool RunningEvaluation::isWholeRecord() const {
  return isOriginal() || selection_.window.from != "begin" || selection_.window.until != "end";
}

bool RunningEvaluation::isOnWay(double time) const {
  if (!context_->hasRobot || isWholeRecord()) {
    return context_->hasRobot;
  }
  const bool isLate = arrival_ && time > *arrival_ + kTimeSlack;
  return time >= context_->robotStartTime - kTimeSlack && !isLate;
}

/// Of an arrival between two samples the second is the end of the way.
OnWay RunningEvaluation::onWayOf(const Sample& sample) {
  const double time = sample.time;
  OnWay onWay;
  onWay.is = isOnWay(arrival_ && !isAtGoal_ ? std::min(time, *arrival_) : time);
  isAtGoal_ = isAtGoal_ || (arrival_ && time >= *arrival_ - kTimeSlack);
  setOff_ = onWay.is && !setOff_ ? time : setOff_;
  if (onWay.is && !arrival_ && !isWholeRecord() && !context_->goals.empty()) {
    const bool stands = isStanding(sample.robot, parameters_);
    hasMoved_ = hasMoved_ || !stands;
    onWay.isAtGoal =
        hasMoved_ && stands && isInGoalRegion(*context_, sample.robot.position, parameters_);
    onWay.isTooLate = time - *setOff_ >= parameters_.timeLimit;
  }
  return onWay;
}

void RunningEvaluation::markNew(Sample& sample) {
  for (Person& person : sample.people) {
    person.isNew = entered_.count(person.id) > 0;
  }
  entered_.clear();
}

void RunningEvaluation::addToBehaviors(Sample& sample, const OnWay& onWay) {
  const bool anyActive = isActive(sample);
  for (std::size_t k = 0; k < kBehaviors; ++k) {
    Behavior& behavior = behaviors_[k];
    if (!behavior.feed) {
      continue;
    }
    Sample part = takePeople(sample, static_cast<int>(k) + 1);
    behavior.isMet = behavior.isMet || !part.people.empty();
    // The original leaves out types that are missing at any sample.
    if (isOriginal() && part.people.empty()) {
      behavior.feed.reset();
      continue;
    }
    if (selection_.behaviorSeries) {
      // Of the people of this type; the original looks at everybody.
      behavior.active.push_back((isOriginal() ? anyActive : isActive(part)) ? 1.0 : 0.0);
    }
    behavior.feed->add(std::move(part), onWay);
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
  const OnWay onWay = onWayOf(sample);
  markNew(sample);
  all_.add(std::move(sample), onWay);
  if (selection_.behaviors) {
    addToBehaviors(all_.newest(), onWay);
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
  evaluation.robotId = selection_.robotId;
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

TimedWay wayOf(const sim2d::Trace& trace, const Selection& selection,
               const MetricParameters& parameters) {
  TimedWay way;
  MetricEntry places;
  places.info.key = "way";
  places.stream = streamOf<Places>([&way](const Places& all) {
    way = all.way();
    return MetricValue();
  });
  Selection only = *selectionOfKeys({});
  only.own = {places};
  only.window = selection.window;
  only.robotId = selection.robotId;
  only.behaviors = false;
  const std::vector<sim2d::TraceRobot>& robots = trace.header.robots;
  const bool isThere = std::any_of(robots.begin(), robots.end(), [&](const auto& robot) {
    return robot.id == selection.robotId;
  });
  if (!isThere && !robots.empty()) {
    only.robotId = robots.front().id;
  }
  return evaluate(trace, only, parameters) ? way : TimedWay();
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
