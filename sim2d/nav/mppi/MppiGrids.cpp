#include "sim2d/nav/mppi/MppiGrids.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace sim2d {
namespace {

constexpr double kWindowStep = 0.5;         // [m]
constexpr double kClearanceSpacing = 0.05;  // [m]
constexpr double kCostToGoSpacing = 0.1;    // [m]
constexpr double kSeedSpacing = 0.05;       // [m], along the route
constexpr float kUnreached = 1e5F;          // [m]
constexpr double kWallSlowness = 20.0;
constexpr double kWallSlowdownDistance = 0.2;  // [m]; nearer to walls the slowness grows to 2
constexpr double kPersonSlowness = 5.0;
constexpr double kExactGoalRadius = 1.0;  // [m]
constexpr float kConvergence = 1e-3F;     // [m]
constexpr int kMaxSweeps = 24;

double clearanceOf(const Observation& observation, const Vec2& node) {
  if (observation.navigation->isOpenPlane() ||
      observation.navigation->clearance(node) >= ClearanceGrid::kMaxClearance) {
    return ClearanceGrid::kMaxClearance;
  }
  return observation.obstacles->clearance(node, ClearanceGrid::kMaxClearance);
}

}  // namespace

MppiGrid NodeWindow::view(const std::vector<float>& values, const Vec2& origin) const {
  const Vec2 first = nodeAt(0, 0) - origin;
  MppiGrid grid;
  grid.values = values.data();
  grid.columns = columns;
  grid.rows = rows;
  grid.x = static_cast<float>(first.x());
  grid.y = static_cast<float>(first.y());
  grid.perMetre = static_cast<float>(1.0 / spacing);
  return grid;
}

NodeWindow windowAround(const Vec2& place, double half, double spacing) {
  const long long perJump = std::llround(kWindowStep / spacing);
  NodeWindow window;
  window.spacing = spacing;
  window.column = static_cast<long long>(std::floor((place.x() - half) / kWindowStep)) * perJump;
  window.row = static_cast<long long>(std::floor((place.y() - half) / kWindowStep)) * perJump;
  window.columns = static_cast<int>(std::ceil((2.0 * half + kWindowStep) / spacing)) + 2;
  window.rows = window.columns;
  return window;
}

void ClearanceGrid::update(const Observation& observation, double half) {
  const NodeWindow window = windowAround(observation.pose.position, half, kClearanceSpacing);
  const bool isSameWorld = version_ == observation.navigation->version();
  if (isSameWorld && window == window_) {
    return;
  }
  std::vector<float> values(static_cast<std::size_t>(window.columns) *
                            static_cast<std::size_t>(window.rows));
  for (int j = 0; j < window.rows; ++j) {
    for (int i = 0; i < window.columns; ++i) {
      const long long oldColumn = window.column + i - window_.column;
      const long long oldRow = window.row + j - window_.row;
      values[window.indexOf(i, j)] =
          isSameWorld && window_.contains(oldColumn, oldRow)
              ? values_[window_.indexOf(static_cast<int>(oldColumn), static_cast<int>(oldRow))]
              : static_cast<float>(clearanceOf(observation, window.nodeAt(i, j)));
    }
  }
  values_ = std::move(values);
  window_ = window;
  version_ = observation.navigation->version();
}

double ClearanceGrid::at(const Vec2& place) const {
  const Vec2 local = (place - window_.nodeAt(0, 0)) / window_.spacing;
  const double column = std::floor(local.x());
  const double row = std::floor(local.y());
  if (column < 0.0 || row < 0.0 || column >= window_.columns - 1 || row >= window_.rows - 1) {
    return kMaxClearance;
  }
  const auto i = static_cast<int>(column);
  const auto j = static_cast<int>(row);
  const auto value = [&](int di, int dj) {
    return static_cast<double>(values_[window_.indexOf(i + di, j + dj)]);
  };
  const double x = local.x() - column;
  const double y = local.y() - row;
  return (1.0 - y) * ((1.0 - x) * value(0, 0) + x * value(1, 0)) +
         y * ((1.0 - x) * value(0, 1) + x * value(1, 1));
}

Vec2 ClearanceGrid::slopeAt(const Vec2& place) const {
  const double h = 0.5 * window_.spacing;
  return Vec2(at(place + Vec2(h, 0.0)) - at(place - Vec2(h, 0.0)),
              at(place + Vec2(0.0, h)) - at(place - Vec2(0.0, h))) /
         (2.0 * h);
}

void CostToGoGrid::update(const Observation& observation, const std::vector<Vec2>& route,
                          double half, double radius, const ClearanceGrid& clearance,
                          const std::vector<SlowDisc>& discs) {
  const NodeWindow window = windowAround(observation.pose.position, half, kCostToGoSpacing);
  if (version_ == observation.navigation->version() && window == window_ && route == route_ &&
      discs == discs_) {
    return;
  }
  version_ = observation.navigation->version();
  window_ = window;
  route_ = route;
  discs_ = discs;
  setSlowness(radius, clearance);
  solve(*observation.obstacles);
}

void CostToGoGrid::setSlowness(double radius, const ClearanceGrid& clearance) {
  slowness_.assign(
      static_cast<std::size_t>(window_.columns) * static_cast<std::size_t>(window_.rows), 1.0F);
  for (int j = 0; j < window_.rows; ++j) {
    for (int i = 0; i < window_.columns; ++i) {
      const Vec2 node = window_.nodeAt(i, j);
      const double room = clearance.at(node) - radius;
      double slowness = 1.0 + std::max(0.0, 1.0 - room / kWallSlowdownDistance);
      for (const SlowDisc& disc : discs_) {
        if ((node - disc.centre).squaredNorm() < disc.radius * disc.radius) {
          slowness = std::max(slowness, kPersonSlowness);
        }
      }
      slowness_[window_.indexOf(i, j)] = static_cast<float>(room < 0.0 ? kWallSlowness : slowness);
    }
  }
}

void CostToGoGrid::solve(const Obstacles& obstacles) {
  values_.assign(slowness_.size(), kUnreached);
  seedRoute();
  seedGoal(obstacles);
  bool isSettled = false;
  for (int round = 0; round < kMaxSweeps && !isSettled; round += 4) {
    const bool first = sweep(1, 1);
    const bool second = sweep(-1, 1);
    const bool third = sweep(-1, -1);
    const bool fourth = sweep(1, -1);
    isSettled = first && second && third && fourth;
  }
}

/// Lowers the four nodes about the place to their distance through it.
void CostToGoGrid::lowerValues(const Vec2& place, double rest) {
  const Vec2 local = (place - window_.nodeAt(0, 0)) / window_.spacing;
  const auto column = static_cast<long long>(std::floor(local.x()));
  const auto row = static_cast<long long>(std::floor(local.y()));
  for (int corner = 0; corner < 4; ++corner) {
    const long long i = column + corner % 2;
    const long long j = row + corner / 2;
    if (window_.contains(i, j)) {
      const auto columnOf = static_cast<int>(i);
      const auto rowOf = static_cast<int>(j);
      const double way = (window_.nodeAt(columnOf, rowOf) - place).norm() + rest;
      float& value = values_[window_.indexOf(columnOf, rowOf)];
      value = std::min(value, static_cast<float>(way));
    }
  }
}

/// Seeds the route's end and each place where it leaves the window with the remaining length.
void CostToGoGrid::seedRoute() {
  double rest = 0.0;
  bool wasInside = contains(route_.back());
  if (wasInside) {
    lowerValues(route_.back(), 0.0);
  }
  for (std::size_t i = route_.size(); i-- > 1;) {
    const Vec2 back = route_[i - 1] - route_[i];
    const double length = back.norm();
    const int parts = std::max(1, static_cast<int>(std::ceil(length / kSeedSpacing)));
    for (int part = 1; part <= parts; ++part) {
      const double share = static_cast<double>(part) / parts;
      const Vec2 place = route_[i] + share * back;
      const bool isInside = contains(place);
      if (isInside && !wasInside) {
        lowerValues(place, rest + share * length);
      }
      wasInside = isInside;
    }
    rest += length;
  }
}

bool CostToGoGrid::contains(const Vec2& place) const {
  const Vec2 local = (place - window_.nodeAt(0, 0)) / window_.spacing;
  return local.minCoeff() >= 0.0 && local.x() < window_.columns - 1 && local.y() < window_.rows - 1;
}

/// Within the clearance of the goal the path is straight, so the distance is exact.
void CostToGoGrid::seedGoal(const Obstacles& obstacles) {
  const Vec2 goal = route_.back();
  const double room = std::min(kExactGoalRadius, obstacles.clearance(goal, kExactGoalRadius));
  for (int j = 0; j < window_.rows; ++j) {
    for (int i = 0; i < window_.columns; ++i) {
      const double distance = (window_.nodeAt(i, j) - goal).norm();
      if (distance < room) {
        values_[window_.indexOf(i, j)] = static_cast<float>(distance);
      }
    }
  }
}

/// One sweep over all nodes; returns true if no value changed by more than a millimetre.
bool CostToGoGrid::sweep(int stepX, int stepY) {
  const int columns = window_.columns;
  const int rows = window_.rows;
  const auto valueAt = [&](int i, int j) {
    return window_.contains(i, j) ? values_[window_.indexOf(i, j)] : kUnreached;
  };
  float most = 0.0F;
  for (int jj = 0; jj < rows; ++jj) {
    const int j = stepY > 0 ? jj : rows - 1 - jj;
    for (int ii = 0; ii < columns; ++ii) {
      const int i = stepX > 0 ? ii : columns - 1 - ii;
      const float a = std::min(valueAt(i - 1, j), valueAt(i + 1, j));
      const float b = std::min(valueAt(i, j - 1), valueAt(i, j + 1));
      const std::size_t at = window_.indexOf(i, j);
      const float way = slowness_[at] * static_cast<float>(window_.spacing);
      const float apart = std::fabs(a - b);
      const float reached = apart >= way
                                ? std::min(a, b) + way
                                : 0.5F * (a + b + std::sqrt(2.0F * way * way - apart * apart));
      if (reached < values_[at]) {
        most = std::max(most, values_[at] - reached);
        values_[at] = reached;
      }
    }
  }
  return most < kConvergence;
}

}  // namespace sim2d
