#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/map/Obstacles.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/trace/Trace.h"

namespace metrics {

/// Visible ground from a pose: within `range` [m] and `halfAngle` [rad] to each side of the
/// heading, up to the nearest wall. Corners in the world frame, counter-clockwise, starting with
/// the eye unless the view is all around. Exact at walls except for rounding; the arc has a corner
/// every 3 degrees.
std::vector<base::Vec2> visibilityPolygon(const base::Pose2& eye, double halfAngle, double range,
                                          const std::vector<sim2d::Segment>& walls);

/// Edges of walls, obstacles and closed doors of a run within the range of a position. `doorOpen`:
/// states of the doors in frame order; missing ones have their initial state.
std::vector<sim2d::Segment> wallsAround(const sim2d::TraceHeader& header,
                                        const std::vector<char>& doorOpen, const base::Vec2& place,
                                        double range);

/// The nearest wall in each direction around the origin, exact except for rounding. Takes n walls
/// [m] relative to the origin, which may intersect, in O(n log n). Not synchronised.
class VisibilityProfile {
 public:
  struct Turn {
    double rank = 0.0;  // `pseudoAngle` the direction; -2 for the direction -pi
    base::Vec2 towards{1.0, 0.0};
  };
  /// An interval of directions in which one wall is nearest.
  struct View {
    Turn from, to;
    std::size_t wall = 0;
  };

  /// Replaces the walls.
  void look(const std::vector<sim2d::Segment>& walls);
  /// Adds walls.
  void add(const std::vector<sim2d::Segment>& walls);
  /// Ordered by direction from -pi to pi; gaps contain no wall.
  const std::vector<View>& views() const { return views_; }
  const sim2d::Segment& wall(const View& view) const { return walls_[view.wall]; }

 private:
  using Views = std::vector<View>;
  void addViewsOf(std::size_t first, std::size_t end);
  void addViewsOfOne(std::size_t wall);
  void mergeFrom(std::size_t first, std::size_t middle);
  void appendNearer(const View& a, const View& b, const Turn& from, const Turn& to);
  std::size_t nearer(std::size_t a, std::size_t b, const Turn& from, const Turn& to) const;

  std::vector<sim2d::Segment> walls_;
  Views views_;   // during a computation: of the walls merged so far, consecutively
  Views merged_;  // buffer
};

/// Monotonic substitute for the angle: from -2 to 2 as the angle goes from -pi to pi, without an
/// arc tangent.
double pseudoAngle(const base::Vec2& direction);

/// Intersection of the ray from the origin with the line through the segment, as a multiple of the
/// direction; infinite if parallel.
double along(const base::Vec2& direction, const sim2d::Segment& segment);

}  // namespace metrics
