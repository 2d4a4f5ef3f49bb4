#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "sim2d/map/Obstacles.h"

namespace sim2d {

namespace {

constexpr double kTouchSlack = 1e-6;    // [m], touching is no collision
constexpr double kMinClearance = 5e-4;  // [m]; with 0, crossing a wall would count as touching
constexpr double kMinCut = 1e-3;        // [m]
constexpr double kMinLeg = 1e-4;        // [m]
constexpr int kRounds = 14;             // of corner cutting; each halves the turns
constexpr int kBisections = 12;
constexpr double kPiece = 1.0;  // [m], pieces are up to twice as long
constexpr double kMaxPieces = 256.0;

/// A straight line with its clearance, to reject distant walls cheaply.
class Line {
 public:
  Line(const Segment& path, double room)
      : start_(path.a), reach_(room + kTouchSlack), length_((path.b - path.a).norm()) {
    if (length_ > 0.0) {
      along_ = (path.b - path.a) / length_;
    }
  }

  /// True: the wall is certainly out of reach. False: unknown.
  bool isFarFrom(const Segment& wall) const {
    const Vec2 a = wall.a - start_;
    const Vec2 b = wall.b - start_;
    return isApart(base::cross(along_, a), base::cross(along_, b), 0.0) ||
           isApart(along_.dot(a), along_.dot(b), length_);
  }
  /// True: the wall is certainly out of reach of the infinite line, on the side opposite to the
  /// point.
  bool isFarBehind(const Segment& wall, const Vec2& point) const {
    const double side = base::cross(along_, point - start_) < 0.0 ? -1.0 : 1.0;
    return side * base::cross(along_, wall.a - start_) < -reach_ &&
           side * base::cross(along_, wall.b - start_) < -reach_;
  }

 private:
  /// Both coordinates are out of reach on the same side of the interval [0, to].
  bool isApart(double a, double b, double to) const {
    return std::min(a, b) > to + reach_ || std::max(a, b) < -reach_;
  }

  Vec2 start_;
  double reach_, length_;       // [m]
  Vec2 along_ = Vec2::UnitX();  // unit vector
};

double effectiveClearance(double clearance) {
  return std::max(clearance, kMinClearance);
}

/// Whether `distanceBetween` is below `room`, up to rounding; usually decided early.
bool isBlocking(const Segment& wall, const Segment& path, double room) {
  const double least = room - kTouchSlack;
  return segmentsTouch(path, wall) || distanceToSegment(wall, path.a) < least ||
         distanceToSegment(wall, path.b) < least || distanceToSegment(path, wall.a) < least ||
         distanceToSegment(path, wall.b) < least;
}

bool isBlocking(const Segment& wall, const Line& line, const Segment& path, double room) {
  return !line.isFarFrom(wall) && isBlocking(wall, path, room);
}

/// A wall that a disc with this clearance would hit. Searches piece by piece: a circle around a
/// long line would contain many irrelevant walls.
std::optional<Segment> blockingWall(const Segment& path, const Obstacles& obstacles,
                                    double clearance) {
  const double room = effectiveClearance(clearance);
  const Line line(path, room);
  const Vec2 whole = path.b - path.a;
  const auto pieces = static_cast<int>(std::min(kMaxPieces, std::max(1.0, whole.norm() / kPiece)));
  const Vec2 half = 0.5 / pieces * whole;
  std::optional<Segment> found;
  for (int piece = 0; piece < pieces && !found; ++piece) {
    const Vec2 middle = path.a + (2 * piece + 1) * half;
    obstacles.visitNear(middle, half.norm() + room, [&](const Segment& wall) {
      if (!found && isBlocking(wall, line, path, room)) {
        found = wall;
      }
    });
  }
  return found;
}

class PathTightener {
 public:
  PathTightener(const Obstacles& obstacles, double clearance)
      : obstacles_(obstacles), clearance_(clearance) {}

  std::vector<Vec2> pull(const std::vector<Vec2>& given) {
    path_ = given;
    for (int round = 0; round < kRounds; ++round) {
      shortcutPoints();
      cutCorners();
    }
    shortcutPoints();
    return path_;
  }

 private:
  /// Tests the last blocking wall first.
  bool isClear(const Vec2& from, const Vec2& to) {
    const Segment path{from, to};
    const double room = effectiveClearance(clearance_);
    if (blocking_ && isBlocking(*blocking_, path, room)) {
      return false;
    }
    const std::optional<Segment> wall = blockingWall(path, obstacles_, clearance_);
    blocking_ = wall ? wall : blocking_;
    return !wall;
  }

  /// Collects all walls that can block a chord at corner `a` of the triangle, and possibly others.
  void findWallsWithin(const Vec2& a, const Vec2& b, const Vec2& c) {
    const double room = effectiveClearance(clearance_);
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

  bool isChordClear(const Segment& path) const {
    const double room = effectiveClearance(clearance_);
    const Line line(path, room);
    return std::none_of(walls_.begin(), walls_.end(),
                        [&](const Segment& wall) { return isBlocking(wall, line, path, room); });
  }

  /// Connects each point to the farthest point ahead that is in a straight line of free space.
  void shortcutPoints() {
    constexpr std::size_t kMaxShortcut = 64;  // points ahead
    std::vector<Vec2> kept = {path_.front()};
    for (std::size_t at = 0; at + 1 < path_.size();) {
      std::size_t next = at + 1;
      for (std::size_t far = std::min(at + kMaxShortcut, path_.size() - 1); far > next; --far) {
        if (isClear(path_[at], path_[far])) {
          next = far;
        }
      }
      kept.push_back(path_[next]);
      at = next;
    }
    path_ = std::move(kept);
  }

  /// Cuts each corner as far as the obstacle inside it permits.
  void cutCorners() {
    std::vector<Vec2> cut = {path_.front()};
    for (std::size_t k = 1; k + 1 < path_.size(); ++k) {
      addCorner(cut, path_[k], path_[k + 1]);
    }
    cut.push_back(path_.back());
    path_ = std::move(cut);
  }

  void addCorner(std::vector<Vec2>& to, const Vec2& corner, const Vec2& after) {
    const Vec2 back = to.back() - corner;
    const Vec2 ahead = after - corner;
    const double longest = 0.5 * std::min(back.norm(), ahead.norm());
    if (longest < kMinLeg) {
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
    if (good < kMinCut) {
      to.push_back(corner);
      return;
    }
    to.push_back(corner + good * u);
    to.push_back(corner + good * v);
  }

  const Obstacles& obstacles_;
  double clearance_;
  std::vector<Vec2> path_;
  std::optional<Segment> blocking_;  // last blocking wall
  std::vector<Segment> walls_;       // walls near the current corner
};

}  // namespace

bool isSegmentFree(const Vec2& from, const Vec2& to, const Obstacles& obstacles, double clearance) {
  return !blockingWall({from, to}, obstacles, clearance);
}

std::vector<Vec2> tightened(const std::vector<Vec2>& path, const Obstacles& obstacles,
                            double clearance) {
  if (path.size() < 3) {
    return path;
  }
  double most = clearance;
  for (std::size_t k = 1; k < path.size(); ++k) {  // tolerates the rounding of a planning grid
    std::vector<Segment> near;
    obstacles.segmentsNear(0.5 * (path[k - 1] + path[k]),
                           0.5 * (path[k] - path[k - 1]).norm() + clearance, near);
    for (const Segment& wall : near) {
      most = std::min(most, distanceBetween({path[k - 1], path[k]}, wall));
    }
  }
  return PathTightener(obstacles, most).pull(path);
}

}  // namespace sim2d
