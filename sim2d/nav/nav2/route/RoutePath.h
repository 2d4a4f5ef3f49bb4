#pragma once

#include "sim2d/nav/nav2/route/GoalIntent.h"

namespace sim2d::nav2 {

/// A circle's arc that takes the place of a corner between two segments (nav2_route::CornerArc): it
/// touches both. World frame [m].
class CornerArc {
 public:
  /// Not valid: the segments go straight on or back, one has no length, or the arc would begin or
  /// end beyond them.
  CornerArc(const Vec2& start, const Vec2& corner, const Vec2& end, double radius);

  bool isValid() const { return isValid_; }
  const Vec2& begin() const { return begin_; }
  const Vec2& end() const { return end_; }
  const Vec2& centre() const { return centre_; }
  /// From the beginning on, without the end; at most `step` apart [rad].
  std::vector<Vec2> points(double step) const;

 private:
  bool isValid_ = false;
  Vec2 begin_ = Vec2::Zero(), end_ = Vec2::Zero(), centre_ = Vec2::Zero();
};

/// A route as a path (nav2_route::PathConverter): poses at most `path_density` apart along the
/// edges, with arcs at corners where `smooth_corners` is set. A continued edge is followed first,
/// from its nearest point on. Headings are those to the next pose, of the last one along the last
/// edge. A route without edges is its node alone.
Path pathOf(const Route& route, const RouteGraph& graph, const RouteServerParameters& parameters,
            const ContinuedEdge& continued = {});

}  // namespace sim2d::nav2
