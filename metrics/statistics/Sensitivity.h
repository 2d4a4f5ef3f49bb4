#pragma once

#include <cstddef>
#include <vector>

#include "metrics/statistics/Summary.h"

/// Global sensitivity analysis: the effect of each factor (a varied value) on an output, over the
/// whole range of all factors. Coordinates of factors are in [0, 1], so effects are per full range.
namespace statistics {

/// Factors by importance, and how certain their order is.
struct FactorRanking {
  std::vector<std::size_t> order;  // indices of factors, most important first
  /// Per pair of neighbours in `order`: the share of bootstrap resamples with the same order; equal
  /// values count half.
  Numbers orderShares;
};

/// Elementary effects of one factor (Morris 1991, Technometrics 33, 161-174).
struct MorrisFactor {
  int count = 0;                  // number of effects
  double mean = kUndefined;       // mu
  double meanSize = kUndefined;   // mu*: mean of absolute values (Campolongo, Cariboni & Saltelli
                                  // 2007, Environ. Model. Softw. 22)
  double deviation = kUndefined;  // sigma: standard deviation; interactions and curvature
  Interval meanSizeInterval;      // BCa bootstrap
};
struct MorrisIndices {
  std::vector<MorrisFactor> factors;
  FactorRanking ranking;  // by meanSize
};

/// The elementary effects of trajectories: `effects[t][f]` = change of the output per change of
/// factor f, which is the difference of two consecutive points of trajectory t. `points`: the
/// trajectories one after the other, each of one point more than there are factors; consecutive
/// points of a trajectory differ in one coordinate. `outputs`: per point; NaN (undefined) makes the
/// effects at that point NaN.
std::vector<Numbers> elementaryEffects(const std::vector<Numbers>& points, const Numbers& outputs);

/// Statistics of elementary effects `effects[t][f]`, NaN = undefined. Resamples are of whole
/// trajectories.
MorrisIndices morrisIndices(const std::vector<Numbers>& effects,
                            const BootstrapOptions& options = {});

/// Outputs at one base point of Saltelli's design: at the rows of the independent matrices A and B,
/// and, per factor, at the row of A with this coordinate from B.
struct SaltelliRow {
  double a = 0.0, b = 0.0;
  Numbers mixed;
};

/// Shares of the output's variance due to one factor.
struct SobolFactor {
  double first = kUndefined;  // alone: Saltelli et al. 2010, Comput. Phys. Commun. 181, table 2 (b)
  double total = kUndefined;  // with all interactions: Jansen 1999; table 2 (f) of the same
  Interval firstInterval, totalInterval;  // percentiles of the bootstrap
};
struct SobolIndices {
  int rows = 0;                  // base points
  double variance = kUndefined;  // of the output, from A and B together
  std::vector<SobolFactor> factors;
  FactorRanking ranking;  // by `total`
};

/// Sobol indices. All rows have the same number of factors and no undefined value. Outputs are
/// centred before, which does not change the exact value of the indices and reduces the error of
/// the first-order estimate. Fewer than two rows, or an output that does not vary: indices are NaN.
SobolIndices sobolIndices(const std::vector<SaltelliRow>& rows,
                          const BootstrapOptions& options = {});

}  // namespace statistics
