#include "sim2d/map/TautWay.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace sim2d {

namespace {

constexpr double kSlack = 1e-6;      // [m] touching is no collision
constexpr double kLeastRoom = 5e-4;  // [m] of points too: else crossing a wall were touching it
constexpr double kLeastCut = 1e-3;   // [m]
constexpr double kLeastLeg = 1e-4;   // [m]
constexpr int kRounds = 14;          // of cutting corners: the turn at each halves
constexpr int kBisections = 12;
constexpr double kPiece = 1.0;  // [m], up to twice that
constexpr double kMostPieces = 256.0;

/// A straight way, to tell in few steps most walls that come nowhere near it.
class Line {
 public:
  Line(const Segment& way, double room)
      : start_(way.a), reach_(room + kSlack), length_((way.b - way.a).norm()) {
    if (length_ > 0.0) {
      along_ = (way.b - way.a) / length_;
    }
  }

  /// Sure; no says nothing.
  bool isFarFrom(const Segment& wall) const {
    const Vec2 a = wall.a - start_;
    const Vec2 b = wall.b - start_;
    return isApart(base::cross(along_, a), base::cross(along_, b), 0.0) ||
           isApart(along_.dot(a), along_.dot(b), length_);
  }
  /// Beyond the reach of the endless line, at the other side than the point. Sure, too.
  bool isFarBehind(const Segment& wall, const Vec2& point) const {
    const double side = base::cross(along_, point - start_) < 0.0 ? -1.0 : 1.0;
    return side * base::cross(along_, wall.a - start_) < -reach_ &&
           side * base::cross(along_, wall.b - start_) < -reach_;
  }

 private:
  /// Both beyond the reach at the same side of what goes from zero to `to`.
  bool isApart(double a, double b, double to) const {
    return std::min(a, b) > to + reach_ || std::max(a, b) < -reach_;
  }

  Vec2 start_;
  double reach_, length_;       // [m]
  Vec2 along_ = Vec2::UnitX();  // unit vector
};

double roomFor(double clearance) {
  return std::max(clearance, kLeastRoom);
}

/// Whether `distanceBetween` is less than the room, but for the slack; mostly known early.
bool isInTheWay(const Segment& wall, const Segment& way, double room) {
  const double least = room - kSlack;
  return segmentsTouch(way, wall) || distanceToSegment(wall, way.a) < least ||
         distanceToSegment(wall, way.b) < least || distanceToSegment(way, wall.a) < least ||
         distanceToSegment(way, wall.b) < least;
}

bool isInTheWay(const Segment& wall, const Line& line, const Segment& way, double room) {
  return !line.isFarFrom(wall) && isInTheWay(wall, way, room);
}

/// One of the walls that a disc with that clearance would run into. Looked for piece by piece: a
/// circle round all of a long way holds many walls that are not beside it.
std::optional<Segment> wallInTheWay(const Segment& way, const Obstacles& obstacles,
                                    double clearance) {
  const double room = roomFor(clearance);
  const Line line(way, room);
  const Vec2 whole = way.b - way.a;
  const auto pieces = static_cast<int>(std::min(kMostPieces, std::max(1.0, whole.norm() / kPiece)));
  const Vec2 half = 0.5 / pieces * whole;
  std::optional<Segment> found;
  for (int piece = 0; piece < pieces && !found; ++piece) {
    const Vec2 middle = way.a + (2 * piece + 1) * half;
    obstacles.visitNear(middle, half.norm() + room, [&](const Segment& wall) {
      if (!found && isInTheWay(wall, line, way, room)) {
        found = wall;
      }
    });
  }
  return found;
}

class Puller {
 public:
  Puller(const Obstacles& obstacles, double clearance)
      : obstacles_(obstacles), clearance_(clearance) {}

  std::vector<Vec2> pull(const std::vector<Vec2>& given) {
    way_ = given;
    for (int round = 0; round < kRounds; ++round) {
      skipPoints();
      cutCorners();
    }
    skipPoints();
    return way_;
  }

 private:
  /// What was in the way last is mostly in the way again.
  bool isClear(const Vec2& from, const Vec2& to) {
    const Segment way{from, to};
    const double room = roomFor(clearance_);
    if (blocking_ && isInTheWay(*blocking_, way, room)) {
      return false;
    }
    const std::optional<Segment> wall = wallInTheWay(way, obstacles_, clearance_);
    blocking_ = wall ? wall : blocking_;
    return !wall;
  }

  /// All that can be in the way of a chord of the corner a of the triangle, and perhaps others.
  void findWallsWithin(const Vec2& a, const Vec2& b, const Vec2& c) {
    const double room = roomFor(clearance_);
    const std::array<Line, 3> sides = {Line({a, b}, room), Line({b, c}, room), Line({c, a}, room)};
    const Vec2 middle = (a + b + c) / 3.0;
    const double reach =
        std::max({(a - middle).norm(), (b - middle).norm(), (c - middle).norm()}) + room;
    walls_.clear();
    obstacles_.visitNear(middle, reach, [&](const Segment& wall) {
      if (!sides[0].isFarBehind(wall, c) && !sides[1].isFarBehind(wall, a) &&
          !sides[2].isFarBehind(wall, b)) {
        walls_.push_back(wall);
      }
    });
  }

  bool isChordClear(const Segment& way) const {
    const double room = roomFor(clearance_);
    const Line line(way, room);
    return std::none_of(walls_.begin(), walls_.end(),
                        [&](const Segment& wall) { return isInTheWay(wall, line, way, room); });
  }

  /// From each point straight on to the last of those ahead that can be reached so.
  void skipPoints() {
    constexpr std::size_t kFarthest = 64;  // points ahead
    std::vector<Vec2> kept = {way_.front()};
    for (std::size_t at = 0; at + 1 < way_.size();) {
      std::size_t next = at + 1;
      for (std::size_t far = std::min(at + kFarthest, way_.size() - 1); far > next; --far) {
        if (isClear(way_[at], way_[far])) {
          next = far;
        }
      }
      kept.push_back(way_[next]);
      at = next;
    }
    way_ = std::move(kept);
  }

  /// Each corner is cut as far as the obstacle inside of it lets.
  void cutCorners() {
    std::vector<Vec2> cut = {way_.front()};
    for (std::size_t k = 1; k + 1 < way_.size(); ++k) {
      addCorner(cut, way_[k], way_[k + 1]);
    }
    cut.push_back(way_.back());
    way_ = std::move(cut);
  }

  void addCorner(std::vector<Vec2>& to, const Vec2& corner, const Vec2& after) {
    const Vec2 back = to.back() - corner;
    const Vec2 ahead = after - corner;
    const double longest = 0.5 * std::min(back.norm(), ahead.norm());
    if (longest < kLeastLeg) {
      to.push_back(corner);
      return;
    }
    const Vec2 u = back.normalized();
    const Vec2 v = ahead.normalized();
    double good = 0.0;
    double bad = 2.0 * longest;
    findWallsWithin(corner, corner + bad * u, corner + bad * v);
    for (int k = 0; k < kBisections; ++k) {
      const double middle = 0.5 * (good + bad);
      (isChordClear({corner + middle * u, corner + middle * v}) ? good : bad) = middle;
    }
    good = std::min(good, longest);
    if (good < kLeastCut) {
      to.push_back(corner);
      return;
    }
    to.push_back(corner + good * u);
    to.push_back(corner + good * v);
  }

  const Obstacles& obstacles_;
  double clearance_;
  std::vector<Vec2> way_;
  std::optional<Segment> blocking_;  // a wall
  std::vector<Segment> walls_;       // around a corner
};

}  // namespace

bool isWayClear(const Vec2& from, const Vec2& to, const Obstacles& obstacles, double clearance) {
  return !wallInTheWay({from, to}, obstacles, clearance);
}

double distanceBetween(const Segment& first, const Segment& second) {
  if (segmentsTouch(first, second)) {
    return 0.0;
  }
  return std::min({distanceToSegment(second, first.a), distanceToSegment(second, first.b),
                   distanceToSegment(first, second.a), distanceToSegment(first, second.b)});
}

std::vector<Vec2> tautened(const std::vector<Vec2>& way, const Obstacles& obstacles,
                           double clearance) {
  if (way.size() < 3) {
    return way;
  }
  double most = clearance;
  for (std::size_t k = 1; k < way.size(); ++k) {  // a grid rounds
    std::vector<Segment> near;
    obstacles.segmentsNear(0.5 * (way[k - 1] + way[k]),
                           0.5 * (way[k] - way[k - 1]).norm() + clearance, near);
    for (const Segment& wall : near) {
      most = std::min(most, distanceBetween({way[k - 1], way[k]}, wall));
    }
  }
  return Puller(obstacles, most).pull(way);
}

}  // namespace sim2d
