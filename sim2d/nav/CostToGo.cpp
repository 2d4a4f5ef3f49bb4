#include "sim2d/nav/CostToGo.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim2d/base/Math.h"

namespace sim2d {
namespace {

constexpr double kMaxCell = 0.15;         // [m]
constexpr double kUnreachable = 1e6;      // [m], value of unreachable cells
constexpr double kMaxAge = 0.2;           // [s]
constexpr double kMaxDisplacement = 2.0;  // [cells] moved by the robot
constexpr double kDirectRange = 2.5;  // [cells]; nearer to the target the straight distance is used
constexpr double kNarrowPenalty = 2.0;  // additional slowness in the narrowest place
constexpr double kOccupiedSlowness = 30.0;
constexpr double kMarginSlowness = 4.0;
constexpr double kContactMarginRatio = 0.3;  // ratio of the margin that always applies
constexpr double kPersonalSlowness = 2.0;
constexpr double kPersonalRing = 0.3;  // [m], width of the ring in which kPersonalSlowness applies
constexpr int kMaxSweepRounds = 8;     // of four sweeps; more than two are seldom needed

}  // namespace

CostToGo::CostToGo(double inscribed, double reach, double margin)
    : cell_(std::clamp(0.8 * inscribed, 0.05, kMaxCell)),
      inscribed_(inscribed),
      reach_(reach),
      margin_(margin),
      slowness_(static_cast<std::size_t>(kStride) * kStride, 0.0),
      value_(static_cast<std::size_t>(kStride) * kStride, kUnreachable),
      minByRadius_(kSide, 0.0) {}

Vec2 CostToGo::cellCentre(int column, int row) const {
  return origin_ + cell_ * Vec2(column + 0.5, row + 0.5);
}

bool CostToGo::isCurrent(const Observation& observation) const {
  return version_ == observation.navigation->version() && goal_ == observation.goal &&
         observation.time - updateTime_ < kMaxAge && observation.time >= updateTime_ &&
         (observation.pose.position - updatePosition_).norm() < kMaxDisplacement * cell_;
}

void CostToGo::placeGrid(const Observation& observation, const RobotRoute& route) {
  const Vec2& position = observation.pose.position;
  // Aligned to whole cells, so that the values of a place do not jitter between updates.
  constexpr int kHalfSide = kSide / 2;
  const double half = kHalfSide;
  origin_.x() = cell_ * (std::floor(position.x() / cell_) - half);
  origin_.y() = cell_ * (std::floor(position.y() / cell_) - half);
  const double within = cell_ * (0.5 * kSide - 2.0);
  const double whole = route.remainingLength(position);
  const int steps = static_cast<int>(std::ceil(whole / cell_)) + 1;
  target_ = route.pointAhead(position, 0.0);
  remainingLength_ = whole;
  containsRouteEnd_ = false;
  for (int i = 1; i <= steps && !containsRouteEnd_; ++i) {
    const Vec2 point = route.pointAhead(position, i * cell_);
    if ((point - position).cwiseAbs().maxCoeff() > within) {
      return;
    }
    target_ = point;
    containsRouteEnd_ = point == route.points().back();
    remainingLength_ = containsRouteEnd_ ? 0.0 : std::max(0.0, whole - i * cell_);
  }
}

void CostToGo::markWalls(const Observation& observation) {
  // Closes cells that a wall crosses, so that no path leads through a thin wall, and cells in which
  // no point leaves enough clearance for the robot.
  const double closed = std::max(0.5 * cell_, inscribed_ - 0.71 * cell_);
  const double wide = reach_ + margin_;
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const Vec2 middle = cellCentre(column, row);
      double room = observation.navigation->clearance(middle);
      if (room < wide) {
        room = observation.obstacles->clearance(middle, wide);
      }
      const double narrow = kNarrowPenalty * (1.0 - std::min(room / wide, 1.0));
      slowness_[static_cast<std::size_t>(indexOf(column, row))] =
          room <= closed ? 0.0 : 1.0 + narrow;
    }
  }
}

void CostToGo::markDisc(const Vec2& centre, double radius) {
  const double taken = radius + reach_ + kContactMarginRatio * margin_;
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
      const double distance = (cellCentre(column, row) - centre).norm();
      double& slowness = slowness_[static_cast<std::size_t>(indexOf(column, row))];
      if (slowness > 0.0 && distance < ring) {
        const double price = distance < near ? kMarginSlowness : kPersonalSlowness;
        slowness = std::max(slowness, distance < taken ? kOccupiedSlowness : price);
      }
    }
  }
}

void CostToGo::seedTarget(const Observation& observation) {
  std::fill(value_.begin(), value_.end(), kUnreachable);
  const Vec2 at = (target_ - origin_) / cell_;
  const int reach = static_cast<int>(kDirectRange) + 1;
  const auto centreColumn = static_cast<int>(std::floor(at.x()));
  const auto centreRow = static_cast<int>(std::floor(at.y()));
  for (int row = std::max(0, centreRow - reach); row <= std::min(kSide - 1, centreRow + reach);
       ++row) {
    for (int column = std::max(0, centreColumn - reach);
         column <= std::min(kSide - 1, centreColumn + reach); ++column) {
      const Vec2 middle = cellCentre(column, row);
      const double distance = (middle - target_).norm();
      const auto index = static_cast<std::size_t>(indexOf(column, row));
      const bool isOwn = row == centreRow && column == centreColumn;
      if (isOwn || (distance <= kDirectRange * cell_ && slowness_[index] > 0.0 &&
                    observation.obstacles->isVisible(middle, target_))) {
        value_[index] = remainingLength_ + distance;
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
  for (int round = 0; round < kMaxSweepRounds && isBetter; ++round) {
    isBetter = sweep(true, true);
    isBetter = sweep(true, false) || isBetter;
    isBetter = sweep(false, false) || isBetter;
    isBetter = sweep(false, true) || isBetter;
  }
}

/// Gives closed cells values above those of their neighbours, so that the gradient points away from
/// walls.
void CostToGo::fillBlocked() {
  constexpr double kPerCell = 3.0;
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const auto i = static_cast<std::size_t>(indexOf(column, row));
      if (slowness_[i] > 0.0) {
        continue;
      }
      double beside = kUnreachable;
      for (const std::size_t other : {i - 1, i + 1, i - kStride, i + kStride}) {
        if (slowness_[other] > 0.0) {
          beside = std::min(beside, value_[other]);
        }
      }
      value_[i] = std::min(kUnreachable, beside + kPerCell * cell_);
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
  updateTime_ = observation.time;
  updatePosition_ = observation.pose.position;
  placeGrid(observation, route);
  markWalls(observation);
  for (const TrackedBody& body : observation.bodies) {
    if (body.velocity.norm() < slowSpeed) {
      markDisc(body.position, body.radius);
    }
  }
  for (const Vec2& point : points) {
    markDisc(point, 0.0);
  }
  seedTarget(observation);
  solve();
  fillBlocked();
  updateMinima();
}

void CostToGo::updateMinima() {
  std::fill(minByRadius_.begin(), minByRadius_.end(), kUnreachable);
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const double value = value_[static_cast<std::size_t>(indexOf(column, row))];
      const double known = value < kUnreachable ? value : remainingLength_ + cell_ * kSide;
      const double cells = (cellCentre(column, row) - updatePosition_).norm() / cell_;
      double& least =
          minByRadius_[std::min(static_cast<std::size_t>(cells), minByRadius_.size() - 1)];
      least = std::min(least, known);
    }
  }
  for (std::size_t i = 1; i < minByRadius_.size(); ++i) {
    minByRadius_[i] = std::min(minByRadius_[i], minByRadius_[i - 1]);
  }
}

double CostToGo::minWithin(const Vec2& from, double radius) const {
  constexpr double kToCorner = 1.5;  // [cells], from a place to the centres it interpolates
  const double cells = (radius + (from - updatePosition_).norm()) / cell_ + kToCorner;
  double least = minByRadius_[static_cast<std::size_t>(std::min(cells, kSide - 1.0))];
  const double direct = std::max(0.0, (target_ - from).norm() - radius);
  if (direct < kDirectRange * cell_) {
    least = std::min(least, remainingLength_ + direct);
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
  double least = kUnreachable;
  for (int up = 0; up < 2; ++up) {
    for (int right = 0; right < 2; ++right) {
      const double value = value_[static_cast<std::size_t>(indexOf(column + right, row + up))];
      corners.values[up][right] = value;
      least = std::min(least, value);
    }
  }
  for (auto& ofRow : corners.values) {
    for (double& value : ofRow) {
      value = value >= kUnreachable ? least + 3.0 * cell_ : value;
    }
  }
  return corners;
}

double CostToGo::at(const Vec2& place) const {
  const double direct = (place - target_).norm();
  if (direct < kDirectRange * cell_) {
    return remainingLength_ + direct;
  }
  const Corners c = cornersAt(place);
  const double value = (1.0 - c.t) * ((1.0 - c.s) * c.values[0][0] + c.s * c.values[0][1]) +
                       c.t * ((1.0 - c.s) * c.values[1][0] + c.s * c.values[1][1]);
  return value < kUnreachable ? value : remainingLength_ + 2.0 * direct + cell_ * kSide;
}

Vec2 CostToGo::direction(const Vec2& place) const {
  Vec2 downhill = target_ - place;
  const Corners c = cornersAt(place);
  const bool isKnown =
      std::max({c.values[0][0], c.values[0][1], c.values[1][0], c.values[1][1]}) < kUnreachable;
  if (downhill.norm() >= kDirectRange * cell_ && isKnown) {
    downhill.x() =
        (1.0 - c.t) * (c.values[0][0] - c.values[0][1]) + c.t * (c.values[1][0] - c.values[1][1]);
    downhill.y() =
        (1.0 - c.s) * (c.values[0][0] - c.values[1][0]) + c.s * (c.values[0][1] - c.values[1][1]);
  }
  const double length = downhill.norm();
  return length > 1e-9 ? Vec2(downhill / length) : Vec2(Vec2::Zero());
}

}  // namespace sim2d
