#include <algorithm>
#include <cmath>

#include "app/studies/Tuner.h"

namespace app {

base::Diagnostics Tuner::evaluate() {
  show("evaluation");
  std::vector<RunRequest> requests;
  for (const TunedValues& values : {present_, *result_.chosen}) {
    for (std::size_t run = 0; run < heldOutRuns(); ++run) {
      const long long seed = kHeldOutSeed + static_cast<long long>(run / options_.heldOut.size());
      requests.push_back(
          subject_.request(options_.heldOut[run % options_.heldOut.size()], seed, values));
    }
  }
  const base::Result<std::vector<ResultRow>> rows = pool_.run(requests);
  if (!rows) {
    return rows.diagnostics();
  }
  result_.evaluationRuns = requests.size();
  TuneOutcomes outcomes;
  for (const ResultRow& row : *rows) {
    outcomes.push_back(outcomeOf(row, options_.objectives));
  }
  const auto half = outcomes.begin() + static_cast<std::ptrdiff_t>(heldOutRuns());
  compareHeldOut({outcomes.begin(), half}, {half, outcomes.end()});
  return {};
}

void Tuner::compareHeldOut(const TuneOutcomes& before, const TuneOutcomes& tuned) {
  TuneEvaluation made;
  const std::size_t scenarios = options_.heldOut.size();
  made.success = successDifference(tuned, before, scenarios);
  made.objectives = differencesOf(tuned, before, scenarios);
  for (std::size_t scenario = 0; scenario < scenarios; ++scenario) {
    const TuneOutcomes then = ofScenario(before, scenario), now = ofScenario(tuned, scenario);
    made.scenarios.emplace_back(successDifference(now, then, 1), differencesOf(now, then, 1));
    if (then.size() > 1 && areEqual(then) && areEqual(now)) {
      made.withoutSeedEffect.push_back(options_.heldOut[scenario]);
    }
  }
  result_.verdict = isImprovement(made, options_.objectives, options_.maxLoss)
                        ? TuneVerdict::Improved
                        : TuneVerdict::NotConfirmed;
  result_.evaluation = std::move(made);
}

std::vector<TuneDifference> Tuner::differencesOf(const TuneOutcomes& tuned,
                                                 const TuneOutcomes& before,
                                                 std::size_t scenarios) const {
  std::vector<TuneDifference> differences;
  for (std::size_t k = 0; k < options_.objectives.size(); ++k) {
    differences.push_back(differenceOf(tuned, before, k, scenarios));
  }
  return differences;
}

TuneOutcomes Tuner::ofScenario(const TuneOutcomes& all, std::size_t scenario) const {
  TuneOutcomes some;
  for (std::size_t k = scenario; k < all.size(); k += options_.heldOut.size()) {
    some.push_back(all[k]);
  }
  return some;
}

bool Tuner::areEqual(const TuneOutcomes& outcomes) {
  const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  return std::all_of(outcomes.begin(), outcomes.end(), [&](const TuneOutcome& each) {
    const TuneOutcome& first = outcomes.front();
    return each.simulated == first.simulated && each.isSuccess == first.isSuccess &&
           std::equal(each.values.begin(), each.values.end(), first.values.begin(), same);
  });
}

bool isImprovement(const TuneEvaluation& evaluation, const std::vector<TuneObjective>& objectives,
                   double maxLoss) {
  bool isBetter = evaluation.success.interval.low > 0.0;
  if (!(evaluation.success.interval.high >= 0.0)) {
    return false;
  }
  for (std::size_t k = 0; k < objectives.size(); ++k) {
    const TuneDifference& of = evaluation.objectives[k];
    const double sign = objectives[k].sign;
    const double size = std::fabs(of.before) > 0.0 ? std::fabs(of.before) : 1.0;
    if (sign * of.difference / size > maxLoss) {
      return false;
    }
    isBetter = isBetter || (sign > 0.0 ? of.interval.high < 0.0 : of.interval.low > 0.0);
  }
  return isBetter;
}

}  // namespace app
