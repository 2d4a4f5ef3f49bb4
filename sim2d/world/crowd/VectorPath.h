#pragma once

#include <cstdint>

#include "sim2d/world/crowd/CrowdKernel.h"

namespace sim2d {

/// Instruction sets that the kernel is compiled for.
enum class VectorPath : std::uint8_t { Sse2, Avx2, Avx512 };
const char* vectorPathName(VectorPath path);
bool hasVectorPath(VectorPath path);  // this processor
VectorPath fastestVectorPath();
CrowdKernel kernelOf(VectorPath path);

}  // namespace sim2d
