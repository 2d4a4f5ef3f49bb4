#pragma once

#include "sim2d/world/crowd/CrowdLanes.h"

/// Three registers that are processed in parallel: the formula of a pair is a long dependency
/// chain, and the out-of-order window of the processor covers less than two of them. Also powers
/// and angles of one register or of three.
namespace sim2d {
namespace {

constexpr Bits kAllLanes = (1U << static_cast<unsigned>(kWidth)) - 1U;

inline int countOf(Bits bits) {
  if constexpr (kWidth == 4) {
    return static_cast<int>((0x4332322132212110U >> (bits * 4U)) & 0xFU);
  } else {
    return __builtin_popcount(bits);
  }
}

struct TripleMask {
  Mask a, b, c;

  friend TripleMask operator&(TripleMask x, TripleMask y) {
    return {x.a & y.a, x.b & y.b, x.c & y.c};
  }
};

struct Triple {
  Triple(Lanes all) : a(all), b(all), c(all) {}  // implicit, for constants in formulas
  Triple(Lanes first, Lanes second, Lanes third) : a(first), b(second), c(third) {}

  friend Triple operator+(Triple x, Triple y) { return {x.a + y.a, x.b + y.b, x.c + y.c}; }
  friend Triple operator-(Triple x, Triple y) { return {x.a - y.a, x.b - y.b, x.c - y.c}; }
  friend Triple operator*(Triple x, Triple y) { return {x.a * y.a, x.b * y.b, x.c * y.c}; }
  friend Triple operator/(Triple x, Triple y) { return {x.a / y.a, x.b / y.b, x.c / y.c}; }
  friend TripleMask operator<(Triple x, Triple y) { return {x.a < y.a, x.b < y.b, x.c < y.c}; }
  friend TripleMask operator<=(Triple x, Triple y) { return {x.a <= y.a, x.b <= y.b, x.c <= y.c}; }
  friend Triple sqrt(Triple x) { return {sqrt(x.a), sqrt(x.b), sqrt(x.c)}; }
  friend Triple abs(Triple x) { return {abs(x.a), abs(x.b), abs(x.c)}; }
  friend Triple min(Triple x, Triple y) { return {min(x.a, y.a), min(x.b, y.b), min(x.c, y.c)}; }
  friend Triple max(Triple x, Triple y) { return {max(x.a, y.a), max(x.b, y.b), max(x.c, y.c)}; }
  friend Triple select(TripleMask mask, Triple yes, Triple no) {
    return {select(mask.a, yes.a, no.a), select(mask.b, yes.b, no.b), select(mask.c, yes.c, no.c)};
  }
  friend Triple withSign(Triple x, Triple sign) {
    return {withSign(x.a, sign.a), withSign(x.b, sign.b), withSign(x.c, sign.c)};
  }
  friend Triple scaled(Triple x, Triple power) {
    return {scaled(x.a, power.a), scaled(x.b, power.b), scaled(x.c, power.c)};
  }

  Lanes a, b, c;
};

/// The unit of processing of the pair formula. SSE2 has too few registers for three.
#if defined(__AVX2__)
using Group = Triple;
using GroupMask = TripleMask;
constexpr int kGroupWidth = 3 * kWidth;

inline Group loadGroup(const float* from) {
  return {load(from), load(from + kWidth), load(from + kWidth + kWidth)};
}
inline void storeGroup(float* to, Group x) {
  store(to, x.a);
  store(to + kWidth, x.b);
  store(to + kWidth + kWidth, x.c);
}
/// Number of selected lanes per register.
inline void storeCounts(int* to, GroupMask mask) {
  to[0] = countOf(bitsOf(mask.a));
  to[1] = countOf(bitsOf(mask.b));
  to[2] = countOf(bitsOf(mask.c));
}
#else
using Group = Lanes;
using GroupMask = Mask;
constexpr int kGroupWidth = kWidth;

inline Group loadGroup(const float* from) {
  return load(from);
}
inline void storeGroup(float* to, Group x) {
  store(to, x);
}
inline void storeCounts(int* to, GroupMask mask) {
  *to = countOf(bitsOf(mask));
}
#endif

using Quintic = float[6];  // coefficients, lowest power first

template <class T>
inline T polynomial(T x, const Quintic& c) {
  const T x2 = x * x;
  const T low = fill(c[0]) + fill(c[1]) * x;
  const T middle = fill(c[2]) + fill(c[3]) * x;
  const T high = fill(c[4]) + fill(c[5]) * x;
  return low + x2 * (middle + x2 * high);
}

/// 2^x for x <= 0, no subnormal results (clamped at 2^-126). Relative error 2e-7 for x above -2,
/// else |x| * 1e-7.
template <class T>
inline T powerOfTwo(T x) {
  constexpr Quintic kPower = {1.00000012F,   0.693146944F,   0.240221202F,
                              0.0555071309F, 0.00967554096F, 0.00132764725F};  // fitted
  const T limited = max(x, fill(-127.0F));
  const T power = limited + fill(kRoundToInt);
  const T rest = limited - (power - fill(kRoundToInt));
  return scaled(polynomial(rest, kPower), power);
}

/// Angle in [-pi, pi] of the unit vector (x, y). Error 3e-7 rad.
template <class T>
inline T angleOf(T y, T x) {
  constexpr Quintic kArcSine = {0.166641086F,  0.0757668838F,  0.0366140120F,
                                0.0692970380F, -0.0696123019F, 0.110461451F};  // fitted
  const T ax = abs(x);
  const T ay = abs(y);
  const T sine = min(ax, ay);  // of the angle to the nearest axis
  const T z = sine * sine;
  const T toAxis = sine + sine * z * polynomial(z, kArcSine);
  const T quarter = select(ax < ay, fill(1.57079633F) - toAxis, toAxis);
  const T half = select(x < fill(0.0F), fill(3.14159265F) - quarter, quarter);
  return withSign(half, y);
}

}  // namespace
}  // namespace sim2d
