#include "app/studies/TuneScore.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "metrics/MetricRegistry.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr double kLossWeight = 5.0;     // of a loss beyond the accepted one
constexpr double kFailureWeight = 3.0;  // of additional failures
constexpr double kUndefinedTime = 2.0;  // times the longer run

double failureShare(const TuneOutcomes& outcomes, const std::vector<std::size_t>& runs) {
  const auto failed = std::count_if(runs.begin(), runs.end(),
                                    [&](std::size_t run) { return !outcomes[run].isSuccess; });
  return static_cast<double>(failed) / static_cast<double>(runs.size());
}

}  // namespace

base::Result<TuneObjective> tuneObjective(const std::string& text) {
  const std::size_t equals = text.find('=');
  TuneObjective objective;
  objective.key = base::trimmed(text.substr(0, equals));
  const metrics::MetricEntry* const entry = metrics::standardRegistry().find(objective.key);
  if (entry == nullptr) {
    return base::error(
        "tune.unknown-objective",
        {objective.key, base::nearestName(objective.key, metrics::standardRegistry().keys())});
  }
  if (entry->info.better == metrics::Better::Neutral) {
    return base::error("tune.neutral-objective", {objective.key});
  }
  if (equals != std::string::npos) {
    const auto weight = base::parseDouble(base::trimmed(text.substr(equals + 1)));
    if (!weight || !(*weight > 0.0) || *weight > 1e6) {
      return base::error("tune.bad-weight", {text});
    }
    objective.weight = *weight;
  }
  objective.name = entry->info.name;
  objective.unit = entry->info.unit;
  objective.sign = entry->info.better == metrics::Better::Higher ? -1.0 : 1.0;
  return objective;
}

TuneOutcome outcomeOf(const ResultRow& row, const std::vector<TuneObjective>& objectives) {
  TuneOutcome outcome;
  outcome.isSuccess = !isUnsuccessful(row);
  outcome.simulated = base::parseDouble(row.simulated).value_or(0.0);
  for (const TuneObjective& objective : objectives) {
    const bool isRate = std::find(std::begin(kSuccessKeys), std::end(kSuccessKeys),
                                  objective.key) != std::end(kSuccessKeys);
    outcome.values.push_back(outcome.isSuccess || isRate
                                 ? numberOf(row, objective.key).value_or(statistics::kUndefined)
                                 : statistics::kUndefined);
  }
  return outcome;
}

bool TuneScore::isAcceptable(double maxLoss) const {
  return failures <= failuresBefore && std::all_of(ratios.begin(), ratios.end(), [&](double ratio) {
           return ratio <= 1.0 + maxLoss;
         });
}

TuneScoring::TuneScoring(std::vector<TuneObjective> objectives, double maxLoss,
                         const TuneOutcomes& before)
    : objectives_(std::move(objectives)), maxLoss_(maxLoss) {
  for (std::size_t k = 0; k < objectives_.size(); ++k) {
    statistics::Numbers values;
    for (const TuneOutcome& outcome : before) {
      if (!std::isnan(outcome.values[k])) {
        values.push_back(outcome.values[k]);
      } else if (objectives_[k].unit == "s") {
        values.push_back(kUndefinedTime * outcome.simulated);
      }
    }
    const double size = values.empty() ? 0.0 : std::fabs(statistics::mean(values));
    scales_.push_back(size > 0.0 ? size : 1.0);
  }
}

TuneScore TuneScoring::score(const TuneOutcomes& tuned, const TuneOutcomes& before,
                             const std::vector<std::size_t>& runs) const {
  TuneScore score;
  score.failures = failureShare(tuned, runs);
  score.failuresBefore = failureShare(before, runs);
  const double more = score.failures - score.failuresBefore;
  double weights = 0.0;
  for (std::size_t k = 0; k < objectives_.size(); ++k) {
    const TuneObjective& objective = objectives_[k];
    statistics::Numbers differences;
    for (const std::size_t run : runs) {
      double after = tuned[run].values[k], value = before[run].values[k];
      if (objective.unit == "s") {
        const double undefined =
            kUndefinedTime * std::max(tuned[run].simulated, before[run].simulated);
        after = std::isnan(after) ? undefined : after;
        value = std::isnan(value) ? undefined : value;
      }
      if (!std::isnan(after - value)) {
        differences.push_back(after - value);
      }
    }
    const double change = differences.empty() ? 0.0 : statistics::mean(differences);
    score.ratios.push_back(1.0 + objective.sign * change / scales_[k]);
    score.total += objective.weight * score.ratios.back();
    weights += objective.weight;
  }
  score.total /= weights;
  for (const double ratio : score.ratios) {
    score.total += kLossWeight * std::max(0.0, ratio - 1.0 - maxLoss_);
  }
  score.total += more > 0.0 ? kFailureWeight * more : more;
  return score;
}

TuneScore TuneScoring::score(const TuneOutcomes& tuned, const TuneOutcomes& before) const {
  std::vector<std::size_t> runs(std::min(tuned.size(), before.size()));
  std::iota(runs.begin(), runs.end(), std::size_t{0});
  return score(tuned, before, runs);
}

TuneDifference differenceOf(const TuneOutcomes& tuned, const TuneOutcomes& before,
                            std::size_t objective, std::size_t scenarios) {
  statistics::Strata strata(scenarios);
  statistics::Numbers first, second;
  for (std::size_t k = 0; k < tuned.size() && k < before.size(); ++k) {
    const double after = tuned[k].values[objective], value = before[k].values[objective];
    if (!std::isnan(after - value)) {
      strata[k % scenarios].push_back(after - value);
      first.push_back(value);
      second.push_back(after);
    }
  }
  TuneDifference made;
  made.pairs = static_cast<int>(first.size());
  if (made.pairs > 0) {
    made.before = statistics::mean(first);
    made.after = statistics::mean(second);
    made.difference = made.after - made.before;
    made.interval = statistics::stratifiedMeanInterval(strata);
  }
  return made;
}

TuneDifference successDifference(const TuneOutcomes& tuned, const TuneOutcomes& before,
                                 std::size_t scenarios) {
  std::vector<statistics::PairedOutcomes> strata(scenarios);
  TuneDifference made;
  double successes = 0.0, earlier = 0.0;
  for (std::size_t k = 0; k < tuned.size() && k < before.size(); ++k) {
    statistics::PairedOutcomes& of = strata[k % scenarios];
    const bool now = tuned[k].isSuccess, then = before[k].isSuccess;
    ++(now && then ? of.both : now ? of.onlyFirst : then ? of.onlySecond : of.neither);
    successes += now ? 1.0 : 0.0;
    earlier += then ? 1.0 : 0.0;
    ++made.pairs;
  }
  if (made.pairs > 0) {
    made.before = earlier / made.pairs;
    made.after = successes / made.pairs;
    made.difference = made.after - made.before;
    made.interval = statistics::stratifiedRateInterval(strata);
  }
  return made;
}

}  // namespace app
