#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim2d/base/Stop.h"
#include "sim2d/map/SegmentCells.h"
#include "sim2d/map/SegmentGrid.h"

namespace sim2d {

/// All outlines of a world in one index, with parts that can be switched (doors). Queries are
/// const, allocate nothing after the first call with the same buffer, and may run in parallel.
class Obstacles {
 public:
  Obstacles() = default;
  /// Returns the number of the part; all its outlines are switched together. `isOfMap`: they are
  /// those of the map's own walls.
  int add(std::vector<Outline> outlines, bool enabled = true, bool isOfMap = false);
  void build(const base::StopFlag& stop = {});  // after the last add
  void setEnabled(int part, bool enabled);
  bool isEnabled(int part) const { return enabled_.at(static_cast<std::size_t>(part)) != 0; }
  bool isOfMap(int part) const { return ofMap_.at(static_cast<std::size_t>(part)) != 0; }
  int partCount() const { return static_cast<int>(parts_.size()); }
  const std::vector<Outline>& outlines(int part) const {
    return parts_.at(static_cast<std::size_t>(part));
  }

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
  /// A point of one outline that another obstacle covers is no boundary and left out. The last
  /// answers stay for who asks the same of this or a copy on the same thread: metrics ask what
  /// their world has asked, and who stands asks the same again.
  void boundaryPoints(const Vec2& position, std::vector<Point>& points, double range = 5.0) const;
  /// Rule "rays": the hits of 90 rays, 4 degrees apart from +x, up to 4 m. Appends in that order;
  /// from inside an obstacle the rays meet its border and the points are marked.
  void rayPoints(const Vec2& position, std::vector<Point>& points) const;

  /// The nearest point of any boundary within `range`, covered ones as well.
  std::optional<Point> nearestPoint(const Vec2& position, double range) const;
  /// Appends each border that may be within the range, and perhaps some that are farther away.
  void segmentsNear(const Vec2& position, double range, std::vector<Segment>& segments) const;
  /// visit(const Segment&) for each of these, in another order.
  template <class Visit>
  void visitNear(const Vec2& position, double range, Visit visit) const;
  /// Distance to the nearest boundary [m], negative inside, `limit` when nothing is nearer.
  double clearance(const Vec2& position, double limit = 5.0) const;
  bool isInside(const Vec2& position) const { return solidPartAt(position) >= 0; }
  /// Nothing solid between the points: line of sight, way of sound. The same from both ends.
  bool isVisible(const Vec2& from, const Vec2& to) const;
  /// Distance along the unit vector to the first hit, `range` if there is none, 0 inside.
  double raycast(const Vec2& from, const Vec2& direction, double range) const;

 private:
  struct Edge {  // beside the segment of the same number
    int part = 0;
    int previous = 0, next = 0;  // edges of the same outline
    Vec2 along = Vec2::Zero();   // unit vector
    double length = 0.0;         // [m]
    // Nothing of another outline ever covers its points; idem its first corner.
    bool isBare = false, isCornerBare = false;
  };
  struct Winding {  // how often a part's outlines run round the centre of a bucket
    int part = 0;
    int count = 0;
  };
  struct Crossing {      // of an edge with the line through the centres of a row of buckets
    int lastColumn = 0;  // whose centre lies to the left of the edge
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
  void findBare(const base::StopFlag& stop);
  bool isApart(int edge) const;
  Point nearestWayOut(const Vec2& position) const;
  void findBoundaryPoints(const Vec2& position, std::vector<Point>& points, double range) const;
  struct PointQuery;
  void addFoot(int edge, const PointQuery& query) const;
  void addCorner(int edge, const PointQuery& query) const;
  bool isExposed(const Vec2& place, int edge, int other) const;
  bool isCovered(const Vec2& place, int edge, int other, bool withDisabled) const;
  void improveWayOut(int edge, const Vec2& position, Point& best) const;
  Hit firstHit(const Vec2& from, const Vec2& direction, double range) const;
  bool isHit(const Vec2& from, const Vec2& direction, double range) const;

  std::uint64_t version_ = 0;  // another one whenever anything changes; copies have the same
  std::vector<std::vector<Outline>> parts_;
  std::vector<char> enabled_, ofMap_;
  std::vector<int> background_;  // of each part: winding far away, 1 where all around is solid
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

}  // namespace sim2d
