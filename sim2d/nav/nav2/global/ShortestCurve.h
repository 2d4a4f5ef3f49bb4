#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim2d/nav/nav2/Costmap.h"

/// Shortest curves of a car between two poses without obstacles.
namespace sim2d::nav2 {

enum class CarMotion : std::uint8_t {
  Dubins,      // forward only: Dubins, Am. J. Math. 79 (1957)
  ReedsShepp,  // both ways: Reeds and Shepp, Pacific J. Math. 145 (1990), equations 8.1 to 8.11
};

/// A sequence of arcs with the minimum radius and straight pieces.
struct ShortestCurve {
  enum class Turn : std::uint8_t { Left, Straight, Right };
  struct Piece {
    Turn turn = Turn::Straight;
    double length = 0.0;  // in units of the radius: angle of an arc [rad]; negative: reverse
  };
  static constexpr std::size_t kMaxPieces = 5;

  Pose2 start;
  double radius = 1.0;  // R, in the unit of the positions
  std::array<Piece, kMaxPieces> pieces;

  double length() const;            // in the unit of the positions
  Pose2 at(double distance) const;  // pose at a distance from the start; heading in (-pi, pi]
};

/// Positions may be in any unit of length, `radius` > 0 in the same unit. Deterministic if several
/// curves have the same length.
ShortestCurve shortestCurve(CarMotion motion, const Pose2& from, const Pose2& to, double radius);

}  // namespace sim2d::nav2
