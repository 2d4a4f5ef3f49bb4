#include "app/run/StoppingRule.h"

#include <algorithm>
#include <cmath>

#include "app/run/Experiment.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"

namespace app {

namespace {

using base::YamlNode;

constexpr const char* kScenarioPath = "scenario";
constexpr std::size_t kSeedsPerLook = 5;
constexpr std::size_t kRunsPerLook = 16;  // at least, so that several processes have work

class RuleReader {
 public:
  RuleReader(const YamlNode& node, const Experiment& experiment)
      : node_(node), experiment_(experiment) {}

  base::Result<StoppingRule> read() {
    if (!node_.isMap()) {
      error(node_, "experiment.until-form");
      return problems_;
    }
    for (const YamlNode& item : node_.items) {
      readItem(item);
    }
    const bool hasOne = rule_.halfWidth.has_value() != !rule_.ranking.empty();
    if (problems_.empty() && (rule_.metric.empty() || !hasOne)) {
      error(node_, "experiment.until-form");
    }
    if (problems_.empty() && !rule_.range.isDefined()) {
      error(node_, "experiment.until-range", {rule_.metric});
    }
    if (experiment_.seeds.size() < kSeedsPerLook) {
      error(node_, "experiment.until-seeds", {kSeedsPerLook});
    }
    return base::resultOf(std::move(rule_), std::move(problems_));
  }

 private:
  void error(const YamlNode& node, const char* code, base::ProblemValues values = {}) {
    problems_.push_back(located(node, base::error(code, std::move(values))));
  }

  void readItem(const YamlNode& item) {
    if (item.key == "metric") {
      readMetric(item);
    } else if (item.key == "halfwidth") {
      rule_.halfWidth = numberOf(item, 0.0, 1e9);
    } else if (item.key == "level") {
      rule_.level = numberOf(item, 0.5, 1.0);
    } else if (item.key == "ranking") {
      readRanking(item);
    } else if (item.key == "range") {
      readRange(item);
    } else {
      error(item, "experiment.until-form");
    }
  }

  void readMetric(const YamlNode& item) {
    rule_.metric = item.text;
    const std::optional<ColumnInfo> info = columnInfo(item.text);
    if (!info) {
      error(item, "experiment.until-metric",
            {item.text, base::nearestName(item.text, knownColumns())});
    } else if (!rule_.range.isDefined() && info->isBoolean) {
      rule_.range = {0.0, 1.0};
    } else if (!rule_.range.isDefined() && info->unit == "%") {
      rule_.range = {0.0, 100.0};
    }
  }

  /// A number between the limits, both excluded.
  double numberOf(const YamlNode& item, double low, double high) {
    const std::optional<double> number = base::parseDouble(item.text);
    if (!number || !(*number > low && *number < high)) {
      error(item, "experiment.until-number", {item.key, low, high});
      return 0.5 * (low + high);
    }
    return *number;
  }

  void readRanking(const YamlNode& item) {
    rule_.ranking = item.text;
    const auto* const value =
        base::findBy(experiment_.values, &ExperimentValue::path, rule_.ranking);
    const std::size_t options = rule_.ranking == kScenarioPath ? experiment_.scenarios.size()
                                : value != nullptr && value->kind == ExperimentValue::Kind::Grid
                                    ? value->texts.size()
                                    : 0;
    if (options < 2) {
      error(item, "experiment.until-ranking", {item.text});
    }
  }

  void readRange(const YamlNode& item) {
    std::vector<double> ends;
    for (const YamlNode& each : item.items) {
      ends.push_back(base::parseDouble(each.text).value_or(statistics::kUndefined));
    }
    if (ends.size() != 2 || !(ends[0] < ends[1]) || std::isinf(ends[0]) || std::isinf(ends[1])) {
      error(item, "experiment.until-ends");
    } else {
      rule_.range = {ends[0], ends[1]};
    }
  }

  const YamlNode& node_;
  const Experiment& experiment_;
  StoppingRule rule_;
  base::Diagnostics problems_;
};

}  // namespace

std::string StoppingRule::text() const {
  return halfWidth ? "the interval of " + metric + " is at most ±" + base::formatDouble(*halfWidth)
                   : "the values of " + ranking + " are ranked by " + metric;
}

base::Result<StoppingRule> readStoppingRule(const YamlNode& node, const Experiment& experiment) {
  return RuleReader(node, experiment).read();
}

StoppingCheck::StoppingCheck(const Experiment& experiment)
    : experiment_(experiment), runsPerSeed_(experiment.runCount() / experiment.seeds.size()) {
  const StoppingRule& rule = *experiment.until;
  std::map<std::string, std::size_t> numbers;  // of options, by name
  for (std::size_t place = 0; place < runsPerSeed_; ++place) {
    const Experiment::Run run = experiment.run(place * experiment.seeds.size());
    std::string option;
    std::string ofCase;
    const auto add = [&](const std::string& path, const std::string& value, bool isOption) {
      (isOption ? option : ofCase).append(path).append("=").append(value).append("\n");
    };
    add(kScenarioPath, std::to_string(run.scenario), rule.ranking == kScenarioPath);
    for (std::size_t k = 0; k < experiment.values.size(); ++k) {
      const ExperimentValue& value = experiment.values[k];
      if (!value.isDrawn()) {
        add(value.path, run.values[k], rule.ranking.empty() || rule.ranking == value.path);
      }
    }
    const std::size_t number = numbers.emplace(option, numbers.size()).first->second;
    options_.resize(numbers.size());
    options_[number].emplace(ofCase, place);
  }
  for (std::size_t b = 1; b < options_.size() && !rule.ranking.empty(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      pairs_.emplace_back(a, b);
    }
  }
  const std::size_t count = rule.ranking.empty() ? options_.size() : pairs_.size();
  const double share =
      (1.0 - rule.level) / 2.0 / (pairs_.empty() ? 1.0 : static_cast<double>(count));
  const double width = rule.range.high - rule.range.low;
  const statistics::Interval range =
      pairs_.empty() ? rule.range : statistics::Interval{-width, width};
  for (std::size_t k = 0; k < count; ++k) {
    sequences_.emplace_back(range, statistics::MeanSequence::Errors{share, share});
  }
}

void StoppingCheck::add(std::size_t run, const ResultRow& row) {
  const StoppingRule& rule = *experiment_.until;
  const std::optional<double> value = numberOf(row, rule.metric);
  if (!row.ok) {  // as in reports
    values_[run] = isSuccessKey(rule.metric) ? 0.0 : statistics::kUndefined;
  } else {
    values_[run] =
        value ? std::clamp(*value, rule.range.low, rule.range.high) : statistics::kUndefined;
  }
}

std::vector<std::size_t> StoppingCheck::looks() const {
  const std::size_t seeds = experiment_.seeds.size();
  const std::size_t step =
      std::max(kSeedsPerLook, (kRunsPerLook + runsPerSeed_ - 1) / runsPerSeed_);
  std::vector<std::size_t> looks;
  for (std::size_t next = std::min(step, seeds); looks.empty() || looks.back() < seeds;
       next = std::min(next + step, seeds)) {
    looks.push_back(next);
  }
  return looks;
}

double StoppingCheck::valueAt(std::size_t seed, std::size_t place) const {
  const auto found = values_.find(place * experiment_.seeds.size() + seed);
  return found == values_.end() ? statistics::kUndefined : found->second;
}

double StoppingCheck::meanOf(std::size_t seed, const Places& places) const {
  statistics::Numbers values;
  for (const auto& [ofCase, place] : places) {
    if (const double value = valueAt(seed, place); !std::isnan(value)) {
      values.push_back(value);
    }
  }
  return statistics::mean(values);
}

double StoppingCheck::meanDifference(std::size_t seed, const Places& first,
                                     const Places& second) const {
  statistics::Numbers values;
  for (const auto& [ofCase, place] : first) {
    const auto other = second.find(ofCase);
    const double difference = other == second.end()
                                  ? statistics::kUndefined
                                  : valueAt(seed, place) - valueAt(seed, other->second);
    if (!std::isnan(difference)) {
      values.push_back(difference);
    }
  }
  return statistics::mean(values);
}

void StoppingCheck::addSeed(std::size_t seed) {
  for (std::size_t k = 0; k < sequences_.size(); ++k) {
    const double value = pairs_.empty() ? meanOf(seed, options_[k])
                                        : meanDifference(seed, options_[pairs_[k].first],
                                                         options_[pairs_[k].second]);
    if (!std::isnan(value)) {
      sequences_[k].addRound({value});
    }
  }
}

bool StoppingCheck::isDecided(const statistics::MeanSequence& sequence) const {
  const statistics::Interval& interval = sequence.interval();
  const std::optional<double> halfWidth = experiment_.until->halfWidth;
  return halfWidth ? interval.high - interval.low <= 2.0 * *halfWidth
                   : interval.low > 0.0 || interval.high < 0.0;
}

bool StoppingCheck::isEnough(std::size_t seeds) {
  for (; seeds_ < seeds; ++seeds_) {
    addSeed(seeds_);
  }
  return std::all_of(sequences_.begin(), sequences_.end(),
                     [this](const auto& sequence) { return isDecided(sequence); });
}

}  // namespace app
