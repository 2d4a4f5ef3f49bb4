#include "app/report/Comparison.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "app/run/SeedEffect.h"
#include "metrics/statistics/PairedTests.h"
#include "metrics/statistics/Ranks.h"
#include "metrics/statistics/Summary.h"
#include "sim2d/base/Find.h"

namespace report {

namespace {

Estimate estimateOf(const Study& study, const Metric& metric, Numbers values) {
  Estimate estimate;
  estimate.values = std::move(values);
  const Numbers& all = estimate.values;
  estimate.mean = statistics::mean(all);
  estimate.deviation = statistics::standardDeviation(all);
  estimate.median = statistics::median(all);
  if (metric.isRate) {
    estimate.successes = static_cast<int>(std::count(all.begin(), all.end(), 1.0));
    estimate.interval =
        statistics::wilsonInterval(estimate.successes, estimate.count(), study.level);
    return estimate;
  }
  estimate.isConstant = areConstant(all);
  if (estimate.isConstant) {
    return estimate;
  }
  statistics::BootstrapOptions options;
  options.level = study.level;
  options.resamples = study.resamples;
  estimate.interval = statistics::bootstrapMeanInterval(all, options);
  estimate.medianInterval = statistics::medianInterval(all, study.level);
  return estimate;
}

/// The difference, rounded to 12 digits of the larger value, so that equal differences compare
/// equal.
double differenceOf(double first, double second) {
  constexpr int kDigits = 12;  // significant digits
  const double difference = first - second;
  const double larger = std::max(std::abs(first), std::abs(second));
  if (difference == 0.0 || !std::isfinite(difference) || larger < 1e-200) {
    return difference;
  }
  const double scale = std::pow(10.0, kDigits - std::ceil(std::log10(larger)));
  return std::isfinite(difference * scale) ? std::round(difference * scale) / scale : difference;
}

statistics::PairedOutcomes outcomesOf(const PairResult::CaseResult& ofCase) {
  const auto count = static_cast<int>(ofCase.differences.size());
  return {ofCase.both, ofCase.higher, ofCase.lower,
          count - ofCase.both - ofCase.higher - ofCase.lower};
}

/// Tests a rate. The values 0 and 1 of both options follow from the outcomes.
void testRates(const Study& study, const std::vector<statistics::PairedOutcomes>& outcomes,
               PairTest& pair) {
  pair.shift = statistics::mean(pair.differences);
  pair.shiftInterval = statistics::stratifiedRateInterval(outcomes, study.level);
  pair.p = statistics::mcNemarP(pair.higher, pair.lower);
}

void testNumbers(const Study& study, const statistics::Strata& strata, PairTest& pair) {
  pair.shift = statistics::stratifiedShift(strata);
  if (!areConstant(pair.differences)) {
    pair.shiftInterval = statistics::stratifiedShiftInterval(strata, study.level);
  }
  pair.p = statistics::stratifiedSignedRank(strata).p;
}

/// The number of pairs required, for the pairs that differ, divided by their share. If at least
/// half of the pairs tie, the ranks contain little more information than the signs.
double requiredPairsFor(const PairTest& pair) {
  const auto pairs = static_cast<double>(pair.differences.size());
  const int differing = pair.higher + pair.lower;
  if (2.0 * differing <= pairs) {
    return statistics::pairsForMcNemar(pair.higher / pairs, pair.lower / pairs);
  }
  Numbers told;
  std::copy_if(pair.differences.begin(), pair.differences.end(), std::back_inserter(told),
               [](double difference) { return difference != 0.0; });
  const double enough = statistics::pairsForSignedRank(statistics::chanceOfPositiveSum(told));
  return std::ceil(enough * pairs / differing);
}

/// Sets how many pairs are enough, and which difference the pairs find. `deviation`: of the
/// differences within cases.
void addPower(bool isRate, double deviation, PairTest& pair) {
  const auto pairs = static_cast<double>(pair.differences.size());
  const double first = pair.higher / pairs;
  const double second = pair.lower / pairs;
  pair.requiredPairs = isRate ? statistics::pairsForMcNemar(first, second) : requiredPairsFor(pair);
  pair.detectable = isRate ? statistics::detectableRateDifference(first + second, pairs)
                           : statistics::detectableShift(deviation, pairs);
}

/// The standard deviation of differences about the mean of their case.
double deviationWithin(const statistics::Strata& strata) {
  double squares = 0.0;
  double freedom = 0.0;
  for (const Numbers& differences : strata) {
    if (differences.size() > 1) {
      const double deviation = statistics::standardDeviation(differences);
      const auto ofCase = static_cast<double>(differences.size() - 1);
      squares += ofCase * deviation * deviation;
      freedom += ofCase;
    }
  }
  return freedom > 0.0 ? std::sqrt(squares / freedom) : statistics::kUndefined;
}

/// Tests each case, and all cases together.
void testPair(const Study& study, bool isRate, PairResult& pair) {
  std::vector<statistics::PairedOutcomes> outcomes;
  statistics::Strata strata;
  for (PairResult::CaseResult& ofCase : pair.cases) {
    outcomes.push_back(outcomesOf(ofCase));
    strata.push_back(ofCase.differences);
    if (isRate) {
      testRates(study, {outcomes.back()}, ofCase);
    } else {
      testNumbers(study, {strata.back()}, ofCase);
    }
    addPower(isRate, deviationWithin({strata.back()}), ofCase);
  }
  if (isRate) {
    testRates(study, outcomes, pair);
  } else {
    testNumbers(study, strata, pair);
  }
  addPower(isRate, deviationWithin(strata), pair);
}

void addDifference(double difference, PairTest& to) {
  to.differences.push_back(difference);
  to.higher += difference > 0.0 ? 1 : 0;
  to.lower += difference < 0.0 ? 1 : 0;
}

PairResult pairOfOptions(const Study& study, std::size_t metric, std::size_t first,
                         std::size_t second, const std::vector<std::vector<std::size_t>>& blocks) {
  PairResult pair;
  pair.first = first;
  pair.second = second;
  std::map<std::size_t, PairResult::CaseResult> cases;
  for (const auto& block : blocks) {
    if (block[first] >= study.runCount() || block[second] >= study.runCount()) {
      continue;
    }
    const double one = valueOf(study, metric, block[first]);
    const double other = valueOf(study, metric, block[second]);
    const double difference = differenceOf(one, other);
    if (!std::isnan(difference)) {
      PairResult::CaseResult& ofCase = cases[study.caseOf[block[first]]];
      ofCase.both += one == 1.0 && other == 1.0 ? 1 : 0;
      addDifference(difference, ofCase);
      addDifference(difference, pair);
    }
  }
  for (auto& [number, ofCase] : cases) {
    ofCase.number = number;
    pair.cases.push_back(std::move(ofCase));
  }
  if (!pair.differences.empty()) {
    testPair(study, study.metrics[metric].isRate, pair);
  }
  return pair;
}

/// Holm's adjustment over the tests that have a p value.
void adjust(const std::vector<PairTest*>& tests) {
  Numbers ps;
  ps.reserve(tests.size());
  std::transform(tests.begin(), tests.end(), std::back_inserter(ps),
                 [](const PairTest* test) { return test->p; });
  const Numbers adjusted = statistics::holm(ps);
  for (std::size_t k = 0; k < tests.size(); ++k) {
    tests[k]->adjusted = adjusted[k];
  }
}

/// Adjusts the tests of each table as one family: pairs over all cases, pairs per case, and
/// Friedman's tests.
void adjustTables(const std::vector<MetricComparison*>& comparisons) {
  std::vector<PairTest*> pairs;
  std::vector<PairTest*> casePairs;
  Numbers friedman;
  for (MetricComparison* comparison : comparisons) {
    for (PairResult& pair : comparison->pairs) {
      pairs.push_back(&pair);
      std::transform(pair.cases.begin(), pair.cases.end(), std::back_inserter(casePairs),
                     [](PairTest& test) { return &test; });
    }
    friedman.push_back(comparison->friedman ? comparison->friedman->fP : statistics::kUndefined);
  }
  adjust(pairs);
  adjust(casePairs);
  friedman = statistics::holm(friedman);
  for (std::size_t k = 0; k < comparisons.size(); ++k) {
    comparisons[k]->friedmanAdjusted = friedman[k];
  }
}

/// Cliff's delta of the values of each case, weighted by the number of comparisons in it.
double deltaOf(const std::vector<Numbers>& first, const std::vector<Numbers>& second) {
  double sum = 0.0;
  double compared = 0.0;
  for (std::size_t k = 0; k < first.size(); ++k) {
    const auto count = static_cast<double>(first[k].size() * second[k].size());
    sum += count > 0.0 ? count * statistics::cliffsDelta(first[k], second[k]) : 0.0;
    compared += count;
  }
  return compared > 0.0 ? sum / compared : statistics::kUndefined;
}

/// The blocks in which every option has a value.
std::vector<Numbers> completeBlocks(const Study& study, std::size_t metric,
                                    const std::vector<std::vector<std::size_t>>& blocks) {
  std::vector<Numbers> complete;
  for (const auto& block : blocks) {
    Numbers values;
    for (const std::size_t run : block) {
      const double value =
          run < study.runCount() ? valueOf(study, metric, run) : statistics::kUndefined;
      if (!std::isnan(value)) {
        values.push_back(value);
      }
    }
    if (values.size() == block.size()) {
      complete.push_back(std::move(values));
    }
  }
  return complete;
}

/// The best option. Nothing: nothing to compare, or all are equal.
std::optional<std::size_t> bestOf(int sense, const MetricComparison& comparison) {
  const auto meanOf = [&](std::size_t option) { return comparison.estimates[option].mean; };
  std::optional<std::size_t> best;
  std::size_t defined = 0;
  for (std::size_t option = 0; option < comparison.estimates.size(); ++option) {
    const double mean = meanOf(option);
    defined += std::isnan(mean) ? 0 : 1;
    if (comparison.succeeds[option] && !std::isnan(mean) &&
        (!best || (mean - meanOf(*best)) * sense > 0.0)) {
      best = option;
    }
  }
  std::size_t leaders = 0;
  for (std::size_t option = 0; best && option < comparison.estimates.size(); ++option) {
    leaders += comparison.succeeds[option] && meanOf(option) == meanOf(*best) ? 1 : 0;
  }
  return leaders < defined ? best : std::nullopt;
}

/// Compares with the best option by the signs of the paired differences, not by the means.
RelativeToBest relativeToBestOf(const Metric& metric, const MetricComparison& comparison,
                                std::size_t option) {
  const bool isSuccess = metric.isRate && metric.sense > 0;
  if (!comparison.succeeds[option] && !isSuccess) {
    return RelativeToBest::NeverSucceeds;
  }
  const PairResult* const pair = comparison.pairOf(*comparison.best, option);
  if (pair == nullptr || !(pair->adjusted < kSignificance)) {
    return RelativeToBest::NotDifferent;
  }
  const int more = pair->first == option ? pair->higher - pair->lower : pair->lower - pair->higher;
  const double shift = pair->first == option ? pair->shift : -pair->shift;
  const double towards = shift != 0.0 ? shift : more;
  return towards * metric.sense > 0.0 ? RelativeToBest::Better : RelativeToBest::Worse;
}

void findBest(const Metric& metric, MetricComparison& comparison) {
  comparison.relativeToBest.assign(comparison.estimates.size(), RelativeToBest::NotDifferent);
  if (metric.sense != 0) {
    comparison.best = bestOf(metric.sense, comparison);
  }
  for (std::size_t option = 0; comparison.best && option < comparison.estimates.size(); ++option) {
    comparison.relativeToBest[option] = relativeToBestOf(metric, comparison, option);
  }
}

app::SeedEffect seedEffectOf(const Study& study) {
  app::SeedEffect effect;
  for (std::size_t run = 0; run < study.runCount(); ++run) {
    Numbers values;
    values.reserve(study.results.metrics.size());
    for (const Numbers& each : study.results.metrics) {
      values.push_back(each[run]);
    }
    effect.add(study.options[study.optionOf[run]] + ", " + study.cases[study.caseOf[run]],
               study.results.runs[run].seed, values);
  }
  return effect;
}

}  // namespace

const PairResult* MetricComparison::pairOf(std::size_t a, std::size_t b) const {
  return base::findIf(pairs, [&](const PairResult& pair) {
    return (pair.first == a && pair.second == b) || (pair.first == b && pair.second == a);
  });
}

bool areConstant(const Numbers& values) {
  return values.size() > 1 && std::all_of(values.begin(), values.end(), [&values](double value) {
           return value == values.front();
         });
}

double valueOf(const Study& study, std::size_t metric, std::size_t run) {
  if (study.results.runs[run].ok) {
    return study.valuesOf(metric)[run];
  }
  const Metric& what = study.metrics[metric];
  return what.isRate && what.sense > 0 ? 0.0 : statistics::kUndefined;
}

std::vector<bool> succeedingOptions(const Study& study) {
  std::vector<bool> succeeds(study.options.size(), true);
  const std::size_t key = study.results.keyAt("success");
  if (key >= study.results.keys.size()) {
    return succeeds;
  }
  std::vector<double> most(study.options.size(), statistics::kUndefined);
  for (std::size_t run = 0; run < study.runCount(); ++run) {
    if (study.results.runs[run].ok) {
      double& known = most[study.optionOf[run]];
      known = std::fmax(known, study.valuesOf(key)[run]);  // fmax ignores NaN
    }
  }
  std::transform(most.begin(), most.end(), succeeds.begin(),
                 [](double value) { return std::isnan(value) || value > 0.0; });
  return succeeds;
}

std::vector<std::vector<std::size_t>> blocksOf(const Study& study) {
  std::map<std::pair<std::size_t, long long>, std::size_t> places;
  std::vector<std::vector<std::size_t>> blocks;
  for (std::size_t run = 0; run < study.runCount(); ++run) {
    const auto [place, isNew] =
        places.try_emplace({study.caseOf[run], study.results.runs[run].seed}, blocks.size());
    if (isNew) {
      blocks.emplace_back(study.options.size(), study.runCount());
    }
    std::size_t& slot = blocks[place->second][study.optionOf[run]];
    slot = std::min(slot, run);  // the first, if the experiment lists a value twice
  }
  return blocks;
}

std::vector<std::string> constantCells(const Study& study) {
  return seedEffectOf(study).constantCells();
}

bool isOneRunPerCell(const Study& study) {
  const app::SeedEffect effect = seedEffectOf(study);
  return study.options.size() > 1 && effect.cellCount() > 0 &&
         effect.constantCells().size() == effect.cellCount();
}

MetricComparison compare(const Study& study, std::size_t metric,
                         const std::vector<std::vector<std::size_t>>& blocks) {
  MetricComparison comparison;
  comparison.metric = metric;
  std::vector<Numbers> values(study.options.size());
  std::vector<std::vector<Numbers>> byCase(study.options.size(),
                                           std::vector<Numbers>(study.cases.size()));
  for (std::size_t run = 0; run < study.runCount(); ++run) {
    const double value = valueOf(study, metric, run);
    if (!std::isnan(value)) {
      values[study.optionOf[run]].push_back(value);
      byCase[study.optionOf[run]][study.caseOf[run]].push_back(value);
    }
  }
  for (Numbers& each : values) {
    comparison.estimates.push_back(estimateOf(study, study.metrics[metric], std::move(each)));
  }
  for (std::size_t first = 0; first < study.options.size(); ++first) {
    for (std::size_t second = first + 1; second < study.options.size(); ++second) {
      comparison.pairs.push_back(pairOfOptions(study, metric, first, second, blocks));
      comparison.pairs.back().delta = deltaOf(byCase[first], byCase[second]);
    }
  }
  if (study.options.size() > 2) {
    const std::vector<Numbers> complete = completeBlocks(study, metric, blocks);
    if (complete.size() > 1) {
      comparison.friedman = statistics::friedman(complete);
      comparison.criticalDifference = statistics::nemenyiDifference(
          comparison.friedman->options, comparison.friedman->blocks, 1.0 - kSignificance);
    }
  }
  comparison.succeeds = succeedingOptions(study);
  adjustTables({&comparison});
  findBest(study.metrics[metric], comparison);
  return comparison;
}

void adjustTogether(const Study& study, std::vector<MetricComparison>& comparisons) {
  std::vector<MetricComparison*> all;
  all.reserve(comparisons.size());
  std::transform(comparisons.begin(), comparisons.end(), std::back_inserter(all),
                 [](MetricComparison& each) { return &each; });
  adjustTables(all);
  for (MetricComparison& comparison : comparisons) {
    findBest(study.metrics[comparison.metric], comparison);
  }
}

TestCounts testCounts(const std::vector<MetricComparison>& comparisons) {
  TestCounts counts;
  const auto count = [](const PairTest& test) { return std::isnan(test.p) ? 0U : 1U; };
  for (const MetricComparison& comparison : comparisons) {
    for (const PairResult& pair : comparison.pairs) {
      counts.pairs += count(pair);
      for (const PairResult::CaseResult& ofCase : pair.cases) {
        counts.casePairs += count(ofCase);
      }
    }
    counts.friedman += comparison.friedman ? 1 : 0;
  }
  return counts;
}

int decimalsFor(double value, const Interval& interval) {
  constexpr int kMost = 6;
  constexpr double kMore = 2.0;      // at most five significant digits
  constexpr double kTwoUnits = 0.3;  // log10(2): the half width is at least two units
  const auto placeOf = [](double size) { return std::floor(std::log10(size)); };
  double decimals = value != 0.0 && std::isfinite(value) ? 2.0 - placeOf(std::abs(value)) : 0.0;
  const double half = 0.5 * (interval.high - interval.low);
  if (half > 0.0 && std::isfinite(half)) {
    const double size = std::log10(half);
    const double usual = decimals;
    decimals = std::clamp(decimals, std::ceil(kTwoUnits - size), std::ceil(1.0 - size));
    decimals = std::min(decimals, usual + kMore);
  }
  return static_cast<int>(std::clamp(decimals, 0.0, static_cast<double>(kMost)));
}

}  // namespace report
