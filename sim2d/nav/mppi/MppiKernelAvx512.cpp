#include "sim2d/nav/mppi/MppiKernelSource.h"
#include "sim2d/nav/nav2/mppi/TrajectoryKernelSource.h"

namespace sim2d {

MppiKernel mppiKernelAvx512() {
  return {drawSamples, weighSamples, weightedSum};
}

nav2::TrajectoryKernel nav2::trajectoryKernelAvx512() {
  return compiledTrajectoryKernel();
}

}  // namespace sim2d
