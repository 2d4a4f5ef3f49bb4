#pragma once

#include <cstdint>
#include <immintrin.h>

#include <xsimd/xsimd.hpp>

/// One register of floats of the instruction set that this file is compiled for. Only operations
/// that IEEE 754 rounds correctly: no fused, no estimated ones, so every set gives the same bits.
/// What is not of xsimd, whose types carry the instruction set in their names, has internal
/// linkage, so that no other file can be given code it must not run.
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
  return max(low, min(high, a));  // `low` where the two cross
}
inline Lanes orZero(Lanes a) {
  return max(a, fill(0.0F));
}

/// Both halves of the products of 32-bit words with one word.
struct Products {
  LaneWords high, low;
};

#if defined(__AVX512F__)

inline Products productsOf(LaneWords a, std::uint32_t by) {
  const __m512i factor = _mm512_set1_epi64(static_cast<long long>(by));
  const __m512i upper = _mm512_set1_epi64(static_cast<long long>(0xFFFFFFFF00000000ULL));
  const __m512i even = _mm512_mul_epu32(a, factor);
  const __m512i odd = _mm512_mul_epu32(_mm512_srli_epi64(a, 32), factor);
  return {LaneWords(_mm512_or_si512(_mm512_srli_epi64(even, 32), _mm512_and_si512(odd, upper))),
          LaneWords(_mm512_or_si512(_mm512_andnot_si512(upper, even), _mm512_slli_epi64(odd, 32)))};
}

#elif defined(__AVX2__)

inline Products productsOf(LaneWords a, std::uint32_t by) {
  const __m256i factor = _mm256_set1_epi64x(static_cast<long long>(by));
  const __m256i upper = _mm256_set1_epi64x(static_cast<long long>(0xFFFFFFFF00000000ULL));
  const __m256i even = _mm256_mul_epu32(a, factor);
  const __m256i odd = _mm256_mul_epu32(_mm256_srli_epi64(a, 32), factor);
  return {LaneWords(_mm256_or_si256(_mm256_srli_epi64(even, 32), _mm256_and_si256(odd, upper))),
          LaneWords(_mm256_or_si256(_mm256_andnot_si256(upper, even), _mm256_slli_epi64(odd, 32)))};
}

#else

inline Products productsOf(LaneWords a, std::uint32_t by) {
  const __m128i factor = _mm_set1_epi64x(static_cast<long long>(by));
  const __m128i upper = _mm_set1_epi64x(static_cast<long long>(0xFFFFFFFF00000000ULL));
  const __m128i even = _mm_mul_epu32(a, factor);
  const __m128i odd = _mm_mul_epu32(_mm_srli_epi64(a, 32), factor);
  return {LaneWords(_mm_or_si128(_mm_srli_epi64(even, 32), _mm_and_si128(odd, upper))),
          LaneWords(_mm_or_si128(_mm_andnot_si128(upper, even), _mm_slli_epi64(odd, 32)))};
}

#endif

/// 2^x for x <= 0, nothing normal below 2^-126. Relative error 2e-7 for x above -2, else |x| *
/// 1e-7.
inline Lanes powerOfTwo(Lanes x) {
  const Lanes whole = fill(12582912.0F);  // 1.5 * 2^23: adding it rounds to a whole number
  const Lanes limited = max(x, fill(-126.0F));
  const Lanes power = limited + whole;
  const Lanes r = limited - (power - whole);
  const Lanes r2 = r * r;  // own fit on [-1/2, 1/2]
  const Lanes low = fill(1.00000012F) + fill(0.693146944F) * r;
  const Lanes middle = fill(0.240221202F) + fill(0.0555071309F) * r;
  const Lanes high = fill(0.00967554096F) + fill(0.00132764725F) * r;
  const Lanes value = low + r2 * (middle + r2 * high);
  return xsimd::bitwise_cast<Lanes>(xsimd::bitwise_cast<LaneInts>(value) +
                                    (xsimd::bitwise_cast<LaneInts>(power) << 23));
}

}  // namespace
}  // namespace sim2d
