#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/base/Types.h"
#include "sim2d/map/Obstacles.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/trace/Trace.h"

namespace metrics {

/// Personal space as a Gaussian that is elongated in walking direction: 1 at the person, decreasing
/// with distance. Person frame: x ahead, y to the left. Source: Kirby 2010, "Social Robot
/// Navigation", with the parameters of SRPB.
struct GaussianPersonalSpace {
  double ahead = 0.5, behind = 0.25, side = 1.0 / 3.0;  // variances [m²]

  /// Exponent; 0 at the person. The value of the Gaussian is exp(-outsideness).
  double outsideness(const base::Vec2& local) const {
    const double along = local.x() > 0.0 ? ahead : behind;
    return local.x() * local.x() / (2.0 * along) + local.y() * local.y() / (2.0 * side);
  }
};

/// Vf = max(2 |v|, 0.5) ahead, Vf/2 behind, 2/3 Vf to the sides.
GaussianPersonalSpace personalSpaceOf(double speed);  // [m/s]

/// Contour at `level`, 0 < level < 1: corners in the world frame [m], counter-clockwise from
/// straight ahead.
std::vector<base::Vec2> personalSpaceContour(const GaussianPersonalSpace& space,
                                             const base::Pose2& person, double level,
                                             int corners = 48);

/// Kernel radius R [m].
constexpr double kDensityRadius = 1.0;

/// Density of people [1/m²] at the centres of square cells: the sum over people of exp(-d²/R²) /
/// (pi R²), so that each person contributes one in total. Source: Helbing, Johansson and Al-Abideen
/// 2007, "Dynamics of crowd disasters", with R = 1 m. Walls are ignored, and people farther than
/// 3 R, whose contribution is below 4e-5 of one per m².
struct DensityField {
  base::Vec2 low = base::Vec2::Zero();  // corner of the first cell [m]
  double cell = 0.25;                   // side [m]
  int columns = 0, rows = 0;
  std::vector<float> values;  // [1/m²], row-major, ascending y

  base::Vec2 centreOf(int column, int row) const {
    return low + cell * base::Vec2(column + 0.5, row + 0.5);
  }
  float at(int column, int row) const {
    return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)];
  }
  double peak() const;  // 0 without cells
};

/// Density over the box from `low` to `high`, with at most about `mostCells` cells and 4096 along a
/// side; the cell size is increased if necessary.
DensityField densityField(const std::vector<base::Vec2>& people, const base::Vec2& low,
                          const base::Vec2& high, double cell = 0.25,
                          std::size_t mostCells = std::size_t{1} << 18);

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
    double rank = 0.0;  // `pseudoAngle` of the direction; -2 for the direction -pi
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
