#pragma once

#include "sim2d/nav/nav2/route/GoalIntentExtractor.h"

namespace sim2d::nav2 {

/// A circular arc that rounds a corner between two segments (nav2_route::CornerArc) and is tangent
/// to both. World frame [m].
class CornerArc {
 public:
  /// Invalid if the segments are collinear, one has no length, or the arc would begin or end beyond
  /// them.
  CornerArc(const Vec2& start, const Vec2& corner, const Vec2& end, double radius);

  bool isValid() const { return isValid_; }
  const Vec2& begin() const { return begin_; }
  const Vec2& end() const { return end_; }
  const Vec2& centre() const { return centre_; }
  /// Points from the beginning, without the end, at most `step` apart [rad].
  std::vector<Vec2> points(double step) const;

 private:
  bool isValid_ = false;
  Vec2 begin_ = Vec2::Zero(), end_ = Vec2::Zero(), centre_ = Vec2::Zero();
};

/// Converts a route to a path (nav2_route::PathConverter): poses at most `path_density` apart along
/// the edges, with arcs at corners if `smooth_corners` is set. Starts with a continued edge, from
/// its nearest point. Headings point to the next pose; the last one is that of the last edge. A
/// route without edges is its node only.
Path pathOf(const Route& route, const RouteGraph& graph, const RouteServerParameters& parameters,
            const ContinuedEdge& continued = {});

}  // namespace sim2d::nav2
