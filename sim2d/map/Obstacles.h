#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim2d/base/StopFlag.h"
#include "sim2d/map/SegmentGrid.h"

namespace sim2d {

/// Spatial index of all outlines of a world, in parts that can be enabled and disabled (doors).
/// Queries are const, do not allocate after the first call with the same buffer, and may run in
/// parallel.
class Obstacles {
 public:
  Obstacles() = default;
  /// Returns the number of the part, whose outlines are enabled together. `isOfMap`: they are the
  /// outlines of the map's walls.
  int add(std::vector<Outline> outlines, bool enabled = true, bool isOfMap = false);
  void build(const base::StopFlag& stop = {});  // after the last add()
  void setEnabled(int part, bool enabled);
  bool isEnabled(int part) const { return enabled_.at(static_cast<std::size_t>(part)) != 0; }
  bool isOfMap(int part) const { return ofMap_.at(static_cast<std::size_t>(part)) != 0; }
  int partCount() const { return static_cast<int>(parts_.size()); }
  const std::vector<Outline>& outlines(int part) const {
    return parts_.at(static_cast<std::size_t>(part));
  }

  /// Obstacle points that act on a body at `position` (rule "boundary"): on each outline the local
  /// minima of distance within `range` whose outer side faces the position; of points closer than
  /// 0.3 m to each other only the nearest. Inside an obstacle: only the nearest boundary point,
  /// with `inside` set. Appends to `points`, nearest first.
  struct Point {
    Vec2 position = Vec2::Zero();
    double distance = 0.0;  // [m] from the position, >= 0
    bool inside = false;    // the position is inside the obstacle: the force acts towards the point
    int part = -1;
  };
  /// Points that another obstacle covers are omitted. Recent results are cached per thread, also
  /// for copies of this object: metrics and standing people repeat the queries of the world.
  void boundaryPoints(const Vec2& position, std::vector<Point>& points, double range = 5.0) const;
  /// Rule "rays": hits of 90 rays, 4 degrees apart from +x, up to 4 m. Appends in that order; from
  /// inside an obstacle the rays hit its border and `inside` is set.
  void rayPoints(const Vec2& position, std::vector<Point>& points) const;

  /// The nearest point of any boundary within `range`, including covered ones.
  std::optional<Point> nearestPoint(const Vec2& position, double range) const;
  /// Appends each edge that may be within the range, and possibly some that are not.
  void segmentsNear(const Vec2& position, double range, std::vector<Segment>& segments) const;
  /// Calls visit(const Segment&) for the same edges, in another order.
  template <class Visit>
  void visitNear(const Vec2& position, double range, Visit visit) const;
  /// Distance to the nearest boundary [m], negative inside; `limit` if none is nearer.
  double clearance(const Vec2& position, double limit = 5.0) const;
  bool isInside(const Vec2& position) const { return solidPartAt(position) >= 0; }
  /// Line of sight (also for sound): no solid between the points. Symmetric.
  bool isVisible(const Vec2& from, const Vec2& to) const;
  /// Distance along the unit vector to the first hit; `range` without a hit, 0 inside.
  double raycast(const Vec2& from, const Vec2& direction, double range) const;

 private:
  struct Edge {  // belongs to the segment of the same index
    int part = 0;
    int previous = 0, next = 0;  // edges of the same outline
    Vec2 along = Vec2::Zero();   // unit vector
    double length = 0.0;         // [m]
    // Never covered by another outline; the same for its first corner.
    bool isUncovered = false, isCornerUncovered = false;
  };
  struct Winding {  // winding number of a part at a bucket centre
    int part = 0;
    int count = 0;
  };
  struct Crossing {      // of an edge with the centre line of a row of buckets
    int lastColumn = 0;  // the last one left of the edge
    int part = 0;
    int sense = 0;  // 1: the edge rises, -1: it falls
  };
  struct Hit {
    double distance = 0.0;  // [m]
    int edge = -1;          // none
  };

  bool isOn(int edge) const {
    const int part = edges_[static_cast<std::size_t>(edge)].part;
    return enabled_[static_cast<std::size_t>(part)] != 0;
  }
  void addOutline(const Outline& outline, int part);
  void countWindings(const base::StopFlag& stop);
  void countWindingsOfRow(int row);
  std::vector<Crossing> crossingsOfRow(int row) const;
  int windingAt(const Vec2& point, SegmentGrid::Bucket bucket, const Winding& atCentre) const;
  int solidPartAt(const Vec2& point, bool withDisabled = false) const;  // -1: free
  void findUncovered(const base::StopFlag& stop);
  bool isIsolated(int edge) const;
  Point nearestExit(const Vec2& position) const;
  void findBoundaryPoints(const Vec2& position, std::vector<Point>& points, double range) const;
  struct PointQuery;
  void addFoot(int edge, const PointQuery& query) const;
  void addCorner(int edge, const PointQuery& query) const;
  bool isExposed(const Vec2& place, int edge, int other) const;
  bool isCovered(const Vec2& place, int edge, int other, bool withDisabled) const;
  void improveExit(int edge, const Vec2& position, Point& best) const;
  Hit firstHit(const Vec2& from, const Vec2& direction, double range) const;
  bool isHit(const Vec2& from, const Vec2& direction, double range) const;

  std::uint64_t version_ = 0;  // changes with every modification; copies keep it
  std::vector<std::vector<Outline>> parts_;
  std::vector<char> enabled_, ofMap_;
  std::vector<int> background_;  // per part: winding number far outside, 1 if the outside is solid
  std::vector<Segment> segments_;
  std::vector<Edge> edges_;
  SegmentGrid index_;
  SegmentCells cells_;
  std::vector<int> windingStart_;  // by bucket
  std::vector<Winding> windings_;
  std::vector<Vec2> rays_;
};

template <class Visit>
void Obstacles::visitNear(const Vec2& position, double range, Visit visit) const {
  cells_.visitNear(position, range, [&](int edge) {
    if (isOn(edge)) {
      visit(segments_[static_cast<std::size_t>(edge)]);
    }
  });
}

/// Tightens a path: the shortest one that passes all obstacles on the same sides, for a disc that
/// keeps `clearance` [m] from all borders (less where the path begins or ends closer). Straight
/// lines, and chords for arcs around corners; accurate to 2e-4 of the length. The given path must
/// be free up to the rounding of a planning grid.
std::vector<Vec2> tightened(const std::vector<Vec2>& path, const Obstacles& obstacles,
                            double clearance);

/// Whether a disc can move straight between two points with `clearance` [m] to all borders (at
/// least half a millimetre).
bool isSegmentFree(const Vec2& from, const Vec2& to, const Obstacles& obstacles, double clearance);

}  // namespace sim2d
