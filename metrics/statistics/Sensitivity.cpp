#include "metrics/statistics/Sensitivity.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace statistics {

namespace {

/// Ranks factors and counts, over the resamples, in how many the neighbours keep their order.
class RankingCount {
 public:
  explicit RankingCount(const Numbers& importance) {
    ranking_.order.resize(importance.size());
    std::iota(ranking_.order.begin(), ranking_.order.end(), std::size_t{0});
    std::stable_sort(ranking_.order.begin(), ranking_.order.end(),
                     [&](std::size_t a, std::size_t b) { return importance[a] > importance[b]; });
    ranking_.orderShares.resize(importance.empty() ? 0 : importance.size() - 1);
  }
  /// `importance`: of a resample; undefined values count as equal.
  void add(const Numbers& importance) {
    ++resamples_;
    for (std::size_t k = 0; k < ranking_.orderShares.size(); ++k) {
      const double first = importance[ranking_.order[k]],
                   second = importance[ranking_.order[k + 1]];
      ranking_.orderShares[k] += first > second ? 1.0 : first < second ? 0.0 : 0.5;
    }
  }
  FactorRanking take() {
    for (double& share : ranking_.orderShares) {
      share = resamples_ == 0 ? kUndefined : share / resamples_;
    }
    return std::move(ranking_);
  }

 private:
  FactorRanking ranking_;
  int resamples_ = 0;
};

Interval percentileInterval(const Numbers& resampled, double level) {
  const Numbers ends = quantiles(resampled, {0.5 * (1.0 - level), 0.5 * (1.0 + level)});
  return {ends[0], ends[1]};
}

Numbers definedOf(const std::vector<Numbers>& effects, std::size_t factor) {
  Numbers values;
  for (const Numbers& each : effects) {
    if (!std::isnan(each[factor])) {
      values.push_back(each[factor]);
    }
  }
  return values;
}

MorrisFactor morrisFactorOf(const Numbers& effects, const BootstrapOptions& options) {
  Numbers sizes(effects.size());
  std::transform(effects.begin(), effects.end(), sizes.begin(),
                 [](double effect) { return std::abs(effect); });
  MorrisFactor factor;
  factor.count = static_cast<int>(effects.size());
  factor.mean = mean(effects);
  factor.meanSize = mean(sizes);
  factor.deviation = standardDeviation(effects);
  factor.meanSizeInterval = bootstrapMeanInterval(sizes, options);
  return factor;
}

/// The means of absolute effects over these trajectories.
Numbers meanSizesOf(const std::vector<Numbers>& effects, const std::vector<std::size_t>& rows) {
  const std::size_t factors = effects.front().size();
  Numbers sums(factors), counts(factors);
  for (const std::size_t row : rows) {
    for (std::size_t k = 0; k < factors; ++k) {
      if (!std::isnan(effects[row][k])) {
        sums[k] += std::abs(effects[row][k]);
        counts[k] += 1.0;
      }
    }
  }
  for (std::size_t k = 0; k < factors; ++k) {
    sums[k] /= counts[k];  // NaN without any
  }
  return sums;
}

}  // namespace

std::vector<Numbers> elementaryEffects(const std::vector<Numbers>& points, const Numbers& outputs) {
  std::vector<Numbers> effects;
  const std::size_t factors = points.empty() ? 0 : points.front().size();
  for (std::size_t start = 0; start + factors < points.size(); start += factors + 1) {
    effects.emplace_back(factors, kUndefined);
    for (std::size_t at = start; at < start + factors; ++at) {
      const Numbers &before = points[at], &after = points[at + 1];
      for (std::size_t k = 0; k < factors; ++k) {
        if (after[k] != before[k]) {
          effects.back()[k] = (outputs[at + 1] - outputs[at]) / (after[k] - before[k]);
        }
      }
    }
  }
  return effects;
}

MorrisIndices morrisIndices(const std::vector<Numbers>& effects, const BootstrapOptions& options) {
  MorrisIndices indices;
  if (effects.empty()) {
    return indices;
  }
  Numbers sizes;
  for (std::size_t k = 0; k < effects.front().size(); ++k) {
    indices.factors.push_back(morrisFactorOf(definedOf(effects, k), options));
    sizes.push_back(indices.factors.back().meanSize);
  }
  for (double& size : sizes) {
    size = std::isnan(size) ? -1.0 : size;  // last in the ranking
  }
  RankingCount ranking(sizes);
  std::vector<std::size_t> rows;
  for (int resample = 0; resample < options.resamples; ++resample) {
    drawResample(effects.size(), options, resample, rows);
    ranking.add(meanSizesOf(effects, rows));
  }
  indices.ranking = ranking.take();
  return indices;
}

namespace {

/// The quantities of one base point whose means give the indices; outputs are centred.
struct SobolTerms {
  double outputs = 0.0;  // (a + b) / 2
  double squares = 0.0;  // (a² + b²) / 2
  Numbers steps;         // mixed - a
  Numbers products;      // b (mixed - a)
  Numbers stepSquares;   // (mixed - a)²
};

std::vector<SobolTerms> sobolTermsOf(const std::vector<SaltelliRow>& rows) {
  double center = 0.0;
  for (const SaltelliRow& row : rows) {
    center += 0.5 * (row.a + row.b) / static_cast<double>(rows.size());
  }
  std::vector<SobolTerms> terms;
  terms.reserve(rows.size());
  for (const SaltelliRow& row : rows) {
    const double a = row.a - center, b = row.b - center;
    SobolTerms& term = terms.emplace_back();
    term.outputs = 0.5 * (a + b);
    term.squares = 0.5 * (a * a + b * b);
    for (const double mixed : row.mixed) {
      const double step = mixed - row.a;
      term.steps.push_back(step);
      term.products.push_back(b * step);
      term.stepSquares.push_back(step * step);
    }
  }
  return terms;
}

struct SobolEstimate {
  double variance = 0.0;
  Numbers first, total;  // per factor; NaN without variance
};

/// `rowAt(k)`: the row at position k of the sample.
template <class RowAt>
SobolEstimate sobolEstimateOf(const std::vector<SobolTerms>& terms, RowAt rowAt) {
  const std::size_t factors = terms.front().steps.size();
  const auto count = static_cast<double>(terms.size());
  double outputs = 0.0, squares = 0.0;
  Numbers steps(factors), products(factors), stepSquares(factors);
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const SobolTerms& term = terms[rowAt(k)];
    outputs += term.outputs;
    squares += term.squares;
    for (std::size_t f = 0; f < factors; ++f) {
      steps[f] += term.steps[f];
      products[f] += term.products[f];
      stepSquares[f] += term.stepSquares[f];
    }
  }
  const double center = outputs / count;
  SobolEstimate estimate;
  estimate.variance = squares / count - center * center;
  for (std::size_t f = 0; f < factors; ++f) {
    const bool varies = estimate.variance > 0.0;
    const double first = (products[f] - center * steps[f]) / count;
    estimate.first.push_back(varies ? first / estimate.variance : kUndefined);
    estimate.total.push_back(varies ? 0.5 * stepSquares[f] / count / estimate.variance
                                    : kUndefined);
  }
  return estimate;
}

/// The intervals of the factors from resamples in which the output varies.
void setIntervals(const std::vector<SobolTerms>& terms, const BootstrapOptions& options,
                  SobolIndices& indices) {
  const std::size_t factors = indices.factors.size();
  Numbers totals;
  for (const SobolFactor& factor : indices.factors) {
    totals.push_back(factor.total);
  }
  RankingCount ranking(totals);
  std::vector<Numbers> first(factors), total(factors);
  std::vector<std::size_t> rows;
  for (int resample = 0; resample < options.resamples; ++resample) {
    drawResample(terms.size(), options, resample, rows);
    const SobolEstimate estimate = sobolEstimateOf(terms, [&](std::size_t k) { return rows[k]; });
    if (!(estimate.variance > 0.0)) {
      continue;
    }
    ranking.add(estimate.total);
    for (std::size_t f = 0; f < factors; ++f) {
      first[f].push_back(estimate.first[f]);
      total[f].push_back(estimate.total[f]);
    }
  }
  for (std::size_t f = 0; f < factors; ++f) {
    indices.factors[f].firstInterval = percentileInterval(first[f], options.level);
    indices.factors[f].totalInterval = percentileInterval(total[f], options.level);
  }
  indices.ranking = ranking.take();
}

bool variesAmong(const std::vector<SaltelliRow>& rows) {
  return std::any_of(rows.begin(), rows.end(), [&](const SaltelliRow& row) {
    return row.a != rows.front().a || row.b != rows.front().a;
  });
}

}  // namespace

SobolIndices sobolIndices(const std::vector<SaltelliRow>& rows, const BootstrapOptions& options) {
  SobolIndices indices;
  indices.rows = static_cast<int>(rows.size());
  if (rows.empty()) {
    return indices;
  }
  indices.factors.resize(rows.front().mixed.size());
  indices.ranking = RankingCount(Numbers(indices.factors.size())).take();
  if (rows.size() < 2 || !variesAmong(rows)) {
    return indices;
  }
  const std::vector<SobolTerms> terms = sobolTermsOf(rows);
  const SobolEstimate estimate = sobolEstimateOf(terms, [](std::size_t k) { return k; });
  indices.variance = estimate.variance;
  for (std::size_t f = 0; f < indices.factors.size(); ++f) {
    indices.factors[f].first = estimate.first[f];
    indices.factors[f].total = estimate.total[f];
  }
  setIntervals(terms, options, indices);
  return indices;
}

}  // namespace statistics
