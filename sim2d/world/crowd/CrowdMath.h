#pragma once

#include <cstdint>
#include <immintrin.h>

#include <xsimd/xsimd.hpp>

/// One register of floats of the instruction set for which this file is compiled. Only operations
/// that IEEE 754 rounds correctly are used, neither fused nor approximate ones. Everything except
/// xsimd, whose types carry the instruction set in their names, has internal linkage, so that no
/// other file can link code it must not run.
namespace sim2d {
namespace {

constexpr float kRoundToInt = 12582912.0F;  // 1.5 * 2^23: adding it rounds to an integer
constexpr int kRootBits = 0x5f375a86;       // balances the error of the root estimate

#if defined(__AVX512F__)
using InstructionSet = xsimd::avx512f;
#elif defined(__AVX2__)
using InstructionSet = xsimd::avx2;
#else
using InstructionSet = xsimd::sse2;
#endif

using Lanes = xsimd::batch<float, InstructionSet>;
using LaneBits = xsimd::batch<std::int32_t, InstructionSet>;
using Mask = Lanes::batch_bool_type;
using Bits = unsigned;
constexpr int kWidth = static_cast<int>(Lanes::size);

inline Lanes fill(float value) {
  return Lanes(value);
}
inline Lanes load(const float* from) {
  return Lanes::load_unaligned(from);
}
inline void store(float* to, Lanes a) {
  a.store_unaligned(to);
}
/// `a` >= 0 with the sign bit of `sign`.
inline Lanes withSign(Lanes a, Lanes sign) {
  return a | (sign & fill(-0.0F));
}
/// `a` times 2^power; the result must be a normal number. `power` is an integer plus `kRoundToInt`.
inline Lanes scaled(Lanes a, Lanes power) {
  return xsimd::bitwise_cast<Lanes>(xsimd::bitwise_cast<LaneBits>(a) +
                                    (xsimd::bitwise_cast<LaneBits>(power) << 23));
}
/// Estimate of 1 / sqrt(a), a > 0, within 3.5 %: halves the exponent by a bit shift.
inline Lanes approximateInverseRoot(Lanes a) {
  return xsimd::bitwise_cast<Lanes>(LaneBits(kRootBits) - (xsimd::bitwise_cast<LaneBits>(a) >> 1));
}

#if defined(__AVX512F__)

inline Bits bitsOf(Mask mask) {
  return static_cast<__mmask16>(mask);
}
/// Moves the selected lanes together, in order.
struct Packing {
  explicit Packing(Bits bits) : mask(static_cast<__mmask16>(bits)) {}
  void put(float* to, Lanes a) const { _mm512_storeu_ps(to, _mm512_maskz_compress_ps(mask, a)); }
  void putIndices(int* to, int first) const {
    const __m512i lanes = _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
    const __m512i indices = _mm512_add_epi32(lanes, _mm512_set1_epi32(first));
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(mask, indices));
  }
  __mmask16 mask;
};

#elif defined(__AVX2__)

inline Bits bitsOf(Mask mask) {
  return static_cast<Bits>(_mm256_movemask_ps(mask));
}

/// For each lane mask, the indices of its lanes in order.
struct PackingTable {
  constexpr PackingTable() {
    for (int bits = 0; bits < 256; ++bits) {
      int to = 0;
      for (int lane = 0; lane < 8; ++lane) {
        if (((bits >> lane) & 1) != 0) {
          lanes[bits][to] = lane;
          ++to;
        }
      }
    }
  }
  alignas(32) int lanes[256][8] = {};
};
constexpr PackingTable kPackings;

/// Moves the selected lanes together, in order.
struct Packing {
  explicit Packing(Bits bits)
      : lanes(_mm256_load_si256(reinterpret_cast<const __m256i*>(kPackings.lanes[bits]))) {}
  void put(float* to, Lanes a) const { _mm256_storeu_ps(to, _mm256_permutevar8x32_ps(a, lanes)); }
  void putIndices(int* to, int first) const {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                        _mm256_add_epi32(lanes, _mm256_set1_epi32(first)));
  }
  __m256i lanes;
};

#else

inline Bits bitsOf(Mask mask) {
  return static_cast<Bits>(_mm_movemask_ps(mask));
}
/// Moves the selected lanes together, in order.
struct Packing {
  explicit Packing(Bits chosen) : bits(chosen) {}
  void put(float* to, Lanes a) const {
    float lanes[kWidth] = {};
    store(lanes, a);
    int next = 0;
    for (int lane = 0; lane < kWidth; ++lane) {
      to[next] = lanes[lane];
      next += static_cast<int>((bits >> lane) & 1U);
    }
  }
  void putIndices(int* to, int first) const {
    int next = 0;
    for (int lane = 0; lane < kWidth; ++lane) {
      to[next] = first + lane;
      next += static_cast<int>((bits >> lane) & 1U);
    }
  }
  Bits bits;
};

#endif

/// Three registers that are processed in parallel: the formula of a pair is a long dependency
/// chain, and the out-of-order window of the processor covers less than two of them. Also powers
/// and angles of one register or of three.

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
