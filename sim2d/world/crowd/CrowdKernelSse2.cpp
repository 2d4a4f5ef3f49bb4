#include "sim2d/world/crowd/CrowdKernelSource.h"

namespace sim2d {

CrowdKernel crowdKernelSse2() {
  return {forceOn, sumPairs, appendColumns};
}

}  // namespace sim2d
