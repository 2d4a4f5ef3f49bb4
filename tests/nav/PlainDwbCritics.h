#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/control/dwb/DwbCritic.h"
#include "tests/nav/PlainDwb.h"

/// The critics of DWB a second time, from their description alone: what the program's are compared
/// with. A price is empty where the trajectory is illegal.
namespace plain_dwb {

using Price = std::optional<double>;

inline Price obstaclePrice(const Costmap& map, const std::vector<Pose2>& poses, bool sums) {
  double sum = 0.0, last = 0.0;
  for (const Pose2& pose : poses) {
    const auto cell = map.worldToCell(pose.position);
    if (!cell || map.at(*cell) > 252) {
      return std::nullopt;
    }
    last = map.at(*cell);
    sum += last;
  }
  return sums ? sum : last;
}

/// The highest cost of the cells between two, both included; cell k of the longer axis lies at the
/// whole part of (k times the shorter one + half the longer one) / the longer one.
inline int highestBetween(const Costmap& map, Cell from, Cell to) {
  const int dx = std::abs(to.column - from.column), dy = std::abs(to.row - from.row);
  const int longer = std::max({dx, dy, 1});
  const int sx = to.column < from.column ? -1 : 1, sy = to.row < from.row ? -1 : 1;
  int highest = 0;
  for (int k = 0; k <= std::max(dx, dy); ++k) {
    const int along = k, across = (k * std::min(dx, dy) + longer / 2) / longer;
    const Cell cell{from.column + sx * (dx >= dy ? along : across),
                    from.row + sy * (dx >= dy ? across : along)};
    highest = std::max(highest, static_cast<int>(map.at(cell)));
  }
  return highest;
}

inline Price footprintPrice(const Costmap& map, const std::vector<base::Vec2>& corners,
                            const std::vector<Pose2>& poses, bool sums) {
  double sum = 0.0, last = 0.0;
  for (const Pose2& pose : poses) {
    std::vector<Cell> cells;
    for (const base::Vec2& corner : corners) {
      const double c = std::cos(pose.heading), s = std::sin(pose.heading);
      const auto cell =
          map.worldToCell(pose.position + base::Vec2(c * corner.x() - s * corner.y(),
                                                     s * corner.x() + c * corner.y()));
      if (!cell || !map.worldToCell(pose.position)) {
        return std::nullopt;
      }
      cells.push_back(*cell);
    }
    int highest = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      highest = std::max(highest, highestBetween(map, cells[i], cells[(i + 1) % cells.size()]));
    }
    if (highest > 253) {
      return std::nullopt;
    }
    last = highest;
    sum += last;
  }
  return sums ? sum : last;
}

/// The map-grid critics. `ahead` [m]: 0 for PathDist and GoalDist, which test every pose.
inline Price gridPrice(const Costmap& map, const Grid& grid, const std::vector<Pose2>& poses,
                       double ahead, const std::string& aggregation) {
  double sum = 0.0, product = 1.0, last = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (ahead > 0.0 && aggregation == "last" && i + 1 < poses.size()) {
      continue;
    }
    const base::Vec2 way(std::cos(poses[i].heading), std::sin(poses[i].heading));
    const auto cell = map.worldToCell(poses[i].position + ahead * way);
    if (!cell) {
      return std::nullopt;
    }
    last = grid.at(*cell);
    sum += last;
    product *= product > 0.0 ? last : 1.0;
  }
  return aggregation == "sum" ? sum : aggregation == "product" ? product : last;
}

class RotateToGoal {
 public:
  RotateToGoal(const DwbCriticParameters& critic, const DwbParameters& controller)
      : critic_(critic), controller_(controller) {}

  /// `length` of the local path [m], 0 before Lyrical.
  void prepare(const Pose2& robot, const BodyTwist& speed, const Pose2& goal, double length) {
    goal_ = goal;
    now_ = std::hypot(speed.linear, speed.lateral);
    const double away =
        std::hypot(robot.position.x() - goal.position.x(), robot.position.y() - goal.position.y());
    if (away <= controller_.xyGoalTolerance && length <= 1.0) {
      isThere_ = true;
    }
    if (isThere_ && now_ <= controller_.transStoppedVelocity) {
      isTurning_ = true;
    }
  }
  Price score(const BodyTwist& v, double endHeading) const {
    const double left = std::fabs(std::remainder(goal_.heading - endHeading, 2.0 * M_PI));
    const double wanted = std::hypot(v.linear, v.lateral);
    if (!isThere_) {
      return 0.0;
    }
    if (isTurning_) {
      const bool drives = std::fabs(v.linear) > 1e-5 || std::fabs(v.lateral) > 1e-5;
      return drives ? Price() : Price(left);
    }
    return wanted < now_ ? Price(wanted * wanted * critic_.slowingFactor + left) : Price();
  }

 private:
  DwbCriticParameters critic_;
  DwbParameters controller_;
  Pose2 goal_;
  double now_ = 0.0;
  bool isThere_ = false, isTurning_ = false;
};

class Oscillation {
 public:
  explicit Oscillation(const DwbCriticParameters& parameters) : p_(parameters) {}

  void debrief(const BodyTwist& chosen, const Pose2& robot, double time) {
    const std::array<double, 3> v = {chosen.linear, chosen.lateral, chosen.angular};
    bool isFlip = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool isNoted =
          i == 0 || p_.xOnlyThreshold < 0.0 || std::fabs(chosen.linear) <= p_.xOnlyThreshold;
      if (!isNoted || v[i] == 0.0) {
        continue;
      }
      if (v[i] * sign_[i] < 0.0) {
        isFlip = true;
        (sign_[i] < 0.0 ? noBack_ : noAhead_)[i] = true;
      }
      sign_[i] = v[i] < 0.0 ? -1.0 : 1.0;
    }
    if (isFlip) {
      place_ = robot;
      time_ = time;
    }
    const double moved = std::hypot(robot.position.x() - place_.position.x(),
                                    robot.position.y() - place_.position.y());
    const bool isOver =
        (p_.resetDistance >= 0.0 && moved > p_.resetDistance) ||
        (p_.resetAngle >= 0.0 && std::fabs(robot.heading - place_.heading) > p_.resetAngle) ||
        (p_.resetTime >= 0.0 && time - time_ > p_.resetTime);
    const auto any = [](const std::array<bool, 3>& all) { return all[0] || all[1] || all[2]; };
    if (isOver && (any(noBack_) || any(noAhead_))) {
      noBack_ = noAhead_ = {};
      sign_ = {};
    }
  }
  Price score(const BodyTwist& twist) const {
    const std::array<double, 3> v = {twist.linear, twist.lateral, twist.angular};
    for (std::size_t i = 0; i < 3; ++i) {
      if ((noBack_[i] && v[i] < 0.0) || (noAhead_[i] && v[i] > 0.0)) {
        return std::nullopt;
      }
    }
    return 0.0;
  }

 private:
  DwbCriticParameters p_;
  std::array<double, 3> sign_{};
  std::array<bool, 3> noBack_{}, noAhead_{};
  Pose2 place_;
  double time_ = 0.0;
};

}  // namespace plain_dwb
