#include "sim2d/nav/nav2/global/SmacSmoother.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "sim2d/nav/nav2/global/SmoothingSweeps.h"

namespace sim2d::nav2 {
namespace {

constexpr std::size_t kShortestSmoothed = 10;  // poses beyond the first
constexpr long long kMostMoves = 50000000;     // of poses in all sweeps

bool isHit(const Costmap& costmap, const Vec2& place) {
  const auto cell = costmap.worldToCell(place);
  return !cell || costmap.at(*cell) >= kInscribed;
}

/// A curve from the start of a segment to its pose `end`.
struct Entrance {
  std::size_t end = 0;
  Path poses;  // as many as it stands for
  double length = std::numeric_limits<double>::max();
};

/// None when the curve is a loop or hits something.
std::optional<Entrance> entranceTo(const Path& segment, std::size_t end, double pathLength,
                                   const SmoothedCar& car, bool isBackward,
                                   const Costmap& costmap) {
  Pose2 from = segment.front(), to = segment[end];
  if (isBackward) {
    std::swap(from, to);
  }
  const ShortestCurve curve = shortestCurve(car.motion, from, to, car.turningRadius);
  const double length = curve.length();
  if (length > 2.0 * pathLength) {
    return std::nullopt;
  }
  Entrance entrance;
  entrance.end = end;
  entrance.length = 0.0;
  for (std::size_t i = 0; i <= end; ++i) {
    entrance.poses.push_back(curve.at(length * static_cast<double>(i) / static_cast<double>(end)));
    if (isHit(costmap, entrance.poses.back().position)) {
      return std::nullopt;
    }
    if (i > 0) {
      entrance.length += (entrance.poses[i].position - entrance.poses[i - 1].position).norm();
    }
  }
  if (isBackward) {
    std::reverse(entrance.poses.begin(), entrance.poses.end());
  }
  return entrance;
}

/// Replaces the beginning of a segment by the shortest of the curves that lead to where it is one
/// radius, one diameter, half a circle and a circle long.
void enterByCurve(Path& segment, const SmoothedCar& car, bool isBackward, const Costmap& costmap) {
  const double radius = car.turningRadius;
  const std::vector<double> lengths = {radius, 2.0 * radius, base::kPi * radius,
                                       2.0 * base::kPi * radius};
  Entrance best;
  double passed = 0.0;
  std::size_t which = 0;
  for (std::size_t i = 1; i < segment.size() && which < lengths.size(); ++i) {
    passed += (segment[i].position - segment[i - 1].position).norm();
    if (passed < lengths[which]) {
      continue;
    }
    ++which;
    const auto entrance = entranceTo(segment, i, passed, car, isBackward, costmap);
    if (entrance && entrance->length < best.length && entrance->length > 0.0) {
      best = *entrance;
    }
  }
  std::copy(best.poses.begin(), best.poses.end(), segment.begin());
}

}  // namespace

void smoothSmacPath(Path& path, const SmacParameters& parameters, const Costmap& costmap,
                    const std::optional<SmoothedCar>& car) {
  if (parameters.smootherMaxIterations <= 0 || path.size() < 3) {
    return;
  }
  SweepSettings settings;
  settings.tolerance = parameters.smootherTolerance;
  settings.mostSweeps = parameters.smootherMaxIterations;
  settings.wData = parameters.smootherWData;
  settings.wSmooth = parameters.smootherWSmooth;
  settings.refinements = parameters.smootherDoRefinement ? parameters.smootherRefinementNum : 0;
  settings.isHolonomic = !car;
  const std::vector<PathSegment> segments =
      car ? directionalSegments(path) : std::vector<PathSegment>{{0, path.size() - 1}};
  long long budget = kMostMoves;
  for (const PathSegment& part : segments) {
    if (part.last - part.first <= kShortestSmoothed) {
      continue;
    }
    const auto first = path.begin() + static_cast<std::ptrdiff_t>(part.first);
    const auto last = path.begin() + static_cast<std::ptrdiff_t>(part.last);
    Path segment(first, last + 1);
    const Path raw = segment;
    const SweepEnd end = smoothBySweeps(segment, settings, costmap, budget);
    if (car && end == SweepEnd::Converged) {
      const bool isBackward = faceAlongSegment(segment, false);
      segment.front() = raw.front();
      enterByCurve(segment, *car, isBackward, costmap);
      // The end is the beginning of the way back.
      std::reverse(segment.begin(), segment.end());
      segment.front() = raw.back();
      enterByCurve(segment, *car, !isBackward, costmap);
      std::reverse(segment.begin(), segment.end());
    }
    std::copy(segment.begin(), segment.end(), first);
  }
}

}  // namespace sim2d::nav2
