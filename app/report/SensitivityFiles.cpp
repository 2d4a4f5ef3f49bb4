#include <cmath>

#include <nlohmann/json.hpp>

#include "app/report/Markup.h"
#include "app/report/Sensitivity.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

using ReportJson = nlohmann::ordered_json;

std::string fieldText(double value) {
  return std::isfinite(value) ? base::formatDouble(value) : std::string();
}

/// A named number of a factor; a column of the CSV file.
using NamedNumber = std::pair<const char*, double>;

std::vector<NamedNumber> numbersOf(const SensitivityResult& result, std::size_t factor) {
  if (result.morris) {
    const statistics::MorrisFactor& each = result.morris->factors[factor];
    return {{"mu_star", each.meanSize},
            {"mu_star_low", each.meanSizeInterval.low},
            {"mu_star_high", each.meanSizeInterval.high},
            {"mu", each.mean},
            {"sigma", each.deviation},
            {"effects", static_cast<double>(each.count)}};
  }
  const statistics::SobolFactor& each = result.sobol->factors[factor];
  return {{"total", each.total},
          {"total_low", each.totalInterval.low},
          {"total_high", each.totalInterval.high},
          {"first", each.first},
          {"first_low", each.firstInterval.low},
          {"first_high", each.firstInterval.high}};
}

double orderShareAt(const SensitivityResult& result, std::size_t place) {
  const Numbers& shares = result.ranking().orderShares;
  return place < shares.size() ? shares[place] : statistics::kUndefined;
}

ReportJson factorsJson(const Study& study, const SensitivityResult& result) {
  ReportJson factors = ReportJson::array();
  const std::vector<std::size_t>& order = result.ranking().order;
  for (std::size_t place = 0; place < order.size(); ++place) {
    ReportJson factor = {{"path", study.sensitivity->factors[order[place]].path},
                         {"rank", place + 1}};
    for (const auto& [name, value] : numbersOf(result, order[place])) {
      factor[name] = base::jsonNumber<ReportJson>(value);
    }
    factor["order_share"] = base::jsonNumber<ReportJson>(orderShareAt(result, place));
    factors.push_back(std::move(factor));
  }
  return factors;
}

ReportJson resultJson(const Study& study, const SensitivityAnalysis& analysis,
                      const SensitivityResult& result) {
  const TooFewPoints few = tooFewPoints(study, result);
  ReportJson wide = ReportJson::array(), unordered = ReportJson::array();
  for (const std::size_t factor : few.wide) {
    wide.push_back(study.sensitivity->factors[factor].path);
  }
  for (const std::size_t place : few.unordered) {
    const std::vector<std::size_t>& order = result.ranking().order;
    unordered.push_back({study.sensitivity->factors[order[place]].path,
                         study.sensitivity->factors[order[place + 1]].path});
  }
  return {{"metric", study.metrics[result.metric].key},
          {"case", analysis.cases[result.caseNumber]},
          {"varies", result.varies},
          {"undefined_points", result.undefined},
          {"seed_share", base::jsonNumber<ReportJson>(result.seedShare)},
          {"too_few_points",
           {{"wide", wide},
            {"unordered", unordered},
            {"required", base::jsonNumber<ReportJson>(few.required)}}},
          {"factors", factorsJson(study, result)}};
}

}  // namespace

std::string sensitivityJson(const Study& study, const SensitivityAnalysis& analysis) {
  const Study::Sensitivity& sensitivity = *study.sensitivity;
  ReportJson factors = ReportJson::array(), constant = ReportJson::array(),
             results = ReportJson::array();
  for (const Study::Factor& factor : sensitivity.factors) {
    factors.push_back({{"path", factor.path}, {"from", factor.from}, {"to", factor.to}});
  }
  for (const std::size_t metric : analysis.constant) {
    constant.push_back(study.metrics[metric].key);
  }
  for (const SensitivityResult& result : analysis.results) {
    results.push_back(resultJson(study, analysis, result));
  }
  return base::jsonText(ReportJson{
             {"method",
              sensitivity.design.method == app::Design::Method::Morris ? "morris" : "sobol"},
             {"points", sensitivity.design.points},
             {"seed", sensitivity.design.seed},
             {"runs", study.runCount()},
             {"seeds", analysis.seeds},
             {"level", study.level},
             {"resamples", study.resamples},
             {"factors", factors},
             {"constant_metrics", constant},
             {"results", results}}) +
         "\n";
}

std::string sensitivityCsv(const Study& study, const SensitivityAnalysis& analysis) {
  std::vector<std::vector<std::string>> rows = {
      {"metric", "case", "path", "from", "to", "rank", "order_share"}};
  for (const SensitivityResult& result : analysis.results) {
    const std::vector<std::size_t>& order = result.ranking().order;
    for (std::size_t place = 0; place < order.size(); ++place) {
      const Study::Factor& factor = study.sensitivity->factors[order[place]];
      std::vector<std::string> row = {study.metrics[result.metric].key,
                                      analysis.cases[result.caseNumber],
                                      factor.path,
                                      fieldText(factor.from),
                                      fieldText(factor.to),
                                      std::to_string(place + 1),
                                      fieldText(orderShareAt(result, place))};
      const bool isFirst = rows.size() == 1;
      for (const auto& [name, value] : numbersOf(result, order[place])) {
        row.push_back(fieldText(value));
        if (isFirst) {
          rows.front().push_back(name);
        }
      }
      rows.push_back(std::move(row));
    }
  }
  return csvText(rows);
}

}  // namespace report
