#include "sim2d/nav/nav2/global/SmacCommon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim2d/nav/nav2/global/PathSmoother.h"

namespace sim2d::nav2 {

Costmap downsampled(const Costmap& costmap, int factor, bool takesLeast) {
  if (factor <= 1) {
    return costmap;
  }
  const auto shrunk = [factor](int cells) { return (cells + factor - 1) / factor; };
  Costmap small(shrunk(costmap.width()), shrunk(costmap.height()), costmap.resolution() * factor,
                costmap.origin(), takesLeast ? kNoInformation : kFreeSpace);
  for (int row = 0; row < costmap.height(); ++row) {
    for (int column = 0; column < costmap.width(); ++column) {
      std::uint8_t& cost = small.costs()[small.indexOf({column / factor, row / factor})];
      const std::uint8_t found = costmap.at({column, row});
      cost = takesLeast ? std::min(cost, found) : std::max(cost, found);
    }
  }
  return small;
}

SmacLimits smacLimits(const SmacParameters& parameters, double maxPlanningTime, double perSecond) {
  constexpr int kNone = std::numeric_limits<int>::max();
  const auto limit = [](int given) { return given > 0 ? given : kNone; };
  const double inTime =
      std::clamp(std::round(maxPlanningTime * perSecond), 1.0, static_cast<double>(kNone));
  return {std::min(limit(parameters.maxIterations), static_cast<int>(inTime)),
          limit(parameters.maxOnApproachIterations),
          std::max(1, parameters.terminalCheckingInterval)};
}

namespace {

constexpr Cell kEightMoves[] = {{-1, 0},  {1, 0},  {0, -1}, {0, 1},
                                {-1, -1}, {-1, 1}, {1, -1}, {1, 1}};
constexpr double kRoot2 = 1.4142135623730951;
constexpr std::size_t kMaxLengths = 50000000;  // number of cached lengths

}  // namespace

void ObstacleHeuristic::start(const Costmap& costmap, Cell goal, const Settings& settings,
                              bool keepsCache) {
  if (keepsCache && goal == goal_ && costmap.width() == width_ && costmap.height() == height_) {
    return;
  }
  settings_ = settings;
  goal_ = goal;
  width_ = costmap.width();
  height_ = costmap.height();
  factor_ = settings.isDownsampled ? 2 : 1;
  costmap_ = downsampled(costmap, factor_, true);
  distance_.assign(costmap_.costs().size(), std::numeric_limits<double>::infinity());
  isSettled_.assign(costmap_.costs().size(), 0);
  open_.clear();
  const std::size_t first = costmap_.indexOf({goal.column / factor_, goal.row / factor_});
  distance_[first] = 0.0;
  open_.push(0.0, first);
}

double ObstacleHeuristic::from(Cell cell) {
  const std::size_t index = costmap_.indexOf({cell.column / factor_, cell.row / factor_});
  while (isSettled_[index] == 0 && !open_.isEmpty()) {
    settleNext();
  }
  return isSettled_[index] != 0 ? factor_ * distance_[index] : 0.0;
}

void ObstacleHeuristic::settleNext() {
  const std::size_t index = open_.pop().node;
  if (isSettled_[index] != 0) {
    return;
  }
  isSettled_[index] = 1;
  const Cell cell = costmap_.cellOf(index);
  for (const Cell& move : kEightMoves) {
    const Cell next{cell.column + move.column, cell.row + move.row};
    if (!costmap_.contains(next) || !isSmacFree(costmap_.at(next), settings_.allowUnknown)) {
      continue;
    }
    const double share = costmap_.at(next) / kSmacMaxCost;
    const double weight = settings_.isQuadratic ? share * share : share;
    const double length = move.column != 0 && move.row != 0 ? kRoot2 : 1.0;
    const double found = distance_[index] + length * (1.0 + settings_.costPenalty * weight);
    const std::size_t at = costmap_.indexOf(next);
    if (found < distance_[at]) {
      distance_[at] = found;
      open_.push(found, at);
    }
  }
}

DistanceHeuristic::DistanceHeuristic(CarMotion motion, double turningRadius, int bins, int side)
    : motion_(motion), radius_(turningRadius), bins_(bins), half_(side / 2) {
  const auto rows = static_cast<std::size_t>(half_) + 1;
  blockOf_.assign((2 * rows - 1) * rows, -1);
}

double DistanceHeuristic::from(const Vec2& inGoal, int bin) {
  const double x = std::round(inGoal.x()), y = std::round(inGoal.y());
  if (!(std::fabs(x) <= half_ && std::fabs(y) <= half_)) {
    return 0.0;
  }
  const int mirrored = y < 0.0 ? (bins_ - bin) % bins_ : bin;  // mirrored at the goal's axis
  const auto column = static_cast<std::size_t>(x + half_);
  const auto row = static_cast<std::size_t>(std::fabs(y));
  const auto bins = static_cast<std::size_t>(bins_);
  const Pose2 from{{x, std::fabs(y)}, mirrored * 2.0 * base::kPi / bins_};
  const auto lengthFrom = [&] { return shortestCurve(motion_, from, {}, radius_).length(); };
  std::int32_t& block = blockOf_[column * (static_cast<std::size_t>(half_) + 1) + row];
  if (block < 0 && lengths_.size() > kMaxLengths) {
    return static_cast<double>(static_cast<float>(lengthFrom()));
  }
  if (block < 0) {
    block = static_cast<std::int32_t>(lengths_.size() / bins);
    lengths_.resize(lengths_.size() + bins, -1.0F);
  }
  float& length =
      lengths_[static_cast<std::size_t>(block) * bins + static_cast<std::size_t>(mirrored)];
  if (length < 0.0F) {
    length = static_cast<float>(lengthFrom());
  }
  return length;
}

namespace {

constexpr std::size_t kMostUnsmoothedPoses = 11;
constexpr long long kMaxMoves = 50000000;  // poses moved in all sweeps

bool isHit(const Costmap& costmap, const Vec2& place) {
  const auto cell = costmap.worldToCell(place);
  return !cell || costmap.at(*cell) >= kInscribed;
}

/// A curve from the start of a segment to its pose `end`.
struct BoundaryExpansion {
  std::size_t end = 0;
  Path poses;  // as many as it replaces
  double length = std::numeric_limits<double>::max();
};

/// Returns nullopt if the curve is a loop or collides.
std::optional<BoundaryExpansion> boundaryExpansion(const Path& segment, std::size_t end,
                                                   double pathLength, const CarModel& car,
                                                   bool isBackward, const Costmap& costmap) {
  Pose2 from = segment.front(), to = segment[end];
  if (isBackward) {
    std::swap(from, to);
  }
  const ShortestCurve curve = shortestCurve(car.motion, from, to, car.turningRadius);
  const double length = curve.length();
  if (length > 2.0 * pathLength) {
    return std::nullopt;
  }
  BoundaryExpansion expansion;
  expansion.end = end;
  expansion.length = 0.0;
  for (std::size_t i = 0; i <= end; ++i) {
    expansion.poses.push_back(curve.at(length * static_cast<double>(i) / static_cast<double>(end)));
    if (isHit(costmap, expansion.poses.back().position)) {
      return std::nullopt;
    }
    if (i > 0) {
      expansion.length += (expansion.poses[i].position - expansion.poses[i - 1].position).norm();
    }
  }
  if (isBackward) {
    std::reverse(expansion.poses.begin(), expansion.poses.end());
  }
  return expansion;
}

/// Replaces the beginning of a segment by the shortest of the curves that end after a path length
/// of one radius, one diameter, half a circle and a circle.
void enforceBoundaryCondition(Path& segment, const CarModel& car, bool isBackward,
                              const Costmap& costmap) {
  const double radius = car.turningRadius;
  const std::vector<double> lengths = {radius, 2.0 * radius, base::kPi * radius,
                                       2.0 * base::kPi * radius};
  BoundaryExpansion best;
  double passed = 0.0;
  std::size_t which = 0;
  for (std::size_t i = 1; i < segment.size() && which < lengths.size(); ++i) {
    passed += (segment[i].position - segment[i - 1].position).norm();
    if (passed < lengths[which]) {
      continue;
    }
    ++which;
    const auto expansion = boundaryExpansion(segment, i, passed, car, isBackward, costmap);
    if (expansion && expansion->length < best.length && expansion->length > 0.0) {
      best = *expansion;
    }
  }
  std::copy(best.poses.begin(), best.poses.end(), segment.begin());
}

}  // namespace

void smoothSmacPath(Path& path, const SmacParameters& parameters, const Costmap& costmap,
                    const std::optional<CarModel>& car) {
  if (parameters.smootherMaxIterations <= 0 || path.size() < 3) {
    return;
  }
  SweepSettings settings;
  settings.tolerance = parameters.smootherTolerance;
  settings.maxSweeps = parameters.smootherMaxIterations;
  settings.wData = parameters.smootherWData;
  settings.wSmooth = parameters.smootherWSmooth;
  settings.refinements = parameters.smootherDoRefinement ? parameters.smootherRefinementNum : 0;
  settings.isHolonomic = !car;
  long long budget = kMaxMoves;
  smoothSegments(path, car.has_value(), kMostUnsmoothedPoses, [&](Path& segment) {
    const Pose2 begin = segment.front(), last = segment.back();
    const SweepResult end = smoothBySweeps(segment, settings, costmap, budget);
    if (!car || end != SweepResult::Converged) {
      return;
    }
    const bool isBackward = orientSegment(segment, false);
    segment.front() = begin;
    enforceBoundaryCondition(segment, *car, isBackward, costmap);
    // The end is treated as the beginning of the reversed segment.
    std::reverse(segment.begin(), segment.end());
    segment.front() = last;
    enforceBoundaryCondition(segment, *car, !isBackward, costmap);
    std::reverse(segment.begin(), segment.end());
  });
}

}  // namespace sim2d::nav2
