#pragma once

#include <cstdint>

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

/// Lane by lane; compilers vectorise it as one instruction for even and one for odd words.
inline Products productsOf(LaneWords a, std::uint32_t by) {
  std::uint32_t words[kLaneCount];
  std::uint32_t high[kLaneCount];
  std::uint32_t low[kLaneCount];
  a.store_unaligned(words);
  for (int lane = 0; lane < kLaneCount; ++lane) {
    const std::uint64_t product = static_cast<std::uint64_t>(words[lane]) * by;
    high[lane] = static_cast<std::uint32_t>(product >> 32U);
    low[lane] = static_cast<std::uint32_t>(product);
  }
  return {LaneWords::load_unaligned(high), LaneWords::load_unaligned(low)};
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
