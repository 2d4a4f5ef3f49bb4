#pragma once

#include <optional>
#include <vector>

#include "sim2d/map/Outlines.h"

namespace sim2d {

/// All outlines of a world in one index, with parts that can be switched (doors). Queries are
/// const, allocate nothing after the first call with the same buffer, and may run in parallel.
class Obstacles {
 public:
  Obstacles() = default;
  /// Returns the number of the part; all its outlines are switched together.
  int add(std::vector<Outline> outlines, bool enabled = true);
  void build();  // after the last add
  void setEnabled(int part, bool enabled);
  bool isEnabled(int part) const;
  int partCount() const;
  const std::vector<Outline>& outlines(int part) const;

  /// Points by which obstacles act on a body at `position` (rule "boundary"): on each outline the
  /// local minima of distance nearer than `range` whose outward side faces the position; of points
  /// closer than 0.3 m to each other only the nearest. Inside an obstacle: the nearest boundary
  /// point alone, marked. Appends to `points`, nearest first.
  struct Point {
    Vec2 position = Vec2::Zero();
    double distance = 0.0;  // [m] from the position, >= 0
    bool inside = false;    // the position is inside the obstacle: the force points to the point
    int part = -1;
  };
  void boundaryPoints(const Vec2& position, std::vector<Point>& points, double range = 5.0) const;
  /// Rule "rays": the hits of 90 rays, 4 degrees apart from +x, up to 4 m.
  void rayPoints(const Vec2& position, std::vector<Point>& points) const;

  /// Distance to the nearest boundary [m], negative inside, `limit` when nothing is nearer.
  double clearance(const Vec2& position, double limit = 5.0) const;
  bool isInside(const Vec2& position) const;
  /// Nothing solid between the points: line of sight, way of sound.
  bool isVisible(const Vec2& from, const Vec2& to) const;
  /// Distance along the unit vector to the first hit, `range` if there is none.
  double raycast(const Vec2& from, const Vec2& direction, double range) const;

 private:
  struct Segment {
    Vec2 a = Vec2::Zero(), b = Vec2::Zero();
    int part = 0, outline = 0, previous = 0, next = 0;
  };
  std::vector<std::vector<Outline>> parts_;
  std::vector<char> enabled_;
  std::vector<Segment> segments_;
  // uniform grid over the segments
  Vec2 gridOrigin_ = Vec2::Zero();
  double gridCell_ = 1.0;
  int gridWidth_ = 0, gridHeight_ = 0;
  std::vector<int> gridStart_, gridItems_;
};

}  // namespace sim2d
