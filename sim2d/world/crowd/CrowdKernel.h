#pragma once

#include <cstdint>

/// Input and output of the social-force vector code. Plain data only: the code is compiled once per
/// instruction set, and nothing shared by these files may be compiled with the flags of one of
/// them.
namespace sim2d {

/// Pairs above the cut-off are summed in this many columns, independent of the register width.
constexpr int kCrowdLanes = 16;
/// [m]; pairs nearer than this are handled by scalar code, which uses their ids.
constexpr float kCoincidentDistance = 1e-4F;

/// People in columns, sorted by cell, relative to the middle of the crowd. Must be readable for
/// `kCrowdLanes` entries beyond the end.
struct CrowdColumns {
  const float* x = nullptr;  // [m]
  const float* y = nullptr;
  const float* vx = nullptr;  // [m/s]
  const float* vy = nullptr;
  const float* room = nullptr;  // clearance to walls [m]
};

/// Slots [first, last) of the columns.
struct CrowdSpan {
  int first = 0, last = 0;
};

/// A person on whom forces act.
struct CrowdReceiver {
  float x = 0.0F, y = 0.0F, vx = 0.0F, vy = 0.0F, room = 0.0F;
  int firstSpan = 0, lastSpan = 0;  // candidates, including the person itself
};

/// Force parameters of a batch; names as in ForceParameters.
struct CrowdForceParameters {
  float lambda = 0.0F, gamma = 0.0F, n = 0.0F, nPrime = 0.0F, epsilon = 0.0F;
  float cutOff = 0.0F;           // -ln of the share of k_s that is ignored
  float minTestedForce = 1e-4F;  // smaller forces, in units of k_s, skip the wall test
  bool testsWalls = true;        // walls may be in between and block the force
};

/// Work arrays of the kernel; see `kCrowdSpare` for their length.
struct CrowdPairs {
  int* word = nullptr;    // per register of candidates with survivors: lane mask
  int* wordAt = nullptr;  // its first slot
  float* x = nullptr;     // of the survivors, relative to the receiver
  float* y = nullptr;
  float* vx = nullptr;
  float* vy = nullptr;
  int* slot = nullptr;  // only if walls are tested
  float* fx = nullptr;  // force on the receiver, in units of k_s
  float* fy = nullptr;
  int* touching = nullptr;  // per register
  int* doubtful = nullptr;  // pairs that need a wall test
};
/// The arrays of CrowdPairs hold all candidates of a batch plus this many entries per receiver and
/// per span.
constexpr int kCrowdSpare = 2 * kCrowdLanes;

struct CrowdResult {
  float x = 0.0F, y = 0.0F;  // sum over all pairs, in units of k_s
  int first = 0, last = 0;   // pairs
  int firstDoubtful = 0, lastDoubtful = 0;
  int touching = 0;  // pairs at the receiver's position, including itself; skipped
};

/// People with the same law. Processing several at once hides the latency of square roots.
struct CrowdBatch {
  CrowdForceParameters law;
  const CrowdReceiver* receivers = nullptr;
  int count = 0;
  const CrowdSpan* spans = nullptr;
  CrowdResult* results = nullptr;
};

/// One compiled version of the kernel. All versions give bit-identical results.
struct CrowdKernel {
  void (*forces)(const CrowdColumns& crowd, const CrowdBatch& batch,
                 const CrowdPairs& pairs) = nullptr;
  /// Recomputes the sum after forces of some pairs were set to zero.
  void (*sum)(const CrowdPairs& pairs, CrowdResult& result) = nullptr;
};

CrowdKernel crowdKernelSse2();
CrowdKernel crowdKernelAvx2();
CrowdKernel crowdKernelAvx512();

/// Instruction sets for which the kernel is compiled.
enum class SimdLevel : std::uint8_t { Sse2, Avx2, Avx512 };
const char* simdLevelName(SimdLevel path);
bool isSimdLevelSupported(SimdLevel path);  // supported by this processor
SimdLevel fastestSimdLevel();
CrowdKernel crowdKernelFor(SimdLevel path);

}  // namespace sim2d
