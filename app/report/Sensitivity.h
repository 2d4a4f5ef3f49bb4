#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/Study.h"
#include "metrics/statistics/Sensitivity.h"

/// Sensitivity analysis of a batch whose design is Morris' or Saltelli's: indices of each factor
/// for each metric in each case.
namespace report {

/// The indices of one metric in one case (scenario and listed values).
struct SensitivityResult {
  std::size_t metric = 0;      // index in the study
  std::size_t caseNumber = 0;  // in SensitivityAnalysis::cases
  // One of them, by the method:
  std::optional<statistics::MorrisIndices> morris;  // effects are per full range of the factor
  std::optional<statistics::SobolIndices> sobol;
  /// The share of the variance between points that is due to the choice of seeds; NaN: one seed.
  double seedShare = statistics::kUndefined;
  std::size_t points = 0, undefined = 0;  // of the design; without a value for any seed
  bool varies = false;                    // otherwise there are no indices

  const statistics::FactorRanking& ranking() const {
    return morris ? morris->ranking : sobol->ranking;
  }
  /// mu* or the total index; its interval; NaN: undefined.
  double importance(std::size_t factor) const;
  statistics::Interval importanceInterval(std::size_t factor) const;
  /// The importance relative to that of the first factor in the ranking; 0 if undefined.
  double relativeImportance(std::size_t factor) const;
};

/// Factors below this relative importance are negligible: their intervals and order do not matter.
constexpr double kNegligible = 0.1;
/// A share of seedShare above this is reported: more seeds are needed.
constexpr double kLargeSeedShare = 0.2;

/// Why the number of points is too small for a result.
struct TooFewPoints {
  std::vector<std::size_t> wide;       // factors whose interval is wider than their importance
  std::vector<std::size_t> unordered;  // positions in the ranking whose order to the next one holds
                                       // in less than 95 % of the resamples
  /// The number of points (of the design) at which the widest interval is about as wide as the
  /// importance; NaN: not known.
  double required = statistics::kUndefined;
  bool any() const { return !wide.empty() || !unordered.empty(); }
};

struct SensitivityAnalysis {
  std::vector<std::string> cases;
  std::vector<std::size_t> metrics;        // that vary in at least one case
  std::vector<std::size_t> constant;       // that have the same value everywhere
  std::vector<SensitivityResult> results;  // by metric, then case; of `metrics`
  std::size_t seeds = 0;

  const SensitivityResult& of(std::size_t metric, std::size_t caseNumber) const {
    return results[metric * cases.size() + caseNumber];
  }
};

TooFewPoints tooFewPoints(const Study& study, const SensitivityResult& result);

/// Analyses the displayed metrics. Seeds are averaged at each point: effects per seed for Morris;
/// for Sobol values without the mean of their seed, because all points have the same seeds. Points
/// without a value are excluded. `study.sensitivity` is required. Errors: runs are missing, or the
/// manifest is not that of the results.
base::Result<SensitivityAnalysis> analyseSensitivity(const Study& study);

/// sensitivity.json: the design, and the indices of every case, metric and factor.
std::string sensitivityJson(const Study& study, const SensitivityAnalysis& analysis);
/// sensitivity.csv: one row per case, metric and factor, by rank.
std::string sensitivityCsv(const Study& study, const SensitivityAnalysis& analysis);

}  // namespace report
