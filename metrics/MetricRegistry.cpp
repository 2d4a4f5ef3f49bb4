#include "metrics/MetricRegistry.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <utility>

#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"

namespace metrics {

const char* categoryName(Category category) {
  static constexpr std::array<const char*, kCategories> kNames = {
      "Navigation Performance", "Social Behavior", "Motion Analysis",
      "Safety & Collisions",    "Social Forces",   "Danger & Surprise Metrics"};
  return kNames.at(static_cast<std::size_t>(category));
}

const char* betterName(Better better) {
  static constexpr std::array<const char*, 3> kNames = {"lower", "higher", "neutral"};
  return kNames.at(static_cast<std::size_t>(better));
}

namespace {

constexpr std::pair<bool Needs::*, const char*> kNeeds[] = {
    {&Needs::robot, "robot"},         {&Needs::people, "people"}, {&Needs::groups, "groups"},
    {&Needs::obstacles, "obstacles"}, {&Needs::goal, "goal"},     {&Needs::map, "map"}};

}  // namespace

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

/// Whether the text contains the word, not as a part of a longer word.
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

/// The enumerator with this name.
template <class Enum>
Enum named(const std::string& name, const char* (*nameOf)(Enum)) {
  int value = 0;
  while (name != nameOf(static_cast<Enum>(value))) {
    ++value;
  }
  return static_cast<Enum>(value);
}

/// The properties shared by the metrics below a heading.
MetricInfo parseHeading(const std::vector<std::string>& fields) {
  MetricInfo info;
  info.category = named(fields.at(0).substr(2), categoryName);
  info.better = named(fields.at(1), betterName);
  for (const auto& [needed, name] : kNeeds) {
    info.needs.*needed = hasWord(fields.at(2), name);
  }
  info.source = fields.at(3);
  info.rateBound = fields.size() > 4 ? base::parseDouble(fields[4]).value() : info.rateBound;
  return info;
}

std::vector<MetricInfo> parseTable(const char* table) {
  std::vector<MetricInfo> infos;
  MetricInfo info;
  for (const std::string& line : base::split(table, '\n')) {
    const std::vector<std::string> fields = base::split(line, '|');
    if (line[0] == ' ') {
      infos.back().formula += line.substr(1);
    } else if (line[0] == '=') {
      info = parseHeading(fields);
    } else if (!line.empty()) {
      const std::vector<std::string> words = base::split(fields[0], ' ');
      info.hunav = static_cast<int>(base::parseInt(words.front()).value_or(0));
      info.key = words.back();
      info.name = fields.at(1);
      info.unit = fields.at(2);
      info.range = fields.at(3);
      info.kind = info.range == "0 or 1"      ? Kind::Boolean
                  : info.range == "0, 1, ..." ? Kind::Count
                                              : Kind::Number;
      const std::size_t before =
          fields[0].size() + fields[1].size() + fields[2].size() + fields[3].size();
      info.formula = line.substr(before + 4);  // may contain bars: |v|
      infos.push_back(info);
    }
  }
  return infos;
}

}  // namespace

void MetricRegistry::add(MetricInfo info, MetricComputation computation) {
  assert(find(info.key) == nullptr);
  entries_.push_back({std::move(info), std::move(computation)});
}

void MetricRegistry::add(const char* table,
                         const std::map<std::string, MetricComputation>& computations) {
  std::vector<MetricInfo> infos = parseTable(table);
  assert(infos.size() == computations.size());  // one line per entry
  for (MetricInfo& info : infos) {
    const MetricComputation& computation = computations.at(info.key);
    add(std::move(info), computation);
  }
}

void MetricRegistry::addSums(const char* table,
                             const std::map<std::string, MetricComputation>& computations) {
  std::vector<MetricInfo> infos = parseTable(table);
  assert(infos.size() == computations.size());
  for (MetricInfo& info : infos) {
    const std::string key = info.key;
    info.rateBound = 0.51;  // doubling the samples doubles the sum
    add(info, computations.at(key));
    info.key += "_mean";
    info.name += ", mean per sample";
    info.formula = key + " / N";
    info.source = "HuNavSim Desktop";
    info.kind = Kind::Number;
    info.hunav = 0;
    info.partOf = key;
    info.rateBound = MetricInfo{}.rateBound;
    add(std::move(info), {});
  }
}

void MetricRegistry::sort() {
  const auto rank = [](const MetricEntry& entry) {
    return entry.info.hunav > 0 ? entry.info.hunav : 1000;
  };
  std::stable_sort(entries_.begin(), entries_.end(),
                   [&](const MetricEntry& a, const MetricEntry& b) { return rank(a) < rank(b); });
}

std::vector<std::string> MetricRegistry::keys() const {
  std::vector<std::string> keys;
  keys.reserve(entries_.size());
  for (const MetricEntry& entry : entries_) {
    keys.push_back(entry.info.key);
  }
  return keys;
}

const MetricEntry* MetricRegistry::find(std::string_view key) const {
  return base::findIf(entries_, [key](const MetricEntry& entry) { return entry.info.key == key; });
}

std::vector<base::ParameterSpec> MetricRegistry::parametersOf(const MetricInfo& info) const {
  if (const MetricEntry* sum = find(info.partOf)) {
    return parametersOf(sum->info);
  }
  std::vector<base::ParameterSpec> parameters;
  for (const ParameterInfo& parameter : parameterInfos()) {
    const std::vector<std::string> users = base::split(parameter.usedBy, ' ');
    const bool isUser = std::any_of(users.begin(), users.end(), [&info](const std::string& begin) {
      return !begin.empty() && base::startsWith(info.key, begin);
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
