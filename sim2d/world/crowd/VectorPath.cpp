#include "sim2d/world/crowd/VectorPath.h"

namespace sim2d {

const char* vectorPathName(VectorPath path) {
  switch (path) {
    case VectorPath::Avx512:
      return "AVX-512";
    case VectorPath::Avx2:
      return "AVX2";
    case VectorPath::Sse2:
      break;
  }
  return "SSE2";
}

bool hasVectorPath(VectorPath path) {
  switch (path) {
    case VectorPath::Avx512:
      return __builtin_cpu_supports("avx512f") != 0;
    case VectorPath::Avx2:
      return __builtin_cpu_supports("avx2") != 0;
    case VectorPath::Sse2:
      break;
  }
  return true;
}

VectorPath fastestVectorPath() {
  if (hasVectorPath(VectorPath::Avx512)) {
    return VectorPath::Avx512;
  }
  return hasVectorPath(VectorPath::Avx2) ? VectorPath::Avx2 : VectorPath::Sse2;
}

CrowdKernel kernelOf(VectorPath path) {
  switch (path) {
    case VectorPath::Avx512:
      return crowdKernelAvx512();
    case VectorPath::Avx2:
      return crowdKernelAvx2();
    case VectorPath::Sse2:
      break;
  }
  return crowdKernelSse2();
}

}  // namespace sim2d
