#pragma once

#include "sim2d/world/crowd/CrowdLanes.h"

/// Three registers that go through the same formula side by side: the pairs' formula is a long
/// chain in which each operation waits for the one before, and the processor looks ahead over less
/// than two such chains.
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

struct Triple {
  Triple(Lanes all) : a(all), b(all), c(all) {}  // constants stand beside triples in formulae
  Triple(Lanes first, Lanes second, Lanes third) : a(first), b(second), c(third) {}
  Lanes a, b, c;
};
struct TripleMask {
  Mask a, b, c;
};

inline Triple operator+(Triple x, Triple y) {
  return {x.a + y.a, x.b + y.b, x.c + y.c};
}
inline Triple operator-(Triple x, Triple y) {
  return {x.a - y.a, x.b - y.b, x.c - y.c};
}
inline Triple operator*(Triple x, Triple y) {
  return {x.a * y.a, x.b * y.b, x.c * y.c};
}
inline Triple operator/(Triple x, Triple y) {
  return {x.a / y.a, x.b / y.b, x.c / y.c};
}
inline Triple squareRoot(Triple x) {
  return {squareRoot(x.a), squareRoot(x.b), squareRoot(x.c)};
}
inline Triple smaller(Triple x, Triple y) {
  return {smaller(x.a, y.a), smaller(x.b, y.b), smaller(x.c, y.c)};
}
inline Triple larger(Triple x, Triple y) {
  return {larger(x.a, y.a), larger(x.b, y.b), larger(x.c, y.c)};
}
inline TripleMask operator<(Triple x, Triple y) {
  return {x.a < y.a, x.b < y.b, x.c < y.c};
}
inline TripleMask operator<=(Triple x, Triple y) {
  return {x.a <= y.a, x.b <= y.b, x.c <= y.c};
}
inline TripleMask operator&(TripleMask x, TripleMask y) {
  return {x.a & y.a, x.b & y.b, x.c & y.c};
}
inline Triple choose(TripleMask mask, Triple yes, Triple no) {
  return {choose(mask.a, yes.a, no.a), choose(mask.b, yes.b, no.b), choose(mask.c, yes.c, no.c)};
}
inline Triple magnitude(Triple x) {
  return {magnitude(x.a), magnitude(x.b), magnitude(x.c)};
}
inline Triple withSign(Triple x, Triple sign) {
  return {withSign(x.a, sign.a), withSign(x.b, sign.b), withSign(x.c, sign.c)};
}
inline Triple scaled(Triple x, Triple power) {
  return {scaled(x.a, power.a), scaled(x.b, power.b), scaled(x.c, power.c)};
}

/// What goes through the formula of the pairs at once. SSE2 has too few registers for three.
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
/// The number of chosen lanes of each register.
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

}  // namespace
}  // namespace sim2d
