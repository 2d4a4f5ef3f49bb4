#include "sim2d/nav/mppi/MppiUpdate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim2d/base/Math.h"

namespace sim2d {
namespace {

constexpr double kLeastLogWeight = -30.0;

}  // namespace

void mppiWeights(const float* costs, int count, double temperature, float* weights) {
  const double least = static_cast<double>(*std::min_element(costs, costs + count));
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double power = (least - static_cast<double>(costs[i])) / temperature;
    const double weight = power > kLeastLogWeight ? base::exp(power) : 0.0;
    weights[i] = static_cast<float>(weight);
    sum += weight;
  }
  for (int i = 0; i < count; ++i) {
    weights[i] = static_cast<float>(static_cast<double>(weights[i]) / sum);
  }
}

void mppiControlCost(const std::vector<float>& mean, double gamma, double deviation, double keep,
                     std::vector<float>& pull) {
  const double fresh = std::sqrt(1.0 - keep * keep);
  pull.resize(mean.size());
  double before = 0.0;
  for (std::size_t i = 0; i < mean.size(); ++i) {
    const auto now = static_cast<double>(mean[i]);
    const double white = i == 0 ? now : (now - keep * before) / fresh;
    pull[i] = static_cast<float>(deviation > 0.0 ? gamma * white / deviation : 0.0);
    before = now;
  }
}

std::vector<float> savitzkyGolay(const std::vector<float>& sequence,
                                 const std::array<float, 4>& sent, int order) {
  constexpr std::array<float, 9> kQuadratic = {-21.0F, 14.0F, 39.0F, 54.0F, 59.0F,
                                               54.0F,  39.0F, 14.0F, -21.0F};
  constexpr std::array<float, 9> kMean = {1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F};
  const std::array<float, 9>& taps = order == 1 ? kMean : kQuadratic;
  const float divisor = order == 1 ? 9.0F : 231.0F;  // sum of the taps
  std::vector<float> padded(sent.begin(), sent.end());
  padded.reserve(sequence.size() + 8);
  padded.insert(padded.end(), sequence.begin(), sequence.end());
  padded.insert(padded.end(), 4, sequence.back());
  std::vector<float> result(sequence.size());
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    float sum = 0.0F;
    for (std::size_t tap = 0; tap < taps.size(); ++tap) {
      sum += taps[tap] * padded[i + tap];
    }
    result[i] = sum / divisor;
  }
  return result;
}

std::vector<float> shifted(const std::vector<float>& sequence, double steps) {
  const std::size_t last = sequence.size() - 1;
  std::vector<float> result(sequence.size());
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const double place = std::min(static_cast<double>(i) + steps, static_cast<double>(last));
    const std::size_t low = std::min(static_cast<std::size_t>(place), last);
    const std::size_t high = std::min(low + 1, last);
    const auto share = static_cast<float>(place - static_cast<double>(low));
    result[i] = sequence[low] + share * (sequence[high] - sequence[low]);
  }
  return result;
}

}  // namespace sim2d
