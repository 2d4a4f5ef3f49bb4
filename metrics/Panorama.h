#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/map/Obstacles.h"

namespace metrics {

/// What stands nearest to the origin in each direction, exact but for rounding. Of n walls [m, as
/// seen from the origin], which may cross each other, in about n log n. Thread: one at a time.
class Panorama {
 public:
  struct Turn {
    double rank = 0.0;  // `rankOf` the direction; the turn of -pi has -2
    base::Vec2 towards{1.0, 0.0};
  };
  /// Between two turns nothing is nearer than this wall.
  struct View {
    Turn from, to;
    std::size_t wall = 0;
  };

  /// Forgets the walls before.
  void look(const std::vector<sim2d::Segment>& walls);
  /// Others as well.
  void add(const std::vector<sim2d::Segment>& walls);
  /// By their turns, from -pi to pi; where there is none, no wall stands.
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
  Views views_;   // while walls are looked at: of those merged so far, one after the other
  Views merged_;  // buffer
};

/// Among all directions: from -2 to 2 as the angle from -pi to pi, without its arc tangent.
double rankOf(const base::Vec2& direction);

/// Where the ray from the origin meets the line through the segment, as a multiple of the
/// direction; infinite when it runs beside it.
double along(const base::Vec2& direction, const sim2d::Segment& segment);

}  // namespace metrics
