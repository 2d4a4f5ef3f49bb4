#include "metrics/MetricSums.h"

#include <algorithm>
#include <map>
#include <utility>

#include "metrics/Interaction.h"

namespace metrics {

MetricSums::MetricSums(const Selection& selection, const MetricParameters& parameters,
                       bool hasRobot, const MetricRegistry& registry)
    : parameters_(parameters), hasRobot_(hasRobot), keepsSeries_(!selection.totalsOnly) {
  std::map<std::string, const Accumulator*> shared;
  for (MetricEntry& entry : selection.entries(registry)) {
    Item item{std::move(entry), nullptr};
    const Stream& stream = item.entry.stream;
    const bool isMean = !item.entry.meanOf.empty();
    if (stream.make && !isMean && (hasRobot || !item.entry.info.needs.robot)) {
      const Accumulator*& known =
          shared[stream.shared.empty() ? item.entry.info.key + "()" : stream.shared];
      if (known == nullptr) {
        sums_.push_back(stream.make(parameters));
        known = sums_.back().get();
      }
      item.sum = known;
    }
    items_.push_back(std::move(item));
  }
}

void MetricSums::add(const Recording& recording, std::size_t sample) {
  for (const std::unique_ptr<Accumulator>& sum : sums_) {
    sum->add(recording, sample);
  }
}

bool MetricSums::needsAllPeople() const {
  return std::any_of(items_.begin(), items_.end(), [](const Item& item) {
    return !item.entry.stream.make && item.entry.meanOf.empty() && item.entry.info.needs.people;
  });
}

bool MetricSums::needsMap() const {
  return std::any_of(items_.begin(), items_.end(),
                     [](const Item& item) { return item.entry.info.needs.map; });
}

MetricValue MetricSums::valueOf(const Item& item, const Recording& recording,
                                const std::vector<MetricResult>& before) const {
  const MetricEntry& entry = item.entry;
  if (entry.info.needs.robot && !hasRobot_) {
    return undefinedValue("there is no robot");
  }
  const MetricResult* whole = entry.meanOf.empty() ? nullptr : findResult(before, entry.meanOf);
  if (whole != nullptr) {
    return meanOver(whole->value, recording.size());
  }
  return item.sum != nullptr ? entry.stream.read(*item.sum, recording, parameters_)
                             : entry.compute(recording, parameters_);
}

std::vector<MetricResult> MetricSums::values(const Recording& recording,
                                             const std::vector<MetricResult>* all) const {
  std::vector<MetricResult> results;
  for (const Item& item : items_) {
    const Needs& needs = item.entry.info.needs;
    const bool isSame = all != nullptr && !needs.people && !needs.groups;
    results.push_back({item.entry.info,
                       isSame ? (*all)[results.size()].value : valueOf(item, recording, results)});
    if (!keepsSeries_) {
      results.back().value.series.reset();
    }
  }
  return results;
}

SampleFeed::SampleFeed(Recording empty, const Selection& selection,
                       const MetricParameters& parameters, const MetricRegistry& registry)
    : recording_(std::move(empty)),
      sums_(selection, parameters, recording_.hasRobot, registry),
      parameters_(parameters),
      keepsPeople_(sums_.needsAllPeople()),
      looks_(sums_.needsMap()) {}

void SampleFeed::add(Sample sample) {
  std::vector<Sample>& samples = recording_.samples;
  samples.push_back(std::move(sample));
  if (recording_.hasRobot) {
    workOutPairs(samples.back(), looks_ ? &recording_.map : nullptr, parameters_);
  }
  sums_.add(recording_, samples.size() - 1);
  if (!keepsPeople_ && samples.size() > 1) {
    Sample& before = samples[samples.size() - 2];
    std::vector<Person>().swap(before.people);
    std::vector<ObstaclePoint>().swap(before.robot.obstacles);
  }
}

void SampleFeed::note(double time, const sim2d::Event& event) {
  recording_.events.emplace_back(time, event);
}

std::vector<MetricResult> SampleFeed::values(const std::vector<MetricResult>* all) const {
  return sums_.values(recording_, all);
}

}  // namespace metrics
