#pragma once

/// What the vector code of the social force is given and gives back. Plain data only: the code is
/// compiled once per instruction set, and nothing that these files share may be compiled with the
/// flags of one of them.
namespace sim2d {

/// Survivors of the cut-off are summed in this many columns, whatever the registers hold.
constexpr int kCrowdLanes = 16;
/// [m]; bodies nearer than this to each other are left to the scalar code, which knows their ids.
constexpr float kCrowdTouching = 1e-4F;

/// People in columns, relative to the middle of the crowd.
struct CrowdColumns {
  float* x = nullptr;  // [m]
  float* y = nullptr;
  float* vx = nullptr;  // [m/s]
  float* vy = nullptr;
  float* room = nullptr;  // to the next wall [m]
};

/// One person and the parameters of the force (ForceParameters has their meaning).
struct CrowdReceiver {
  float x = 0.0F, y = 0.0F, vx = 0.0F, vy = 0.0F, room = 0.0F;
  float lambda = 0.0F, gamma = 0.0F, n = 0.0F, nPrime = 0.0F, epsilon = 0.0F;
  float cutOff = 0.0F;        // -ln of the share of k_s that is left out
  bool seesWalls = true;      // forces do not go through walls
  int candidates = 0;         // filled up with NaN to a multiple of `kCrowdLanes`
  float leastLooked = 1e-4F;  // smaller ones, in units of k_s, are not worth a look for walls
};

/// What the kernel writes per pair; each column has room for all candidates and one register more.
struct CrowdPairs {
  float* dx = nullptr;  // from the receiver to the other
  float* dy = nullptr;
  float* dvx = nullptr;  // of the receiver less the other's
  float* dvy = nullptr;
  int* index = nullptr;  // of the candidate
  float* fx = nullptr;   // force on the receiver, in units of k_s
  float* fy = nullptr;
  int* doubtful = nullptr;  // pairs that a wall may part
};

struct CrowdResult {
  float x = 0.0F, y = 0.0F;  // sum over all pairs, in units of k_s
  int pairs = 0;
  int doubtful = 0;
  int touching = 0;  // candidates in the receiver's place, itself among them
};

/// One compiled version of the kernel. All give the same bits.
struct CrowdKernel {
  CrowdResult (*force)(const CrowdColumns& candidates, const CrowdReceiver& receiver,
                       const CrowdPairs& pairs) = nullptr;
  /// The same sum again, after forces of some pairs were set to zero.
  void (*sum)(const CrowdPairs& pairs, CrowdResult& result) = nullptr;
  /// Copies `count` people; reads and writes up to `kCrowdLanes` more.
  void (*append)(const CrowdColumns& from, int begin, int count, const CrowdColumns& into,
                 int at) = nullptr;
};

CrowdKernel crowdKernelSse2();
CrowdKernel crowdKernelAvx2();
CrowdKernel crowdKernelAvx512();

}  // namespace sim2d
