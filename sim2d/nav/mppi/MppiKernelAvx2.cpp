#include "sim2d/nav/mppi/MppiKernelSource.h"

sim2d::nav2::CompiledKernels sim2d::nav2::kernelsForAvx2() {
  return compiledKernels();
}
