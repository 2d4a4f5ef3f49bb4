#include "app/report/GateTables.h"

#include <algorithm>
#include <cmath>

#include "app/report/Comparison.h"
#include "app/report/Study.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

using app::GateMetric;
using app::GateMetricResult;
using app::GateVerdict;
using GateScale = app::GateMetric::Scale;
using statistics::Interval;

/// A gain as a difference candidate - base.
double differenceOf(const GateMetric& metric, double gain) {
  const double difference = metric.sense * gain;
  switch (metric.scale) {
    case GateScale::Rate:
      return 100.0 * difference;
    case GateScale::Ratio:
      return 100.0 * std::expm1(difference);
    case GateScale::Difference:
      break;
  }
  return difference;
}

/// A value of a metric: "93 %", "21.40".
std::string gateValueText(const GateMetric& metric, double value, int decimals) {
  return metric.scale == GateScale::Rate && !std::isnan(value) ? numberText(100.0 * value, 1) + " %"
                                                               : numberText(value, decimals);
}

std::string unitSuffix(const std::string& unit) {
  return unit.empty() || unit == "-" ? std::string() : " " + unit;
}

std::string gatePlayCommand(const app::GateOptions& options, const app::GatePair& pair,
                            bool candidate) {
  const app::RunRequest request = app::gateRequest(options, pair.scenario, pair.seed, candidate);
  app::RunSpec spec = request.spec;
  spec.scenario = request.scenario;
  spec.seed = request.seed;
  std::vector<std::string> words = app::commandLineOf(spec);
  words.front() = "hunavsim";
  return shellText(words);
}

std::string outcomeOfRow(const app::ResultRow& row) {
  return app::outcomeText(row.ok, row.reason, [&row](const char* key) {
    return app::numberOf(row, key).value_or(statistics::kUndefined);
  });
}

GateFinding findingOf(const app::GateOptions& options, const app::GatePair& pair,
                      std::string what) {
  return {&pair, std::move(what), gatePlayCommand(options, pair, true),
          gatePlayCommand(options, pair, false)};
}

/// The pairs with the largest losses by a metric.
std::vector<GateFinding> lossesBy(const app::GateOptions& options, const app::GateResult& result,
                                  const GateMetric& metric) {
  constexpr std::size_t kMost = 5;
  std::vector<std::pair<double, const app::GatePair*>> losses;
  for (const app::GatePair& pair : result.pairs) {
    const double gain = app::gainOf(metric, pair.base, pair.candidate).gain;
    if (gain < 0.0) {
      losses.emplace_back(gain, &pair);
    }
  }
  std::stable_sort(losses.begin(), losses.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  losses.resize(std::min(losses.size(), kMost));
  std::vector<GateFinding> findings;
  for (const auto& [gain, pair] : losses) {
    const app::GateGain values = app::gainOf(metric, pair->base, pair->candidate);
    const auto text = [&metric](const std::optional<double>& value) {
      return value ? gateValueText(metric, *value, decimalsFor(*value)) : std::string("no value");
    };
    findings.push_back(
        findingOf(options, *pair,
                  metric.title() + ": " + text(values.base) + " to " + text(values.candidate)));
  }
  return findings;
}

}  // namespace

GateDifference gateDifference(const GateMetricResult& result) {
  const GateMetric& metric = result.metric;
  GateDifference difference;
  difference.mean = differenceOf(metric, result.meanGain);
  difference.interval = {differenceOf(metric, result.gain.low),
                         differenceOf(metric, result.gain.high)};
  if (metric.sense < 0) {
    std::swap(difference.interval.low, difference.interval.high);
  }
  difference.margin = metric.scale == GateScale::Difference ? metric.margin : 100.0 * metric.margin;
  difference.unit = metric.scale == GateScale::Rate    ? "points"
                    : metric.scale == GateScale::Ratio ? "%"
                    : metric.unit == "%"               ? "points"
                                                       : metric.unit;
  return difference;
}

std::string marginText(const GateMetric& metric) {
  GateMetricResult result;
  result.metric = metric;
  const GateDifference difference = gateDifference(result);
  return base::formatDecimals(std::round(1e6 * difference.margin) / 1e6, 0) +
         unitSuffix(difference.unit);
}

Table gateTable(const app::GateResult& result) {
  Table table;
  table.name = "gate";
  table.caption = kGateColumnsText;
  table.columns = {{"Metric", {}, false},
                   {"Base, mean", {}, true},
                   {"Candidate, mean", {}, true},
                   {"Difference of pairs", {}, true},
                   {"Margin", {}, true},
                   {"Verdict", {}, false},
                   {"Pairs", {}, true}};
  for (const GateMetricResult& each : result.metrics) {
    const GateDifference difference = gateDifference(each);
    const int decimals = decimalsFor(difference.mean, difference.interval);
    const int places = decimalsFor(each.baseMean);
    const bool isMeasured = each.defined > 0;
    Table::Cell change{"–"};
    if (isMeasured) {
      change.text = signedNumberText(difference.mean, decimals) + unitSuffix(difference.unit);
      change.below = intervalText(difference.interval, decimals);
    }
    Table::Cell verdict{isMeasured ? app::gateVerdictName(each.verdict) : "not measured"};
    verdict.bold = each.verdict == GateVerdict::Worse;
    table.rows.push_back({{each.metric.title()},
                          {gateValueText(each.metric, each.baseMean, places)},
                          {gateValueText(each.metric, each.candidateMean, places)},
                          std::move(change),
                          {marginText(each.metric)},
                          std::move(verdict),
                          {std::to_string(each.pairs)}});
  }
  return table;
}

Figure gateFigure(const app::GateResult& result) {
  constexpr double kRow = 30.0, kNames = 260.0, kWidth = 720.0, kTop = 8.0;
  constexpr double kReach = 4.0;  // margins on each side
  const double bottom = kTop + kRow * static_cast<double>(result.metrics.size());
  Figure figure("gate", kWidth, bottom + 44.0);
  const Scale scale{-kReach, kReach, kNames, kWidth - 18.0};
  for (const double tick : axisTicks(scale)) {
    figure.line(scale.at(tick), kTop, scale.at(tick), bottom, "grid");
  }
  figure.line(scale.at(0.0), kTop, scale.at(0.0), bottom, "axis");
  figure.line(scale.at(-1.0), kTop, scale.at(-1.0), bottom, "zero", 1.5);
  for (std::size_t k = 0; k < result.metrics.size(); ++k) {
    const GateMetricResult& each = result.metrics[k];
    const double margin = app::marginAsGain(each.metric);
    const double y = kTop + (static_cast<double>(k) + 0.5) * kRow;
    figure.text(kNames - 10.0, y + 4.0, shortened(each.metric.title(), 38), "ink",
                Figure::Anchor::End);
    if (each.defined == 0) {
      figure.text(scale.at(0.0) + 6.0, y + 4.0, "not measured", "dim");
      continue;
    }
    const auto at = [&](double gain) {
      return scale.at(std::clamp(gain / margin, -kReach, kReach));
    };
    const std::size_t color = each.verdict == GateVerdict::Worse ? 1 : 0;
    figure.line(at(each.gain.low), y, at(each.gain.high), y, strokeOf(color), 2.0);
    figure.mark(at(each.meanGain), y, color);
  }
  horizontalAxis(figure, scale, bottom);
  figure.text(scale.at(0.0), bottom + 38.0, "gain of the candidate, in margins", "dim",
              Figure::Anchor::Middle);
  figure.caption =
      "Mean gain of the candidate per pair with its interval, in units of the margin: to the right "
      "the candidate is better. A metric passes when its interval is right of the dashed line "
      "(one margin worse) and is worse when it is left of 0. Intervals beyond 4 margins are cut.";
  return figure;
}

std::vector<GateFinding> gateFindings(const app::GateOptions& options,
                                      const app::GateResult& result) {
  std::vector<GateFinding> findings;
  for (const app::GatePair& pair : result.pairs) {
    if (app::isUnsuccessful(pair.candidate) && !app::isUnsuccessful(pair.base)) {
      findings.push_back(findingOf(options, pair, outcomeOfRow(pair.candidate)));
    }
  }
  const auto isKnown = [&findings](const GateFinding& finding) {
    return std::any_of(findings.begin(), findings.end(),
                       [&](const GateFinding& each) { return each.pair == finding.pair; });
  };
  for (const GateMetricResult& each : result.metrics) {
    if (each.verdict == GateVerdict::Pass) {
      continue;
    }
    for (GateFinding& finding : lossesBy(options, result, each.metric)) {
      if (!isKnown(finding)) {
        findings.push_back(std::move(finding));
      }
    }
  }
  return findings;
}

Table findingsTable(const app::GateOptions& options, const std::vector<GateFinding>& findings,
                    std::size_t most) {
  Table table;
  table.name = "findings";
  table.columns = {{"Scenario", {}, false},
                   {"Seed", {}, true},
                   {"Candidate", {}, false},
                   {"Play the candidate", {}, false},
                   {"Play the base", {}, false}};
  for (const GateFinding& finding : findings) {
    if (table.rows.size() >= most) {
      break;
    }
    table.rows.push_back({{options.scenarios[finding.pair->scenario].name},
                          {std::to_string(finding.pair->seed)},
                          {finding.what},
                          commandCell(finding.playCandidate),
                          commandCell(finding.playBase)});
  }
  table.caption =
      "Pairs in which the candidate is worse: runs in which only the candidate has no "
      "success, then the largest losses by metrics that are not passed.";
  if (findings.size() > most) {
    table.caption += " The first " + std::to_string(most) + " of " +
                     std::to_string(findings.size()) + " are listed.";
  }
  return table;
}

}  // namespace report
