// The two rules by which obstacles act on bodies: boundary points and ray points.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include "sim2d/map/ObstacleQueryCache.h"
#include "sim2d/map/Obstacles.h"

namespace sim2d {

namespace {

constexpr double kSlack = 1e-9;         // [m], rounding where an edge is split
constexpr double kStepOut = 1e-6;       // [m], step from a border into free space
constexpr double kMergeDistance = 0.3;  // [m]
constexpr double kRayRange = 4.0;       // [m]

constexpr double kSurely = 2e-9;  // [m]; a larger difference always means different ranks

/// Compares distances rounded to a nanometre, so that equally distant points keep one order however
/// their outline is split.
bool isNearer(const Obstacles::Point& a, const Obstacles::Point& b) {
  if (std::abs(a.distance - b.distance) > kSurely) {
    return a.distance < b.distance;
  }
  const auto rank = [](const Obstacles::Point& point) {
    return std::llround(point.distance * 1e9);
  };
  if (rank(a) != rank(b)) {
    return rank(a) < rank(b);
  }
  return a.position.x() != b.position.x() ? a.position.x() < b.position.x()
                                          : a.position.y() < b.position.y();
}

/// Whether the point keeps the merge distance from all given points, which are sorted by distance.
/// Points that are nearer to the position by more than the merge distance cannot be within it.
template <class Iterator>
bool isFarFromAll(const Obstacles::Point& point, Iterator begin, Iterator end) {
  while (begin != end) {
    const Obstacles::Point& nearer = *--end;
    if (point.distance - nearer.distance > kMergeDistance + kSurely) {
      return true;
    }
    if ((nearer.position - point.position).squaredNorm() < kMergeDistance * kMergeDistance) {
      return false;
    }
  }
  return true;
}

}  // namespace

struct Obstacles::PointQuery {
  /// A local minimum of distance on an edge or at a corner.
  struct Candidate {
    Point point;
    int edge, other;
  };

  const Obstacles& obstacles;
  const Vec2& position;
  double range = 0.0;  // [m]
  std::vector<Candidate>& candidates;

  void addCandidates() const;
  struct Rank;
  const std::vector<Rank>& nearestFirst() const;
  const NearEdges* nearEdges() const;
  void findNearEdges(NearEdges& square) const;
  bool mayHaveFoot(int edge, const Vec2& middle) const;
  bool mayBeCorner(int edge, const Vec2& middle) const;
};

struct Obstacles::PointQuery::Rank {
  double distance = 0.0;  // [m]
  std::size_t candidate = 0;
};

/// Candidate indices sorted by distance; cheaper than sorting the candidates, which are large.
/// Valid until the next call.
const std::vector<Obstacles::PointQuery::Rank>& Obstacles::PointQuery::nearestFirst() const {
  thread_local std::vector<Rank> ranks;
  ranks.clear();
  ranks.reserve(candidates.size());
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    ranks.push_back({candidates[k].point.distance, k});
  }
  const auto isBefore = [this](const Rank& a, const Rank& b) {
    return std::abs(a.distance - b.distance) > kSurely
               ? a.distance < b.distance
               : isNearer(candidates[a.candidate].point, candidates[b.candidate].point);
  };
  if (ranks.size() > NearEdges::kMost) {
    std::sort(ranks.begin(), ranks.end(), isBefore);
    return ranks;
  }
  for (std::size_t k = 1; k < ranks.size(); ++k) {  // most are already in order
    const Rank rank = ranks[k];
    std::size_t at = k;
    for (; at > 0 && isBefore(rank, ranks[at - 1]); --at) {
      ranks[at] = ranks[at - 1];
    }
    ranks[at] = rank;
  }
  return ranks;
}

void Obstacles::boundaryPoints(const Vec2& position, std::vector<Point>& points,
                               double range) const {
  const QueryKey<3> queryKey(version_, {position.x(), position.y(), range});
  CachedPoints& slot = pointsCache().slotOf(queryKey);
  if (version_ != 0 && slot.queryKey == queryKey) {
    points.insert(points.end(), slot.points.begin(),
                  slot.points.begin() + static_cast<std::ptrdiff_t>(slot.count));
    return;
  }
  const std::size_t first = points.size();
  findBoundaryPoints(position, points, range);
  if (points.size() - first <= slot.points.size()) {
    slot.queryKey = queryKey;
    slot.count = points.size() - first;
    std::copy(points.end() - static_cast<std::ptrdiff_t>(slot.count), points.end(),
              slot.points.begin());
  }
}

void Obstacles::findBoundaryPoints(const Vec2& position, std::vector<Point>& points,
                                   double range) const {
  if (isInside(position)) {
    points.push_back(nearestExit(position));
    return;
  }
  thread_local std::vector<PointQuery::Candidate> candidates;
  candidates.clear();
  const PointQuery query{*this, position, range, candidates};
  query.addCandidates();
  const auto start = static_cast<std::ptrdiff_t>(points.size());
  for (const PointQuery::Rank& rank : query.nearestFirst()) {
    const PointQuery::Candidate& each = candidates[rank.candidate];
    const bool isAlone = isFarFromAll(each.point, points.begin() + start, points.end());
    if (isAlone && isExposed(each.point.position, each.edge, each.other)) {  // expensive, so last
      points.push_back(each.point);
    }
  }
}

void Obstacles::PointQuery::addCandidates() const {
  const auto add = [&](int edge, unsigned has) {
    if (obstacles.isOn(edge) && (has & NearEdges::kFoot) != 0) {
      obstacles.addFoot(edge, *this);
    }
    if (obstacles.isOn(edge) && (has & NearEdges::kCorner) != 0) {
      obstacles.addCorner(edge, *this);
    }
  };
  const NearEdges* const near = nearEdges();
  if (near == nullptr) {
    obstacles.cells_.visitNear(position, range,
                               [&](int edge) { add(edge, NearEdges::kFoot | NearEdges::kCorner); });
    return;
  }
  std::for_each(near->edges.begin(), near->edges.begin() + static_cast<std::ptrdiff_t>(near->count),
                [&](unsigned each) { add(static_cast<int>(each >> 2U), each); });
}

/// Cached edges of the square around the position; null: too many. Valid until the next call.
const NearEdges* Obstacles::PointQuery::nearEdges() const {
  const bool isUsual =
      position.cwiseAbs().maxCoeff() < base::kMaxCoordinate && range < base::kMaxCoordinate;
  if (obstacles.version_ == 0 || !isUsual) {
    return nullptr;
  }
  const NearEdges asked(obstacles.version_, range, position);
  NearEdges& kept = asked.slot();
  if (!kept.isOf(asked)) {
    NearEdges found = asked;
    findNearEdges(found);
    kept = found;
  }
  return kept.count <= NearEdges::kMost ? &kept : nullptr;
}

/// Nearest first, so that candidates are almost sorted for any position in the square.
void Obstacles::PointQuery::findNearEdges(NearEdges& square) const {
  const Vec2 middle = square.middle();
  thread_local std::vector<std::pair<double, unsigned>> found;  // [m] to the centre, edge
  found.clear();
  obstacles.cells_.visitNear(middle, range + kHalfDiagonal, [&](int edge) {
    const unsigned has = (mayHaveFoot(edge, middle) ? NearEdges::kFoot : 0U) |
                         (mayBeCorner(edge, middle) ? NearEdges::kCorner : 0U);
    if (has != 0) {
      const Segment& segment = obstacles.segments_[static_cast<std::size_t>(edge)];
      found.emplace_back(has == NearEdges::kCorner ? (segment.a - middle).norm()
                                                   : distanceToSegment(segment, middle),
                         static_cast<unsigned>(edge) * 4U + has);
    }
  });
  square.count = found.size();
  if (square.count <= NearEdges::kMost) {
    std::sort(found.begin(), found.end());
    std::transform(found.begin(), found.end(), square.edges.begin(),
                   [](const auto& each) { return each.second; });
  }
}

/// Whether `addFoot` may find a point for some position in the square around `middle`.
bool Obstacles::PointQuery::mayHaveFoot(int edge, const Vec2& middle) const {
  constexpr double kWithin = kHalfDiagonal + 2.0 * kSlack;
  const Edge& info = obstacles.edges_[static_cast<std::size_t>(edge)];
  const Vec2 offset = middle - obstacles.segments_[static_cast<std::size_t>(edge)].a;
  const double height = base::cross(offset, info.along);
  const double foot = offset.dot(info.along);
  return foot > -kWithin && foot < info.length + kWithin && height > -kWithin &&
         height < range + kWithin;
}

bool Obstacles::PointQuery::mayBeCorner(int edge, const Vec2& middle) const {
  constexpr double kWithin = kHalfDiagonal + 2.0 * kSlack;
  const Edge& info = obstacles.edges_[static_cast<std::size_t>(edge)];
  const Vec2& in = obstacles.edges_[static_cast<std::size_t>(info.previous)].along;
  const Vec2 offset = middle - obstacles.segments_[static_cast<std::size_t>(edge)].a;
  return offset.dot(info.along) < kWithin && offset.dot(in) > -kWithin &&
         (base::cross(info.along, offset) < kWithin || base::cross(in, offset) < kWithin) &&
         offset.norm() < range + kWithin;
}

/// The foot of the perpendicular on an edge is a local minimum; edges face to their right.
void Obstacles::addFoot(int edge, const PointQuery& query) const {
  const Edge& info = edges_[static_cast<std::size_t>(edge)];
  const Vec2& start = segments_[static_cast<std::size_t>(edge)].a;
  const Vec2 offset = query.position - start;
  const double height = base::cross(offset, info.along);
  const double foot = offset.dot(info.along);
  if (foot <= 0.0 || foot >= info.length || height < -kSlack || height >= query.range) {
    return;
  }
  const Vec2 place = start + foot * info.along;
  query.candidates.push_back(
      {{place, (query.position - place).norm(), false, info.part}, edge, edge});
}

/// The first corner of an edge is a local minimum if the position projects onto neither adjacent
/// edge.
void Obstacles::addCorner(int edge, const PointQuery& query) const {
  const Edge& info = edges_[static_cast<std::size_t>(edge)];
  const Vec2& corner = segments_[static_cast<std::size_t>(edge)].a;
  const Vec2& in = edges_[static_cast<std::size_t>(info.previous)].along;
  const Vec2 offset = query.position - corner;
  const bool isMinimum = offset.dot(info.along) <= kSlack && offset.dot(in) >= -kSlack;
  const bool faces = base::cross(info.along, offset) <= kSlack || base::cross(in, offset) <= kSlack;
  if (!isMinimum || !faces) {
    return;
  }
  const double distance = offset.norm();
  if (distance < query.range) {
    query.candidates.push_back({{corner, distance, false, info.part}, info.previous, edge});
  }
}

/// Whether free space begins to the right of the two edges (or twice the same) at this point: no
/// other obstacle covers it.
bool Obstacles::isExposed(const Vec2& place, int edge, int other) const {
  const Edge& info = edges_[static_cast<std::size_t>(edge)];
  const Edge& otherInfo = edges_[static_cast<std::size_t>(other)];
  const bool isUncovered = edge == other ? info.isUncovered
                                         : (info.next == other && otherInfo.isCornerUncovered &&
                                            place == segments_[static_cast<std::size_t>(other)].a);
  return isUncovered || !isCovered(place, edge, other, false);
}

bool Obstacles::isCovered(const Vec2& place, int edge, int other, bool withDisabled) const {
  const auto rightOf = [&](int number) {
    const Vec2& along = edges_[static_cast<std::size_t>(number)].along;
    return Vec2(along.y(), -along.x());
  };
  const Vec2 outward = rightOf(edge) + rightOf(other);
  const double length = outward.norm();
  return length > kSlack && solidPartAt(place + kStepOut / length * outward, withDisabled) >= 0;
}

/// No edge except its neighbours comes near this one.
bool Obstacles::isIsolated(int edge) const {
  const Segment& segment = segments_[static_cast<std::size_t>(edge)];
  const Edge& info = edges_[static_cast<std::size_t>(edge)];
  const Vec2 low = segment.a.cwiseMin(segment.b) - Vec2::Constant(kStepOut);
  const Vec2 high = segment.a.cwiseMax(segment.b) + Vec2::Constant(kStepOut);
  bool isIsolated = true;
  index_.visitAlong(segment, [&](int other) {
    if (!isIsolated || other == edge || other == info.previous || other == info.next) {
      return;
    }
    const Segment& near = segments_[static_cast<std::size_t>(other)];
    const bool isBeside = (near.a.cwiseMax(near.b).array() < low.array()).any() ||
                          (near.a.cwiseMin(near.b).array() > high.array()).any();
    isIsolated = isBeside || distanceBetween(segment, near) > kStepOut;
  });
  return isIsolated;
}

/// An isolated edge is covered entirely or not at all. If it is free with all parts enabled, it is
/// free in every state of the doors.
void Obstacles::findUncovered(const base::StopFlag& stop) {
  std::vector<char> apart(edges_.size());
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    stop.check();
    apart[i] = isIsolated(static_cast<int>(i)) ? 1 : 0;
  }
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    Edge& edge = edges_[i];
    const Segment& segment = segments_[i];
    const auto number = static_cast<int>(i);
    edge.isUncovered =
        apart[i] != 0 && !isCovered(0.5 * (segment.a + segment.b), number, number, true);
    edge.isCornerUncovered = apart[i] != 0 && apart[static_cast<std::size_t>(edge.previous)] != 0 &&
                             !isCovered(segment.a, edge.previous, number, true);
  }
}

/// The nearest exposed point of an edge: the closest point, or an intersection with another edge.
void Obstacles::improveExit(int edge, const Vec2& position, Point& best) const {
  const Segment& segment = segments_[static_cast<std::size_t>(edge)];
  const Edge& info = edges_[static_cast<std::size_t>(edge)];
  const Vec2 nearest = closestOnSegment(segment, position);
  if ((nearest - position).norm() >= best.distance) {
    return;
  }
  const auto offer = [&](const Vec2& place, int other) {
    const double distance = (place - position).norm();
    if (distance < best.distance && isExposed(place, edge, other)) {
      best = {place, distance, true, info.part};
    }
  };
  offer(nearest, nearest == segment.a ? info.previous : (nearest == segment.b ? info.next : edge));
  if (best.position == nearest) {
    return;
  }
  index_.visitAlong(segment, [&](int other) {
    if (other == edge || !isOn(other)) {
      return;
    }
    const std::optional<double> crossing =
        raySegmentHit(segment.a, info.along, segments_[static_cast<std::size_t>(other)]);
    if (crossing && *crossing <= info.length) {
      offer(segment.a + *crossing * info.along, other);
    }
  });
}

Obstacles::Point Obstacles::nearestExit(const Vec2& position) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Point best{position, kFar, true, -1};
  index_.visitNear(position, best.distance, [&](int edge) {
    if (isOn(edge)) {
      improveExit(edge, position, best);
    }
  });
  if (best.part < 0) {  // covered everywhere
    best = nearestPoint(position, kFar).value_or(Point{position, 0.0, true, -1});
    best.inside = true;
  }
  return best;
}

void Obstacles::rayPoints(const Vec2& position, std::vector<Point>& points) const {
  const bool inside = isInside(position);
  for (const Vec2& direction : rays_) {
    const Hit hit = firstHit(position, direction, kRayRange);
    if (hit.edge >= 0) {
      points.push_back({position + hit.distance * direction, hit.distance, inside,
                        edges_[static_cast<std::size_t>(hit.edge)].part});
    }
  }
}

}  // namespace sim2d
