#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim2d/map/Outlines.h"

namespace sim2d {

/// Uniform grid of square buckets over segments, for proximity and ray queries. A segment is listed
/// in every bucket closer than a micrometre, so most queries visit it repeatedly. Immutable after
/// build and thread-safe.
class SegmentGrid {
 public:
  using Bucket = Cell;
  struct Items {
    const int* first = nullptr;
    const int* last = nullptr;
    const int* begin() const { return first; }
    const int* end() const { return last; }
  };

  /// `bucketSize`: preferred size [m]; it grows if there would be more than a million buckets.
  void build(const std::vector<Segment>& segments, double bucketSize);

  bool isEmpty() const { return width_ == 0; }
  int width() const { return width_; }
  int height() const { return height_; }
  bool contains(Bucket bucket) const {
    return bucket.column >= 0 && bucket.row >= 0 && bucket.column < width_ && bucket.row < height_;
  }
  Bucket bucketAt(const Vec2& point) const;  // may lie outside
  Vec2 centreOf(Bucket bucket) const;
  int indexOf(Bucket bucket) const { return bucket.row * width_ + bucket.column; }
  Items items(Bucket bucket) const {
    const auto index = static_cast<std::size_t>(indexOf(bucket));
    return {items_.data() + start_[index], items_.data() + start_[index + 1]};
  }

  /// Calls visit(int segment) for all buckets near the segment.
  template <class Visit>
  void visitAlong(const Segment& segment, Visit visit) const;

  /// Calls visit(int segment) in rings of buckets around the point, as long as a ring may contain a
  /// segment nearer than `limit`, which the visitor may lower.
  template <class Visit>
  void visitNear(const Vec2& point, const double& limit, Visit visit) const;

  /// Calls visit(Items, double end) for the non-empty buckets along a ray, in order; `end`:
  /// distance at which the ray leaves the bucket. The visitor returns false to stop.
  template <class Visit>
  void visitRay(const Vec2& from, const Vec2& direction, double range, Visit visit) const;

 private:
  struct Walk {  // traversal state of a ray
    Bucket bucket, step;
    Vec2 next = Vec2::Zero(), delta = Vec2::Zero();  // distance to the next border; between borders
    Vec2 borders = Vec2::Zero();                     // crossed per metre
  };
  struct Span {
    int first = 0, last = -1;
  };
  void computeRingDistances();
  int ringDistance(Bucket bucket) const {
    return ringDistances_[static_cast<std::size_t>(indexOf(bucket))];
  }
  static double skipEmptyRings(Walk& walk, int rings);
  Span columnsIn(int row, const Segment& segment) const;
  Span rowsOf(const Segment& segment) const;
  bool clip(const Vec2& from, const Vec2& direction, double& begin, double& end) const;
  Walk startWalk(const Vec2& from, const Vec2& direction, double begin) const;

  template <class Visit>
  void visitBuckets(Bucket low, Bucket high, Visit& visit) const;
  template <class Visit>
  void forEachBucketAlong(const Segment& segment, Visit visit) const;

  Vec2 origin_ = Vec2::Zero();
  double size_ = 1.0;
  int width_ = 0, height_ = 0;
  std::vector<int> start_, items_;
  std::vector<std::uint8_t>
      ringDistances_;  // by bucket: rings to the nearest non-empty one, at most 255
};

template <class Visit>
void SegmentGrid::visitBuckets(Bucket low, Bucket high, Visit& visit) const {
  const int lastRow = std::min(high.row, height_ - 1);
  const int lastColumn = std::min(high.column, width_ - 1);
  for (int row = std::max(low.row, 0); row <= lastRow; ++row) {
    for (int column = std::max(low.column, 0); column <= lastColumn; ++column) {
      for (const int item : items({column, row})) {
        visit(item);
      }
    }
  }
}

template <class Visit>
void SegmentGrid::forEachBucketAlong(const Segment& segment, Visit visit) const {
  const Span rows = rowsOf(segment);
  for (int row = rows.first; row <= rows.last; ++row) {
    const Span columns = columnsIn(row, segment);
    for (int column = columns.first; column <= columns.last; ++column) {
      visit(Bucket{column, row});
    }
  }
}

template <class Visit>
void SegmentGrid::visitAlong(const Segment& segment, Visit visit) const {
  forEachBucketAlong(segment, [&](Bucket bucket) {
    for (const int item : items(bucket)) {
      visit(item);
    }
  });
}

template <class Visit>
void SegmentGrid::visitNear(const Vec2& point, const double& limit, Visit visit) const {
  if (isEmpty()) {
    return;
  }
  const auto [column, row] = bucketAt(point);
  const int beside = std::max({0, -column, column - width_ + 1});
  const int above = std::max({0, -row, row - height_ + 1});
  const int last = std::max({column, row, width_ - 1 - column, height_ - 1 - row, 0});
  const int empty = contains({column, row}) ? ringDistance({column, row}) : 0;
  for (int ring = std::max({beside, above, empty}); ring <= last; ++ring) {
    if ((ring - 1) * size_ > limit) {
      return;
    }
    visitBuckets({column - ring, row - ring}, {column + ring, row - ring}, visit);
    if (ring > 0) {
      visitBuckets({column - ring, row + ring}, {column + ring, row + ring}, visit);
      visitBuckets({column - ring, row - ring + 1}, {column - ring, row + ring - 1}, visit);
      visitBuckets({column + ring, row - ring + 1}, {column + ring, row + ring - 1}, visit);
    }
  }
}

template <class Visit>
void SegmentGrid::visitRay(const Vec2& from, const Vec2& direction, double range,
                           Visit visit) const {
  double begin = 0.0;
  double end = range;
  if (isEmpty() || !clip(from, direction, begin, end)) {
    return;
  }
  Walk walk = startWalk(from, direction, begin);
  double reached = begin;
  while (contains(walk.bucket) && reached <= end) {
    const int rings = ringDistance(walk.bucket);
    if (rings > 1) {
      reached = skipEmptyRings(walk, rings - 1);
      continue;
    }
    const bool alongX = walk.next.x() < walk.next.y();
    reached = alongX ? walk.next.x() : walk.next.y();
    if (rings == 0 && !visit(items(walk.bucket), reached)) {
      return;
    }
    if (alongX) {
      walk.bucket.column += walk.step.column;
      walk.next.x() += walk.delta.x();
    } else {
      walk.bucket.row += walk.step.row;
      walk.next.y() += walk.delta.y();
    }
  }
}

/// Advances to where the ray leaves the given number of rings; returns that distance.
inline double SegmentGrid::skipEmptyRings(Walk& walk, int rings) {
  const Vec2 leave = walk.next + static_cast<double>(rings) * walk.delta;
  const double reached = std::min(leave.x(), leave.y());
  const auto pass = [&](int axis, int& at, int step) {
    const double beyond = reached - walk.next[axis];
    if (beyond >= 0.0) {
      const int borders = std::min(static_cast<int>(beyond * walk.borders[axis]), rings) + 1;
      walk.next[axis] += borders * walk.delta[axis];
      at += borders * step;
    }
  };
  pass(0, walk.bucket.column, walk.step.column);
  pass(1, walk.bucket.row, walk.step.row);
  return reached;
}

/// Spatial hash of segments by their midpoints: a query visits each segment at most once, unlike in
/// SegmentGrid. Immutable after build and thread-safe.
class SegmentCells {
 public:
  /// `side`: preferred cell size [m]; it grows if there would be more than a million cells.
  void build(const std::vector<Segment>& segments, double side);

  /// Calls visit(int segment) for each segment that may be nearer than `range` [m] to the point,
  /// and possibly for some that are not. The order is deterministic.
  template <class Visit>
  void visitNear(const Vec2& point, double range, Visit visit) const;

 private:
  struct Item {
    Vec2 middle = Vec2::Zero();
    double half = 0.0;  // half the length [m], rounded up
    int segment = 0;
  };
  Cell cellAt(const Vec2& point) const;  // clamped to the grid
  template <class Visit>
  static void visitItems(const Item* from, const Item* to, const Vec2& point, double range,
                         Visit& visit);

  Vec2 origin_ = Vec2::Zero();
  double side_ = 1.0;     // [m]
  double longest_ = 0.0;  // half the longest stored length [m]
  int width_ = 0, height_ = 0;
  std::size_t long_ = 0;     // number of items too long for a cell, at the front
  std::vector<Item> items_;  // the others follow cell by cell, row by row
  std::vector<std::size_t> start_;
};

template <class Visit>
void SegmentCells::visitItems(const Item* from, const Item* to, const Vec2& point, double range,
                              Visit& visit) {
  for (const Item* item = from; item != to; ++item) {
    const double within = range + item->half;
    if ((item->middle - point).squaredNorm() < within * within) {
      visit(item->segment);
    }
  }
}

template <class Visit>
void SegmentCells::visitNear(const Vec2& point, double range, Visit visit) const {
  if (items_.empty()) {
    return;
  }
  const Item* const items = items_.data();
  visitItems(items, items + long_, point, range, visit);
  if (width_ == 0) {
    return;
  }
  const Vec2 reach = Vec2::Constant(range + longest_);
  const Cell low = cellAt(point - reach);
  const Cell high = cellAt(point + reach);
  for (int row = low.row; row <= high.row; ++row) {
    const auto first = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
    visitItems(items + start_[first + static_cast<std::size_t>(low.column)],
               items + start_[first + static_cast<std::size_t>(high.column) + 1], point, range,
               visit);
  }
}

}  // namespace sim2d
