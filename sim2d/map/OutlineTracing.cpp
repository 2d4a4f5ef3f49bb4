#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sim2d/map/SegmentGrid.h"

namespace sim2d {

namespace {

/// A corner of the border of wall cells, in cell coordinates.
struct Corner {
  int column = 0, row = 0;
  int direction = 0;     // of the outgoing edge: 0 = +x, 1 = +y, 2 = -x, 3 = -y
  bool left = false;     // the border turns left here
  bool pinched = false;  // two wall cells touch only by their corners
};
using Ring = std::vector<Corner>;

constexpr std::array<Cell, 4> kStep = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// Traces borders with the solid on the left. Wall cells that touch by a corner count as connected,
/// so nothing passes between them.
class BorderWalk {
 public:
  BorderWalk(const OccupancyGrid& grid, const base::StopFlag& stop)
      : grid_(grid), stop_(stop), visited_(grid.cells().size(), false) {}

  std::vector<Ring> rings() {
    std::vector<Ring> all;
    for (int row = 0; row < grid_.height(); ++row) {
      stop_.check();
      for (int column = 0; column < grid_.width(); ++column) {
        const Cell cell{column, row};
        if (grid_.isWall(cell) && !grid_.isWall({column, row - 1}) &&
            !visited_[grid_.indexOf(cell)]) {
          all.push_back(follow(cell));
        }
      }
    }
    return all;
  }

 private:
  Ring follow(Cell first) {
    Ring ring;
    Cell at = first;
    int direction = 0;
    do {
      if (direction == 0) {
        visited_[grid_.indexOf(at)] = true;
      }
      const auto side = static_cast<std::size_t>(direction);
      at = {at.column + kStep[side].column, at.row + kStep[side].row};
      const bool solidLeft = grid_.isWall(aheadLeft(at, direction));
      const bool solidRight = grid_.isWall(aheadLeft(at, (direction + 3) % 4));
      if (solidRight || !solidLeft) {
        direction = (direction + (solidRight ? 3 : 1)) % 4;
        ring.push_back({at.column, at.row, direction, !solidRight, solidRight && !solidLeft});
      }
    } while (at != first || direction != 0);
    return ring;
  }

  /// The cell ahead on the left, seen from a corner in this direction.
  static Cell aheadLeft(Cell corner, int direction) {
    constexpr std::array<Cell, 4> kAhead = {{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
    const Cell offset = kAhead[static_cast<std::size_t>(direction)];
    return {corner.column + offset.column, corner.row + offset.row};
  }

  const OccupancyGrid& grid_;
  const base::StopFlag& stop_;
  std::vector<bool> visited_;  // lower edges of wall cells
};

/// A border edge of one cell between a left and a right turn: part of a staircase (slanted wall).
bool isStep(const Ring& ring, std::size_t index) {
  const Corner& from = ring[index];
  const Corner& to = ring[(index + 1) % ring.size()];
  return from.left != to.left &&
         std::abs(to.column - from.column) + std::abs(to.row - from.row) == 1;
}

Vec2 pointOf(const Corner& corner) {
  return Vec2(corner.column, corner.row);
}

/// Cuts a pinched corner, so that the border does not touch itself.
void appendCorner(const Corner& corner, std::vector<Vec2>& points) {
  constexpr double kCut = 0.25;
  if (!corner.pinched) {
    points.push_back(pointOf(corner));
    return;
  }
  const Cell out = kStep[static_cast<std::size_t>(corner.direction)];
  const Cell in = kStep[static_cast<std::size_t>((corner.direction + 1) % 4)];  // a right turn
  points.push_back(pointOf(corner) - kCut * Vec2(in.column, in.row));
  points.push_back(pointOf(corner) + kCut * Vec2(out.column, out.row));
}

std::vector<Vec2> exactRing(const Ring& ring) {
  std::vector<Vec2> points;
  for (const Corner& corner : ring) {
    appendCorner(corner, points);
  }
  return points;
}

/// Douglas-Peucker on a ring. Candidates in staircases are the middles of the steps; the distance
/// to the true corners must stay within the tolerance.
class Simplifier {
 public:
  Simplifier(const Ring& ring, const base::StopFlag& stop) : stop_(stop) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const bool before = isStep(ring, (i + ring.size() - 1) % ring.size());
      const bool after = isStep(ring, i);
      std::vector<Vec2> corner;
      appendCorner(ring[i], corner);
      for (const Vec2& point : corner) {
        marks_.push_back({point, !before && !after});
      }
      if (after) {
        marks_.push_back({0.5 * (pointOf(ring[i]) + pointOf(ring[(i + 1) % ring.size()])), true});
      }
    }
  }

  std::vector<Vec2> points() {
    startAtCandidate();
    const std::size_t count = marks_.size() - 1;  // the last mark repeats the first
    keep_.assign(marks_.size(), false);
    std::size_t far = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (marks_[i].candidate && distanceFromFirst(i) > distanceFromFirst(far)) {
        far = i;
      }
    }
    keepBetween(0, far);
    keepBetween(far, count);
    std::vector<Vec2> result;
    for (std::size_t i = 0; i < count; ++i) {
      if (keep_[i]) {
        result.push_back(marks_[i].point);
      }
    }
    return result;
  }

 private:
  struct Mark {
    Vec2 point = Vec2::Zero();
    bool candidate = false;
  };

  double distanceFromFirst(std::size_t index) const {
    return (marks_[index].point - marks_[0].point).squaredNorm();
  }

  void startAtCandidate() {
    const auto isCandidate = [](const Mark& mark) { return mark.candidate; };
    std::rotate(marks_.begin(), std::find_if(marks_.begin(), marks_.end(), isCandidate),
                marks_.end());
    marks_.push_back(marks_.front());
  }

  /// Processes long borders in pieces, to avoid quadratic time.
  void keepBetween(std::size_t first, std::size_t last) {
    constexpr std::size_t kPiece = 4096;
    std::vector<std::pair<std::size_t, std::size_t>> open;
    std::size_t from = first;
    while (last - from > 2 * kPiece) {
      std::size_t to = from + kPiece;
      while (to < last && !marks_[to].candidate) {
        ++to;
      }
      open.emplace_back(from, to);
      from = to;
    }
    open.emplace_back(from, last);
    while (!open.empty()) {
      stop_.check();
      const auto [low, high] = open.back();
      open.pop_back();
      keep_[low] = true;
      keep_[high] = true;
      const std::size_t middle = worstBetween(low, high);
      if (middle != low) {
        open.emplace_back(low, middle);
        open.emplace_back(middle, high);
      }
    }
  }

  /// The candidate farthest from the chord if a mark exceeds the tolerance, else `low`.
  std::size_t worstBetween(std::size_t low, std::size_t high) const {
    constexpr double kTolerance = 0.5 + 1e-9;  // [cells]
    const Segment chord{marks_[low].point, marks_[high].point};
    std::size_t worst = low;
    double worstDistance = -1.0;
    bool within = true;
    for (std::size_t i = low + 1; i < high; ++i) {
      const double distance = distanceToSegment(chord, marks_[i].point);
      within = within && distance <= kTolerance;
      if (marks_[i].candidate && distance > worstDistance) {
        worst = i;
        worstDistance = distance;
      }
    }
    return within ? low : worst;
  }

  const base::StopFlag& stop_;
  std::vector<Mark> marks_;
  std::vector<bool> keep_;
};

std::vector<Vec2> simplifiedRing(const Ring& ring, const base::StopFlag& stop) {
  std::vector<Vec2> exact = exactRing(ring);
  std::vector<Vec2> simple = Simplifier(ring, stop).points();
  const double area = signedArea(exact);
  const bool keepsShape = simple.size() >= 3 && signedArea(simple) / area > 0.5;
  return keepsShape ? simple : exact;
}

bool isConflict(const Segment& first, const Segment& second, bool sameRing) {
  if (sameRing && second.a == first.b) {
    return isSpike(first, second);
  }
  if (sameRing && second.b == first.a) {
    return isSpike(second, first);
  }
  return segmentsTouch(first, second);
}

/// Indices of the rings that touch or cross themselves or another ring.
std::vector<std::size_t> conflicts(const std::vector<std::vector<Vec2>>& rings,
                                   const base::StopFlag& stop) {
  std::vector<Segment> edges;
  std::vector<std::size_t> ringOf;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      edges.push_back({rings[r][i], rings[r][(i + 1) % rings[r].size()]});
      ringOf.push_back(r);
    }
  }
  SegmentGrid near;
  near.build(edges, 8.0);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    stop.check();
    const Segment& edge = edges[i];
    near.visitAlong(edge, [&](int item) {
      const auto j = static_cast<std::size_t>(item);
      if (j > i && isConflict(edge, edges[j], ringOf[i] == ringOf[j])) {
        found.insert(found.end(), {ringOf[i], ringOf[j]});
      }
    });
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace

std::vector<Outline> traceOutlines(const OccupancyGrid& grid, const base::StopFlag& stop) {
  const std::vector<Ring> rings = BorderWalk(grid, stop).rings();
  std::vector<std::vector<Vec2>> shapes;
  shapes.reserve(rings.size());
  for (const Ring& ring : rings) {
    shapes.push_back(simplifiedRing(ring, stop));
  }
  std::vector<bool> exact(rings.size(), false);
  // Exact rings never touch, so the loop terminates.
  for (bool changed = true; changed;) {
    changed = false;
    for (const std::size_t ring : conflicts(shapes, stop)) {
      changed = changed || !exact[ring];
      shapes[ring] = exactRing(rings[ring]);
      exact[ring] = true;
    }
  }
  std::vector<Outline> outlines;
  outlines.reserve(shapes.size());
  for (const std::vector<Vec2>& shape : shapes) {
    Outline outline;
    for (const Vec2& corner : shape) {
      outline.points.push_back(grid.cornerToWorld(corner.x(), corner.y()));
    }
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

}  // namespace sim2d
