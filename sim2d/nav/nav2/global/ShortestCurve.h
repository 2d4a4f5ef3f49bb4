#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim2d/nav/nav2/Costmap.h"

/// Shortest ways of a car from one pose to another through an empty plane.
namespace sim2d::nav2 {

enum class CarMotion : std::uint8_t {
  Dubins,      // forward only: Dubins, Am. J. Math. 79 (1957)
  ReedsShepp,  // either way: Reeds and Shepp, Pacific J. Math. 145 (1990), equations 8.1 to 8.11
};

/// Arcs of the smallest circle and straight pieces, one after the other.
struct ShortestCurve {
  enum class Turn : std::uint8_t { Left, Straight, Right };
  struct Piece {
    Turn turn = Turn::Straight;
    double length = 0.0;  // in units of the radius: angle of an arc [rad]; negative: backward
  };
  static constexpr std::size_t kMostPieces = 5;

  Pose2 start;
  double radius = 1.0;  // R, in the unit of the positions
  std::array<Piece, kMostPieces> pieces;

  double length() const;            // in the unit of the positions
  Pose2 at(double distance) const;  // along it from the start; heading in (-pi, pi]
};

/// The poses lie in any unit of length, `radius` > 0 in the same. Of equally short curves always
/// the same one.
ShortestCurve shortestCurve(CarMotion motion, const Pose2& from, const Pose2& to, double radius);

}  // namespace sim2d::nav2
