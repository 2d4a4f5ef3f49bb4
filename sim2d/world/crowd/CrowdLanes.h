#pragma once

#include <immintrin.h>

/// One register of floats of the instruction set that this file is compiled for. Only operations
/// that IEEE 754 rounds correctly: no fused, no estimated ones. Everything has internal linkage, so
/// that no other file can be given code it must not run.
namespace sim2d {
namespace {

constexpr float kWhole = 12582912.0F;  // 1.5 * 2^23: adding it rounds to a whole number
constexpr int kRootBits = 0x5f375a86;  // makes the guess of a root about equally wrong both ways

#if defined(__AVX512F__)

constexpr int kWidth = 16;
using Bits = unsigned;
struct Lanes {
  __m512 v;
};
struct Mask {
  __mmask16 v;
};

inline Lanes fill(float value) {
  return {_mm512_set1_ps(value)};
}
inline Lanes load(const float* from) {
  return {_mm512_loadu_ps(from)};
}
inline void store(float* to, Lanes a) {
  _mm512_storeu_ps(to, a.v);
}
inline Lanes operator+(Lanes a, Lanes b) {
  return {_mm512_add_ps(a.v, b.v)};
}
inline Lanes operator-(Lanes a, Lanes b) {
  return {_mm512_sub_ps(a.v, b.v)};
}
inline Lanes operator*(Lanes a, Lanes b) {
  return {_mm512_mul_ps(a.v, b.v)};
}
inline Lanes operator/(Lanes a, Lanes b) {
  return {_mm512_div_ps(a.v, b.v)};
}
inline Lanes squareRoot(Lanes a) {
  return {_mm512_sqrt_ps(a.v)};
}
inline Lanes smaller(Lanes a, Lanes b) {
  return {_mm512_min_ps(a.v, b.v)};
}
inline Lanes larger(Lanes a, Lanes b) {
  return {_mm512_max_ps(a.v, b.v)};
}
inline Mask operator<(Lanes a, Lanes b) {
  return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ)};
}
inline Mask operator<=(Lanes a, Lanes b) {
  return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ)};
}
inline Mask operator&(Mask a, Mask b) {
  return {static_cast<__mmask16>(a.v & b.v)};
}
inline Lanes choose(Mask mask, Lanes yes, Lanes no) {
  return {_mm512_mask_blend_ps(mask.v, no.v, yes.v)};
}
inline Bits bitsOf(Mask mask) {
  return mask.v;
}
inline Lanes magnitude(Lanes a) {
  return {_mm512_abs_ps(a.v)};
}
/// `a` >= 0 with the sign bit of `sign`.
inline Lanes withSign(Lanes a, Lanes sign) {
  const __m512i bit = _mm512_set1_epi32(static_cast<int>(0x80000000U));
  return {_mm512_castsi512_ps(_mm512_or_si512(_mm512_castps_si512(a.v),
                                              _mm512_and_si512(_mm512_castps_si512(sign.v), bit)))};
}
/// `a` times 2^power, the result a normal number. `power` is whole and has `kWhole` added.
inline Lanes scaled(Lanes a, Lanes power) {
  return {_mm512_castsi512_ps(_mm512_add_epi32(
      _mm512_castps_si512(a.v), _mm512_slli_epi32(_mm512_castps_si512(power.v), 23)))};
}
/// About 1 / sqrt(a), a > 0, to 3.5 %: half the exponent by a shift of the bits.
inline Lanes guessInverseRoot(Lanes a) {
  return {_mm512_castsi512_ps(_mm512_sub_epi32(_mm512_set1_epi32(kRootBits),
                                               _mm512_srli_epi32(_mm512_castps_si512(a.v), 1)))};
}
/// Moves the chosen lanes together, in order.
struct Packing {
  explicit Packing(Bits bits) : mask(static_cast<__mmask16>(bits)) {}
  void put(float* to, Lanes a) const { _mm512_storeu_ps(to, _mm512_maskz_compress_ps(mask, a.v)); }
  void putIndices(int* to, int first) const {
    const __m512i lanes = _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
    const __m512i indices = _mm512_add_epi32(lanes, _mm512_set1_epi32(first));
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(mask, indices));
  }
  __mmask16 mask;
};

#elif defined(__AVX2__)

constexpr int kWidth = 8;
using Bits = unsigned;
struct Lanes {
  __m256 v;
};
struct Mask {
  __m256 v;
};

inline Lanes fill(float value) {
  return {_mm256_set1_ps(value)};
}
inline Lanes load(const float* from) {
  return {_mm256_loadu_ps(from)};
}
inline void store(float* to, Lanes a) {
  _mm256_storeu_ps(to, a.v);
}
inline Lanes operator+(Lanes a, Lanes b) {
  return {_mm256_add_ps(a.v, b.v)};
}
inline Lanes operator-(Lanes a, Lanes b) {
  return {_mm256_sub_ps(a.v, b.v)};
}
inline Lanes operator*(Lanes a, Lanes b) {
  return {_mm256_mul_ps(a.v, b.v)};
}
inline Lanes operator/(Lanes a, Lanes b) {
  return {_mm256_div_ps(a.v, b.v)};
}
inline Lanes squareRoot(Lanes a) {
  return {_mm256_sqrt_ps(a.v)};
}
inline Lanes smaller(Lanes a, Lanes b) {
  return {_mm256_min_ps(a.v, b.v)};
}
inline Lanes larger(Lanes a, Lanes b) {
  return {_mm256_max_ps(a.v, b.v)};
}
inline Mask operator<(Lanes a, Lanes b) {
  return {_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)};
}
inline Mask operator<=(Lanes a, Lanes b) {
  return {_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)};
}
inline Mask operator&(Mask a, Mask b) {
  return {_mm256_and_ps(a.v, b.v)};
}
inline Lanes choose(Mask mask, Lanes yes, Lanes no) {
  return {_mm256_blendv_ps(no.v, yes.v, mask.v)};
}
inline Bits bitsOf(Mask mask) {
  return static_cast<Bits>(_mm256_movemask_ps(mask.v));
}
inline Lanes magnitude(Lanes a) {
  return {_mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.v)};
}
/// `a` >= 0 with the sign bit of `sign`.
inline Lanes withSign(Lanes a, Lanes sign) {
  return {_mm256_or_ps(a.v, _mm256_and_ps(sign.v, _mm256_set1_ps(-0.0F)))};
}
/// `a` times 2^power, the result a normal number. `power` is whole and has `kWhole` added.
inline Lanes scaled(Lanes a, Lanes power) {
  return {_mm256_castsi256_ps(_mm256_add_epi32(
      _mm256_castps_si256(a.v), _mm256_slli_epi32(_mm256_castps_si256(power.v), 23)))};
}
/// About 1 / sqrt(a), a > 0, to 3.5 %: half the exponent by a shift of the bits.
inline Lanes guessInverseRoot(Lanes a) {
  return {_mm256_castsi256_ps(_mm256_sub_epi32(_mm256_set1_epi32(kRootBits),
                                               _mm256_srli_epi32(_mm256_castps_si256(a.v), 1)))};
}

/// For each set of lanes the lanes of it one after the other.
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

/// Moves the chosen lanes together, in order.
struct Packing {
  explicit Packing(Bits bits)
      : lanes(_mm256_load_si256(reinterpret_cast<const __m256i*>(kPackings.lanes[bits]))) {}
  void put(float* to, Lanes a) const { _mm256_storeu_ps(to, _mm256_permutevar8x32_ps(a.v, lanes)); }
  void putIndices(int* to, int first) const {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                        _mm256_add_epi32(lanes, _mm256_set1_epi32(first)));
  }
  __m256i lanes;
};

#else

constexpr int kWidth = 4;
using Bits = unsigned;
struct Lanes {
  __m128 v;
};
struct Mask {
  __m128 v;
};

inline Lanes fill(float value) {
  return {_mm_set1_ps(value)};
}
inline Lanes load(const float* from) {
  return {_mm_loadu_ps(from)};
}
inline void store(float* to, Lanes a) {
  _mm_storeu_ps(to, a.v);
}
inline Lanes operator+(Lanes a, Lanes b) {
  return {_mm_add_ps(a.v, b.v)};
}
inline Lanes operator-(Lanes a, Lanes b) {
  return {_mm_sub_ps(a.v, b.v)};
}
inline Lanes operator*(Lanes a, Lanes b) {
  return {_mm_mul_ps(a.v, b.v)};
}
inline Lanes operator/(Lanes a, Lanes b) {
  return {_mm_div_ps(a.v, b.v)};
}
inline Lanes squareRoot(Lanes a) {
  return {_mm_sqrt_ps(a.v)};
}
inline Lanes smaller(Lanes a, Lanes b) {
  return {_mm_min_ps(a.v, b.v)};
}
inline Lanes larger(Lanes a, Lanes b) {
  return {_mm_max_ps(a.v, b.v)};
}
inline Mask operator<(Lanes a, Lanes b) {
  return {_mm_cmplt_ps(a.v, b.v)};
}
inline Mask operator<=(Lanes a, Lanes b) {
  return {_mm_cmple_ps(a.v, b.v)};
}
inline Mask operator&(Mask a, Mask b) {
  return {_mm_and_ps(a.v, b.v)};
}
inline Lanes choose(Mask mask, Lanes yes, Lanes no) {
  return {_mm_or_ps(_mm_and_ps(mask.v, yes.v), _mm_andnot_ps(mask.v, no.v))};
}
inline Bits bitsOf(Mask mask) {
  return static_cast<Bits>(_mm_movemask_ps(mask.v));
}
inline Lanes magnitude(Lanes a) {
  return {_mm_andnot_ps(_mm_set1_ps(-0.0F), a.v)};
}
/// `a` >= 0 with the sign bit of `sign`.
inline Lanes withSign(Lanes a, Lanes sign) {
  return {_mm_or_ps(a.v, _mm_and_ps(sign.v, _mm_set1_ps(-0.0F)))};
}
/// `a` times 2^power, the result a normal number. `power` is whole and has `kWhole` added.
inline Lanes scaled(Lanes a, Lanes power) {
  return {_mm_castsi128_ps(
      _mm_add_epi32(_mm_castps_si128(a.v), _mm_slli_epi32(_mm_castps_si128(power.v), 23)))};
}
/// About 1 / sqrt(a), a > 0, to 3.5 %: half the exponent by a shift of the bits.
inline Lanes guessInverseRoot(Lanes a) {
  return {_mm_castsi128_ps(
      _mm_sub_epi32(_mm_set1_epi32(kRootBits), _mm_srli_epi32(_mm_castps_si128(a.v), 1)))};
}
/// Moves the chosen lanes together, in order.
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

}  // namespace
}  // namespace sim2d
