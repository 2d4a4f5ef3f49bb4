#include "metrics/statistics/MultipleComparisons.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "metrics/statistics/Distributions.h"
#include "metrics/statistics/Ranks.h"

namespace statistics {

namespace {

constexpr double kRootOfTwo = 1.41421356237309504880;

/// Standard deviation of the difference of two mean ranks, over √2.
double rankError(int options, int blocks) {
  return std::sqrt(options * (options + 1.0) / (6.0 * blocks));
}

/// Probability that all blocks order their values like the first: for each, one in k! / (t! of each
/// tie).
double chanceOfAgreement(Numbers block, int blocks) {
  std::sort(block.begin(), block.end());
  double orders = 1.0;
  std::size_t equal = 0;
  for (std::size_t k = 0; k < block.size(); ++k) {
    equal = k > 0 && block[k] == block[k - 1] ? equal + 1 : 1;
    orders *= static_cast<double>(k + 1) / static_cast<double>(equal);
  }
  return std::pow(orders, 1.0 - blocks);
}

}  // namespace

Numbers holm(const Numbers& ps) {
  std::vector<std::size_t> order;
  order.reserve(ps.size());
  for (std::size_t k = 0; k < ps.size(); ++k) {
    if (!std::isnan(ps[k])) {
      order.push_back(k);
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [&ps](std::size_t a, std::size_t b) { return ps[a] < ps[b]; });
  Numbers adjusted(ps.size(), kUndefined);
  double least = 0.0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const double factor = static_cast<double>(order.size() - k);
    least = std::max(least, std::min(1.0, factor * ps[order[k]]));
    adjusted[order[k]] = least;
  }
  return adjusted;
}

Friedman friedman(const std::vector<Numbers>& blocks) {
  Friedman result;
  result.blocks = static_cast<int>(blocks.size());
  result.options = blocks.empty() ? 0 : static_cast<int>(blocks.front().size());
  const double b = result.blocks;
  const double k = result.options;
  Numbers sums(static_cast<std::size_t>(result.options), 0.0);
  double squares = 0.0;
  for (const Numbers& block : blocks) {
    const Numbers ranks = midranks(block);
    for (std::size_t option = 0; option < sums.size(); ++option) {
      sums[option] += ranks[option];
      squares += ranks[option] * ranks[option];
    }
  }
  double spread = 0.0;
  for (const double sum : sums) {
    const double distance = sum - b * (k + 1.0) / 2.0;
    spread += distance * distance;
    result.meanRanks.push_back(sum / b);
  }
  const double within = squares - b * k * (k + 1.0) * (k + 1.0) / 4.0;
  if (result.blocks < 2 || result.options < 2 || within <= 0.0) {
    return result;
  }
  result.chiSquared = (k - 1.0) * spread / within;
  result.p = chiSquaredTail(result.chiSquared, k - 1.0);
  const double rest = b * (k - 1.0) - result.chiSquared;
  result.f = rest > 1e-12 * b ? (b - 1.0) * result.chiSquared / rest
                              : std::numeric_limits<double>::infinity();
  result.fP = std::isinf(result.f) ? chanceOfAgreement(blocks.front(), result.blocks)
                                   : fisherTail(result.f, k - 1.0, (k - 1.0) * (b - 1.0));
  return result;
}

double nemenyiDifference(int options, int blocks, double level) {
  const double q =
      studentizedRangeQuantile(1.0 - level, options, std::numeric_limits<double>::infinity());
  return q / kRootOfTwo * rankError(options, blocks);
}

double nemenyiP(double meanRank1, double meanRank2, int options, int blocks) {
  const double q = std::abs(meanRank1 - meanRank2) / rankError(options, blocks) * kRootOfTwo;
  return studentizedRangeTail(q, options, std::numeric_limits<double>::infinity());
}

}  // namespace statistics
