#pragma once

#include "sim2d/world/crowd/CrowdTriple.h"

/// Powers and angles of a register, or of three, from the operations of CrowdLanes.h alone.
namespace sim2d {
namespace {

using Quintic = float[6];  // coefficients, of the lowest power first

template <class T>
inline T polynomial(T x, const Quintic& c) {
  const T x2 = x * x;
  const T low = fill(c[0]) + fill(c[1]) * x;
  const T middle = fill(c[2]) + fill(c[3]) * x;
  const T high = fill(c[4]) + fill(c[5]) * x;
  return low + x2 * (middle + x2 * high);
}

/// 2^x for x <= 0, nothing normal below 2^-126. Relative error 2e-7 for x above -2, else |x| *
/// 1e-7.
template <class T>
inline T powerOfTwo(T x) {
  constexpr Quintic kPower = {1.00000012F,   0.693146944F,   0.240221202F,
                              0.0555071309F, 0.00967554096F, 0.00132764725F};  // own fit
  const T limited = larger(x, fill(-127.0F));
  const T power = limited + fill(kWhole);
  const T rest = limited - (power - fill(kWhole));
  return scaled(polynomial(rest, kPower), power);
}

/// Angle in [-pi, pi] of the unit vector (x, y). Error 3e-7 rad.
template <class T>
inline T angleOf(T y, T x) {
  constexpr Quintic kArcSine = {0.166641086F,  0.0757668838F,  0.0366140120F,
                                0.0692970380F, -0.0696123019F, 0.110461451F};  // own fit
  const T ax = magnitude(x);
  const T ay = magnitude(y);
  const T sine = smaller(ax, ay);  // of the angle to the nearest axis
  const T z = sine * sine;
  const T toAxis = sine + sine * z * polynomial(z, kArcSine);
  const T quarter = choose(ax < ay, fill(1.57079633F) - toAxis, toAxis);
  const T half = choose(x < fill(0.0F), fill(3.14159265F) - quarter, quarter);
  return withSign(half, y);
}

}  // namespace
}  // namespace sim2d
