#pragma once

#include <cstdint>

/// What the vector code of the social force is given and gives back. Plain data only: the code is
/// compiled once per instruction set, and nothing that these files share may be compiled with the
/// flags of one of them.
namespace sim2d {

/// Survivors of the cut-off are summed in this many columns, whatever the registers hold.
constexpr int kCrowdLanes = 16;
/// [m]; bodies nearer than this to each other are left to the scalar code, which knows their ids.
constexpr float kCrowdTouching = 1e-4F;

/// People in columns, sorted by cell, relative to the middle of the crowd. `kCrowdLanes` more may
/// be read.
struct CrowdColumns {
  const float* x = nullptr;  // [m]
  const float* y = nullptr;
  const float* vx = nullptr;  // [m/s]
  const float* vy = nullptr;
  const float* room = nullptr;  // to the next wall [m]
};

/// Slots of the columns: `first` up to before `last`.
struct CrowdSpan {
  int first = 0, last = 0;
};

/// One person who feels the others.
struct CrowdReceiver {
  float x = 0.0F, y = 0.0F, vx = 0.0F, vy = 0.0F, room = 0.0F;
  int firstSpan = 0, lastSpan = 0;  // who may be near enough, the person itself among them
};

/// The force of some people (ForceParameters has the meaning of its names).
struct CrowdLaw {
  float lambda = 0.0F, gamma = 0.0F, n = 0.0F, nPrime = 0.0F, epsilon = 0.0F;
  float cutOff = 0.0F;        // -ln of the share of k_s that is left out
  float leastLooked = 1e-4F;  // smaller forces, in units of k_s, are not worth a look for walls
  bool looksForWalls = true;  // there may be walls between, and they keep the force off
};

/// What the kernel writes on its way; see `kCrowdSpare` for the length of the columns.
struct CrowdPairs {
  int* word = nullptr;    // per register of candidates with survivors: which lanes
  int* wordAt = nullptr;  // its first slot
  float* x = nullptr;     // of the survivors, from the receiver
  float* y = nullptr;
  float* vx = nullptr;
  float* vy = nullptr;
  int* slot = nullptr;  // only for who looks for walls
  float* fx = nullptr;  // force on the receiver, in units of k_s
  float* fy = nullptr;
  int* touching = nullptr;  // per register
  int* doubtful = nullptr;  // pairs that a wall may part
};
/// The columns of CrowdPairs have room for all candidates of a batch and so many more per receiver
/// and per span.
constexpr int kCrowdSpare = 2 * kCrowdLanes;

struct CrowdResult {
  float x = 0.0F, y = 0.0F;  // sum over all pairs, in units of k_s
  int first = 0, last = 0;   // pairs
  int firstDoubtful = 0, lastDoubtful = 0;
  int touching = 0;  // pairs in the receiver's place, itself among them: left out
};

/// Some people who feel by one law. Work on several at once hides the time that one root takes.
struct CrowdBatch {
  CrowdLaw law;
  const CrowdReceiver* receivers = nullptr;
  int count = 0;
  const CrowdSpan* spans = nullptr;
  CrowdResult* results = nullptr;
};

/// One compiled version of the kernel. All give the same bits.
struct CrowdKernel {
  void (*forces)(const CrowdColumns& crowd, const CrowdBatch& batch,
                 const CrowdPairs& pairs) = nullptr;
  /// The sum again, after forces of some pairs were set to zero.
  void (*sum)(const CrowdPairs& pairs, CrowdResult& result) = nullptr;
};

CrowdKernel crowdKernelSse2();
CrowdKernel crowdKernelAvx2();
CrowdKernel crowdKernelAvx512();

/// Instruction sets that the kernel is compiled for.
enum class VectorPath : std::uint8_t { Sse2, Avx2, Avx512 };
const char* vectorPathName(VectorPath path);
bool hasVectorPath(VectorPath path);  // this processor
VectorPath fastestVectorPath();
CrowdKernel kernelOf(VectorPath path);

}  // namespace sim2d
