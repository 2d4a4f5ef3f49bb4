#pragma once

#include "sim2d/base/Types.h"

/// Who ran into whom. One rule for events of contacts and for the metrics that count them.
namespace sim2d {

enum class Culprit { First, Second, Both };

/// Of two bodies that touch: the one that closes in faster along the line of centres; both when
/// they do so equally fast, to 1e-6 m/s, or when the centres lie in one place. Velocities [m/s] are
/// those before the contact, which may have stopped the bodies already.
inline Culprit culpritOf(const base::Vec2& first, const base::Vec2& velocityOfFirst,
                         const base::Vec2& second, const base::Vec2& velocityOfSecond) {
  constexpr double kEqualSpeeds = 1e-6;  // [m/s]
  const base::Vec2 between = second - first;
  const double separation = between.norm();
  const base::Vec2 normal =
      separation > 0.0 ? base::Vec2(between / separation) : base::Vec2(0.0, 0.0);
  const double byFirst = velocityOfFirst.dot(normal);
  const double bySecond = -velocityOfSecond.dot(normal);
  if (byFirst > bySecond + kEqualSpeeds) {
    return Culprit::First;
  }
  return bySecond > byFirst + kEqualSpeeds ? Culprit::Second : Culprit::Both;
}

}  // namespace sim2d
