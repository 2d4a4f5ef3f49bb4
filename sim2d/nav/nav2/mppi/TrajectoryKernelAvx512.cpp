#include "sim2d/nav/nav2/mppi/TrajectoryKernelSource.h"

namespace sim2d::nav2 {

TrajectoryKernel trajectoryKernelAvx512() {
  return compiledTrajectoryKernel();
}

}  // namespace sim2d::nav2
