#include "sim2d/world/crowd/CrowdKernelSource.h"

namespace sim2d {

CrowdKernel crowdKernelAvx512() {
  return {forcesOf, sumPairs};
}

}  // namespace sim2d
