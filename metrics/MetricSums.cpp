#include "metrics/MetricSums.h"

#include <algorithm>
#include <map>

#include "metrics/Interaction.h"

namespace metrics {

namespace {

constexpr double kTimeSlack = 1e-9;  // [s]

bool looksAtPeople(const MetricInfo& info) {
  return info.needs.people || info.needs.groups;
}

}  // namespace

MetricSums::MetricSums(const Selection& selection, const MetricParameters& parameters,
                       bool hasRobot, const MetricRegistry& registry, Among among)
    : hasRobot_(hasRobot) {
  std::map<std::string, const Accumulator*> shared;
  for (MetricEntry& entry : selection.entries(registry)) {
    Item item{std::move(entry), nullptr};
    const Stream& stream = item.entry.stream;
    const bool isAsked = among == Among::All || looksAtPeople(item.entry.info);
    if (stream.make && isAsked && (hasRobot || !item.entry.info.needs.robot)) {
      const Accumulator*& known = shared[stream.shared];
      if (known == nullptr) {
        sums_.push_back(stream.make(parameters));
        known = sums_.back().get();
      }
      item.sum = known;
    }
    items_.push_back(std::move(item));
  }
}

void MetricSums::note(const RunContext& context, double elapsed, const sim2d::Event& event) {
  for (const std::unique_ptr<Accumulator>& sum : sums_) {
    sum->note(context, elapsed, event);
  }
}

void MetricSums::add(const Instant& at) {
  for (const std::unique_ptr<Accumulator>& sum : sums_) {
    sum->add(at);
  }
}

bool MetricSums::needsRecord() const {
  return std::any_of(items_.begin(), items_.end(),
                     [](const Item& item) { return static_cast<bool>(item.entry.compute); });
}

bool MetricSums::needsMap() const {
  return std::any_of(items_.begin(), items_.end(),
                     [](const Item& item) { return item.entry.info.needs.map; });
}

MetricValue MetricSums::valueOf(const Item& item, const Instant& last, const SampledRun* whole,
                                const std::vector<MetricResult>& before) const {
  const MetricEntry& entry = item.entry;
  if (entry.info.needs.robot && !hasRobot_) {
    return undefinedValue("there is no robot");
  }
  if (item.sum != nullptr) {
    return entry.stream.read(*item.sum, last);
  }
  if (const MetricResult* sum = findResult(before, entry.meanOf)) {
    return meanOver(sum->value, last.count());
  }
  return entry.compute(*whole, last.parameters);
}

std::vector<MetricResult> MetricSums::values(const Instant& last, const SampledRun* whole,
                                             const std::vector<MetricResult>* all,
                                             const SeriesSink& sink) const {
  std::vector<MetricResult> results;
  for (const Item& item : items_) {
    const bool isSame = all != nullptr && !looksAtPeople(item.entry.info);
    results.push_back({item.entry.info, isSame ? (*all)[results.size()].value
                                               : valueOf(item, last, whole, results)});
    std::optional<Series>& series = results.back().value.series;
    if (sink && series && last.keepsSeries) {
      sink(item.entry.info, *series);
    }
    if (sink || !last.keepsSeries) {
      series.reset();
    }
  }
  return results;
}

SampleFeed::SampleFeed(std::shared_ptr<const RunContext> context, const Selection& selection,
                       const MetricParameters& parameters, const MetricRegistry& registry,
                       Among among)
    : context_(std::move(context)),
      parameters_(parameters),
      keepsSeries_(selection.series),
      store_(selection.seriesOnDisk ? std::make_unique<NumberStore>() : nullptr),
      sums_(selection, parameters, context_->hasRobot, registry, among),
      looks_(sums_.needsMap()) {
  if (sums_.needsRecord()) {
    whole_ = std::make_unique<SampledRun>();
    static_cast<RunContext&>(*whole_) = *context_;
  }
}

Instant SampleFeed::newestInstant(TermMemory* memory) const {
  return {*context_,    parameters_,  now_,  count_ > 1 ? &before_ : nullptr, count_ - 1, begin_,
          keepsSeries_, store_.get(), memory};
}

/// Those since the beginning; what was noted too early waits for the next sample.
void SampleFeed::takeEvents() {
  const double now = now_.time + kTimeSlack;
  const auto later = std::find_if(noted_.begin(), noted_.end(),
                                  [now](const auto& noted) { return noted.first > now; });
  for (auto noted = noted_.begin(); noted != later; ++noted) {
    if (noted->first >= begin_ - kTimeSlack) {
      sums_.note(*context_, noted->first - begin_, noted->second);
    }
  }
  noted_.erase(noted_.begin(), later);
}

void SampleFeed::add(Sample sample) {
  before_ = std::move(now_);
  now_ = std::move(sample);
  begin_ = count_ == 0 ? now_.time : begin_;
  ++count_;
  if (context_->hasRobot) {
    workOutPairs(now_, looks_ ? &context_->map : nullptr, parameters_);
  }
  takeEvents();
  terms_.forget();
  sums_.add(newestInstant(&terms_));
  if (whole_) {
    whole_->samples.push_back(now_);
  }
}

std::vector<MetricResult> SampleFeed::values(const std::vector<MetricResult>* all,
                                             const SeriesSink& sink) const {
  return sums_.values(newestInstant(nullptr), whole_.get(), all, sink);
}

}  // namespace metrics
