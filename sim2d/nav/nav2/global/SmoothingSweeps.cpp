#include "sim2d/nav/nav2/global/SmoothingSweeps.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim2d/base/Math.h"

namespace sim2d::nav2 {
namespace {

constexpr double kSamePlace = 1e-4;    // [m]
constexpr double kSameHeading = 1e-4;  // [rad]

bool isSamePlace(const Vec2& step) {
  return std::fabs(step.x()) < kSamePlace && std::fabs(step.y()) < kSamePlace;
}

bool isBlocked(const Costmap& costmap, const Vec2& place) {
  const auto cell = costmap.worldToCell(place);
  return !cell || costmap.at(*cell) == kInscribed || costmap.at(*cell) == kLethal;
}

/// Performs one sweep over `moved`; returns the sum of changes, or nullopt at an obstacle.
std::optional<double> sweepOnce(const Path& anchors, const SweepSettings& settings,
                                const Costmap& costmap, Path& moved) {
  double change = 0.0;
  for (std::size_t i = 1; i + 1 < moved.size(); ++i) {
    for (int axis = 0; axis < 2; ++axis) {
      const double before = moved[i].position[axis];
      const double neighbours = moved[i + 1].position[axis] + moved[i - 1].position[axis];
      const double after = before + (settings.wData * (anchors[i].position[axis] - before) +
                                     settings.wSmooth * (neighbours - 2.0 * before));
      moved[i].position[axis] = after;
      change += std::fabs(after - before);
    }
    if (isBlocked(costmap, moved[i].position)) {
      return std::nullopt;
    }
  }
  return change;
}

SweepResult sweepUntilDone(Path& segment, const SweepSettings& settings, const Costmap& costmap,
                           long long& budget) {
  const Path anchors = segment;
  Path moved = segment;
  for (int sweep = 1; sweep < settings.maxSweeps; ++sweep) {
    budget -= static_cast<long long>(segment.size());
    if (budget < 0) {
      return SweepResult::OutOfBudget;
    }
    const auto change = sweepOnce(anchors, settings, costmap, moved);
    if (!change) {
      return SweepResult::Obstacle;
    }
    segment = moved;
    if (*change < settings.tolerance) {
      return SweepResult::Converged;
    }
  }
  return SweepResult::MaxSweeps;
}

}  // namespace

std::vector<PathSegment> directionalSegments(const Path& path) {
  std::vector<PathSegment> segments;
  PathSegment segment;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Vec2 here = path[i].position - path[i - 1].position;
    const Vec2 next = path[i + 1].position - path[i].position;
    const bool turnsOnTheSpot =
        isSamePlace(next) &&
        std::fabs(base::angleDiff(path[i + 1].heading, path[i].heading)) > kSameHeading;
    if (here.dot(next) < 0.0 || turnsOnTheSpot) {
      segment.last = i;
      segments.push_back(segment);
      segment.first = i;
    }
  }
  segment.last = path.empty() ? 0 : path.size() - 1;
  segments.push_back(segment);
  return segments;
}

bool orientSegment(Path& segment, bool isHolonomic) {
  const Vec2 ahead = segment[2].position - segment[1].position;
  const double turn = base::angleDiff(base::atan2(ahead.y(), ahead.x()), segment[1].heading);
  const bool isBackward = !isHolonomic && std::fabs(turn) > 0.5 * base::kPi;
  for (std::size_t i = 0; i + 1 < segment.size(); ++i) {
    const Vec2 step = segment[i + 1].position - segment[i].position;
    if (!isSamePlace(step)) {
      const double heading = base::atan2(step.y(), step.x());
      segment[i].heading = isBackward ? base::wrapToPi(heading + base::kPi) : heading;
    }
  }
  return isBackward;
}

SweepResult smoothBySweeps(Path& segment, const SweepSettings& settings, const Costmap& costmap,
                           long long& budget) {
  const SweepResult first = sweepUntilDone(segment, settings, costmap, budget);
  SweepResult last = first;
  for (int i = 0; i < settings.refinements && last == SweepResult::Converged; ++i) {
    last = sweepUntilDone(segment, settings, costmap, budget);
  }
  orientSegment(segment, settings.isHolonomic);
  return last == SweepResult::OutOfBudget ? last : first;
}

namespace {

constexpr double kMaxSmoothingDuration = 60.0;  // [s], upper limit of maxDuration

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
  settings.maxSweeps = parameters_.maxIts;
  settings.wData = parameters_.wData;
  settings.wSmooth = parameters_.wSmooth;
  settings.refinements = parameters_.doRefinement ? parameters_.refinementNum : 0;
  const bool splits = distro_ < Distro::Kilted || parameters_.enforcePathInversion;
  const std::vector<PathSegment> segments =
      splits ? directionalSegments(path) : std::vector<PathSegment>{{0, path.size() - 1}};
  const std::size_t shortest = distro_ == Distro::Humble ? 9 : 3;  // number of poses minus 1
  auto budget = static_cast<long long>(std::clamp(maxDuration, 0.0, kMaxSmoothingDuration) *
                                       kSweptPosesPerSecond);
  result.path = path;
  for (const PathSegment& part : segments) {
    if (part.last - part.first <= shortest) {
      continue;
    }
    const auto first = result.path.begin() + static_cast<std::ptrdiff_t>(part.first);
    const auto last = result.path.begin() + static_cast<std::ptrdiff_t>(part.last);
    Path segment(first, last + 1);
    const SweepResult end = smoothBySweeps(segment, settings, costmap, budget);
    if (end == SweepResult::OutOfBudget && distro_ != Distro::Humble) {
      return {SmoothError::Timeout, {}, false};
    }
    result.wasCompleted = result.wasCompleted && end == SweepResult::Converged;
    std::copy(segment.begin(), segment.end(), first);
  }
  return result;
}

}  // namespace sim2d::nav2
