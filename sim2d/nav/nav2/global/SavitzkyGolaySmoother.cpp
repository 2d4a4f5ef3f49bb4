#include "sim2d/nav/nav2/global/SavitzkyGolaySmoother.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim2d/nav/nav2/global/SmoothingSweeps.h"

namespace sim2d::nav2 {
namespace {

constexpr int kDefaultWindow = 7, kDefaultOrder = 3;
constexpr std::size_t kMinFilteredPoses = 9;  // number of poses minus 1

double dotOf(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

std::vector<double> savitzkyGolayWeights(int window, int order) {
  const int half = window / 2;
  const auto count = static_cast<std::size_t>(window), middle = static_cast<std::size_t>(half);
  std::vector<double> weights(count, 0.0);
  std::vector<std::vector<double>> basis;  // orthonormal polynomials at -half … half
  for (int degree = 0; degree <= order; ++degree) {
    std::vector<double> next(count, 1.0);
    for (std::size_t i = 0; i < count && degree > 0; ++i) {
      next[i] = basis.back()[i] * (static_cast<double>(i) - half);
    }
    for (int round = 0; round < 2; ++round) {  // orthogonalizes twice because of rounding errors
      for (const std::vector<double>& before : basis) {
        const double share = dotOf(next, before);
        for (std::size_t i = 0; i < count; ++i) {
          next[i] -= share * before[i];
        }
      }
    }
    const double length = std::sqrt(dotOf(next, next));
    for (double& value : next) {
      value /= length;
    }
    for (std::size_t i = 0; i < count; ++i) {
      weights[i] += next[middle] * next[i];
    }
    basis.push_back(next);
  }
  return weights;
}

SavitzkyGolaySmoother::SavitzkyGolaySmoother(const SavitzkyGolayParameters& parameters,
                                             Distro distro)
    : parameters_(parameters),
      distro_(distro),
      weights_(distro >= Distro::Lyrical
                   ? savitzkyGolayWeights(parameters.windowSize, parameters.polyOrder)
                   : savitzkyGolayWeights(kDefaultWindow, kDefaultOrder)) {}

SmoothResult SavitzkyGolaySmoother::smooth(const Path& path, const Costmap& /*costmap*/,
                                           double /*maxDuration*/) const {
  SmoothResult result;
  if (path.empty()) {
    result.error = SmoothError::InvalidPath;
    return result;
  }
  const bool splits = distro_ < Distro::Kilted || parameters_.enforcePathInversion;
  const std::vector<PathSegment> segments =
      splits ? directionalSegments(path) : std::vector<PathSegment>{{0, path.size() - 1}};
  const int rounds = 1 + (parameters_.doRefinement ? parameters_.refinementNum : 0);
  result.path = path;
  for (const PathSegment& part : segments) {
    if (part.last - part.first <= kMinFilteredPoses) {
      continue;
    }
    const auto first = result.path.begin() + static_cast<std::ptrdiff_t>(part.first);
    const auto last = result.path.begin() + static_cast<std::ptrdiff_t>(part.last);
    Path segment(first, last + 1);
    for (int i = 0; i < rounds; ++i) {
      filter(segment);
    }
    orientSegment(segment, false);
    std::copy(segment.begin(), segment.end(), first);
  }
  return result;
}

/// Filters all poses except the ends, which are repeated beyond the segment.
void SavitzkyGolaySmoother::filter(Path& segment) const {
  const Path before = segment;
  const int half = static_cast<int>(weights_.size() / 2),
            last = static_cast<int>(before.size()) - 1;
  for (int i = 1; i < last; ++i) {
    Vec2 sum = Vec2::Zero();
    int at = i - half;
    for (const double weight : weights_) {
      sum += weight * before[static_cast<std::size_t>(std::clamp(at++, 0, last))].position;
    }
    segment[static_cast<std::size_t>(i)].position = sum;
  }
}

}  // namespace sim2d::nav2
