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

}  // namespace
}  // namespace sim2d
