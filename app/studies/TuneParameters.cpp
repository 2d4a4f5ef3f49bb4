#include "app/studies/TuneParameters.h"

#include <algorithm>
#include <cmath>

#include "app/run/DataPaths.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"

namespace app {

namespace {

constexpr char kTuningKey[] = "hunavsim_tuning";

base::Diagnostic at(const base::YamlNode& node, base::Diagnostic problem) {
  problem.line = node.line;
  problem.column = node.column;
  return problem;
}

/// "[0.1, 0.5]".
bool readLimits(const base::YamlNode* node, TuningRange& range) {
  if (node == nullptr || !node->isList() || node->items.size() != 2) {
    return false;
  }
  const auto low = base::parseDouble(node->items[0].text);
  const auto high = base::parseDouble(node->items[1].text);
  range.low = low.value_or(0.0);
  range.high = high.value_or(0.0);
  return low && high && std::isfinite(*low) && std::isfinite(*high) && *low < *high;
}

TuningRange readRange(const base::YamlNode& node, base::Diagnostics& problems) {
  TuningRange range;
  range.name = node.key;
  const base::YamlNode* const scale = node.isMap() ? node.find("scale") : nullptr;
  range.isLogarithmic = scale != nullptr && scale->text == "log";
  if (!node.isMap() || !readLimits(node.find("range"), range) ||
      (range.isLogarithmic && range.low <= 0.0)) {
    problems.push_back(at(node, base::error("tune.bad-range", {node.key})));
  }
  if (scale != nullptr && scale->text != "log" && scale->text != "linear") {
    problems.push_back(at(*scale, base::error("tune.bad-scale", {scale->text})));
  }
  for (const base::YamlNode& item : node.items) {
    if (node.isMap() && item.key != "range" && item.key != "scale") {
      problems.push_back(
          at(base::keyNode(item),
             base::error("tune.unknown-key",
                         {item.key, base::nearestName(item.key, {"range", "scale"})})));
    }
  }
  return range;
}

TuningList::Entries readEntries(const base::YamlNode& section, base::Diagnostics& problems) {
  TuningList::Entries entries;
  for (const base::YamlNode& of : section.items) {
    entries.emplace_back(of.key, std::vector<TuningRange>());
    for (const base::YamlNode& item : of.items) {
      entries.back().second.push_back(readRange(item, problems));
    }
    if (!of.isMap()) {
      problems.push_back(at(base::keyNode(of), base::error("tune.no-parameters", {of.key})));
    }
  }
  return entries;
}

}  // namespace

const std::vector<TuningRange>* TuningList::find(const Entries& entries, const std::string& name) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const auto& entry) { return entry.first == name; });
  return found != entries.end() ? &found->second : nullptr;
}

std::string shippedTuningList() {
  return shippedResources("tuning") + "/parameters.yaml";
}

base::Result<TuningList> readTuningList(const std::string& path) {
  const base::Result<std::string> text = base::readTextFile(path);
  if (!text) {
    return text.diagnostics();
  }
  base::Diagnostics problems;
  const base::YamlNode root = base::parseYaml(*text, path, problems);
  TuningList list;
  list.file = path;
  if (!base::hasErrors(problems)) {
    const base::YamlNode* const version = root.isMap() ? root.find(kTuningKey) : nullptr;
    if (version == nullptr || version->text != "1") {
      return base::error("tune.no-list", {}, path, 1);
    }
    for (const base::YamlNode& item : root.items) {
      if (item.key == "controllers") {
        list.controllers = readEntries(item, problems);
      } else if (item.key == "planners") {
        list.planners = readEntries(item, problems);
      } else if (item.key != kTuningKey) {
        problems.push_back(
            at(base::keyNode(item),
               base::error("tune.unknown-key",
                           {item.key, base::nearestName(item.key, {"controllers", "planners"})})));
      }
    }
  }
  for (base::Diagnostic& problem : problems) {
    problem.file = path;
  }
  return base::resultOf(std::move(list), std::move(problems));
}

std::string TunedParameter::textAt(double share) const {
  const double part = std::clamp(share, 0.0, 1.0);
  const double value = range.isLogarithmic ? range.low * std::pow(range.high / range.low, part)
                                           : range.low + part * (range.high - range.low);
  // Three significant digits of the larger of value and range, so that 0 is not 1e-17.
  const double size = std::max(std::fabs(value), 1e-3 * (range.high - range.low));
  const int decimals = std::max(1, 2 - static_cast<int>(std::floor(std::log10(size))));
  const double scale = std::pow(10.0, decimals);
  return textOf(isInteger ? value : std::round(value * scale) / scale);
}

std::string TunedParameter::textOf(double value) const {
  return isInteger ? std::to_string(std::llround(value)) : base::formatDecimals(value, 1);
}

double TunedParameter::shareOf(double value) const {
  const double share = range.isLogarithmic ? std::log(std::max(value, range.low) / range.low) /
                                                 std::log(range.high / range.low)
                                           : (value - range.low) / (range.high - range.low);
  return std::clamp(share, 0.0, 1.0);
}

TunedParameter tunedParameter(const TuningRange& range, double present, bool isInteger) {
  TunedParameter tuned;
  tuned.range = range;
  tuned.range.low = std::min(range.low, present);
  tuned.range.high = std::max(range.high, present);
  tuned.range.isLogarithmic = range.isLogarithmic && present > 0.0;
  tuned.isInteger = isInteger;
  tuned.presentNumber = present;
  return tuned;
}

}  // namespace app
