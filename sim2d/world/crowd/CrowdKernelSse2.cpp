#include "sim2d/world/crowd/CrowdKernelSource.h"

namespace sim2d {

CrowdKernel crowdKernelSse2() {
  return {forcesOf, sumPairs};
}

}  // namespace sim2d
