#include "app/studies/TuneScore.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "metrics/MetricRegistry.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr double kLossWeight = 5.0;          // of a loss beyond the accepted one
constexpr double kMoreFailuresWeight = 3.0;  // of an increase of the share of failures
constexpr double kUndefinedTime = 2.0;       // times the mean time of the reference

/// A mean of paired differences with its standard error; 0 for a single one.
struct PairedMean {
  double mean = 0.0, error = 0.0;
};

PairedMean pairedMean(const statistics::Numbers& differences) {
  if (differences.empty()) {
    return {};
  }
  const double count = static_cast<double>(differences.size());
  const double error =
      differences.size() > 1 ? statistics::standardDeviation(differences) / std::sqrt(count) : 0.0;
  return {statistics::mean(differences), error};
}

double failureShare(const TuneOutcomes& outcomes) {
  const auto failed = std::count_if(outcomes.begin(), outcomes.end(),
                                    [](const TuneOutcome& each) { return !each.isSuccess; });
  return static_cast<double>(failed) / static_cast<double>(outcomes.size());
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
  outcome.remaining = std::clamp(numberOf(row, kRemainingKey).value_or(1.0), 0.0, 1.0);
  for (const TuneObjective& objective : objectives) {
    outcome.values.push_back(outcome.isSuccess || isSuccessKey(objective.key)
                                 ? numberOf(row, objective.key).value_or(statistics::kUndefined)
                                 : statistics::kUndefined);
  }
  return outcome;
}

bool TuneScore::isAcceptable(double maxLoss) const {
  return failures <= failuresBefore + failureError &&
         std::all_of(ratios.begin(), ratios.end(),
                     [&](double ratio) { return ratio <= 1.0 + maxLoss; });
}

TuneScoring::TuneScoring(std::vector<TuneObjective> objectives, double maxLoss,
                         const TuneOutcomes& reference)
    : objectives_(std::move(objectives)), maxLoss_(maxLoss) {
  for (std::size_t k = 0; k < objectives_.size(); ++k) {
    statistics::Numbers values, durations;
    for (const TuneOutcome& outcome : reference) {
      if (!std::isnan(outcome.values[k])) {
        values.push_back(outcome.values[k]);
      }
      durations.push_back(outcome.simulated);
    }
    if (values.empty() && objectives_[k].unit == "s") {
      values = durations;
    }
    const double size = values.empty() ? 0.0 : std::fabs(statistics::mean(values));
    scales_.push_back(size > 0.0 ? size : 1.0);
    weights_ += objectives_[k].weight;
  }
}

double TuneScoring::timeOf(const TuneOutcome& run, const TuneOutcome& other,
                           std::size_t objective) const {
  if (!std::isnan(run.values[objective])) {
    return run.values[objective];
  }
  const double others =
      std::isnan(other.values[objective]) ? other.simulated : other.values[objective];
  return std::max({run.simulated, others, kUndefinedTime * scales_[objective]});
}

double TuneScoring::changeOf(const TuneOutcome& tuned, const TuneOutcome& reference,
                             std::size_t objective) const {
  const bool isTime = objectives_[objective].unit == "s";
  const double after = isTime ? timeOf(tuned, reference, objective) : tuned.values[objective];
  const double before = isTime ? timeOf(reference, tuned, objective) : reference.values[objective];
  return objectives_[objective].sign * (after - before) / scales_[objective];
}

TuneScore TuneScoring::score(const TuneOutcomes& tuned, const TuneOutcomes& reference) const {
  TuneScore score;
  score.failures = failureShare(tuned);
  score.failuresBefore = failureShare(reference);
  statistics::Numbers totals, failures;
  for (std::size_t run = 0; run < tuned.size(); ++run) {
    totals.push_back(tuned[run].severity() - reference[run].severity());
    failures.push_back((tuned[run].isSuccess ? 0.0 : 1.0) - (reference[run].isSuccess ? 0.0 : 1.0));
  }
  score.total = statistics::mean(totals);
  for (std::size_t k = 0; k < objectives_.size(); ++k) {
    const double share = objectives_[k].weight / weights_;
    statistics::Numbers changes;
    for (std::size_t run = 0; run < tuned.size(); ++run) {
      const double change = changeOf(tuned[run], reference[run], k);
      if (!std::isnan(change)) {
        changes.push_back(change);
        totals[run] += share * change;
      }
    }
    const PairedMean change = pairedMean(changes);
    score.ratios.push_back(1.0 + change.mean);
    score.total += share * score.ratios.back() +
                   kLossWeight * std::max(0.0, change.mean - maxLoss_ - change.error);
  }
  const PairedMean more = pairedMean(failures);
  score.failureError = more.error;
  score.total += kMoreFailuresWeight * std::max(0.0, more.mean - more.error);
  score.error = pairedMean(totals).error;
  return score;
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
