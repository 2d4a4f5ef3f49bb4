#include "sim2d/nav/mppi/MppiKernel.h"

#include <array>
#include <cstddef>

#include "sim2d/nav/nav2/mppi/TrajectoryKernel.h"

namespace sim2d {
namespace {

nav2::CompiledKernels kernelsFor(MppiSimdLevel path) {
  constexpr std::array<nav2::CompiledKernels (*)(), 3> kKernels = {
      nav2::kernelsForSse2, nav2::kernelsForAvx2, nav2::kernelsForAvx512};
  return kKernels[static_cast<std::size_t>(path)]();
}

}  // namespace

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
  return kernelsFor(path).mppi;
}

nav2::TrajectoryKernel nav2::trajectoryKernelOf(MppiSimdLevel path) {
  return kernelsFor(path).trajectories;
}

}  // namespace sim2d
