#include "sim2d/nav/CostToGo.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim2d/base/Math.h"

namespace sim2d {
namespace {

constexpr double kMostCell = 0.15;   // [m]
constexpr double kUnknownFar = 1e6;  // [m], of places without a way
constexpr double kKeptFor = 0.2;     // [s]
constexpr double kKeptWithin = 2.0;  // [cells] of the robot's way
constexpr double kBySight = 2.5;     // [cells]; nearer to the target the distance itself counts
constexpr double kAmongWalls = 2.0;  // slowness added in the narrowest place
constexpr double kThroughBody = 30.0;
constexpr double kWithinMargin = 4.0;
constexpr double kTouchShare = 0.3;  // of the margin that the robot keeps in any case
constexpr double kNearBody = 2.0;
constexpr double kPersonalRing = 0.3;  // [m], where that counts
constexpr int kMostRounds = 8;         // of four sweeps; few places need more than two

}  // namespace

CostToGo::CostToGo(double inscribed, double reach, double margin)
    : cell_(std::clamp(0.8 * inscribed, 0.05, kMostCell)),
      inscribed_(inscribed),
      reach_(reach),
      margin_(margin),
      slowness_(static_cast<std::size_t>(kStride) * kStride, 0.0),
      value_(static_cast<std::size_t>(kStride) * kStride, kUnknownFar),
      least_(kSide, 0.0) {}

Vec2 CostToGo::middleOf(int column, int row) const {
  return origin_ + cell_ * Vec2(column + 0.5, row + 0.5);
}

bool CostToGo::isCurrent(const Observation& observation) const {
  return version_ == observation.navigation->version() && goal_ == observation.goal &&
         observation.time - madeAt_ < kKeptFor && observation.time >= madeAt_ &&
         (observation.pose.position - madeFor_).norm() < kKeptWithin * cell_;
}

void CostToGo::choosePlace(const Observation& observation, const RobotRoute& route) {
  const Vec2& position = observation.pose.position;
  // On whole cells, so that the same places have the same numbers from one time to the next.
  constexpr int kHalfSide = kSide / 2;
  const double half = kHalfSide;
  origin_.x() = cell_ * (std::floor(position.x() / cell_) - half);
  origin_.y() = cell_ * (std::floor(position.y() / cell_) - half);
  const double within = cell_ * (0.5 * kSide - 2.0);
  const double whole = route.restLength(position);
  const int steps = static_cast<int>(std::ceil(whole / cell_)) + 1;
  target_ = route.pointAhead(position, 0.0);
  rest_ = whole;
  endsHere_ = false;
  for (int i = 1; i <= steps && !endsHere_; ++i) {
    const Vec2 point = route.pointAhead(position, i * cell_);
    if ((point - position).cwiseAbs().maxCoeff() > within) {
      return;
    }
    target_ = point;
    endsHere_ = point == route.points().back();
    rest_ = endsHere_ ? 0.0 : std::max(0.0, whole - i * cell_);
  }
}

void CostToGo::markWalls(const Observation& observation) {
  // Cells that a wall passes are closed, so that no way leads through a thin one; and cells where
  // no part of the cell has room for the robot.
  const double closed = std::max(0.5 * cell_, inscribed_ - 0.71 * cell_);
  const double wide = reach_ + margin_;
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const Vec2 middle = middleOf(column, row);
      double room = observation.navigation->clearance(middle);
      if (room < wide) {
        room = observation.obstacles->clearance(middle, wide);
      }
      const double narrow = kAmongWalls * (1.0 - std::min(room / wide, 1.0));
      slowness_[static_cast<std::size_t>(indexOf(column, row))] =
          room <= closed ? 0.0 : 1.0 + narrow;
    }
  }
}

void CostToGo::markDisc(const Vec2& centre, double radius) {
  const double taken = radius + reach_ + kTouchShare * margin_;
  const double near = radius + reach_ + margin_;
  const double ring = near + kPersonalRing;
  const Vec2 low = (centre - origin_) / cell_ - Vec2::Constant(ring / cell_);
  const Vec2 high = (centre - origin_) / cell_ + Vec2::Constant(ring / cell_);
  if (high.minCoeff() < 0.0 || low.maxCoeff() > kSide) {
    return;
  }
  const auto clipped = [](double at) {
    return std::clamp(static_cast<int>(std::floor(at)), 0, kSide - 1);
  };
  for (int row = clipped(low.y()); row <= clipped(high.y()); ++row) {
    for (int column = clipped(low.x()); column <= clipped(high.x()); ++column) {
      const double distance = (middleOf(column, row) - centre).norm();
      double& slowness = slowness_[static_cast<std::size_t>(indexOf(column, row))];
      if (slowness > 0.0 && distance < ring) {
        const double price = distance < near ? kWithinMargin : kNearBody;
        slowness = std::max(slowness, distance < taken ? kThroughBody : price);
      }
    }
  }
}

void CostToGo::start(const Observation& observation) {
  std::fill(value_.begin(), value_.end(), kUnknownFar);
  const Vec2 at = (target_ - origin_) / cell_;
  const int reach = static_cast<int>(kBySight) + 1;
  const auto centreColumn = static_cast<int>(std::floor(at.x()));
  const auto centreRow = static_cast<int>(std::floor(at.y()));
  for (int row = std::max(0, centreRow - reach); row <= std::min(kSide - 1, centreRow + reach);
       ++row) {
    for (int column = std::max(0, centreColumn - reach);
         column <= std::min(kSide - 1, centreColumn + reach); ++column) {
      const Vec2 middle = middleOf(column, row);
      const double distance = (middle - target_).norm();
      const auto index = static_cast<std::size_t>(indexOf(column, row));
      const bool isOwn = row == centreRow && column == centreColumn;
      if (isOwn || (distance <= kBySight * cell_ && slowness_[index] > 0.0 &&
                    observation.obstacles->isVisible(middle, target_))) {
        value_[index] = rest_ + distance;
        slowness_[index] = std::max(slowness_[index], 1.0);
      }
    }
  }
}

bool CostToGo::improve(int index) {
  const auto i = static_cast<std::size_t>(index);
  const double slowness = slowness_[i];
  if (slowness <= 0.0) {
    return false;
  }
  const double a = std::min(value_[i - 1], value_[i + 1]);
  const double b = std::min(value_[i - kStride], value_[i + kStride]);
  const double step = slowness * cell_;
  const double low = std::min(a, b);
  const double high = std::max(a, b);
  const double between = high - low;
  const double value = between >= step
                           ? low + step
                           : 0.5 * (a + b + std::sqrt(2.0 * step * step - between * between));
  if (value >= value_[i] - 1e-6) {
    return false;
  }
  value_[i] = value;
  return true;
}

bool CostToGo::sweep(bool isUp, bool isRight) {
  bool isBetter = false;
  for (int i = 0; i < kSide; ++i) {
    const int row = isUp ? i : kSide - 1 - i;
    for (int j = 0; j < kSide; ++j) {
      isBetter = improve(indexOf(isRight ? j : kSide - 1 - j, row)) || isBetter;
    }
  }
  return isBetter;
}

void CostToGo::solve() {
  bool isBetter = true;
  for (int round = 0; round < kMostRounds && isBetter; ++round) {
    isBetter = sweep(true, true);
    isBetter = sweep(true, false) || isBetter;
    isBetter = sweep(false, false) || isBetter;
    isBetter = sweep(false, true) || isBetter;
  }
}

/// Closed cells get values above those beside them, so that near a wall it goes away from it.
void CostToGo::fillBlocked() {
  constexpr double kPerCell = 3.0;
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const auto i = static_cast<std::size_t>(indexOf(column, row));
      if (slowness_[i] > 0.0) {
        continue;
      }
      double beside = kUnknownFar;
      for (const std::size_t other : {i - 1, i + 1, i - kStride, i + kStride}) {
        if (slowness_[other] > 0.0) {
          beside = std::min(beside, value_[other]);
        }
      }
      value_[i] = std::min(kUnknownFar, beside + kPerCell * cell_);
    }
  }
}

void CostToGo::update(const Observation& observation, const RobotRoute& route, double slowSpeed,
                      const std::vector<Vec2>& points) {
  if (isCurrent(observation)) {
    return;
  }
  version_ = observation.navigation->version();
  goal_ = observation.goal;
  madeAt_ = observation.time;
  madeFor_ = observation.pose.position;
  choosePlace(observation, route);
  markWalls(observation);
  for (const TrackedBody& body : observation.bodies) {
    if (body.velocity.norm() < slowSpeed) {
      markDisc(body.position, body.radius);
    }
  }
  for (const Vec2& point : points) {
    markDisc(point, 0.0);
  }
  start(observation);
  solve();
  fillBlocked();
  findLeast();
}

void CostToGo::findLeast() {
  std::fill(least_.begin(), least_.end(), kUnknownFar);
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const double value = value_[static_cast<std::size_t>(indexOf(column, row))];
      const double known = value < kUnknownFar ? value : rest_ + cell_ * kSide;
      const double cells = (middleOf(column, row) - madeFor_).norm() / cell_;
      double& least = least_[std::min(static_cast<std::size_t>(cells), least_.size() - 1)];
      least = std::min(least, known);
    }
  }
  for (std::size_t i = 1; i < least_.size(); ++i) {
    least_[i] = std::min(least_[i], least_[i - 1]);
  }
}

double CostToGo::leastWithin(const Vec2& from, double radius) const {
  constexpr double kToCorner = 1.5;  // [cells] from a place to the middles that it is mixed of
  const double cells = (radius + (from - madeFor_).norm()) / cell_ + kToCorner;
  double least = least_[static_cast<std::size_t>(std::min(cells, kSide - 1.0))];
  const double direct = std::max(0.0, (target_ - from).norm() - radius);
  if (direct < kBySight * cell_) {
    least = std::min(least, rest_ + direct);
  }
  return least;
}

CostToGo::Corners CostToGo::cornersAt(const Vec2& place) const {
  const Vec2 at =
      ((place - origin_) / cell_ - Vec2::Constant(0.5)).cwiseMax(0.0).cwiseMin(kSide - 1.001);
  const auto column = static_cast<int>(at.x());
  const auto row = static_cast<int>(at.y());
  Corners corners;
  corners.s = at.x() - column;
  corners.t = at.y() - row;
  double least = kUnknownFar;
  for (int up = 0; up < 2; ++up) {
    for (int right = 0; right < 2; ++right) {
      const double value = value_[static_cast<std::size_t>(indexOf(column + right, row + up))];
      corners.values[up][right] = value;
      least = std::min(least, value);
    }
  }
  for (auto& ofRow : corners.values) {
    for (double& value : ofRow) {
      value = value >= kUnknownFar ? least + 3.0 * cell_ : value;
    }
  }
  return corners;
}

double CostToGo::at(const Vec2& place) const {
  const double direct = (place - target_).norm();
  if (direct < kBySight * cell_) {
    return rest_ + direct;
  }
  const Corners c = cornersAt(place);
  const double value = (1.0 - c.t) * ((1.0 - c.s) * c.values[0][0] + c.s * c.values[0][1]) +
                       c.t * ((1.0 - c.s) * c.values[1][0] + c.s * c.values[1][1]);
  return value < kUnknownFar ? value : rest_ + 2.0 * direct + cell_ * kSide;
}

Vec2 CostToGo::direction(const Vec2& place) const {
  Vec2 downhill = target_ - place;
  const Corners c = cornersAt(place);
  const bool isKnown =
      std::max({c.values[0][0], c.values[0][1], c.values[1][0], c.values[1][1]}) < kUnknownFar;
  if (downhill.norm() >= kBySight * cell_ && isKnown) {
    downhill.x() =
        (1.0 - c.t) * (c.values[0][0] - c.values[0][1]) + c.t * (c.values[1][0] - c.values[1][1]);
    downhill.y() =
        (1.0 - c.s) * (c.values[0][0] - c.values[1][0]) + c.s * (c.values[0][1] - c.values[1][1]);
  }
  const double length = downhill.norm();
  return length > 1e-9 ? Vec2(downhill / length) : Vec2(Vec2::Zero());
}

}  // namespace sim2d
