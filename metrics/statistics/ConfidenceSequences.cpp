#include "metrics/statistics/ConfidenceSequences.h"

#include <algorithm>
#include <iterator>

namespace statistics {

namespace {

/// Share of the wealth that is staked, and how much of the first wealth does. The full stake
/// decides samples that all lie on one side, the small ones those that scatter.
struct Stake {
  double share, mixed, mostlyFull;
};
constexpr Stake kStakes[] = {
    {1.0, 0.3, 0.6}, {0.6, 0.2, 0.15}, {0.36, 0.2, 0.1}, {0.2, 0.2, 0.1}, {0.1, 0.1, 0.05}};

}  // namespace

void MeanSequence::addRound(const Numbers& values) {
  for (const double value : values) {
    const double inside = std::clamp(value, range_.low, range_.high);
    addValue(inside);
    ++count_;
    sum_ += inside;
  }
  interval_.low = bound(true);
  interval_.high = bound(false);
}

void MeanSequence::addValue(double value) {
  const auto known = std::find_if(repeated_.begin(), repeated_.end(),
                                  [value](const auto& each) { return each.first == value; });
  if (known != repeated_.end()) {
    ++known->second;
    return;
  }
  const auto single = std::find(single_.begin(), single_.end(), value);
  if (single == single_.end()) {
    single_.push_back(value);
  } else {
    *single = single_.back();
    single_.pop_back();
    repeated_.emplace_back(value, 2);
  }
}

double MeanSequence::mean() const {
  return count_ == 0 ? kUndefined : sum_ / count_;
}

double MeanSequence::logWealth(double m, bool higher) const {
  const double end = higher ? range_.low : range_.high;
  double logs[std::size(kStakes)];
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < std::size(kStakes); ++k) {
    const Stake& stake = kStakes[k];
    const double weight = stakes_ == Stakes::Mixed ? stake.mixed : stake.mostlyFull;
    logs[k] = std::log(weight) + logGrowth(stake.share, m, end);
    most = std::max(most, logs[k]);
  }
  double sum = 0.0;
  for (const double each : logs) {
    sum += std::isinf(most) ? 0.0 : std::exp(each - most);
  }
  return std::isinf(most) ? most : most + std::log(sum);
}

/// Σ count log(1 - θ + θ (x - end) / (m - end)). Logarithms are slow: up to kBlock factors of
/// single values are multiplied first.
double MeanSequence::logGrowth(double share, double m, double end) const {
  constexpr std::size_t kBlock = 16;
  const double slope = share / (m - end);
  const double constant = 1.0 - share - slope * end;
  double log = 0.0;
  for (std::size_t begin = 0; begin < single_.size(); begin += kBlock) {
    double product = 1.0;
    for (std::size_t k = begin; k < std::min(begin + kBlock, single_.size()); ++k) {
      product *= std::max(0.0, constant + slope * single_[k]);
    }
    log += std::log(product);
  }
  for (const auto& [value, count] : repeated_) {
    log += count * std::log(std::max(0.0, constant + slope * value));
  }
  return log;
}

/// The bound now, or an earlier one that is narrower. Rounded outwards to a millionth of the range.
double MeanSequence::bound(bool higher) const {
  double out = higher ? interval_.low : interval_.high;  // rejected, or the end of the range
  double within = higher ? range_.high : range_.low;     // never rejected
  const double enough = -std::log(higher ? errors_.below : errors_.above);
  const double precision = 1e-6 * (range_.high - range_.low);
  const double next = out + (higher ? precision : -precision);
  if (!(logWealth(next, higher) >= enough)) {
    return out;
  }
  while (std::abs(within - out) > precision) {
    const double middle = 0.5 * (out + within);
    (logWealth(middle, higher) >= enough ? out : within) = middle;
  }
  return out;
}

}  // namespace statistics
