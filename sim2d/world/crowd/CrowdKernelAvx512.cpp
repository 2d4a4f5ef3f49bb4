#include "sim2d/world/crowd/CrowdKernelSource.h"

namespace sim2d {

CrowdKernel crowdKernelAvx512() {
  return {forceOn, sumPairs, appendColumns};
}

}  // namespace sim2d
