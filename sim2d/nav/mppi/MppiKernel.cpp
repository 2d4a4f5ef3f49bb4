#include "sim2d/nav/mppi/MppiKernel.h"

#include <array>
#include <cstddef>

#include "sim2d/nav/nav2/mppi/TrajectoryKernel.h"

namespace sim2d {

bool isMppiSimdLevelSupported(MppiSimdLevel path) {
  const std::array<bool, 3> isThere = {true, __builtin_cpu_supports("avx2") != 0,
                                       __builtin_cpu_supports("avx512f") != 0};
  return isThere[static_cast<std::size_t>(path)];
}

MppiSimdLevel fastestMppiSimdLevel() {
  if (isMppiSimdLevelSupported(MppiSimdLevel::Avx512)) {
    return MppiSimdLevel::Avx512;
  }
  return isMppiSimdLevelSupported(MppiSimdLevel::Avx2) ? MppiSimdLevel::Avx2 : MppiSimdLevel::Sse2;
}

MppiKernel mppiKernelFor(MppiSimdLevel path) {
  constexpr std::array<MppiKernel (*)(), 3> kKernels = {mppiKernelSse2, mppiKernelAvx2,
                                                        mppiKernelAvx512};
  return kKernels[static_cast<std::size_t>(path)]();
}

nav2::TrajectoryKernel nav2::trajectoryKernelOf(MppiSimdLevel path) {
  constexpr std::array<TrajectoryKernel (*)(), 3> kKernels = {
      trajectoryKernelSse2, trajectoryKernelAvx2, trajectoryKernelAvx512};
  return kKernels[static_cast<std::size_t>(path)]();
}

}  // namespace sim2d
