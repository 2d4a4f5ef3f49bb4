#include "app/report/Tables.h"

#include <algorithm>
#include <cmath>

#include "app/report/Plots.h"
#include "metrics/statistics/Ranks.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

using Cell = Table::Cell;

constexpr double kManyPairs = 9999.0;
constexpr const char* kPowerText =
    "Enough: number of pairs required to detect a difference such as the observed one. Detectable: "
    "smallest difference that this number of pairs can detect (both: power 80 %, level 5 % without "
    "adjustment).";

/// A p value; files contain all its digits.
Cell pValueCell(double p, bool bold = false) {
  const std::string digits = std::isnan(p) ? std::string() : base::formatDouble(p);
  Cell cell{pValueText(p)};
  cell.sort = digits.empty() ? "–" : digits;
  cell.bold = bold;
  cell.csv = digits;
  return cell;
}

/// The cells with the metric and the options of a pair.
std::vector<Cell> namesOfPair(const Study& study, const MetricComparison& comparison,
                              const PairResult& pair) {
  return {{titleOf(study.metrics[comparison.metric])},
          {study.options[pair.first] + " − " + study.options[pair.second]}};
}

/// Adds the cells: pairs, signs, difference, both p values.
void addTest(const Study& study, const MetricComparison& comparison, const PairTest& test,
             std::vector<Cell>& row) {
  const Metric& metric = study.metrics[comparison.metric];
  const int decimals = decimalsFor(test.shift, test.shiftInterval);
  const auto ties = static_cast<int>(test.differences.size()) - test.higher - test.lower;
  Cell shift = numberCell(estimateText(metric, test.shift, decimals), test.shift);
  shift.below = !metric.isRate && areConstant(test.differences)
                    ? kConstant
                    : estimateInterval(metric, test.shiftInterval, decimals);
  row.push_back(numberCell(std::to_string(test.differences.size()),
                           static_cast<double>(test.differences.size())));
  row.push_back({std::to_string(test.higher) + " / " + std::to_string(ties) + " / " +
                 std::to_string(test.lower)});
  row.push_back(std::move(shift));
  row.push_back(pValueCell(test.p));
  row.push_back(pValueCell(test.adjusted, test.adjusted < kSignificance));
}

/// Adds the cells: pairs that are enough for the difference, difference that the pairs find.
/// `cases`: of the test, to state seeds.
void addPowerCells(const Study& study, const MetricComparison& comparison, const PairTest& test,
                   std::size_t cases, std::vector<Cell>& row) {
  const Metric& metric = study.metrics[comparison.metric];
  Cell enough =
      numberCell(test.requiredPairs > kManyPairs ? "> 9999" : numberText(test.requiredPairs, 0),
                 test.requiredPairs);
  if (cases > 1 && test.requiredPairs <= kManyPairs) {
    const double seeds = std::ceil(test.requiredPairs / static_cast<double>(cases));
    enough.note = numberText(seeds, 0) + (seeds == 1.0 ? " seed" : " seeds");
  }
  row.push_back(std::move(enough));
  const int decimals = decimalsFor(test.detectable, test.shiftInterval);
  row.push_back(numberCell(estimateText(metric, test.detectable, decimals), test.detectable));
}

/// The numbers of cases in which the first option is higher, equal and lower by the typical
/// difference.
std::string directionsOf(const PairResult& pair) {
  int directions[3] = {};
  for (const PairResult::CaseResult& ofCase : pair.cases) {
    const double towards =
        ofCase.shift != 0.0 ? ofCase.shift : static_cast<double>(ofCase.higher - ofCase.lower);
    ++directions[towards > 0.0 ? 0 : towards < 0.0 ? 2 : 1];
  }
  return std::to_string(directions[0]) + " / " + std::to_string(directions[1]) + " / " +
         std::to_string(directions[2]);
}

std::vector<Cell> pairRow(const Study& study, const MetricComparison& comparison,
                          const PairResult& pair) {
  std::vector<Cell> row = namesOfPair(study, comparison, pair);
  addTest(study, comparison, pair, row);
  row.push_back(numberCell(numberText(pair.delta, 2), pair.delta));
  addPowerCells(study, comparison, pair, pair.cases.size(), row);
  if (study.cases.size() > 1) {
    row.push_back({directionsOf(pair)});
  }
  return row;
}

/// The pairs that a table lists.
std::vector<const PairResult*> listedPairs(const MetricComparison& comparison, bool all) {
  if (!all) {
    return shownPairs(comparison);
  }
  std::vector<const PairResult*> pairs;
  for (const PairResult& pair : comparison.pairs) {
    pairs.push_back(&pair);
  }
  return pairs;
}

/// The number of blocks with which the largest difference of mean ranks is Nemenyi's critical one;
/// NaN: all mean ranks are equal.
double enoughBlocks(const MetricComparison& comparison) {
  const Numbers& ranks = comparison.friedman->meanRanks;
  const auto [least, most] = std::minmax_element(ranks.begin(), ranks.end());
  const double ratio = comparison.criticalDifference / (*most - *least);
  return *most > *least ? std::ceil(comparison.friedman->blocks * ratio * ratio)
                        : statistics::kUndefined;
}

std::vector<std::string> summaryRow(const Study& study, std::size_t metric, const Numbers& values) {
  const Metric& what = study.metrics[metric];
  const Numbers five = statistics::quantiles(values, {0.0, 0.25, 0.5, 0.75, 1.0});
  const Interval interval = !what.isRate && areConstant(values)
                                ? Interval()
                                : statistics::meanInterval(values, study.level);
  std::vector<std::string> row = {what.key, what.unit == "-" ? "" : what.unit,
                                  std::to_string(values.size())};
  for (const double number :
       {statistics::mean(values), statistics::standardDeviation(values), interval.low,
        interval.high, five[0], five[1], five[2], five[3], five[4]}) {
    row.push_back(std::isnan(number) ? std::string() : base::formatDouble(number));
  }
  return row;
}

}  // namespace

std::string comparedName(const Study& study) {
  return study.compared.empty() ? "Option" : study.compared;
}

std::string allTests(std::size_t count) {
  return count == 1 ? "the only test" : "all " + std::to_string(count) + " tests";
}

std::string estimateInterval(const Metric& metric, const Interval& interval, int decimals) {
  return metric.isRate ? intervalText(interval, 0, 100.0) : intervalText(interval, decimals);
}

std::string estimateText(const Metric& metric, double value, int decimals) {
  return metric.isRate && !std::isnan(value) ? percentText(value) : numberText(value, decimals);
}

Table pairsTable(const Study& study, const Comparisons& comparisons, bool all) {
  Table table;
  table.name = "pairs";
  table.columns = {{"Metric", {}, false},   {"Pair", {}, false},      {"Pairs", {}, true},
                   {"+ / = / −", {}, true}, {"Difference", {}, true}, {"p", {}, true},
                   {"p, Holm", {}, true},   {"δ", {}, true},          {"Enough", {}, true},
                   {"Detectable", {}, true}};
  const bool hasCases = study.cases.size() > 1;
  if (hasCases) {
    table.columns.push_back({"Cases + / = / −", {}, true});
  }
  for (const MetricComparison& comparison : comparisons) {
    for (const PairResult* pair : listedPairs(comparison, all)) {
      table.rows.push_back(pairRow(study, comparison, *pair));
    }
  }
  table.caption =
      "Comparison of options on the same case and seed. + / = / −: number of pairs in which the "
      "first option is higher, equal, lower. Difference: Hodges-Lehmann estimate (rates: "
      "difference of rates) with its confidence interval, level " +
      levelText(study.level) +
      ". p: signed-rank test (rates: McNemar's test). p, Holm: adjusted over " +
      allTests(testCounts(comparisons).pairs) + ". δ: Cliff's delta. " + kPowerText +
      (hasCases
           ? " Differences are ranked within their case and combined over cases (van Elteren). "
             "Cases + / = / −: number of cases in which the first option is higher, equal, lower."
           : "") +
      (all || study.options.size() < 4
           ? ""
           : " Only pairs with the best option are listed (if there is none, with the first); "
             "tables/pairs.csv contains all pairs.");
  return table;
}

std::optional<Table> casePairsTable(const Study& study, const Comparisons& comparisons, bool all) {
  constexpr std::size_t kMaxRows = 200;
  if (study.cases.size() < 2) {
    return std::nullopt;
  }
  Table table;
  table.name = "pairs_by_case";
  table.columns = {{"Metric", {}, false},   {"Pair", {}, false},     {"Case", {}, false},
                   {"Pairs", {}, true},     {"+ / = / −", {}, true}, {"Difference", {}, true},
                   {"p", {}, true},         {"p, Holm", {}, true},   {"Enough", {}, true},
                   {"Detectable", {}, true}};
  bool isCut = false;
  for (const MetricComparison& comparison : comparisons) {
    for (const PairResult* pair : listedPairs(comparison, all)) {
      for (const PairResult::CaseResult& ofCase : pair->cases) {
        isCut = isCut || (!all && table.rows.size() >= kMaxRows);
        if (isCut) {
          break;
        }
        std::vector<Cell> row = namesOfPair(study, comparison, *pair);
        row.push_back({study.cases[ofCase.number]});
        addTest(study, comparison, ofCase, row);
        addPowerCells(study, comparison, ofCase, 1, row);
        table.rows.push_back(std::move(row));
      }
    }
  }
  table.caption = "The same pairs separately for each case. p, Holm: adjusted over " +
                  allTests(testCounts(comparisons).casePairs) + ". " + kPowerText +
                  std::string(isCut ? " The first " + std::to_string(kMaxRows) +
                                          " rows are listed; tables/pairs_by_case.csv contains all."
                                    : "");
  return table.rows.empty() ? std::nullopt : std::optional(std::move(table));
}

std::optional<Table> familyTable(const Study& study, const Comparisons& comparisons) {
  Table table;
  table.name = "friedman";
  table.columns = {
      {"Metric", {}, false}, {"Blocks", {}, true}, {"χ²", {}, true},           {"p", {}, true},
      {"F", {}, true},       {"p of F", {}, true}, {"p of F, Holm", {}, true}, {"CD", {}, true},
      {"Enough", {}, true}};
  for (const MetricComparison& comparison : comparisons) {
    if (!comparison.friedman) {
      continue;
    }
    const statistics::Friedman& test = *comparison.friedman;
    table.rows.push_back(
        {{titleOf(study.metrics[comparison.metric])},
         {std::to_string(test.blocks)},
         {numberText(test.chiSquared, 2)},
         pValueCell(test.p),
         {std::isinf(test.f) ? std::string("∞") : numberText(test.f, 2)},
         pValueCell(test.fP),
         pValueCell(comparison.friedmanAdjusted, comparison.friedmanAdjusted < kSignificance),
         {numberText(comparison.criticalDifference, 2)},
         numberCell(numberText(enoughBlocks(comparison), 0), enoughBlocks(comparison))});
  }
  table.caption =
      "Friedman's test over all options, for blocks in which every option has a value. F: "
      "statistic of Iman and Davenport. p of F, Holm: adjusted over " +
      allTests(testCounts(comparisons).friedman) +
      ". CD: Nemenyi's critical difference of mean ranks (level 5 "
      "%), the smallest that these blocks can show. Enough: number of blocks with which the "
      "largest "
      "observed difference is the critical one.";
  return table.rows.empty() ? std::nullopt : std::optional(std::move(table));
}

Table failuresTable(const Study& study, const std::vector<std::size_t>& failures,
                    const std::vector<std::size_t>& played) {
  Table table;
  table.name = "failures";
  table.columns = {{"Run", {}, true},  {comparedName(study), {}, false}, {"Case", {}, false},
                   {"Seed", {}, true}, {"What happened", {}, false},     {"Replay", {}, false}};
  for (const std::size_t run : failures) {
    const Results::Run& row = study.results.runs[run];
    const std::string command = study.replayCommand(run);
    std::string button;
    const auto place = std::find(played.begin(), played.end(), run);
    if (place != played.end()) {
      const std::string number = std::to_string(place - played.begin());
      button =
          "<button type=\"button\" class=\"play\" data-replay=\"" + number + "\">Play</button> ";
    }
    table.rows.push_back({{std::to_string(row.number)},
                          {study.options[study.optionOf[run]]},
                          {study.cases[study.caseOf[run]]},
                          {std::to_string(row.seed)},
                          {study.outcomeText(run)},
                          commandCell(command, button)});
  }
  return table;
}

std::string allMetricsCsv(const Study& study) {
  std::vector<std::vector<std::string>> rows = {{comparedName(study), "case", "metric", "unit", "n",
                                                 "mean", "sd", "low", "high", "min", "q1", "median",
                                                 "q3", "max"}};
  const std::size_t cases = study.cases.size();
  for (std::size_t metric = 0; metric < study.metrics.size(); ++metric) {
    // Per option: all cases together, then each case.
    std::vector<Numbers> values(study.options.size() * (cases + 1));
    for (std::size_t run = 0; run < study.runCount(); ++run) {
      const double value = valueOf(study, metric, run);
      const std::size_t first = study.optionOf[run] * (cases + 1);
      if (!std::isnan(value)) {
        values[first].push_back(value);
        values[first + 1 + study.caseOf[run]].push_back(value);
      }
    }
    for (std::size_t k = 0; k < values.size(); ++k) {
      const std::size_t ofCase = k % (cases + 1);
      if (cases == 1 && ofCase == 1) {
        continue;  // identical to "all"
      }
      std::vector<std::string> row = {study.options[k / (cases + 1)],
                                      ofCase == 0 ? "all" : study.cases[ofCase - 1]};
      const std::vector<std::string> summary = summaryRow(study, metric, values[k]);
      row.insert(row.end(), summary.begin(), summary.end());
      rows.push_back(std::move(row));
    }
  }
  return csvText(rows);
}

}  // namespace report
