#include "sim2d/map/SegmentGrid.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

namespace sim2d {

namespace {

constexpr double kReach = 1e-6;  // [m]

int toBucket(double value) {
  constexpr double kFar = 1e8;
  if (!(value > -kFar)) {  // also NaN
    return static_cast<int>(-kFar);
  }
  return static_cast<int>(std::floor(std::min(value, kFar)));
}

/// Restricts the parameter range [low, high] of a segment to where one coordinate lies in [from,
/// to].
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
  constexpr double kMaxBuckets = 1e6;
  const Vec2 extent = high - low + Vec2::Constant(4.0 * kReach);
  size_ = std::max({bucketSize, std::sqrt(extent.x() * extent.y() / kMaxBuckets),
                    extent.maxCoeff() / kMaxBuckets});
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
  computeRingDistances();
}

/// Chebyshev distance transform in two sweeps from opposite corners.
void SegmentGrid::computeRingDistances() {
  constexpr int kMost = 255;
  ringDistances_.assign(start_.size() - 1, 0);
  const auto farther = [this](int column, int row) {
    return contains({column, row}) ? ringDistance({column, row}) + 1 : kMost;
  };
  const auto lower = [&](Bucket at, int side, int most) {
    const Items here = items(at);
    const int before = at.row + side;
    const int ringDistance =
        std::min({most, farther(at.column + side, at.row), farther(at.column - 1, before),
                  farther(at.column, before), farther(at.column + 1, before)});
    ringDistances_[static_cast<std::size_t>(indexOf(at))] =
        static_cast<std::uint8_t>(here.first != here.last ? 0 : ringDistance);
  };
  for (int row = 0; row < height_; ++row) {
    for (int column = 0; column < width_; ++column) {
      lower({column, row}, -1, kMost);
    }
  }
  for (int row = height_ - 1; row >= 0; --row) {
    for (int column = width_ - 1; column >= 0; --column) {
      lower({column, row}, 1, ringDistance({column, row}));
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

/// Clips the ray to the area of the grid; false: it misses.
bool SegmentGrid::clip(const Vec2& from, const Vec2& direction, double& begin, double& end) const {
  const Vec2 high = origin_ + size_ * Vec2(width_, height_);
  for (int axis = 0; axis < 2; ++axis) {
    if (direction[axis] == 0.0 && (from[axis] < origin_[axis] || from[axis] > high[axis])) {
      return false;
    }
    clipParameter(from[axis], direction[axis], origin_[axis], high[axis], begin, end);
  }
  // For points too far apart the direction underflows to 0: such a ray stays in its bucket.
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

Cell SegmentCells::cellAt(const Vec2& point) const {
  const Vec2 at = (point - origin_) / side_;
  const auto within = [](double value, int count) {  // NaN: the first cell
    return value > 0.0 ? static_cast<int>(std::min(value, count - 1.0)) : 0;
  };
  return {within(at.x(), width_), within(at.y(), height_)};
}

void SegmentCells::build(const std::vector<Segment>& segments, double side) {
  assert(side > 0.0);
  *this = SegmentCells();
  constexpr double kRounding = 1e-6;  // [m]
  std::vector<Item> small;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    const Item item{0.5 * (segment.a + segment.b), 0.5 * (segment.b - segment.a).norm() + kRounding,
                    static_cast<int>(i)};
    (item.half > side ? items_ : small).push_back(item);
  }
  long_ = items_.size();
  if (small.empty()) {
    return;
  }
  Vec2 low = small.front().middle;
  Vec2 high = low;
  for (const Item& item : small) {
    low = low.cwiseMin(item.middle);
    high = high.cwiseMax(item.middle);
    longest_ = std::max(longest_, item.half);
  }
  constexpr double kMaxCells = 1e6;
  const Vec2 extent = high - low;
  side_ = std::max(
      {side, std::sqrt(extent.x() * extent.y() / kMaxCells), extent.maxCoeff() / kMaxCells});
  origin_ = low;
  width_ = static_cast<int>(extent.x() / side_) + 1;
  height_ = static_cast<int>(extent.y() / side_) + 1;
  const auto numberOf = [this](const Item& item) {
    const Cell cell = cellAt(item.middle);
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.column);
  };
  start_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) + 1, 0);
  for (const Item& item : small) {
    ++start_[numberOf(item) + 1];
  }
  start_.front() = long_;
  for (std::size_t i = 1; i < start_.size(); ++i) {
    start_[i] += start_[i - 1];
  }
  items_.resize(items_.size() + small.size());
  std::vector<std::size_t> fill(start_.begin(), start_.end() - 1);
  for (const Item& item : small) {
    items_[fill[numberOf(item)]++] = item;
  }
}

}  // namespace sim2d
