#pragma once

#include <cstdint>
#include <immintrin.h>

#include <xsimd/xsimd.hpp>

#include "sim2d/nav/mppi/MppiKernel.h"

/// One register of floats of the instruction set for which this file is compiled. Only operations
/// that IEEE 754 rounds correctly are used, neither fused nor approximate ones, so that every set
/// gives identical bits. Everything except xsimd, whose types carry the instruction set in their
/// names, has internal linkage, so that no other file can link code it must not run.
namespace sim2d {
namespace {

#if defined(__AVX512F__)
using MppiInstructions = xsimd::avx512f;
#elif defined(__AVX2__)
using MppiInstructions = xsimd::avx2;
#else
using MppiInstructions = xsimd::sse2;
#endif

using Lanes = xsimd::batch<float, MppiInstructions>;
using LaneInts = xsimd::batch<std::int32_t, MppiInstructions>;
using LaneWords = xsimd::batch<std::uint32_t, MppiInstructions>;
using LaneMask = Lanes::batch_bool_type;
constexpr int kLaneCount = static_cast<int>(Lanes::size);

inline Lanes fill(float value) {
  return Lanes(value);
}
inline Lanes load(const float* from) {
  return Lanes::load_unaligned(from);
}
inline void store(float* to, Lanes a) {
  a.store_unaligned(to);
}
inline Lanes clamped(Lanes a, Lanes low, Lanes high) {
  return max(low, min(high, a));  // `low` if the bounds cross
}
inline Lanes positivePart(Lanes a) {
  return max(a, fill(0.0F));
}

/// Adds kMppiColumns partial sums, always in the same order; overwrites them.
inline float sumOfColumns(float* columns) {
  for (int half = kMppiColumns / 2; half > 0; half /= 2) {
    for (int i = 0; i < half; ++i) {
      columns[i] = columns[i] + columns[i + half];
    }
  }
  return columns[0];
}

/// High and low halves of the products of 32-bit words with one word.
struct Products {
  LaneWords high, low;
};

/// Compilers do not find the multiplication of 32-bit words with 64-bit products, which is one
/// instruction for the even words and one for the odd ones.
inline Products productsOf(LaneWords a, std::uint32_t by) {
#if defined(__AVX512F__)
  const __m512i factor = _mm512_set1_epi64(by);
  const __m512i even = _mm512_mul_epu32(a, factor);
  const __m512i odd = _mm512_mul_epu32(_mm512_srli_epi64(a, 32), factor);
  constexpr __mmask16 kOdd = 0xAAAA;
  return {_mm512_mask_mov_epi32(_mm512_srli_epi64(even, 32), kOdd, odd),
          _mm512_mask_mov_epi32(even, kOdd, _mm512_slli_epi64(odd, 32))};
#elif defined(__AVX2__)
  const __m256i factor = _mm256_set1_epi64x(by);
  const __m256i even = _mm256_mul_epu32(a, factor);
  const __m256i odd = _mm256_mul_epu32(_mm256_srli_epi64(a, 32), factor);
  constexpr int kOdd = 0xAA;
  return {_mm256_blend_epi32(_mm256_srli_epi64(even, 32), odd, kOdd),
          _mm256_blend_epi32(even, _mm256_slli_epi64(odd, 32), kOdd)};
#else
  const __m128i factor = _mm_set1_epi64x(by);
  const __m128i even = _mm_mul_epu32(a, factor);
  const __m128i odd = _mm_mul_epu32(_mm_srli_epi64(a, 32), factor);
  const __m128i isOdd = _mm_set_epi32(-1, 0, -1, 0);
  return {_mm_or_si128(_mm_srli_epi64(even, 32), _mm_and_si128(isOdd, odd)),
          _mm_or_si128(_mm_andnot_si128(isOdd, even), _mm_slli_epi64(odd, 32))};
#endif
}

/// 2^x for x <= 0, no subnormal results (clamped at 2^-126). Relative error 2e-7 for x above -2,
/// else |x| * 1e-7.
inline Lanes powerOfTwo(Lanes x) {
  const Lanes whole = fill(12582912.0F);  // 1.5 * 2^23: adding it rounds to an integer
  const Lanes limited = max(x, fill(-126.0F));
  const Lanes power = limited + whole;
  const Lanes r = limited - (power - whole);
  const Lanes r2 = r * r;  // polynomial fitted on [-1/2, 1/2]
  const Lanes low = fill(1.00000012F) + fill(0.693146944F) * r;
  const Lanes middle = fill(0.240221202F) + fill(0.0555071309F) * r;
  const Lanes high = fill(0.00967554096F) + fill(0.00132764725F) * r;
  const Lanes value = low + r2 * (middle + r2 * high);
  return xsimd::bitwise_cast<Lanes>(xsimd::bitwise_cast<LaneInts>(value) +
                                    (xsimd::bitwise_cast<LaneInts>(power) << 23));
}

}  // namespace
}  // namespace sim2d
