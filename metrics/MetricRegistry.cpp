#include "metrics/MetricRegistry.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <utility>

#include "sim2d/base/Text.h"

namespace metrics {

const char* categoryName(Category category) {
  static constexpr std::array<const char*, kCategories> kNames = {
      "Navigation Performance", "Social Behavior", "Motion Analysis",
      "Safety & Collisions",    "Social Forces",   "Danger & Surprise Metrics"};
  return kNames[static_cast<std::size_t>(category)];
}

const char* betterName(Better better) {
  static constexpr std::array<const char*, 3> kNames = {"lower", "higher", "neutral"};
  return kNames[static_cast<std::size_t>(better)];
}

std::string needsText(const Needs& needs) {
  constexpr std::pair<bool Needs::*, const char*> kNames[] = {
      {&Needs::robot, "robot"},         {&Needs::people, "people"}, {&Needs::groups, "groups"},
      {&Needs::obstacles, "obstacles"}, {&Needs::goal, "goal"},     {&Needs::map, "map"}};
  std::string text;
  for (const auto& [needed, name] : kNames) {
    if (needs.*needed) {
      text += (text.empty() ? "" : ", ") + std::string(name);
    }
  }
  return text.empty() ? "nothing" : text;
}

MetricValue::MetricValue(double number) {
  if (std::isnan(number)) {
    why = "not a number";
    return;
  }
  value = number;
  why = std::isinf(number) ? "grows without limit" : "";
}

MetricValue undefinedValue(std::string why) {
  MetricValue value;
  value.why = std::move(why);
  return value;
}

MetricValue infiniteValue(std::string why) {
  MetricValue value = HUGE_VAL;
  value.why = std::move(why);
  return value;
}

MetricValue withSeries(MetricValue value, std::vector<double> series, Kind kind) {
  value.series = Series{std::move(series), kind};
  return value;
}

MetricValue withTerms(const SeriesSum& sum, Kind kind) {
  return withSeries(sum.sum(), sum.terms(), kind);
}

MetricValue meanOver(MetricValue sum, std::size_t samples) {
  sum.series.reset();
  if (sum.value) {
    *sum.value /= static_cast<double>(samples);
  }
  return sum;
}

namespace {

/// The word stands in the text, and not as a part of a longer one.
bool hasWord(const std::string& text, const std::string& word) {
  constexpr char kLetters[] = "abcdefghijklmnopqrstuvwxyz0123456789_";
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const std::size_t end = text.find_first_not_of(kLetters, at);
    const bool isBegin = at == 0 || std::strchr(kLetters, text[at - 1]) == nullptr;
    if (isBegin && std::min(end, text.size()) == at + word.size()) {
      return true;
    }
  }
  return false;
}

}  // namespace

Stream streamOfLast(MetricValue (*read)(const Instant& last)) {
  return streamOf<Accumulator>(
      [read](const Accumulator& /*sum*/, const Instant& last) { return read(last); });
}

void MetricRegistry::add(MetricInfo info, Stream stream) {
  assert(find(info.key) == nullptr);
  entries_.push_back({std::move(info), std::move(stream), ""});
}

void MetricRegistry::addSum(MetricInfo info, Stream stream) {
  const std::string key = info.key;
  info.rateBound = 0.51;  // twice the samples, twice the sum
  add(info, std::move(stream));
  info.key += "_mean";
  info.name += ", mean per sample";
  info.formula = key + " / N";
  info.source = "ours";
  info.kind = Kind::Number;
  info.hunav = 0;
  info.partOf = key;
  info.rateBound = MetricInfo{}.rateBound;
  assert(find(info.key) == nullptr);
  entries_.push_back({std::move(info), {}, key});
}

void MetricRegistry::sort() {
  const auto rank = [](const MetricEntry& entry) {
    return entry.info.hunav > 0 ? entry.info.hunav : 1000;
  };
  std::stable_sort(entries_.begin(), entries_.end(),
                   [&](const MetricEntry& a, const MetricEntry& b) { return rank(a) < rank(b); });
}

const MetricEntry* MetricRegistry::find(std::string_view key) const {
  for (const MetricEntry& entry : entries_) {
    if (entry.info.key == key) {
      return &entry;
    }
  }
  return nullptr;
}

std::vector<std::string> MetricRegistry::keys() const {
  std::vector<std::string> keys;
  for (const MetricEntry& entry : entries_) {
    keys.push_back(entry.info.key);
  }
  return keys;
}

std::vector<base::ParameterSpec> MetricRegistry::parametersOf(const MetricInfo& info) const {
  if (const MetricEntry* sum = find(info.partOf)) {
    return parametersOf(sum->info);
  }
  std::vector<base::ParameterSpec> parameters;
  for (const ParameterInfo& parameter : parameterInfos()) {
    const std::vector<std::string> users = base::split(parameter.usedBy, ' ');
    const bool isUser = std::any_of(users.begin(), users.end(), [&info](const std::string& begin) {
      return !begin.empty() && info.key.compare(0, begin.size(), begin) == 0;
    });
    if (isUser || hasWord(info.formula, parameter.spec.key)) {
      parameters.push_back(parameter.spec);
    }
  }
  return parameters;
}

const MetricRegistry& standardRegistry() {
  static const MetricRegistry kRegistry = [] {
    MetricRegistry registry;
    addAllMetrics(registry);
    registry.sort();
    return registry;
  }();
  return kRegistry;
}

}  // namespace metrics
