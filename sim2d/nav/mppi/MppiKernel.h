#pragma once

#include <cstdint>

/// What the vector code of MPPI is given and gives back. Plain data only: the code is compiled once
/// per instruction set, and nothing that these files share may be compiled with the flags of one of
/// them. Lengths in [m] from the robot's place, along the axes of the world.
namespace sim2d {

constexpr int kMostMppiSteps = 200;
constexpr int kMppiColumns = 16;  // samples come in multiples of it; sums too
/// Upper byte of the fourth word of the counter: base::Draw::Mppi.
constexpr std::uint32_t kMppiDraw = 11U << 24U;

/// Whose draws, and how large the noise is. It has the standard deviation below at every step and
/// the correlation keep^k over k steps.
struct MppiNoise {
  std::uint32_t key[2] = {1, 0};  // the seed
  std::uint32_t robot = 0, call = 0;
  float linear = 0.2F, angular = 0.4F, lateral = 0.2F;  // [m/s], [rad/s], [m/s]
  float keep = 0.0F, fresh = 1.0F;                      // keep² + fresh² = 1
};

/// Limits of the drive; the last three per step.
struct MppiDrive {
  float lowLinear = -1.0F, highLinear = 1.0F, highAngular = 1.5F, highLateral = 0.0F;
  float linearStep = 0.05F, angularStep = 0.15F, lateralStep = 0.0F;
  bool isOmnidirectional = false;
  bool isAckermann = false;
  float mostCurvature = 0.0F;  // Ackermann: |omega| <= mostCurvature |v| [1/m]
};

struct MppiStart {
  float cosine = 1.0F, sine = 0.0F;                     // of the heading
  float linear = 0.0F, angular = 0.0F, lateral = 0.0F;  // own motion
};

/// Values at nodes, row-major, bilinear between them; outside the value at the border.
struct MppiGrid {
  const float* values = nullptr;
  int columns = 2, rows = 2;
  float x = 0.0F, y = 0.0F;  // of the first node
  float perMetre = 1.0F;     // nodes
};

/// A disc of the footprint, robot frame.
struct MppiDisc {
  float x = 0.0F, y = 0.0F, radius = 0.35F;
};

/// Somebody at one step. The first four are all that plain MPPI looks at.
struct MppiPerson {
  float x = 0.0F, y = 0.0F;
  float far2 = 1.0F;                             // square of the distance from which on it costs
  float perBand = 1.0F;                          // 1 / (far2 - square of the distance of touch)
  float touch = 0.7F;                            // distance of touch
  float vx = 0.0F, vy = 0.0F;                    // [m/s]
  float hx = 1.0F, hy = 0.0F;                    // heading
  float front = 1.0F, rear = 1.0F, side = 1.0F;  // log2(e) / (2 variance) [1/m²]
  float perStrip = 0.0F;                         // 1 / length of the way walked soon [1/m]
  float walks = 0.0F;                            // 1: walks, 0: stands
  float comfort = 1.0F;                          // 1: a person, 0: a robot, which feels nothing
};

/// A disc that is better left free for the whole plan.
struct MppiZone {
  float x = 0.0F, y = 0.0F;
  float perRadius2 = 1.0F;  // [1/m²]
  float weight = 0.0F;
};

/// Weights; all but `end` are of means over the steps.
struct MppiCosts {
  float goal = 5.0F;     // of the distance to go [1/m]
  float end = 0.0F;      // idem, at the last step
  float heading = 0.0F;  // of (1 - cos) / 2 of the angle to the way
  float reverse = 0.0F;  // of the speed backwards [s/m]
  float stop = 0.0F;     // of v² inside the goal [s²/m²]
  float wall = 0.0F, perWallRange = 2.0F;
  float person = 0.0F;
  float hit = 0.0F;  // per share of steps in touch
  float changeLinear = 0.0F, changeAngular = 0.0F, changeLateral = 0.0F;  // of squares per step
  float goalRadius = 0.2F;                                                // [m]
  float wallMargin = 0.02F;  // [m]; nearer counts as touch
};

/// Weights of what people feel; the terms are in SocialMppi's table.
struct MppiSocial {
  float intimate = 0.0F, perIntimate = 2.2F;  // 1 / width of the zone [1/m]
  float personal = 0.0F, perPersonal = 0.8F;
  float space = 0.0F;
  float touchTime = 0.0F, fromTouchTime = 3.0F;  // [s]
  float relativeSpeed = 0.0F;                    // [s²/m²]
  float strip = 0.0F, perStripWidth = 1.0F;      // [1/m]
  float legible = 0.0F, perPass = 1.0F;          // 1 / room to pass [1/m]
  float perLegible = 0.2F;                       // 1 / distance from which on it matters [1/m]
};

/// One call of the planner.
struct MppiProblem {
  MppiStart start;
  MppiDrive drive;
  MppiNoise noise;
  MppiCosts costs;
  MppiSocial social;
  bool isSocial = false;
  float dt = 0.05F;  // [s]
  int steps = 56;
  MppiGrid clearance, distance;  // to walls; to go to the goal
  const MppiDisc* discs = nullptr;
  int discCount = 0;
  const MppiPerson* people = nullptr;  // by step
  const int* firstPerson = nullptr;    // of each step, and the end
  const MppiZone* zones = nullptr;
  int zoneCount = 0;
  const float* mean[3] = {};  // linear, angular, lateral per step: what noise is added to
  const float* pull[3] = {};  // cost per unit of the step's fresh noise; see MppiUpdate.h
};

/// Columns of controls: number `sample` of `step` is at step * stride + sample.
struct MppiSamples {
  float* controls[3] = {};  // linear, angular, lateral
  int stride = 0;
  float* costs = nullptr;
  float* hits = nullptr;  // share of steps in touch with something, more the deeper; 0: none
};

/// One compiled version of the kernel. All give the same bits.
struct MppiKernel {
  /// Draws the controls of samples `first` up to before `last` (multiples of kMppiColumns), makes
  /// them feasible and weighs them.
  void (*draw)(const MppiProblem& problem, const MppiSamples& samples, int first,
               int last) = nullptr;
  /// The same with the controls that are there.
  void (*weigh)(const MppiProblem& problem, const MppiSamples& samples, int first,
                int last) = nullptr;
  /// Sum of weight * value over `count` samples, in kMppiColumns columns.
  float (*sum)(const float* weights, const float* values, int count) = nullptr;
};

MppiKernel mppiKernelSse2();
MppiKernel mppiKernelAvx2();
MppiKernel mppiKernelAvx512();

/// Instruction sets that the kernel is compiled for.
enum class MppiPath : std::uint8_t { Sse2, Avx2, Avx512 };
bool hasMppiPath(MppiPath path);  // this processor
MppiPath fastestMppiPath();
MppiKernel mppiKernelOf(MppiPath path);

}  // namespace sim2d
