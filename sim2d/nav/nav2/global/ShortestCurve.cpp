#include "sim2d/nav/nav2/global/ShortestCurve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "sim2d/base/Math.h"

namespace sim2d::nav2 {
namespace {

using base::kPi;
using Turn = ShortestCurve::Turn;
using Lengths = std::array<double, ShortestCurve::kMaxPieces>;

constexpr double kSameAngle = 1e-9;  // [rad]: an almost complete turn counts as none

/// The goal in the frame of the start, in units of the radius.
struct RelativePose {
  double x = 0.0, y = 0.0, phi = 0.0;
};

double moduloTwoPi(double angle) {  // to [0, 2 pi)
  const double rest = angle - 2.0 * kPi * std::floor(angle / (2.0 * kPi));
  return 2.0 * kPi - rest < kSameAngle ? 0.0 : rest;
}

double sumOf(const Lengths& lengths) {
  double sum = 0.0;
  for (const double length : lengths) {
    sum += std::fabs(length);
  }
  return sum;
}

/// Keeps the shortest of the offered curves, the first one of equal curves.
class Shortest {
 public:
  void offer(const char* turns, const Lengths& lengths) {
    const double sum = sumOf(lengths);
    if (sum < least_) {
      least_ = sum;
      for (std::size_t i = 0; i < lengths.size(); ++i) {
        pieces_[i] = {};
      }
      for (std::size_t i = 0; turns[i] != '\0'; ++i) {
        pieces_[i] = {turnOf(turns[i]), lengths[i]};
      }
    }
  }
  const std::array<ShortestCurve::Piece, ShortestCurve::kMaxPieces>& pieces() const {
    return pieces_;
  }

 private:
  static Turn turnOf(char letter) {
    return letter == 'L' ? Turn::Left : letter == 'R' ? Turn::Right : Turn::Straight;
  }

  double least_ = std::numeric_limits<double>::max();
  std::array<ShortestCurve::Piece, ShortestCurve::kMaxPieces> pieces_;
};

// --- Dubins: arc, straight or arc, arc ----------------------------------------------------------

struct DubinsEnds {
  double d, a, b;  // distance; headings at both ends relative to the line between them
  double sa, ca, sb, cb, cab;
};

void offerDubinsStraight(const DubinsEnds& e, Shortest& shortest) {
  const auto offer = [&](const char* turns, double square, double theta, double first,
                         double last) {
    if (square >= -kSameAngle) {
      shortest.offer(turns, {moduloTwoPi(first * (theta - e.a)), std::sqrt(std::fmax(square, 0.0)),
                             moduloTwoPi(last * (e.b - theta)), 0.0, 0.0});
    }
  };
  const double same = 2.0 + e.d * e.d - 2.0 * e.cab;
  offer("LSL", same + 2.0 * e.d * (e.sa - e.sb), base::atan2(e.cb - e.ca, e.d + e.sa - e.sb), 1.0,
        1.0);
  offer("RSR", same - 2.0 * e.d * (e.sa - e.sb), base::atan2(e.ca - e.cb, e.d - e.sa + e.sb), -1.0,
        -1.0);
  const double other = e.d * e.d - 2.0 + 2.0 * e.cab;
  const double inner = other - 2.0 * e.d * (e.sa + e.sb);  // right, straight, left
  offer("RSL", inner,
        base::atan2(e.ca + e.cb, e.d - e.sa - e.sb) -
            base::atan2(2.0, std::sqrt(std::fmax(inner, 0.0))),
        -1.0, 1.0);
  const double outer = other + 2.0 * e.d * (e.sa + e.sb);  // left, straight, right
  offer("LSR", outer,
        base::atan2(-e.ca - e.cb, e.d + e.sa + e.sb) -
            base::atan2(-2.0, std::sqrt(std::fmax(outer, 0.0))),
        1.0, -1.0);
}

void offerDubinsCircles(const DubinsEnds& e, Shortest& shortest) {
  const auto offer = [&](const char* turns, double side) {  // side: 1 = right arc in the middle
    const double cosine =
        0.125 * (6.0 - e.d * e.d + 2.0 * e.cab - side * 2.0 * e.d * (e.sa - e.sb));
    if (std::fabs(cosine) >= 1.0) {
      return;
    }
    const double middle = 2.0 * kPi - base::acos(cosine);
    const double theta = side > 0.0 ? base::atan2(e.cb - e.ca, e.d + e.sa - e.sb)
                                    : base::atan2(e.ca - e.cb, e.d - e.sa + e.sb);
    const double first = moduloTwoPi(side * (theta - e.a) + 0.5 * middle);
    const double last = moduloTwoPi(side * (e.b - e.a) - first + middle);
    shortest.offer(turns, {first, middle, last, 0.0, 0.0});
  };
  offer("RLR", -1.0);
  offer("LRL", 1.0);
}

void offerDubins(const RelativePose& goal, Shortest& shortest) {
  const double d = std::sqrt(goal.x * goal.x + goal.y * goal.y);
  const double line = base::atan2(goal.y, goal.x);
  DubinsEnds ends{};
  ends.d = d;
  ends.a = moduloTwoPi(-line);
  ends.b = moduloTwoPi(goal.phi - line);
  ends.sa = base::sin(ends.a);
  ends.ca = base::cos(ends.a);
  ends.sb = base::sin(ends.b);
  ends.cb = base::cos(ends.b);
  ends.cab = ends.ca * ends.cb + ends.sa * ends.sb;
  offerDubinsStraight(ends, shortest);
  offerDubinsCircles(ends, shortest);
}

// --- Reeds-Shepp: words, each in up to eight mirrored forms -------------------------------------

constexpr double kAtLeast = -1e-9, kAtMost = 1e-9;  // tolerance of lengths with a required sign

struct Polar {
  double length, angle;
};
Polar polarOf(double x, double y) {
  return {std::sqrt(x * x + y * y), base::atan2(y, x)};
}

/// Angles of the first and last arc of four-arc words.
Polar firstAndLast(double u, double v, double xi, double eta, double phi) {
  const double delta = base::wrapToPi(u - v);
  const double a = base::sin(u) - base::sin(delta);
  const double b = base::cos(u) - base::cos(delta) - 1.0;
  const double t = base::atan2(eta * a - xi * b, xi * a + eta * b);
  const double side = 2.0 * (base::cos(delta) - base::cos(v) - base::cos(u)) + 3.0;
  const double tau = base::wrapToPi(side < 0.0 ? t + kPi : t);
  return {tau, base::wrapToPi(tau - u + v - phi)};
}

using Word = std::optional<Lengths>;

Word leftStraightLeft(const RelativePose& g) {  // 8.1
  const Polar p = polarOf(g.x - base::sin(g.phi), g.y - 1.0 + base::cos(g.phi));
  const double v = base::wrapToPi(g.phi - p.angle);
  return p.angle >= kAtLeast && v >= kAtLeast ? Word({p.angle, p.length, v}) : std::nullopt;
}

Word leftStraightRight(const RelativePose& g) {  // 8.2
  const Polar p = polarOf(g.x + base::sin(g.phi), g.y - 1.0 - base::cos(g.phi));
  const double square = p.length * p.length - 4.0;
  if (square < 0.0) {
    return std::nullopt;
  }
  const double u = std::sqrt(square);
  const double t = base::wrapToPi(p.angle + base::atan2(2.0, u));
  const double v = base::wrapToPi(t - g.phi);
  return t >= kAtLeast && v >= kAtLeast ? Word({t, u, v}) : std::nullopt;
}

Word leftRightLeft(const RelativePose& g) {  // 8.3, 8.4
  const Polar p = polarOf(g.x - base::sin(g.phi), g.y - 1.0 + base::cos(g.phi));
  if (p.length > 4.0) {
    return std::nullopt;
  }
  const double u = -2.0 * (0.5 * kPi - base::acos(0.25 * p.length));
  const double t = base::wrapToPi(p.angle + 0.5 * u + kPi);
  const double v = base::wrapToPi(g.phi - t + u);
  return t >= kAtLeast && u <= kAtMost ? Word({t, u, v}) : std::nullopt;
}

Word forwardTwoBackTwo(const RelativePose& g) {  // 8.7
  const double xi = g.x + base::sin(g.phi), eta = g.y - 1.0 - base::cos(g.phi);
  const double rho = 0.25 * (2.0 + std::sqrt(xi * xi + eta * eta));
  if (rho > 1.0) {
    return std::nullopt;
  }
  const double u = base::acos(rho);
  const Polar ends = firstAndLast(u, -u, xi, eta, g.phi);
  return ends.length >= kAtLeast && ends.angle <= kAtMost ? Word({ends.length, u, -u, ends.angle})
                                                          : std::nullopt;
}

Word backInTheMiddle(const RelativePose& g) {  // 8.8
  const double xi = g.x + base::sin(g.phi), eta = g.y - 1.0 - base::cos(g.phi);
  const double rho = (20.0 - xi * xi - eta * eta) / 16.0;
  if (rho < 0.0 || rho > 1.0) {
    return std::nullopt;
  }
  const double u = -base::acos(rho);
  const Polar ends = firstAndLast(u, u, xi, eta, g.phi);
  return ends.length >= kAtLeast && ends.angle >= kAtLeast ? Word({ends.length, u, u, ends.angle})
                                                           : std::nullopt;
}

Word quarterThenLeft(const RelativePose& g) {  // 8.9
  const Polar p = polarOf(g.x - base::sin(g.phi), g.y - 1.0 + base::cos(g.phi));
  if (p.length < 2.0) {
    return std::nullopt;
  }
  const double r = std::sqrt(p.length * p.length - 4.0);
  const double u = 2.0 - r;
  const double t = base::wrapToPi(p.angle + base::atan2(r, -2.0));
  const double v = base::wrapToPi(g.phi - 0.5 * kPi - t);
  return t >= kAtLeast && u <= kAtMost && v <= kAtMost ? Word({t, -0.5 * kPi, u, v}) : std::nullopt;
}

Word quarterThenRight(const RelativePose& g) {  // 8.10
  const double xi = g.x + base::sin(g.phi), eta = g.y - 1.0 - base::cos(g.phi);
  const Polar p = polarOf(-eta, xi);
  if (p.length < 2.0) {
    return std::nullopt;
  }
  const double t = p.angle, u = 2.0 - p.length;
  const double v = base::wrapToPi(t + 0.5 * kPi - g.phi);
  return t >= kAtLeast && u <= kAtMost && v <= kAtMost ? Word({t, -0.5 * kPi, u, v}) : std::nullopt;
}

Word twoQuarters(const RelativePose& g) {  // 8.11
  const double xi = g.x + base::sin(g.phi), eta = g.y - 1.0 - base::cos(g.phi);
  const double square = xi * xi + eta * eta;
  if (square < 4.0) {
    return std::nullopt;
  }
  const double u = 4.0 - std::sqrt(square - 4.0);
  if (u > kAtMost) {
    return std::nullopt;
  }
  const double t =
      base::wrapToPi(base::atan2((4.0 - u) * xi - 2.0 * eta, -2.0 * xi + (u - 4.0) * eta));
  const double v = base::wrapToPi(t - g.phi);
  return t >= kAtLeast && v >= kAtLeast ? Word({t, -0.5 * kPi, u, -0.5 * kPi, v}) : std::nullopt;
}

struct Family {
  const char* turns;
  const char* mirrored;  // left and right swapped
  std::ptrdiff_t count;
  bool isReversed;  // driven from the goal to the start
  Word (*solve)(const RelativePose&);
};

constexpr Family kFamilies[] = {
    {"LSL", "RSR", 3, false, leftStraightLeft},    {"LSR", "RSL", 3, false, leftStraightRight},
    {"LRL", "RLR", 3, false, leftRightLeft},       {"LRL", "RLR", 3, true, leftRightLeft},
    {"LRLR", "RLRL", 4, false, forwardTwoBackTwo}, {"LRLR", "RLRL", 4, false, backInTheMiddle},
    {"LRSL", "RLSR", 4, false, quarterThenLeft},   {"LSRL", "RSLR", 4, true, quarterThenLeft},
    {"LRSR", "RLSL", 4, false, quarterThenRight},  {"RSRL", "LSLR", 4, true, quarterThenRight},
    {"LRSLR", "RLSRL", 5, false, twoQuarters},
};

/// Offers the word, mirrored, reversed (x and phi negative) and both.
void offerForms(const Family& family, const RelativePose& goal, Shortest& shortest) {
  for (const double side : {1.0, -1.0}) {
    for (const double way : {1.0, -1.0}) {
      Word word = family.solve({way * goal.x, side * goal.y, way * side * goal.phi});
      if (!word) {
        continue;
      }
      for (double& length : *word) {
        length *= way;
      }
      if (family.isReversed) {
        std::reverse(word->begin(), word->begin() + family.count);
      }
      shortest.offer(side > 0.0 ? family.turns : family.mirrored, *word);
    }
  }
}

void offerReedsShepp(const RelativePose& goal, Shortest& shortest) {
  const double cosine = base::cos(goal.phi), sine = base::sin(goal.phi);
  const RelativePose reversed{goal.x * cosine + goal.y * sine, goal.x * sine - goal.y * cosine,
                              goal.phi};
  for (const Family& family : kFamilies) {
    offerForms(family, family.isReversed ? reversed : goal, shortest);
  }
}

/// The pose after a part of a piece, in units of the radius.
Pose2 moved(const Pose2& from, Turn turn, double length) {
  const double phi = from.heading;
  if (turn == Turn::Straight) {
    return {from.position + length * Vec2(base::cos(phi), base::sin(phi)), phi};
  }
  const double side = turn == Turn::Left ? 1.0 : -1.0;
  const double after = phi + side * length;
  const Vec2 step(base::sin(after) - base::sin(phi), base::cos(phi) - base::cos(after));
  return {from.position + side * step, after};
}

}  // namespace

double ShortestCurve::length() const {
  double sum = 0.0;
  for (const Piece& piece : pieces) {
    sum += std::fabs(piece.length);
  }
  return radius * sum;
}

Pose2 ShortestCurve::at(double distance) const {
  double left = distance / radius;
  Pose2 pose{Vec2::Zero(), start.heading};
  for (const Piece& piece : pieces) {
    const double part = std::clamp(left, 0.0, std::fabs(piece.length));
    pose = moved(pose, piece.turn, piece.length < 0.0 ? -part : part);
    left -= part;
  }
  return {start.position + radius * pose.position, base::wrapToPi(pose.heading)};
}

ShortestCurve shortestCurve(CarMotion motion, const Pose2& from, const Pose2& to, double radius) {
  const Vec2 way = (to.position - from.position) / radius;
  const double cosine = base::cos(from.heading), sine = base::sin(from.heading);
  const RelativePose goal{way.x() * cosine + way.y() * sine, way.y() * cosine - way.x() * sine,
                          base::angleDiff(to.heading, from.heading)};
  Shortest shortest;
  if (motion == CarMotion::Dubins) {
    offerDubins(goal, shortest);
  } else {
    offerReedsShepp(goal, shortest);
  }
  return {from, radius, shortest.pieces()};
}

}  // namespace sim2d::nav2
