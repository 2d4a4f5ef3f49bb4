#include "app/report/Sensitivity.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>

#include "app/report/Comparison.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

using statistics::kUndefined;

/// The runs of one case with one seed: one per point, in the order of the design.
using PointRuns = std::vector<std::size_t>;

/// The runs of a study by case and seed.
struct DesignRuns {
  std::vector<std::string> cases;
  std::vector<std::vector<PointRuns>> runs;  // per case and seed
};

/// The positions of the factors among the paths of the results.
std::vector<std::size_t> factorColumns(const Study& study) {
  std::vector<std::size_t> columns;
  const std::vector<std::string>& paths = study.results.paths;
  for (const Study::Factor& factor : study.sensitivity->factors) {
    columns.push_back(static_cast<std::size_t>(std::find(paths.begin(), paths.end(), factor.path) -
                                               paths.begin()));
  }
  return columns;
}

/// Names the case of each run by the scenario and the listed values that vary.
class CaseNames {
 public:
  explicit CaseNames(const Study& study) : study_(study) {
    const std::vector<std::size_t> factors = factorColumns(study);
    const Results& results = study.results;
    for (std::size_t k = 0; k < results.paths.size(); ++k) {
      const bool isDrawn =
          std::find(study.drawn.begin(), study.drawn.end(), results.paths[k]) != study.drawn.end();
      const bool isFactor = std::find(factors.begin(), factors.end(), k) != factors.end();
      const bool varies = std::any_of(
          results.runs.begin(), results.runs.end(),
          [&](const Results::Run& run) { return run.values[k] != results.runs[0].values[k]; });
      if (!isDrawn && !isFactor && varies) {
        columns_.push_back(k);
      }
    }
  }
  std::string of(std::size_t run) const {
    std::string name = study_.scenarioName(run);
    for (const std::size_t column : columns_) {
      const std::string& path = study_.results.paths[column];
      name +=
          ", " + path.substr(path.rfind('.') + 1) + " " + study_.results.runs[run].values[column];
    }
    return name;
  }

 private:
  const Study& study_;
  std::vector<std::size_t> columns_;
};

/// Error: a case does not have all points with each seed.
base::Result<DesignRuns> designRunsOf(const Study& study) {
  DesignRuns found;
  const CaseNames names(study);
  std::map<std::string, std::size_t> caseNumbers;
  std::vector<std::map<long long, std::size_t>> seedNumbers;
  for (std::size_t run = 0; run < study.runCount(); ++run) {
    const auto [place, isNewCase] = caseNumbers.emplace(names.of(run), caseNumbers.size());
    if (isNewCase) {
      found.cases.push_back(place->first);
      found.runs.emplace_back();
      seedNumbers.emplace_back();
    }
    std::vector<PointRuns>& ofCase = found.runs[place->second];
    auto& seeds = seedNumbers[place->second];
    const auto [seed, isNewSeed] = seeds.emplace(study.results.runs[run].seed, seeds.size());
    if (isNewSeed) {
      ofCase.emplace_back();
    }
    ofCase[seed->second].push_back(run);
  }
  const std::size_t points =
      study.sensitivity->design.pointCount(study.sensitivity->factors.size());
  for (const auto& ofCase : found.runs) {
    for (const PointRuns& runs : ofCase) {
      if (runs.size() != points || ofCase.size() != found.runs.front().size()) {
        return base::error("report.sensitivity-incomplete", {runs.size(), points}, study.folder);
      }
    }
  }
  return found;
}

/// The values of a metric at the points, per seed; NaN: undefined.
std::vector<Numbers> outputsOf(const Study& study, std::size_t metric,
                               const std::vector<PointRuns>& seeds) {
  std::vector<Numbers> outputs;
  for (const PointRuns& runs : seeds) {
    outputs.emplace_back();
    for (const std::size_t run : runs) {
      outputs.back().push_back(valueOf(study, metric, run));
    }
  }
  return outputs;
}

/// The mean of the defined values of row k of each list; NaN: none.
double definedMean(const std::vector<Numbers>& lists, std::size_t k) {
  Numbers defined;
  for (const Numbers& list : lists) {
    if (!std::isnan(list[k])) {
      defined.push_back(list[k]);
    }
  }
  return statistics::mean(defined);
}

/// Each list minus the mean of its defined values.
std::vector<Numbers> centredBySeed(std::vector<Numbers> outputs) {
  for (Numbers& values : outputs) {
    Numbers defined;
    std::copy_if(values.begin(), values.end(), std::back_inserter(defined),
                 [](double value) { return !std::isnan(value); });
    const double mean = statistics::mean(defined);
    for (double& value : values) {
      value -= mean;
    }
  }
  return outputs;
}

Numbers pointMeans(const std::vector<Numbers>& outputs) {
  Numbers means;
  for (std::size_t k = 0; k < outputs.front().size(); ++k) {
    means.push_back(definedMean(outputs, k));
  }
  return means;
}

/// Two-way layout of points and seeds without interaction: the variance of the mean over the seeds,
/// from the residuals, relative to the variance of the points' means. Points with a value for all
/// seeds.
double seedShareOf(const std::vector<Numbers>& outputs) {
  std::vector<Numbers> complete(outputs.size());
  for (std::size_t k = 0; k < outputs.front().size(); ++k) {
    const bool isComplete = std::none_of(outputs.begin(), outputs.end(),
                                         [k](const Numbers& each) { return std::isnan(each[k]); });
    for (std::size_t seed = 0; isComplete && seed < outputs.size(); ++seed) {
      complete[seed].push_back(outputs[seed][k]);
    }
  }
  const auto seeds = static_cast<double>(outputs.size());
  const auto points = static_cast<double>(complete.front().size());
  if (seeds < 2.0 || points < 2.0) {
    return kUndefined;
  }
  const std::vector<Numbers> centred = centredBySeed(complete);
  const Numbers means = pointMeans(centred);
  double squares = 0.0;
  for (const Numbers& values : centred) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      squares += (values[k] - means[k]) * (values[k] - means[k]);
    }
  }
  const double ofMean = squares / ((points - 1.0) * (seeds - 1.0)) / seeds;
  const double deviation = statistics::standardDeviation(means);
  return deviation > 0.0 ? std::min(1.0, ofMean / (deviation * deviation)) : kUndefined;
}

/// The points of the design in [0, 1], from the values of the runs.
std::vector<Numbers> pointsOf(const Study& study, const PointRuns& runs) {
  const std::vector<std::size_t> columns = factorColumns(study);
  std::vector<Numbers> points;
  for (const std::size_t run : runs) {
    points.emplace_back();
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const Study::Factor& factor = study.sensitivity->factors[k];
      const double value =
          base::parseDouble(study.results.runs[run].values[columns[k]]).value_or(kUndefined);
      points.back().push_back((value - factor.from) / (factor.to - factor.from));
    }
  }
  return points;
}

/// Effects per seed, averaged over the seeds that have them.
std::vector<Numbers> meanEffects(const std::vector<Numbers>& points,
                                 const std::vector<Numbers>& outputs) {
  std::vector<std::vector<Numbers>> bySeed;
  bySeed.reserve(outputs.size());
  for (const Numbers& values : outputs) {
    bySeed.push_back(statistics::elementaryEffects(points, values));
  }
  std::vector<Numbers> effects = bySeed.front();
  for (std::size_t t = 0; t < effects.size(); ++t) {
    std::vector<Numbers> ofTrajectory;
    ofTrajectory.reserve(bySeed.size());
    for (const auto& each : bySeed) {
      ofTrajectory.push_back(each[t]);
    }
    effects[t] = pointMeans(ofTrajectory);
  }
  return effects;
}

/// The rows of Saltelli's design that are defined at all points.
std::vector<statistics::SaltelliRow> saltelliRows(const Numbers& values, std::size_t factors) {
  std::vector<statistics::SaltelliRow> rows;
  for (std::size_t start = 0; start + factors + 2 <= values.size(); start += factors + 2) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(start);
    const auto end = at + static_cast<std::ptrdiff_t>(factors) + 2;
    if (std::none_of(at, end, [](double value) { return std::isnan(value); })) {
      rows.push_back({*at, *(at + 1), Numbers(at + 2, end)});
    }
  }
  return rows;
}

SensitivityResult resultOf(const Study& study, std::size_t metric,
                           const std::vector<PointRuns>& seeds) {
  const std::vector<Numbers> outputs = outputsOf(study, metric, seeds);
  const Numbers means = pointMeans(centredBySeed(outputs));
  SensitivityResult result;
  result.metric = metric;
  result.points = means.size();
  result.undefined = static_cast<std::size_t>(
      std::count_if(means.begin(), means.end(), [](double mean) { return std::isnan(mean); }));
  result.seedShare = seedShareOf(outputs);
  statistics::BootstrapOptions options;
  options.level = study.level;
  options.resamples = study.resamples;
  if (study.sensitivity->design.method == app::Design::Method::Morris) {
    result.morris =
        statistics::morrisIndices(meanEffects(pointsOf(study, seeds.front()), outputs), options);
  } else {
    result.sobol =
        statistics::sobolIndices(saltelliRows(means, study.sensitivity->factors.size()), options);
  }
  const std::vector<std::size_t>& order = result.ranking().order;
  result.varies = !order.empty() && result.importance(order.front()) > 0.0;
  return result;
}

}  // namespace

double SensitivityResult::importance(std::size_t factor) const {
  return morris ? morris->factors[factor].meanSize : sobol->factors[factor].total;
}

statistics::Interval SensitivityResult::importanceInterval(std::size_t factor) const {
  return morris ? morris->factors[factor].meanSizeInterval : sobol->factors[factor].totalInterval;
}

double SensitivityResult::relativeImportance(std::size_t factor) const {
  const double first = ranking().order.empty() ? 0.0 : importance(ranking().order.front());
  const double own = importance(factor);
  return first > 0.0 && own > 0.0 ? own / first : 0.0;
}

TooFewPoints tooFewPoints(const Study& study, const SensitivityResult& result) {
  constexpr double kCertain = 0.95;
  TooFewPoints found;
  if (!result.varies) {
    return found;
  }
  const statistics::FactorRanking& ranking = result.ranking();
  for (std::size_t place = 0; place < ranking.order.size(); ++place) {
    const std::size_t factor = ranking.order[place];
    if (result.relativeImportance(factor) < kNegligible) {
      break;
    }
    const statistics::Interval interval = result.importanceInterval(factor);
    const double width = (interval.high - interval.low) / result.importance(factor);
    if (!(width <= 1.0)) {
      found.wide.push_back(factor);
      const double required =
          std::ceil(static_cast<double>(study.sensitivity->design.points) * width * width);
      found.required = std::isnan(found.required) ? required : std::max(found.required, required);
    }
    const bool hasNext = place + 1 < ranking.order.size() &&
                         result.relativeImportance(ranking.order[place + 1]) >= kNegligible;
    if (hasNext && !(ranking.orderShares[place] >= kCertain)) {
      found.unordered.push_back(place);
    }
  }
  return found;
}

base::Result<SensitivityAnalysis> analyseSensitivity(const Study& study) {
  for (const std::size_t column : factorColumns(study)) {
    if (column == study.results.paths.size()) {  // the results are of another batch
      return base::error("report.bad-manifest", {},
                         (std::filesystem::path(study.folder) / "manifest.json").string());
    }
  }
  base::Result<DesignRuns> runs = designRunsOf(study);
  if (!runs) {
    return runs.diagnostics();
  }
  SensitivityAnalysis analysis;
  analysis.cases = runs->cases;
  analysis.seeds = runs->runs.front().size();
  for (const std::size_t metric : study.shown) {
    std::vector<SensitivityResult> results;
    for (std::size_t k = 0; k < analysis.cases.size(); ++k) {
      results.push_back(resultOf(study, metric, runs->runs[k]));
      results.back().caseNumber = k;
    }
    const bool varies = std::any_of(results.begin(), results.end(),
                                    [](const SensitivityResult& result) { return result.varies; });
    (varies ? analysis.metrics : analysis.constant).push_back(metric);
    if (varies) {
      std::move(results.begin(), results.end(), std::back_inserter(analysis.results));
    }
  }
  return analysis;
}

}  // namespace report
