#include "sim2d/nav/nav2/global/HybridEstimates.h"

#include <cmath>
#include <limits>

#include "sim2d/nav/nav2/global/SmacGrid.h"

namespace sim2d::nav2 {
namespace {

constexpr Cell kEightMoves[] = {{-1, 0},  {1, 0},  {0, -1}, {0, 1},
                                {-1, -1}, {-1, 1}, {1, -1}, {1, 1}};
constexpr double kRoot2 = 1.4142135623730951;
constexpr std::size_t kMostLengths = 50000000;  // that are kept

}  // namespace

void ObstacleDistance::start(const Costmap& costmap, Cell goal, const Settings& settings,
                             bool keepsOld) {
  if (keepsOld && goal == goal_ && costmap.width() == width_ && costmap.height() == height_) {
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

double ObstacleDistance::from(Cell cell) {
  const std::size_t index = costmap_.indexOf({cell.column / factor_, cell.row / factor_});
  while (isSettled_[index] == 0 && !open_.isEmpty()) {
    settleNext();
  }
  return isSettled_[index] != 0 ? factor_ * distance_[index] : 0.0;
}

void ObstacleDistance::settleNext() {
  const std::size_t index = open_.pop().node;
  if (isSettled_[index] != 0) {
    return;
  }
  isSettled_[index] = 1;
  const auto width = static_cast<std::size_t>(costmap_.width());
  const Cell cell{static_cast<int>(index % width), static_cast<int>(index / width)};
  for (const Cell& move : kEightMoves) {
    const Cell next{cell.column + move.column, cell.row + move.row};
    if (!costmap_.contains(next) || !isSmacFree(costmap_.at(next), settings_.allowUnknown)) {
      continue;
    }
    const double share = costmap_.at(next) / kSmacMostCost;
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

CurveDistance::CurveDistance(CarMotion motion, double turningRadius, int bins, int side)
    : motion_(motion), radius_(turningRadius), bins_(bins), half_(side / 2) {
  const auto rows = static_cast<std::size_t>(half_) + 1;
  blockOf_.assign((2 * rows - 1) * rows, -1);
}

double CurveDistance::from(const Vec2& inGoal, int bin) {
  const double x = std::round(inGoal.x()), y = std::round(inGoal.y());
  if (!(std::fabs(x) <= half_ && std::fabs(y) <= half_)) {
    return 0.0;
  }
  const int mirrored = y < 0.0 ? (bins_ - bin) % bins_ : bin;  // across the goal's axis
  const auto column = static_cast<std::size_t>(x + half_);
  const auto row = static_cast<std::size_t>(std::fabs(y));
  const auto bins = static_cast<std::size_t>(bins_);
  const Pose2 from{{x, std::fabs(y)}, mirrored * 2.0 * base::kPi / bins_};
  const auto lengthFrom = [&] { return shortestCurve(motion_, from, {}, radius_).length(); };
  std::int32_t& block = blockOf_[column * (static_cast<std::size_t>(half_) + 1) + row];
  if (block < 0 && lengths_.size() > kMostLengths) {
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

}  // namespace sim2d::nav2
