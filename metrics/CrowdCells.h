#pragma once

#include <utility>
#include <vector>

#include "metrics/Samples.h"

/// Neighbours and cells of points, for the crowd measures.
namespace metrics {

/// Of each point the others within the distance; squares of that size keep it linear.
std::vector<std::vector<Vec2>> neighbours(const std::vector<Vec2>& points, double reach);

/// Areas of Voronoi cells, each cut by a 64-gon with the area of a circle.
class CellAreas {
 public:
  explicit CellAreas(double radius);
  /// Others at least up to twice the radius.
  double areaOf(const Vec2& point, const std::vector<Vec2>& others);

 private:
  void cutOut(const std::vector<Vec2>& outline, const Vec2& axis);
  void cut(const Vec2& other);

  std::vector<Vec2> circle_;  // corners around the origin, the first on the x axis
  std::vector<Vec2> square_;  // around the circle: quicker for cells that end inside
  double inside2_ = 0.0;      // of the largest circle inside the 64-gon, radius squared
  std::vector<std::pair<double, Vec2>> from_;  // the others from the point, distance squared
  std::vector<Vec2> cell_, part_;              // corners from the point
  double reach2_ = 0.0;                        // of the farthest corner, squared
};

}  // namespace metrics
