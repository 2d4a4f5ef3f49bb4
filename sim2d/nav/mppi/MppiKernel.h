#pragma once

#include <cstdint>

/// Input and output of the MPPI vector code. Plain data only: the code is compiled once per
/// instruction set, and nothing shared by these files may be compiled with the flags of one of
/// them. Lengths in [m] from the robot's position, along the world axes.
namespace sim2d {

constexpr int kMaxMppiSteps = 200;
constexpr int kMppiColumns = 16;  // number of samples is a multiple of it; sums use as many columns
/// Upper byte of the fourth counter word: base::DrawPurpose::Mppi.
constexpr std::uint32_t kMppiDraw = 11U << 24U;

/// Seed and scale of the noise. It has the standard deviations below at every step and the
/// correlation keep^k over k steps.
struct MppiNoise {
  std::uint32_t key[2] = {1, 0};  // the seed
  std::uint32_t robot = 0, call = 0;
  float linear = 0.2F, angular = 0.4F, lateral = 0.2F;  // [m/s], [rad/s], [m/s]
  float keep = 0.0F, fresh = 1.0F;                      // keep² + fresh² = 1
};

/// Limits of the drive; `linearStep`, `angularStep` and `lateralStep` are changes per step.
struct MppiDrive {
  float lowLinear = -1.0F, highLinear = 1.0F, highAngular = 1.5F, highLateral = 0.0F;
  float linearStep = 0.05F, angularStep = 0.15F, lateralStep = 0.0F;
  bool isOmnidirectional = false;
  bool isAckermann = false;
  float mostCurvature = 0.0F;  // Ackermann: |omega| <= mostCurvature |v| [1/m]
};

struct MppiStart {
  float cosine = 1.0F, sine = 0.0F;                     // of the heading
  float linear = 0.0F, angular = 0.0F, lateral = 0.0F;  // current velocity
};

/// Row-major values at nodes, interpolated bilinearly; clamped to the border outside.
struct MppiGrid {
  const float* values = nullptr;
  int columns = 2, rows = 2;
  float x = 0.0F, y = 0.0F;  // first node
  float perMetre = 1.0F;     // nodes per metre
};

/// A disc of the footprint, robot frame.
struct MppiDisc {
  float x = 0.0F, y = 0.0F, radius = 0.35F;
};

/// One person or robot at one step. Plain MPPI uses the first four members only.
struct MppiPerson {
  float x = 0.0F, y = 0.0F;
  float far2 = 1.0F;                             // squared distance beyond which it costs nothing
  float perBand = 1.0F;                          // 1 / (far2 - squared contact distance)
  float touch = 0.7F;                            // contact distance
  float vx = 0.0F, vy = 0.0F;                    // [m/s]
  float hx = 1.0F, hy = 0.0F;                    // heading
  float front = 1.0F, rear = 1.0F, side = 1.0F;  // log2(e) / (2 variance) [1/m²]
  float perStrip = 0.0F;                         // 1 / length of the path walked next [1/m]
  float walks = 0.0F;                            // 1: walking, 0: standing
  float comfort = 1.0F;                          // 1: a person, 0: a robot
};

/// A disc that should stay free during the whole plan.
struct MppiZone {
  float x = 0.0F, y = 0.0F;
  float perRadius2 = 1.0F;  // [1/m²]
  float weight = 0.0F;
};

/// Cost weights; all except `end` apply to means over the steps.
struct MppiCosts {
  float goal = 5.0F;     // of the remaining distance [1/m]
  float end = 0.0F;      // same, at the last step
  float heading = 0.0F;  // of (1 - cos) / 2 of the angle to the path
  float reverse = 0.0F;  // of the reverse speed [s/m]
  float stop = 0.0F;     // of v² inside the goal [s²/m²]
  float wall = 0.0F, perWallRange = 2.0F;
  float person = 0.0F;
  float hit = 0.0F;  // per fraction of steps in contact
  float changeLinear = 0.0F, changeAngular = 0.0F, changeLateral = 0.0F;  // of squared changes
  float goalRadius = 0.2F;                                                // [m]
  float wallMargin = 0.02F;  // [m]; smaller gaps count as contact
};

/// Weights of the comfort costs; the terms are documented in SocialMppi's parameter table.
struct MppiSocial {
  float intimate = 0.0F, perIntimate = 2.2F;  // 1 / width of the zone [1/m]
  float personal = 0.0F, perPersonal = 0.8F;
  float space = 0.0F;
  float touchTime = 0.0F, fromTouchTime = 3.0F;  // [s]
  float relativeSpeed = 0.0F;                    // [s²/m²]
  float strip = 0.0F, perStripWidth = 1.0F;      // [1/m]
  float legible = 0.0F, perPass = 1.0F;          // 1 / passing gap [1/m]
  float perLegible = 0.2F;                       // 1 / distance at which it starts [1/m]
};

/// Input of one call of the planner.
struct MppiProblem {
  MppiStart start;
  MppiDrive drive;
  MppiNoise noise;
  MppiCosts costs;
  MppiSocial social;
  bool isSocial = false;
  float dt = 0.05F;  // [s]
  int steps = 56;
  MppiGrid clearance, distance;  // to walls; remaining path to the goal
  const MppiDisc* discs = nullptr;
  int discCount = 0;
  const MppiPerson* people = nullptr;  // grouped by step
  const int* firstPerson = nullptr;    // index per step, plus the end
  const MppiZone* zones = nullptr;
  int zoneCount = 0;
  const float* mean[3] = {};  // linear, angular, lateral per step; noise is added to them
  const float* pull[3] = {};  // cost per unit of the step's fresh noise; see MppiUpdate.h
};

/// Controls by column: sample `sample` of `step` is at step * stride + sample.
struct MppiSamples {
  float* controls[3] = {};  // linear, angular, lateral
  int stride = 0;
  float* costs = nullptr;
  float* hits = nullptr;  // fraction of steps in contact, larger for deeper contact; 0: none
};

/// One compiled version of the kernel. All versions give bit-identical results.
struct MppiKernel {
  /// Draws the controls of samples [first, last) (multiples of kMppiColumns), makes them feasible
  /// and evaluates their costs.
  void (*draw)(const MppiProblem& problem, const MppiSamples& samples, int first,
               int last) = nullptr;
  /// Same with the existing controls.
  void (*weigh)(const MppiProblem& problem, const MppiSamples& samples, int first,
                int last) = nullptr;
  /// Sum of weight * value over `count` samples, accumulated in kMppiColumns columns.
  float (*sum)(const float* weights, const float* values, int count) = nullptr;
};

/// Instruction sets for which the kernel is compiled.
enum class MppiSimdLevel : std::uint8_t { Sse2, Avx2, Avx512 };
bool isMppiSimdLevelSupported(MppiSimdLevel path);  // supported by this processor
MppiSimdLevel fastestMppiSimdLevel();
MppiKernel mppiKernelFor(MppiSimdLevel path);

}  // namespace sim2d
