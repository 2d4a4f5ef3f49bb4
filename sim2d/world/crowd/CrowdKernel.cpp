#include "sim2d/world/crowd/CrowdKernel.h"

#include <array>
#include <cstddef>

namespace sim2d {

const char* simdLevelName(SimdLevel path) {
  constexpr std::array<const char*, 3> kNames = {"SSE2", "AVX2", "AVX-512"};
  return kNames[static_cast<std::size_t>(path)];
}

bool isSimdLevelSupported(SimdLevel path) {
  const std::array<bool, 3> isThere = {true, __builtin_cpu_supports("avx2") != 0,
                                       __builtin_cpu_supports("avx512f") != 0};
  return isThere[static_cast<std::size_t>(path)];
}

SimdLevel fastestSimdLevel() {
  if (isSimdLevelSupported(SimdLevel::Avx512)) {
    return SimdLevel::Avx512;
  }
  return isSimdLevelSupported(SimdLevel::Avx2) ? SimdLevel::Avx2 : SimdLevel::Sse2;
}

CrowdKernel crowdKernelFor(SimdLevel path) {
  constexpr std::array<CrowdKernel (*)(), 3> kKernels = {crowdKernelSse2, crowdKernelAvx2,
                                                         crowdKernelAvx512};
  return kKernels[static_cast<std::size_t>(path)]();
}

}  // namespace sim2d
