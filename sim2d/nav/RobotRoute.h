#pragma once

#include <utility>
#include <vector>

#include "sim2d/nav/Observation.h"

namespace sim2d {

/// The way of one robot round the walls to its goal, for local planners that follow one. World
/// frame, [m].
class RobotRoute {
 public:
  /// Plans when there is no route to this goal yet, when doors have moved, or, once a second at
  /// most, when the robot is off the route or cannot see the point `sight` ahead of it.
  void update(const Observation& observation, double bodyRadius, double sight);

  bool isEmpty() const { return points_.empty(); }
  const std::vector<Vec2>& points() const { return points_; }
  /// The point `distance` farther along the route than the place nearest to `position`; its end
  /// when it is shorter. The route is not empty.
  Vec2 pointAhead(const Vec2& position, double distance) const;
  /// From the place nearest to `position` to the end [m]; and how far away that place is [m].
  double restLength(const Vec2& position) const;
  double distanceFrom(const Vec2& position) const;
  /// It was planned anew for the same goal since the last call.
  bool takeReplanned() { return std::exchange(replanned_, false); }

 private:
  struct Foot {
    std::size_t leg = 0;
    Vec2 point = Vec2::Zero();
  };
  Foot footOf(const Vec2& position) const;
  bool needsPlan(const Observation& observation, double sight) const;

  std::vector<Vec2> points_;
  Vec2 goal_ = Vec2::Zero();
  int version_ = -1;  // of the navigation map; -1: never planned
  double plannedAt_ = -1e9;
  bool replanned_ = false;
};

}  // namespace sim2d
