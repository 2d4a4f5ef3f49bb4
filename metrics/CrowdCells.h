#pragma once

#include <utility>
#include <vector>

#include "metrics/Panorama.h"
#include "metrics/Samples.h"
#include "sim2d/map/Obstacles.h"

/// Neighbours and cells of points, for the crowd measures.
namespace metrics {

/// Of each point the numbers of the others within the distance; squares of that size keep it
/// linear.
std::vector<std::vector<std::size_t>> neighbours(const std::vector<Vec2>& points, double reach);

/// Areas of Voronoi cells among walls: of what is nearer to a point than to any other that it sees,
/// within a circle around it, and not behind a wall; doors count as open. Exact, but for rounding.
class CellAreas {
 public:
  explicit CellAreas(double radius) : radius_(radius) {}  // of the circle [m]
  /// Others at least up to twice the radius. Walls, and their images beyond the seam, are those of
  /// the context.
  double areaOf(const Vec2& point, const std::vector<Vec2>& others, const RunContext& context);

 private:
  void findWallsAround(const Vec2& point, double reach, const RunContext& context);
  bool isHidden(const Vec2& other) const;
  void takeVisible();
  void cut(const Vec2& other);

  double radius_;
  std::vector<Vec2> cell_, part_;  // corners around the point, which is the origin
  Panorama panorama_;              // of the walls within the circle, from the point
  std::vector<sim2d::Segment> walls_, near_;
};

/// Area that a circle around the origin shares with the polygon, whose corners turn to the left.
double areaInCircle(const std::vector<Vec2>& polygon, double radius);

}  // namespace metrics
