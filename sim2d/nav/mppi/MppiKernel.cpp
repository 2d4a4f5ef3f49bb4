#include "sim2d/nav/mppi/MppiKernel.h"

#include <array>
#include <cstddef>

namespace sim2d {

bool hasMppiPath(MppiPath path) {
  const std::array<bool, 3> isThere = {true, __builtin_cpu_supports("avx2") != 0,
                                       __builtin_cpu_supports("avx512f") != 0};
  return isThere[static_cast<std::size_t>(path)];
}

MppiPath fastestMppiPath() {
  if (hasMppiPath(MppiPath::Avx512)) {
    return MppiPath::Avx512;
  }
  return hasMppiPath(MppiPath::Avx2) ? MppiPath::Avx2 : MppiPath::Sse2;
}

MppiKernel mppiKernelOf(MppiPath path) {
  constexpr std::array<MppiKernel (*)(), 3> kKernels = {mppiKernelSse2, mppiKernelAvx2,
                                                        mppiKernelAvx512};
  return kKernels[static_cast<std::size_t>(path)]();
}

}  // namespace sim2d
