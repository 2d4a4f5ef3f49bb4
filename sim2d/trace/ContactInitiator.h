#pragma once

#include "sim2d/base/Types.h"

/// Determines which body caused a contact; used for contact events and by metrics.
namespace sim2d {

enum class ContactInitiator { First, Second, Both };

/// The body with the higher closing speed along the line of centres; `Both` if the speeds are equal
/// to 1e-6 m/s or the centres coincide. Velocities [m/s] are those before the contact, which may
/// already have stopped the bodies.
inline ContactInitiator contactInitiator(const base::Vec2& first, const base::Vec2& velocityOfFirst,
                                         const base::Vec2& second,
                                         const base::Vec2& velocityOfSecond) {
  constexpr double kEqualSpeeds = 1e-6;  // [m/s]
  const base::Vec2 between = second - first;
  const double separation = between.norm();
  const base::Vec2 normal =
      separation > 0.0 ? base::Vec2(between / separation) : base::Vec2(0.0, 0.0);
  const double byFirst = velocityOfFirst.dot(normal);
  const double bySecond = -velocityOfSecond.dot(normal);
  if (byFirst > bySecond + kEqualSpeeds) {
    return ContactInitiator::First;
  }
  return bySecond > byFirst + kEqualSpeeds ? ContactInitiator::Second : ContactInitiator::Both;
}

}  // namespace sim2d
