#include "app/report/SensitivityPage.h"

#include <algorithm>
#include <cmath>

#include "app/report/ContactTables.h"
#include "app/report/Methods.h"
#include "app/report/PageParts.h"
#include "app/report/PlayerPage.h"
#include "app/report/Plots.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

using Cell = Table::Cell;

bool isMorrisStudy(const Study& study) {
  return study.sensitivity->design.method == app::Design::Method::Morris;
}

std::string pointsWord(const Study& study) {
  return isMorrisStudy(study) ? "trajectories" : "base points";
}

Cell valueCell(double value, const statistics::Interval& interval = {}) {
  const int decimals = std::isnan(value) ? 0 : decimalsFor(value, interval);
  Cell cell = numberCell(numberText(value, decimals), value);
  cell.below = intervalText(interval, decimals);
  cell.csv = std::isnan(value) ? "" : base::formatDouble(value);
  return cell;
}

std::string rangeText(const Study::Factor& factor) {
  return base::formatDouble(factor.from) + " … " + base::formatDouble(factor.to);
}

void addIndices(const SensitivityResult& result, std::size_t factor, std::vector<Cell>& row) {
  if (result.morris) {
    const statistics::MorrisFactor& each = result.morris->factors[factor];
    row.push_back(valueCell(each.meanSize, each.meanSizeInterval));
    row.push_back(valueCell(each.mean));
    row.push_back(valueCell(each.deviation));
    row.push_back({std::to_string(each.count)});
    return;
  }
  const statistics::SobolFactor& each = result.sobol->factors[factor];
  row.push_back(valueCell(each.total, each.totalInterval));
  row.push_back(valueCell(each.first, each.firstInterval));
}

Table indicesTable(const Study& study, const SensitivityAnalysis& analysis, std::size_t metric) {
  const Metric& shown = study.metrics[analysis.metrics[metric]];
  const std::vector<std::string> names = factorNames(study);
  Table table;
  table.name = "sensitivity_" + shown.key;
  table.caption = titleOf(shown) +
                  ": indices of each value, by importance. Order: share of bootstrap "
                  "resamples in which the value is before the next one.";
  table.columns = {{"Case", "", false}, {"Value", "", false}, {"Range", "", false}};
  const std::string unit = shown.unit == "-" ? "" : shown.unit;
  if (isMorrisStudy(study)) {
    table.columns.insert(table.columns.end(),
                         {{"μ*", unit}, {"μ", unit}, {"σ", unit}, {"Effects", ""}});
  } else {
    table.columns.insert(table.columns.end(), {{"Total", ""}, {"First order", ""}});
  }
  table.columns.push_back({"Order", ""});
  for (std::size_t k = 0; k < analysis.cases.size(); ++k) {
    const SensitivityResult& result = analysis.of(metric, k);
    const std::vector<std::size_t>& order = result.ranking().order;
    for (std::size_t place = 0; result.varies && place < order.size(); ++place) {
      std::vector<Cell> row = {{analysis.cases[k]},
                               {names[order[place]]},
                               {rangeText(study.sensitivity->factors[order[place]])}};
      addIndices(result, order[place], row);
      const bool isLast = place + 1 == order.size();
      row.push_back({isLast ? "" : percentText(result.ranking().orderShares[place])});
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

/// The mean over the cases in which the metric varies: of the total index, or of mu* relative to
/// the largest one.
double meanImportance(const SensitivityAnalysis& analysis, std::size_t metric, std::size_t factor) {
  Numbers shares;
  for (std::size_t k = 0; k < analysis.cases.size(); ++k) {
    const SensitivityResult& result = analysis.of(metric, k);
    if (result.varies) {
      shares.push_back(result.morris ? result.relativeImportance(factor)
                                     : result.importance(factor));
    }
  }
  return statistics::mean(shares);
}

Table overviewTable(const Study& study, const SensitivityAnalysis& analysis) {
  Table table;
  table.name = "overview";
  table.caption =
      isMorrisStudy(study)
          ? "Importance of each value: μ* relative to the largest μ* of the metric, mean over the "
            "cases. The most important value of a metric is bold."
          : "Importance of each value: total Sobol index, mean over the cases. The most important "
            "value of a metric is bold.";
  table.columns = {{"Value", "", false}, {"Range", "", false}};
  std::vector<double> largest;
  for (std::size_t m = 0; m < analysis.metrics.size(); ++m) {
    table.columns.push_back({study.metrics[analysis.metrics[m]].name, ""});
    largest.push_back(0.0);
    for (std::size_t f = 0; f < study.sensitivity->factors.size(); ++f) {
      largest.back() = std::max(largest.back(), meanImportance(analysis, m, f));
    }
  }
  const std::vector<std::string> names = factorNames(study);
  for (std::size_t f = 0; f < names.size(); ++f) {
    std::vector<Cell> row = {{names[f]}, {rangeText(study.sensitivity->factors[f])}};
    for (std::size_t m = 0; m < analysis.metrics.size(); ++m) {
      const double share = meanImportance(analysis, m, f);
      Cell cell{isMorrisStudy(study) ? percentText(share) : numberText(share, 2)};
      cell.sort = base::formatDouble(share);
      cell.csv = base::formatDouble(share);
      cell.bold = share == largest[m];
      row.push_back(std::move(cell));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// "a, b and c"
std::string listText(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    text += (k == 0 ? "" : k + 1 == words.size() ? " and " : ", ") + words[k];
  }
  return text;
}

std::string importanceText(const SensitivityResult& result, std::size_t factor) {
  const double value = result.importance(factor);
  return (result.morris ? "μ* " : "total index ") +
         numberText(value, decimalsFor(value, result.importanceInterval(factor)));
}

/// What is not certain in a result.
std::vector<std::string> reasonsOf(const Study& study, const SensitivityResult& result) {
  const std::vector<std::string> names = factorNames(study);
  const TooFewPoints few = tooFewPoints(study, result);
  std::vector<std::string> reasons;
  if (!few.wide.empty()) {
    std::vector<std::string> wide;
    for (const std::size_t factor : few.wide) {
      wide.push_back(names[factor]);
    }
    const char* const range = result.morris ? "μ*" : "index";
    std::string text =
        wide.size() == 1
            ? "the confidence interval of " + wide[0] + " is wider than its " + range
            : "the confidence intervals of " + listText(wide) + " are wider than their " + range;
    if (std::isfinite(few.required)) {
      text += " (about " + numberText(few.required, 0) + " " + pointsWord(study) +
              " would be needed instead of " + std::to_string(study.sensitivity->design.points) +
              ")";
    }
    reasons.push_back(text);
  }
  for (const std::size_t place : few.unordered) {
    const statistics::FactorRanking& ranking = result.ranking();
    reasons.push_back("the order of " + names[ranking.order[place]] + " and " +
                      names[ranking.order[place + 1]] + " is not certain (the same in " +
                      percentText(ranking.orderShares[place]) + " of the resamples)");
  }
  return reasons;
}

/// Of one result: too few points, seeds or values; empty: it is certain.
std::string warningOf(const Study& study, const SensitivityAnalysis& analysis,
                      const SensitivityResult& result) {
  std::vector<std::string> reasons = reasonsOf(study, result);
  if (result.varies && result.seedShare > kLargeSeedShare) {
    reasons.push_back(percentText(result.seedShare) +
                      " of the variance between points is due to the choice of the " +
                      counted(analysis.seeds, "seed") + " (more seeds reduce it)");
  }
  if (result.undefined > 0) {
    reasons.push_back(counted(result.undefined, "point") + " of " + std::to_string(result.points) +
                      " have no value and are excluded");
  }
  if (reasons.empty()) {
    return {};
  }
  return titleOf(study.metrics[result.metric]) + ", " + analysis.cases[result.caseNumber] + ": " +
         base::join(reasons, "; ") + ".";
}

/// A page section by section.
class SensitivityPageBuilder {
 public:
  SensitivityPageBuilder(const Study& study, const SensitivityAnalysis& analysis)
      : study_(study), analysis_(analysis) {}

  Report make(const std::vector<std::string>& command) {
    if (!analysis_.metrics.empty()) {
      parts_.section("overview", "Overview");
      parts_.add(overviewTable(study_, analysis_));
    }
    for (std::size_t metric = 0; metric < analysis_.metrics.size(); ++metric) {
      writeMetric(metric);
    }
    addContactsSection(study_, parts_);
    parts_.section("methods", "Methods");
    parts_.body += methods(command);
    parts_.report.moreFiles = {{"sensitivity.json", sensitivityJson(study_, analysis_)},
                               {"sensitivity.csv", sensitivityCsv(study_, analysis_)}};
    parts_.report.html = parts_.page("Sensitivity", lead(), notes());
    return std::move(parts_.report);
  }

 private:
  void writeMetric(std::size_t metric) {
    const Metric& shown = study_.metrics[analysis_.metrics[metric]];
    parts_.section("metric-" + shown.key, shown.name);
    parts_.add(importanceFigure(study_, analysis_, metric));
    parts_.add(effectsFigure(study_, analysis_, metric));
    parts_.add(indicesTable(study_, analysis_, metric), "failures");
    for (std::size_t k = 0; k < analysis_.cases.size(); ++k) {
      const std::string warning = warningOf(study_, analysis_, analysis_.of(metric, k));
      parts_.body += warning.empty() ? "" : paragraph(warning, " class=\"warning\"");
    }
  }

  std::string lead() const {
    const app::Design& design = study_.sensitivity->design;
    return counted(study_.runCount(), "run") + ": " + std::to_string(design.points) + " " +
           pointsWord(study_) + " of " + counted(study_.sensitivity->factors.size(), "value") +
           ", " + counted(analysis_.cases.size(), "case") + ", " +
           counted(analysis_.seeds, "seed") + ".";
  }

  std::string notes() const {
    std::string findings;
    for (const std::string& finding : sensitivityFindings(study_, analysis_)) {
      findings += element("li", "", escaped(finding)) + "\n";
    }
    std::string text = findings.empty() ? "" : element("ul", "", "\n" + findings) + "\n";
    const std::size_t count = sensitivityWarnings(study_, analysis_).size();
    if (count > 0) {
      text +=
          paragraph(counted(count, "result") + " of " + std::to_string(analysis_.results.size()) +
                        " (metric and case) " + (count == 1 ? "is" : "are") +
                        " uncertain: too few points or seeds. The sections of the metrics give "
                        "the reasons.",
                    " class=\"warning\"");
    }
    std::vector<std::string> constant;
    for (const std::size_t metric : analysis_.constant) {
      constant.push_back(study_.metrics[metric].name);
    }
    return text + (constant.empty()
                       ? ""
                       : paragraph("Do not vary in this study: " + listText(constant) + "."));
  }

  std::string methods(const std::vector<std::string>& command) const {
    const app::Design& design = study_.sensitivity->design;
    return filled(isMorrisStudy(study_) ? kMorrisText : kSobolText,
                  {{"points", std::to_string(design.points)},
                   {"seed", std::to_string(design.seed)},
                   {"level", levelText(study_.level)},
                   {"resamples", std::to_string(study_.resamples)},
                   {"provenance", provenanceMarkup(study_, shellText(command))}});
  }

  const Study& study_;
  const SensitivityAnalysis& analysis_;
  PageParts parts_;
};

}  // namespace

std::vector<std::string> sensitivityFindings(const Study& study,
                                             const SensitivityAnalysis& analysis) {
  constexpr std::size_t kMost = 3;
  const std::vector<std::string> names = factorNames(study);
  std::vector<std::string> findings;
  for (std::size_t metric = 0; metric < analysis.metrics.size(); ++metric) {
    std::vector<std::string> ofCases;
    for (std::size_t k = 0; k < analysis.cases.size(); ++k) {
      const SensitivityResult& result = analysis.of(metric, k);
      std::vector<std::string> factors;
      for (const std::size_t factor : result.ranking().order) {
        if (result.varies && factors.size() < kMost &&
            result.relativeImportance(factor) >= kNegligible) {
          factors.push_back(names[factor] + " (" + importanceText(result, factor) + ")");
        }
      }
      ofCases.push_back((analysis.cases.size() > 1 ? analysis.cases[k] + ": " : "") +
                        (factors.empty() ? "does not vary" : base::join(factors, ", ")));
    }
    findings.push_back(titleOf(study.metrics[analysis.metrics[metric]]) + ": " +
                       base::join(ofCases, "; "));
  }
  return findings;
}

std::vector<std::string> sensitivityWarnings(const Study& study,
                                             const SensitivityAnalysis& analysis) {
  std::vector<std::string> warnings;
  for (const SensitivityResult& result : analysis.results) {
    const std::string warning = warningOf(study, analysis, result);
    if (!warning.empty()) {
      warnings.push_back(warning);
    }
  }
  return warnings;
}

Report makeSensitivityReport(const Study& study, const SensitivityAnalysis& analysis,
                             const std::vector<std::string>& command) {
  return SensitivityPageBuilder(study, analysis).make(command);
}

}  // namespace report
