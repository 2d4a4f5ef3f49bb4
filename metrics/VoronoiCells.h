#pragma once

#include <utility>
#include <vector>

#include "metrics/MapFields.h"
#include "metrics/Samples.h"
#include "sim2d/map/Obstacles.h"

/// Neighbours and Voronoi cells of points, for the crowd metrics.
namespace metrics {

/// For each point the indices of the other points within the distance. Linear in the number of
/// points, by a grid with cells of that size.
std::vector<std::vector<std::size_t>> neighboursWithin(const std::vector<Vec2>& points,
                                                       double reach);

/// Areas of Voronoi cells between walls: the region that is nearer to a point than to any other
/// visible point, within a circle around it and not behind a wall. Doors count as open. Exact
/// except for rounding.
class VoronoiCellAreas {
 public:
  explicit VoronoiCellAreas(double radius) : radius_(radius) {}  // circle radius [m]
  /// `others`: at least all points up to twice the radius. Walls and their images beyond the seam
  /// are those of the context.
  double areaOf(const Vec2& point, const std::vector<Vec2>& others, const RunContext& context);

 private:
  void collectWalls(const Vec2& point, double reach, const RunContext& context);
  bool isHidden(const Vec2& other) const;
  void takeVisible();
  void cut(const Vec2& other);

  double radius_;
  std::vector<Vec2> cell_, part_;  // corners relative to the point
  VisibilityProfile visibility_;   // of the walls within the circle, seen from the point
  std::vector<sim2d::Segment> walls_, near_;
};

/// Area of the intersection of a circle around the origin with a counter-clockwise polygon.
double areaInCircle(const std::vector<Vec2>& polygon, double radius);

}  // namespace metrics
