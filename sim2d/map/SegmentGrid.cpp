#include "sim2d/map/SegmentGrid.h"

#include <cassert>
#include <cmath>
#include <limits>

namespace sim2d {

namespace {

constexpr double kReach = 1e-6;  // [m]

int toBucket(double value) {
  constexpr double kFar = 1e8;
  if (!(value > -kFar)) {  // NaN as well
    return static_cast<int>(-kFar);
  }
  return static_cast<int>(std::floor(std::min(value, kFar)));
}

/// The part of [low, high] of a segment's parameter where one coordinate lies in [from, to].
void clipParameter(double start, double change, double from, double to, double& low, double& high) {
  if (change == 0.0) {
    return;
  }
  const double first = (from - start) / change;
  const double second = (to - start) / change;
  low = std::max(low, std::min(first, second));
  high = std::min(high, std::max(first, second));
}

}  // namespace

void SegmentGrid::build(const std::vector<Segment>& segments, double bucketSize) {
  assert(bucketSize > 0.0);
  *this = SegmentGrid();
  if (segments.empty()) {
    return;
  }
  Vec2 low = segments.front().a;
  Vec2 high = low;
  for (const Segment& segment : segments) {
    low = low.cwiseMin(segment.a).cwiseMin(segment.b);
    high = high.cwiseMax(segment.a).cwiseMax(segment.b);
  }
  constexpr double kMostBuckets = 1e6;
  const Vec2 extent = high - low + Vec2::Constant(4.0 * kReach);
  size_ = std::max({bucketSize, std::sqrt(extent.x() * extent.y() / kMostBuckets),
                    extent.maxCoeff() / kMostBuckets});
  origin_ = low - Vec2::Constant(2.0 * kReach);
  width_ = toBucket(extent.x() / size_) + 1;
  height_ = toBucket(extent.y() / size_) + 1;
  start_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) + 1, 0);
  const auto numberOf = [this](Bucket bucket) { return static_cast<std::size_t>(indexOf(bucket)); };
  for (const Segment& segment : segments) {
    forEachBucketAlong(segment, [&](Bucket bucket) { ++start_[numberOf(bucket) + 1]; });
  }
  for (std::size_t i = 1; i < start_.size(); ++i) {
    start_[i] += start_[i - 1];
  }
  items_.resize(static_cast<std::size_t>(start_.back()));
  std::vector<int> fill(start_.begin(), start_.end() - 1);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    forEachBucketAlong(segments[i], [&](Bucket bucket) {
      items_[static_cast<std::size_t>(fill[numberOf(bucket)]++)] = static_cast<int>(i);
    });
  }
  findAway();
}

/// In two sweeps, from opposite corners: each is a ring farther away than the nearest beside it.
void SegmentGrid::findAway() {
  constexpr int kMost = 255;
  away_.assign(start_.size() - 1, 0);
  const auto farther = [this](int column, int row) {
    return contains({column, row}) ? away({column, row}) + 1 : kMost;
  };
  const auto lower = [&](Bucket at, int side, int most) {
    const Items here = items(at);
    const int before = at.row + side;
    const int away =
        std::min({most, farther(at.column + side, at.row), farther(at.column - 1, before),
                  farther(at.column, before), farther(at.column + 1, before)});
    away_[static_cast<std::size_t>(indexOf(at))] =
        static_cast<std::uint8_t>(here.first != here.last ? 0 : away);
  };
  for (int row = 0; row < height_; ++row) {
    for (int column = 0; column < width_; ++column) {
      lower({column, row}, -1, kMost);
    }
  }
  for (int row = height_ - 1; row >= 0; --row) {
    for (int column = width_ - 1; column >= 0; --column) {
      lower({column, row}, 1, away({column, row}));
    }
  }
}

SegmentGrid::Span SegmentGrid::rowsOf(const Segment& segment) const {
  const double low = std::min(segment.a.y(), segment.b.y()) - kReach;
  const double high = std::max(segment.a.y(), segment.b.y()) + kReach;
  return {std::max(toBucket((low - origin_.y()) / size_), 0),
          std::min(toBucket((high - origin_.y()) / size_), height_ - 1)};
}

SegmentGrid::Span SegmentGrid::columnsIn(int row, const Segment& segment) const {
  const Vec2 along = segment.b - segment.a;
  double low = 0.0;
  double high = 1.0;
  const double bottom = origin_.y() + row * size_;
  clipParameter(segment.a.y(), along.y(), bottom - kReach, bottom + size_ + kReach, low, high);
  if (low > high) {
    return {};
  }
  const double first = segment.a.x() + low * along.x() - origin_.x();
  const double second = segment.a.x() + high * along.x() - origin_.x();
  return {std::max(toBucket((std::min(first, second) - kReach) / size_), 0),
          std::min(toBucket((std::max(first, second) + kReach) / size_), width_ - 1)};
}

SegmentGrid::Bucket SegmentGrid::bucketAt(const Vec2& point) const {
  const Vec2 offset = (point - origin_) / size_;
  return {toBucket(offset.x()), toBucket(offset.y())};
}

Vec2 SegmentGrid::centreOf(Bucket bucket) const {
  return origin_ + size_ * Vec2(bucket.column + 0.5, bucket.row + 0.5);
}

/// Cuts the ray to the area of the buckets; false when it misses them.
bool SegmentGrid::clip(const Vec2& from, const Vec2& direction, double& begin, double& end) const {
  const Vec2 high = origin_ + size_ * Vec2(width_, height_);
  for (int axis = 0; axis < 2; ++axis) {
    if (direction[axis] == 0.0 && (from[axis] < origin_[axis] || from[axis] > high[axis])) {
      return false;
    }
    clipParameter(from[axis], direction[axis], origin_[axis], high[axis], begin, end);
  }
  // Of places too far apart for a number the direction is 0: such a ray leaves no bucket.
  end = std::min(end, std::numeric_limits<double>::max());
  return begin <= end;
}

SegmentGrid::Walk SegmentGrid::startWalk(const Vec2& from, const Vec2& direction,
                                         double begin) const {
  Walk walk;
  walk.bucket = bucketAt(from + begin * direction);
  walk.bucket.column = std::clamp(walk.bucket.column, 0, width_ - 1);
  walk.bucket.row = std::clamp(walk.bucket.row, 0, height_ - 1);
  walk.step = {direction.x() < 0.0 ? -1 : 1, direction.y() < 0.0 ? -1 : 1};
  const Vec2 border = origin_ + size_ * Vec2(walk.bucket.column + (walk.step.column > 0 ? 1 : 0),
                                             walk.bucket.row + (walk.step.row > 0 ? 1 : 0));
  constexpr double kNever = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 2; ++axis) {
    const bool moves = direction[axis] != 0.0;
    walk.next[axis] = moves ? (border[axis] - from[axis]) / direction[axis] : kNever;
    walk.delta[axis] = moves ? size_ / std::fabs(direction[axis]) : kNever;
    walk.borders[axis] = std::fabs(direction[axis]) / size_;
  }
  return walk;
}

}  // namespace sim2d
