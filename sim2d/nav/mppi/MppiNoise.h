#pragma once

#include <cstddef>

#include "sim2d/nav/mppi/MppiKernel.h"
#include "sim2d/nav/mppi/MppiLanes.h"

/// Counter-based normal random numbers for a register of samples: Philox4x32-10 (Salmon et al.
/// 2011) and the Box-Muller transform (1958) in single precision. Include exactly once per
/// instruction-set file.
namespace sim2d {
namespace {

struct NoiseBlock {
  LaneWords words[4];
};

/// Same words as base::philox4x32.
inline NoiseBlock philoxOf(NoiseBlock counter, std::uint32_t key0, std::uint32_t key1) {
  for (int round = 0; round < 10; ++round) {
    const Products first = productsOf(counter.words[0], 0xD2511F53U);
    const Products second = productsOf(counter.words[2], 0xCD9E8D57U);
    counter = {{second.high ^ counter.words[1] ^ LaneWords(key0), second.low,
                first.high ^ counter.words[3] ^ LaneWords(key1), first.low}};
    key0 += 0x9E3779B9U;
    key1 += 0xBB67AE85U;
  }
  return counter;
}

/// In [1, 2), from the upper 23 bits.
inline Lanes fromOneToTwo(LaneWords bits) {
  return xsimd::bitwise_cast<Lanes>((bits >> 9) | LaneWords(0x3F800000U));
}

/// ln u for u in (0, 1], not subnormal; relative error 1e-7.
inline Lanes logOf(Lanes u) {
  const LaneInts bits = xsimd::bitwise_cast<LaneInts>(u);
  const Lanes mantissa =
      xsimd::bitwise_cast<Lanes>((bits & LaneInts(0x007FFFFF)) | LaneInts(0x3F800000));
  const LaneMask isHigh = fill(1.41421356F) < mantissa;
  const Lanes power = xsimd::to_float((bits >> 23) - LaneInts(127));
  const Lanes x = select(isHigh, fill(0.5F) * mantissa, mantissa) - fill(1.0F);
  constexpr float kLog[9] = {0.999999974F,  -0.499999964F, 0.333341934F,
                             -0.250013526F, 0.199559294F,  -0.165779791F,
                             0.149774292F,  -0.142693813F, 0.0853339577F};  // fitted, error 4e-8
  Lanes sum = fill(kLog[8]);
  for (int i = 7; i >= 0; --i) {
    sum = fill(kLog[i]) + x * sum;
  }
  const Lanes whole = power + select(isHigh, fill(1.0F), fill(0.0F));
  return whole * fill(0.693147181F) + x * sum;
}

/// sin(2 pi a), |a| <= 1/4 [turns]; error 1e-7.
inline Lanes sineOfTurn(Lanes a) {
  const Lanes z = a * a;  // fitted polynomial
  return a * (fill(6.28318528F) +
              z * (fill(-41.3416806F) +
                   z * (fill(81.6024764F) + z * (fill(-76.5811726F) + z * fill(39.7598271F)))));
}

struct LaneDirection {
  Lanes cosine, sine;
};

/// Cosine and sine of an angle [turns] in [-1/2, 1/2].
inline LaneDirection directionOfTurn(Lanes turn) {
  const Lanes folded = abs(turn) - fill(0.25F);              // [-1/4, 1/4]
  const Lanes sine = sineOfTurn(fill(0.25F) - abs(folded));  // of |turn|
  return {sineOfTurn(fill(0.0F) - folded), sine | (turn & fill(-0.0F))};
}

/// Two independent standard normal numbers.
struct NormalPair {
  Lanes first, second;
};

inline NormalPair normalsOf(LaneWords forRadius, LaneWords forTurn) {
  const Lanes u = fill(2.0F) - fromOneToTwo(forRadius);  // (0, 1]
  const LaneDirection direction = directionOfTurn(fromOneToTwo(forTurn) - fill(1.5F));
  const Lanes radius = sqrt(positivePart(fill(-2.0F) * logOf(u)));
  return {radius * direction.cosine, radius * direction.sine};
}

/// Normal numbers of one register of samples for all steps: steps 2 k and 2 k + 1 come from block
/// k. `first`, `second`: kLaneCount per step, with room for an even number of steps.
inline void drawNormals(const MppiNoise& noise, int firstSample, int series, int steps,
                        float* first, float* second) {
  std::uint32_t samples[kLaneCount];
  for (int lane = 0; lane < kLaneCount; ++lane) {
    samples[lane] = static_cast<std::uint32_t>(firstSample + lane);
  }
  const LaneWords sample = LaneWords::load_unaligned(samples);
  for (int step = 0; step < steps; step += 2) {
    const auto block =
        static_cast<std::uint32_t>(step / 2) | (static_cast<std::uint32_t>(series) << 16U);
    const NoiseBlock words = philoxOf(
        {{sample, LaneWords(noise.robot), LaneWords(noise.call), LaneWords(kMppiDraw ^ block)}},
        noise.key[0], noise.key[1]);
    for (int half = 0; half < 2; ++half) {
      const auto word = static_cast<std::size_t>(half) * 2;
      const NormalPair pair = normalsOf(words.words[word], words.words[word + 1]);
      const auto at = static_cast<std::ptrdiff_t>(step + half) * kLaneCount;
      store(first + at, pair.first);
      store(second + at, pair.second);
    }
  }
}

}  // namespace
}  // namespace sim2d
