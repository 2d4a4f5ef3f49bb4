#include "metrics/Panorama.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace metrics {

using base::Vec2;

namespace {

using Turn = Panorama::Turn;
using View = Panorama::View;

constexpr double kHalfTurn = 2.0;  // rank

Turn turnTo(const Vec2& place) {
  return {rankOf(place), place.normalized()};
}

/// Where two segments cross each other, if they do.
std::optional<Vec2> crossing(const sim2d::Segment& first, const sim2d::Segment& second) {
  const Vec2 a = first.b - first.a;
  const Vec2 b = second.b - second.a;
  const double across = base::cross(a, b);
  if (across == 0.0) {
    return std::nullopt;
  }
  const double s = base::cross(second.a - first.a, b) / across;
  const double t = base::cross(second.a - first.a, a) / across;
  return s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0 ? std::optional<Vec2>(first.a + s * a)
                                                  : std::nullopt;
}

const Turn& later(const Turn& one, const Turn& other) {
  return one.rank < other.rank ? other : one;
}
const Turn& sooner(const Turn& one, const Turn& other) {
  return other.rank < one.rank ? other : one;
}

/// Goes through views in their order.
class Walk {
 public:
  Walk(const View* next, const View* end) : next_(next), end_(end) {}

  bool isOver() const { return next_ == end_; }
  const View& view() const { return *next_; }
  /// Where the view begins, seen from `at` on; never when there is none.
  Turn from(const Turn& at) const {
    return isOver() ? Turn{HUGE_VAL, Vec2::UnitX()} : later(view().from, at);
  }
  void pass(const Turn& at) { next_ += !isOver() && view().to.rank <= at.rank ? 1 : 0; }

 private:
  const View* next_;
  const View* end_;
};

/// Goes on with the view before where that is of the same wall.
void append(const Turn& from, const Turn& to, std::size_t wall, std::vector<View>& views) {
  if (!(from.rank < to.rank)) {
    return;
  }
  if (!views.empty() && views.back().wall == wall && views.back().to.rank == from.rank) {
    views.back().to = to;
  } else {
    views.push_back({from, to, wall});
  }
}

}  // namespace

double rankOf(const Vec2& direction) {
  const double sum = std::abs(direction.x()) + std::abs(direction.y());
  const double share = sum > 0.0 ? direction.y() / sum : 0.0;
  if (direction.x() >= 0.0) {
    return share;
  }
  return share < 0.0 ? -kHalfTurn - share : kHalfTurn - share;
}

double along(const Vec2& direction, const sim2d::Segment& segment) {
  const double across = base::cross(direction, segment.b - segment.a);
  return across != 0.0 ? base::cross(segment.a, segment.b - segment.a) / across
                       : std::numeric_limits<double>::infinity();
}

void Panorama::look(const std::vector<sim2d::Segment>& walls) {
  walls_ = walls;
  views_.clear();
  addViewsOf(0, walls_.size());
}

void Panorama::add(const std::vector<sim2d::Segment>& walls) {
  const std::size_t before = walls_.size();
  walls_.insert(walls_.end(), walls.begin(), walls.end());
  const std::size_t seen = views_.size();
  addViewsOf(before, walls_.size());
  mergeFrom(0, seen);
}

/// Those of some walls behind the others.
void Panorama::addViewsOf(std::size_t first, std::size_t end) {
  if (end - first < 2) {
    if (first < end) {
      addViewsOfOne(first);
    }
    return;
  }
  const std::size_t start = views_.size();
  const std::size_t middle = first + (end - first) / 2;
  addViewsOf(first, middle);
  const std::size_t second = views_.size();
  addViewsOf(middle, end);
  mergeFrom(start, second);
}

/// None of a wall that is seen edge-on, where rounding alone tells which end is the first.
void Panorama::addViewsOfOne(std::size_t wall) {
  constexpr double kEdgeOn = 1e-12;  // [rad]
  const sim2d::Segment& its = walls_[wall];
  const double side = base::cross(its.a, its.b);
  const double squares = its.a.squaredNorm() * its.b.squaredNorm();
  if (side * side <= kEdgeOn * kEdgeOn * squares) {
    return;
  }
  const Turn from = turnTo(side > 0.0 ? its.a : its.b);
  const Turn to = turnTo(side > 0.0 ? its.b : its.a);
  if (from.rank < to.rank) {
    views_.push_back({from, to, wall});
    return;
  }
  const auto addPart = [&](const Turn& begin, const Turn& end) {
    if (begin.rank < end.rank) {
      views_.push_back({begin, end, wall});
    }
  };
  addPart({-kHalfTurn, -Vec2::UnitX()}, to);
  addPart(from, {kHalfTurn, -Vec2::UnitX()});
}

/// What is nearest of the views from `first` on and of those from `middle` on, in their place.
void Panorama::mergeFrom(std::size_t first, std::size_t middle) {
  merged_.clear();
  Turn at{-HUGE_VAL, Vec2::UnitX()};
  Walk one(views_.data() + first, views_.data() + middle);
  Walk other(views_.data() + middle, views_.data() + views_.size());
  while (!one.isOver() || !other.isOver()) {
    const Turn fromOne = one.from(at);
    const Turn fromOther = other.from(at);
    if (fromOne.rank == fromOther.rank) {
      at = sooner(other.view().to, one.view().to);
      appendNearer(one.view(), other.view(), fromOne, at);
    } else {
      const View& view = (fromOne.rank < fromOther.rank ? one : other).view();
      at = sooner(view.to, later(fromOne, fromOther));
      append(sooner(fromOne, fromOther), at, view.wall, merged_);
    }
    one.pass(at);
    other.pass(at);
  }
  views_.resize(first);
  views_.insert(views_.end(), merged_.begin(), merged_.end());
}

/// Of two walls that cross each other each is the nearer one on its side.
void Panorama::appendNearer(const View& a, const View& b, const Turn& from, const Turn& to) {
  Turn middle = to;
  if (const std::optional<Vec2> place = crossing(walls_[a.wall], walls_[b.wall])) {
    const Turn there = turnTo(*place);
    middle = there.rank > from.rank && there.rank < to.rank ? there : to;
  }
  append(from, middle, nearer(a.wall, b.wall, from, middle), merged_);
  if (middle.rank < to.rank) {
    append(middle, to, nearer(a.wall, b.wall, middle, to), merged_);
  }
}

/// In the middle between two turns.
std::size_t Panorama::nearer(std::size_t a, std::size_t b, const Turn& from, const Turn& to) const {
  const Vec2 middle = from.towards + to.towards;
  return along(middle, walls_[b]) < along(middle, walls_[a]) ? b : a;
}

}  // namespace metrics
