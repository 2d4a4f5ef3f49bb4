#include "sim2d/nav/nav2/global/SimpleSmoother.h"

#include <algorithm>

#include "sim2d/nav/nav2/global/SmoothingSweeps.h"

namespace sim2d::nav2 {
namespace {

constexpr double kLongestSmoothing = 60.0;  // [s], whatever the tree allows

}  // namespace

SimpleSmoother::SimpleSmoother(const SimpleSmootherParameters& parameters, Distro distro)
    : parameters_(parameters), distro_(distro) {}

SmoothResult SimpleSmoother::smooth(const Path& path, const Costmap& costmap,
                                    double maxDuration) const {
  SmoothResult result;
  if (path.empty()) {
    result.error = SmoothError::InvalidPath;
    return result;
  }
  SweepSettings settings;
  settings.tolerance = parameters_.tolerance;
  settings.mostSweeps = parameters_.maxIts;
  settings.wData = parameters_.wData;
  settings.wSmooth = parameters_.wSmooth;
  settings.refinements = parameters_.doRefinement ? parameters_.refinementNum : 0;
  const bool splits = distro_ < Distro::Kilted || parameters_.enforcePathInversion;
  const std::vector<PathSegment> segments =
      splits ? directionalSegments(path) : std::vector<PathSegment>{{0, path.size() - 1}};
  const std::size_t shortest = distro_ == Distro::Humble ? 9 : 3;  // poses beyond the first
  auto budget = static_cast<long long>(std::clamp(maxDuration, 0.0, kLongestSmoothing) *
                                       kSweepedPosesPerSecond);
  result.path = path;
  for (const PathSegment& part : segments) {
    if (part.last - part.first <= shortest) {
      continue;
    }
    const auto first = result.path.begin() + static_cast<std::ptrdiff_t>(part.first);
    const auto last = result.path.begin() + static_cast<std::ptrdiff_t>(part.last);
    Path segment(first, last + 1);
    const SweepEnd end = smoothBySweeps(segment, settings, costmap, budget);
    if (end == SweepEnd::OutOfBudget && distro_ != Distro::Humble) {
      return {SmoothError::Timeout, {}, false};
    }
    result.wasCompleted = result.wasCompleted && end == SweepEnd::Converged;
    std::copy(segment.begin(), segment.end(), first);
  }
  return result;
}

}  // namespace sim2d::nav2
