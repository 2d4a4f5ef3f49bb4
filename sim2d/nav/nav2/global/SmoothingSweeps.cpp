#include "sim2d/nav/nav2/global/SmoothingSweeps.h"

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

/// One sweep over `moved`; none if it leads into an obstacle, else the sum of changes.
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

SweepEnd sweepUntilDone(Path& segment, const SweepSettings& settings, const Costmap& costmap,
                        long long& budget) {
  const Path anchors = segment;
  Path moved = segment;
  for (int sweep = 1; sweep < settings.mostSweeps; ++sweep) {
    budget -= static_cast<long long>(segment.size());
    if (budget < 0) {
      return SweepEnd::OutOfBudget;
    }
    const auto change = sweepOnce(anchors, settings, costmap, moved);
    if (!change) {
      return SweepEnd::Obstacle;
    }
    segment = moved;
    if (*change < settings.tolerance) {
      return SweepEnd::Converged;
    }
  }
  return SweepEnd::MostSweeps;
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

bool faceAlongSegment(Path& segment, bool isHolonomic) {
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

SweepEnd smoothBySweeps(Path& segment, const SweepSettings& settings, const Costmap& costmap,
                        long long& budget) {
  const SweepEnd first = sweepUntilDone(segment, settings, costmap, budget);
  SweepEnd last = first;
  for (int i = 0; i < settings.refinements && last == SweepEnd::Converged; ++i) {
    last = sweepUntilDone(segment, settings, costmap, budget);
  }
  faceAlongSegment(segment, settings.isHolonomic);
  return last == SweepEnd::OutOfBudget ? last : first;
}

}  // namespace sim2d::nav2
