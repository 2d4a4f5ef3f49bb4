#include "app/report/GateReport.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/report/GateTables.h"
#include "app/report/Methods.h"
#include "app/report/PageParts.h"
#include "app/report/Plots.h"
#include "app/report/Study.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

using app::GateMetricResult;
using app::GateVerdict;
using GateJson = nlohmann::ordered_json;

/// Titles of the metrics with this verdict.
std::vector<std::string> titlesWith(const app::GateResult& result, GateVerdict verdict) {
  std::vector<std::string> titles;
  for (const GateMetricResult& each : result.metrics) {
    if (each.verdict == verdict && each.defined > 0) {
      titles.push_back(each.metric.title());
    }
  }
  return titles;
}

std::string gateHeadline(const app::GateOptions& options, const app::GateResult& result) {
  const std::string& candidate = options.candidate.text;
  const std::string& base = options.base.text;
  switch (result.verdict) {
    case GateVerdict::Pass:
      return "PASS: " + candidate + " is not worse than " + base;
    case GateVerdict::Worse:
      return "WORSE: " + candidate + " is worse than " + base + " in " +
             base::join(titlesWith(result, GateVerdict::Worse), ", ");
    case GateVerdict::Undecided:
      break;
  }
  return "UNDECIDED: " + std::to_string(result.pairs.size()) + " pairs do not show whether " +
         candidate + " is worse than " + base;
}

/// How many runs, and what limits the errors.
std::string gateMethodText(const app::GateOptions& options, const app::GateResult& result) {
  const std::string level = levelText(options.level);
  return counted(result.pairs.size(), "pair") + " of runs with the same scenario and seed in " +
         counted(options.scenarios.size(), "scenario") + ", at most " +
         std::to_string(options.maxSeeds) +
         " seeds per scenario. Each metric passes when the candidate is shown to be worse by less "
         "than the margin, and is worse when it is shown to be worse at all. The intervals hold at "
         "all numbers of pairs together (confidence sequences by betting, Waudby-Smith and Ramdas "
         "2024). A candidate that is worse by a margin or more passes with a probability of at "
         "most " +
         level +
         "; one that is not worse is called worse, in any of the metrics, with "
         "a probability of at most " +
         level + ".";
}

/// Remarks on the validity of the result.
std::vector<std::string> gateRemarks(const app::GateOptions& options,
                                     const app::GateResult& result) {
  std::vector<std::string> constant;
  for (const std::size_t scenario : result.constantScenarios) {
    constant.push_back(options.scenarios[scenario].name);
  }
  std::vector<std::string> remarks = withoutSeedEffectRemarks(constant);
  const auto addFailures = [&remarks](std::size_t count, const char* of) {
    if (count > 0) {
      remarks.push_back(counted(count, "run") + " of the " + of +
                        " ended with an error and count as runs without success.");
    }
  };
  addFailures(result.failedBase, "base");
  addFailures(result.failedCandidate, "candidate");
  return remarks;
}

std::string gateHtml(const app::GateOptions& options, const app::GateResult& result,
                     const std::vector<GateFinding>& findings, const std::string& notes,
                     const std::string& provenance) {
  constexpr std::size_t kMostRows = 200;
  PageParts page;
  page.section("metrics", "Metrics");
  page.add(gateTable(result));
  page.add(gateFigure(result));
  page.section("pairs", "Pairs");
  if (findings.empty()) {
    page.body +=
        paragraph("There is no pair in which only the candidate failed, and all metrics passed.");
  } else {
    page.add(findingsTable(options, findings, kMostRows), "failures");
  }
  page.section("methods", "Methods");
  page.body += paragraph(gateMethodText(options, result)) + provenance;
  return page.page("Gate", options.candidate.text + " compared with " + options.base.text + ".",
                   notes);
}

std::string gateMarkdown(const app::GateOptions& options, const app::GateResult& result,
                         const std::vector<GateFinding>& findings, const std::string& headline) {
  constexpr std::size_t kMostRows = 10;
  Table table = gateTable(result);
  table.caption = headline;
  std::string text = tableMarkdown(table) + "\n" + kGateColumnsText + "\n\n";
  for (const std::string& remark : gateRemarks(options, result)) {
    text += "> " + remark + "\n\n";
  }
  if (!findings.empty()) {
    text += "<details><summary>Pairs in which the candidate is worse</summary>\n\n```\n";
    for (std::size_t k = 0; k < std::min(findings.size(), kMostRows); ++k) {
      const GateFinding& finding = findings[k];
      text += "# " + options.scenarios[finding.pair->scenario].name + ", seed " +
              std::to_string(finding.pair->seed) + ": " + finding.what + "\n" +
              finding.playCandidate + "\n";
    }
    text += "```\n\n</details>\n\n";
  }
  return text + gateMethodText(options, result) + "\n";
}

/// A child element of a test case that is not passed; empty if it is.
std::string junitOutcome(const app::GateOptions& options, const GateMetricResult& each,
                         const std::vector<GateFinding>& findings) {
  if (each.defined == 0) {
    return element("skipped", " message=\"no run has a value\"", "");
  }
  if (each.verdict == GateVerdict::Pass) {
    return {};
  }
  const GateDifference difference = gateDifference(each);
  const int decimals = decimalsFor(difference.mean, difference.interval);
  const std::string message = each.metric.title() + ": difference " +
                              plainNumber(difference.mean, decimals) + " [" +
                              plainNumber(difference.interval.low, decimals) + ", " +
                              plainNumber(difference.interval.high, decimals) + "] " +
                              difference.unit + ", margin " + marginText(each.metric);
  std::string details;
  for (const GateFinding& finding : findings) {
    details += options.scenarios[finding.pair->scenario].name + ", seed " +
               std::to_string(finding.pair->seed) + ": " + finding.what + "\n  " +
               finding.playCandidate + "\n";
  }
  const bool isWorse = each.verdict == GateVerdict::Worse;
  return element(isWorse ? "failure" : "error",
                 std::string(" type=\"") + app::gateVerdictName(each.verdict) + "\" message=\"" +
                     escaped(message) + "\"",
                 escaped(details.empty() ? message : details));
}

std::string gateJUnit(const app::GateOptions& options, const app::GateResult& result,
                      const std::vector<GateFinding>& findings, const std::string& headline) {
  std::size_t failures = 0, errors = 0, skipped = 0;
  std::string cases;
  for (const GateMetricResult& each : result.metrics) {
    const bool isMeasured = each.defined > 0;
    skipped += isMeasured ? 0 : 1;
    failures += isMeasured && each.verdict == GateVerdict::Worse ? 1 : 0;
    errors += isMeasured && each.verdict == GateVerdict::Undecided ? 1 : 0;
    cases += element("testcase",
                     " classname=\"hunavsim.gate\" name=\"" + escaped(each.metric.label()) +
                         " (margin " + escaped(marginText(each.metric)) + ")\"",
                     junitOutcome(options, each, findings)) +
             "\n";
  }
  const std::string counts = " tests=\"" + std::to_string(result.metrics.size()) +
                             "\" failures=\"" + std::to_string(failures) + "\" errors=\"" +
                             std::to_string(errors) + "\" skipped=\"" + std::to_string(skipped) +
                             "\"";
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" +
         element("testsuites", " name=\"hunavsim gate\"" + counts,
                 "\n" +
                     element("testsuite", " name=\"" + escaped(headline) + "\"" + counts,
                             "\n" + cases) +
                     "\n") +
         "\n";
}

GateJson gateMetricJson(const GateMetricResult& each) {
  const GateDifference difference = gateDifference(each);
  const bool isRate = each.metric.scale == app::GateMetric::Scale::Rate;
  return {{"metric", each.metric.label()},
          {"verdict", app::gateVerdictName(each.verdict)},
          {"measured", each.defined > 0},
          {"pairs", each.pairs},
          {"base", base::jsonNumber<GateJson>(each.baseMean)},
          {"candidate", base::jsonNumber<GateJson>(each.candidateMean)},
          {"unit", isRate ? "share" : each.metric.unit},
          {"difference",
           {{"mean", base::jsonNumber<GateJson>(difference.mean)},
            {"low", base::jsonNumber<GateJson>(difference.interval.low)},
            {"high", base::jsonNumber<GateJson>(difference.interval.high)},
            {"margin", difference.margin},
            {"unit", difference.unit}}}};
}

std::string gateJson(const app::GateOptions& options, const app::GateResult& result,
                     const std::vector<GateFinding>& findings,
                     const std::vector<app::InputHash>& inputs) {
  GateJson json = {{"verdict", app::gateVerdictName(result.verdict)},
                   {"base", options.base.text},
                   {"candidate", options.candidate.text},
                   {"level", options.level},
                   {"pairs", result.pairs.size()},
                   {"runs", 2 * result.pairs.size()}};
  for (const char* key : {"scenarios", "metrics", "remarks", "findings", "inputs"}) {
    json[key] = GateJson::array();
  }
  for (const app::GateScenario& scenario : options.scenarios) {
    json["scenarios"].push_back(scenario.name);
  }
  for (const GateMetricResult& each : result.metrics) {
    json["metrics"].push_back(gateMetricJson(each));
  }
  json["remarks"] = gateRemarks(options, result);
  for (const GateFinding& finding : findings) {
    json["findings"].push_back({{"scenario", options.scenarios[finding.pair->scenario].name},
                                {"seed", finding.pair->seed},
                                {"what", finding.what},
                                {"play_candidate", finding.playCandidate},
                                {"play_base", finding.playBase}});
  }
  for (const app::InputHash& input : inputs) {
    json["inputs"].push_back({{"path", input.path}, {"sha256", input.sha256}});
  }
  return base::jsonText(json) + "\n";
}

}  // namespace

GateReport makeGateReport(const app::GateOptions& options, const app::GateResult& result,
                          const std::vector<std::string>& command,
                          const std::vector<app::InputHash>& inputs) {
  const std::vector<GateFinding> findings = gateFindings(options, result);
  GateReport report;
  report.headline = gateHeadline(options, result);
  report.html = gateHtml(options, result, findings,
                         verdictNotes(report.headline, gateRemarks(options, result)),
                         provenanceMarkup(inputs, command));
  report.markdown = gateMarkdown(options, result, findings, report.headline);
  report.junit = gateJUnit(options, result, findings, report.headline);
  report.json = gateJson(options, result, findings, inputs);
  return report;
}

std::vector<std::vector<std::string>> gateRows(const app::GateResult& result) {
  const Table table = gateTable(result);
  std::vector<std::vector<std::string>> rows(1);
  for (const Table::Column& column : table.columns) {
    rows.front().push_back(column.title);
  }
  for (const std::vector<Table::Cell>& cells : table.rows) {
    rows.emplace_back();
    for (const Table::Cell& cell : cells) {
      rows.back().push_back(
          withAsciiMinus(cell.text + (cell.below.empty() ? "" : " " + cell.below)));
    }
  }
  return rows;
}

std::string gateColumnsText() {
  return kGateColumnsText;
}

}  // namespace report
