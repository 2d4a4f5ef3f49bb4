#include "sim2d/nav/mppi/MppiKernelSource.h"

namespace sim2d {

MppiKernel mppiKernelAvx2() {
  return {drawSamples, weighSamples, weightedSum};
}

}  // namespace sim2d
