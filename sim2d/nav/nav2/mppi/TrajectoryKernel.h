#pragma once

#include <cstdint>

#include "sim2d/nav/mppi/MppiKernel.h"

/// Interface of the vectorized code of Nav2's MPPI. Plain data only, because the code is compiled
/// once per instruction set (see sim2d/nav/mppi/README.md). Single precision and absolute
/// positions, as in Nav2.
namespace sim2d::nav2 {

constexpr int kTrajectoryAxes = 3;  // vx [m/s], wz [rad/s], vy [m/s]

/// All trajectories of an iteration, in blocks of kMppiColumns samples: the element of a step and
/// sample is at (sample / kMppiColumns * steps + step) * kMppiColumns + sample % kMppiColumns.
struct TrajectoryBatch {
  int samples = 0;  // a multiple of kMppiColumns; the last ones may be padding
  int steps = 0;
  float* noise[kTrajectoryAxes] = {};
  float* controls[kTrajectoryAxes] = {};  // averaged controls: c of Nav2's state
  float* speeds[kTrajectoryAxes] = {};    // predicted velocities
  float *x = nullptr, *y = nullptr;       // [m], after the step
  float* yaw = nullptr;                   // [rad], after the step, not wrapped
  float* length = nullptr;                // driven length, per sample [m]
  float* controlCost = nullptr;           // control cost (gamma), per sample
};

/// Parameters of the rollout from controls to trajectories.
struct RolloutProblem {
  float x = 0.0F, y = 0.0F, yaw = 0.0F;  // robot pose
  float speed[kTrajectoryAxes] = {};     // at step 0
  float dt = 0.05F;                      // [s]
  bool isHolonomic = false;
  bool isLimited = true;               // by accelerations (since Jazzy)
  bool writesLimitedControls = false;  // replaces the controls by the limited ones
  float least[kTrajectoryAxes] = {}, most[kTrajectoryAxes] = {};  // change per step, <= 0, >= 0
  int delay[kTrajectoryAxes] = {};                                // steps before a control acts
  const float* mean[kTrajectoryAxes] = {};                        // last optimal sequence
  float controlCost[kTrajectoryAxes] = {};                        // gamma / std²
};

/// Output of a critic: (weight * raw)^power of each sample, also added to `costs`.
struct ScoreSink {
  float weight = 1.0F;
  int power = 1;
  float* costs = nullptr;
  float* scores = nullptr;
};

/// A costmap. The cost outside is 255.
struct CostCells {
  const float* costs = nullptr;  // row-major
  int columns = 0, rows = 0;
  float x = 0.0F, y = 0.0F;  // lower left corner [m]
  float resolution = 0.05F;  // [m]
};

/// The maximum cost on the edges of the footprint at a pose.
struct FootprintCostCallback {
  float (*cost)(const void* scene, float x, float y, float yaw) = nullptr;
  const void* scene = nullptr;
};

/// Collision check of CostCritic and ObstaclesCritic.
struct CollisionProblem {
  CostCells cells;
  bool tracksUnknown = false;  // 255 is no collision
  bool considersFootprint = false;
  float possible = 0.0F;  // edges of poses whose centre costs less touch nothing; < 1: check all
  FootprintCostCallback footprintCost;
  float* hits = nullptr;  // per sample; 1: collides
};

struct CostProblem {
  CollisionProblem collision;
  float collisionCost = 1e6F, criticalCost = 300.0F, nearCollisionCost = 253.0F;
  bool isNearGoal = false;
  int pointStep = 2, points = 28;
};

struct ObstaclesProblem {
  CollisionProblem collision;
  float collisionCost = 1e5F;
  float margin = 0.1F;            // [m]
  float inflationRadius = 0.55F;  // [m]
  bool hasInflation = true;
  bool isNearGoal = false;
  bool repelsOutsideOnly = false;          // Humble: no repulsion within the margin
  const float* centreDistances = nullptr;  // by cost 0 to 255 [m]
  const float* edgeDistances = nullptr;
  float* margins = nullptr;     // per sample: depth within the margin [m], or collision cost
  float* repulsions = nullptr;  // per sample [m]
};

struct ConstraintProblem {
  enum class Model : std::uint8_t { Linear, Planar, LinearAndLateral, Ackermann };
  Model model = Model::Linear;
  float low = -0.35F, high = 0.5F, lateral = 0.5F;  // [m/s]
  float turningRadius = 0.2F;                       // [m]
  float dt = 0.05F;                                 // [s]
};

struct DeadbandProblem {
  float deadband[kTrajectoryAxes] = {};  // [m/s], [rad/s], [m/s]
  bool isHolonomic = false;
  float dt = 0.05F;  // [s]
};

/// The local path up to its end.
struct PathPoints {
  const float *x = nullptr, *y = nullptr, *yaw = nullptr;
  const float* way = nullptr;    // path length from the first point [m]; infinite after the last
  const float* valid = nullptr;  // 1: usable for alignment
  int count = 0;
};

struct AlignProblem {
  PathPoints path;
  int pointStep = 4;
  bool usesOrientations = false;
};

/// Angle between the robot's heading and the direction to a point.
struct AngleProblem {
  enum class Mode : std::uint8_t { Forward, EitherEnd, AlongPath };
  Mode mode = Mode::Forward;
  bool isMean = false;  // mean of all steps instead of the last one
  float x = 0.0F, y = 0.0F, yaw = 0.0F;
};

/// One compiled version. All versions give bit-identical results.
struct TrajectoryKernel {
  /// Counter-based normal noise with these standard deviations.
  void (*draw)(const MppiNoise& noise, const float* deviations, int axes,
               const TrajectoryBatch& batch);
  void (*roll)(const RolloutProblem& problem, const TrajectoryBatch& batch);
  /// Index of the path point nearest to the end of each sample; if `slack` [m] is finite, at most
  /// the driven length plus `slack` along the path.
  void (*nearest)(const PathPoints& path, float slack, const TrajectoryBatch& batch,
                  float* indices);
  void (*constraint)(const ConstraintProblem& problem, const TrajectoryBatch& batch,
                     const ScoreSink& sink);
  void (*cost)(const CostProblem& problem, const TrajectoryBatch& batch, const ScoreSink& sink);
  void (*obstacles)(const ObstaclesProblem& problem, const TrajectoryBatch& batch);
  void (*goal)(float x, float y, const TrajectoryBatch& batch, const ScoreSink& sink);
  void (*goalAngle)(float yaw, bool isSymmetric, const TrajectoryBatch& batch,
                    const ScoreSink& sink);
  void (*align)(const AlignProblem& problem, const TrajectoryBatch& batch, const ScoreSink& sink);
  void (*follow)(float x, float y, const TrajectoryBatch& batch, const ScoreSink& sink);
  void (*angle)(const AngleProblem& problem, const TrajectoryBatch& batch, const ScoreSink& sink);
  void (*forward)(float dt, const TrajectoryBatch& batch, const ScoreSink& sink);
  void (*twirling)(const TrajectoryBatch& batch, const ScoreSink& sink);
  void (*deadband)(const DeadbandProblem& problem, const TrajectoryBatch& batch,
                   const ScoreSink& sink);
  /// Weighted mean of the controls of an axis; the weights of the samples sum to 1.
  void (*mean)(const TrajectoryBatch& batch, const float* weights, int axis, float* sequence);
};

TrajectoryKernel trajectoryKernelOf(MppiSimdLevel path);

/// The kernels of both planners for one instruction set.
struct CompiledKernels {
  MppiKernel mppi;
  TrajectoryKernel trajectories;
};
CompiledKernels kernelsForSse2();
CompiledKernels kernelsForAvx2();
CompiledKernels kernelsForAvx512();

}  // namespace sim2d::nav2
