#pragma once

#include "sim2d/world/crowd/CrowdLanes.h"

/// Two registers that go through the same formula side by side: the pairs' formula is a long chain
/// in which each operation waits for the one before, and the processor looks ahead over less than
/// two such chains.
namespace sim2d {
namespace {

struct Twin {
  Twin(Lanes both) : a(both), b(both) {}  // NOLINT: constants stand beside twins in formulae
  Twin(Lanes first, Lanes second) : a(first), b(second) {}
  Lanes a, b;
};
struct TwinMask {
  Mask a, b;
};

inline Twin operator+(Twin x, Twin y) {
  return {x.a + y.a, x.b + y.b};
}
inline Twin operator-(Twin x, Twin y) {
  return {x.a - y.a, x.b - y.b};
}
inline Twin operator*(Twin x, Twin y) {
  return {x.a * y.a, x.b * y.b};
}
inline Twin operator/(Twin x, Twin y) {
  return {x.a / y.a, x.b / y.b};
}
inline Twin squareRoot(Twin x) {
  return {squareRoot(x.a), squareRoot(x.b)};
}
inline Twin smaller(Twin x, Twin y) {
  return {smaller(x.a, y.a), smaller(x.b, y.b)};
}
inline Twin larger(Twin x, Twin y) {
  return {larger(x.a, y.a), larger(x.b, y.b)};
}
inline TwinMask operator<(Twin x, Twin y) {
  return {x.a < y.a, x.b < y.b};
}
inline TwinMask operator<=(Twin x, Twin y) {
  return {x.a <= y.a, x.b <= y.b};
}
inline TwinMask operator&(TwinMask x, TwinMask y) {
  return {x.a & y.a, x.b & y.b};
}
inline Twin choose(TwinMask mask, Twin yes, Twin no) {
  return {choose(mask.a, yes.a, no.a), choose(mask.b, yes.b, no.b)};
}
inline Twin magnitude(Twin x) {
  return {magnitude(x.a), magnitude(x.b)};
}
inline Twin withSign(Twin x, Twin sign) {
  return {withSign(x.a, sign.a), withSign(x.b, sign.b)};
}
inline Twin scaled(Twin x, Twin power) {
  return {scaled(x.a, power.a), scaled(x.b, power.b)};
}

/// What goes through the formula of the pairs at once. SSE2 has too few registers for twins.
#if defined(__AVX2__)
using Group = Twin;
using GroupMask = TwinMask;
constexpr int kGroupWidth = 2 * kWidth;

inline Group loadGroup(const float* from) {
  return {load(from), load(from + kWidth)};
}
inline void storeGroup(float* to, Group x) {
  store(to, x.a);
  store(to + kWidth, x.b);
}
inline Bits bitsOf(GroupMask mask) {
  return bitsOf(mask.a) | bitsOf(mask.b) << static_cast<unsigned>(kWidth);
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
#endif

}  // namespace
}  // namespace sim2d
