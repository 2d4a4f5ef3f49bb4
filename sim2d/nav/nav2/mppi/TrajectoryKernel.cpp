#include "sim2d/nav/nav2/mppi/TrajectoryKernel.h"

#include <array>
#include <cstddef>

namespace sim2d::nav2 {

TrajectoryKernel trajectoryKernelOf(MppiSimdLevel path) {
  constexpr std::array<TrajectoryKernel (*)(), 3> kKernels = {
      trajectoryKernelSse2, trajectoryKernelAvx2, trajectoryKernelAvx512};
  return kKernels[static_cast<std::size_t>(path)]();
}

}  // namespace sim2d::nav2
