#pragma once

#include <cstddef>

#include "sim2d/nav/mppi/MppiLanes.h"
#include "sim2d/nav/mppi/MppiNoise.h"
#include "sim2d/nav/nav2/mppi/TrajectoryKernel.h"

/// Noise, kinematic limits, integration of trajectories, and mean of the controls. Include once in
/// the source file of each instruction set.
namespace sim2d::nav2 {
namespace {

inline std::size_t blockElementIndex(const TrajectoryBatch& batch, int sample) {
  const auto block = static_cast<std::size_t>(sample / kMppiColumns);
  return block * static_cast<std::size_t>(batch.steps) * kMppiColumns +
         static_cast<std::size_t>(sample % kMppiColumns);
}

/// Calls `work(sample, place)` for each register of samples; consecutive steps are kMppiColumns
/// apart.
template <class Work>
inline void forEachRegister(const TrajectoryBatch& batch, const Work& work) {
  for (int sample = 0; sample < batch.samples; sample += kLaneCount) {
    work(sample, blockElementIndex(batch, sample));
  }
}

inline void drawTrajectoryNoise(const MppiNoise& noise, const float* deviations, int axes,
                                const TrajectoryBatch& batch) {
  float drawn[4][(kMaxMppiSteps + 1) * kLaneCount];
  forEachRegister(batch, [&](int sample, std::size_t start) {
    drawNormals(noise, sample, 0, batch.steps, drawn[0], drawn[1]);
    if (axes == kTrajectoryAxes) {
      drawNormals(noise, sample, 1, batch.steps, drawn[2], drawn[3]);
    }
    for (int axis = 0; axis < axes; ++axis) {
      float* to = batch.noise[axis] + start;
      for (int step = 0; step < batch.steps; ++step) {
        const Lanes one = load(drawn[axis] + static_cast<std::ptrdiff_t>(step) * kLaneCount);
        store(to + static_cast<std::ptrdiff_t>(step) * kMppiColumns, fill(deviations[axis]) * one);
      }
    }
  });
}

/// Sine and cosine of any angle [rad]; error 1e-7 plus that of the angle itself.
inline LaneDirection directionOfLanes(Lanes angle) {
  const Lanes whole = fill(12582912.0F);  // 1.5 * 2^23: adding it rounds to an integer
  const Lanes turns = angle * fill(0.159154943F);
  return directionOfTurn(turns - ((turns + whole) - whole));
}

/// The reachable velocity nearest to `wanted`: a robot driving forward may gain `most` and lose
/// `least`; for a reversing or standing one they are swapped.
inline Lanes reachedSpeed(Lanes wanted, Lanes now, float least, float most) {
  const LaneMask isAhead = fill(0.0F) < now;
  const Lanes low = now + select(isAhead, fill(least), fill(-most));
  const Lanes high = now + select(isAhead, fill(most), fill(-least));
  return clamped(wanted, low, high);
}

/// Computes controls and velocities of one axis.
inline void predictAxis(const RolloutProblem& problem, const TrajectoryBatch& batch, int axis,
                        std::size_t start) {
  float* const controls = batch.controls[axis] + start;
  float* const speeds = batch.speeds[axis] + start;
  const float* const noise = batch.noise[axis] + start;
  const int delay = problem.delay[axis];
  Lanes speed = fill(problem.speed[axis]);
  for (int step = 0; step < batch.steps; ++step) {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(step) * kMppiColumns;
    store(controls + at, fill(problem.mean[axis][step]) + load(noise + at));
    const int from = step - 1 - delay;
    if (from >= 0) {
      float* const control = controls + static_cast<std::ptrdiff_t>(from) * kMppiColumns;
      const Lanes wanted = load(control);
      speed = problem.isLimited
                  ? reachedSpeed(wanted, speed, problem.least[axis], problem.most[axis])
                  : wanted;
      if (problem.writesLimitedControls) {
        store(control, speed);
      }
    }
    store(speeds + at, speed);
  }
}

/// gamma / std² times the sum over the steps of u (c - u).
inline Lanes controlCostOfAxis(const RolloutProblem& problem, const TrajectoryBatch& batch,
                               int axis, std::size_t start) {
  Lanes sum = fill(0.0F);
  for (int step = 0; step < batch.steps; ++step) {
    const Lanes mean = fill(problem.mean[axis][step]);
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(step) * kMppiColumns;
    sum = sum + mean * (load(batch.controls[axis] + start + at) - mean);
  }
  return fill(problem.controlCost[axis]) * sum;
}

/// Integrates a register of samples; each step uses the heading at its start.
inline Lanes integrateRegister(const RolloutProblem& problem, const TrajectoryBatch& batch,
                               std::size_t start) {
  const Lanes dt = fill(problem.dt);
  LaneDirection heading = directionOfLanes(fill(problem.yaw));
  Lanes turned = fill(0.0F);
  Lanes x = fill(0.0F);
  Lanes y = fill(0.0F);
  Lanes length = fill(0.0F);
  for (int step = 0; step < batch.steps; ++step) {
    const std::size_t at = start + static_cast<std::size_t>(step) * kMppiColumns;
    const Lanes vx = load(batch.speeds[0] + at);
    if (problem.isHolonomic) {
      const Lanes vy = load(batch.speeds[2] + at);
      x = x + (vx * heading.cosine - vy * heading.sine) * dt;
      y = y + (vx * heading.sine + vy * heading.cosine) * dt;
      length = length + sqrt(vx * vx + vy * vy) * dt;
    } else {
      x = x + vx * heading.cosine * dt;
      y = y + vx * heading.sine * dt;
      length = length + abs(vx) * dt;
    }
    turned = turned + load(batch.speeds[1] + at) * dt;
    const Lanes yaw = fill(problem.yaw) + turned;
    heading = directionOfLanes(yaw);
    store(batch.x + at, fill(problem.x) + x);
    store(batch.y + at, fill(problem.y) + y);
    store(batch.yaw + at, yaw);
  }
  return length;
}

inline void rolloutTrajectories(const RolloutProblem& problem, const TrajectoryBatch& batch) {
  const int axes = problem.isHolonomic ? 3 : 2;
  forEachRegister(batch, [&](int sample, std::size_t start) {
    Lanes controlCost = fill(0.0F);
    for (int axis = 0; axis < axes; ++axis) {
      predictAxis(problem, batch, axis, start);
      controlCost = controlCost + controlCostOfAxis(problem, batch, axis, start);
    }
    store(batch.controlCost + sample, controlCost);
    store(batch.length + sample, integrateRegister(problem, batch, start));
  });
}

/// Sums by columns in a fixed order. Skips blocks with zero weight.
inline void meanOfControls(const TrajectoryBatch& batch, const float* weights, int axis,
                           float* sequence) {
  float sums[kMaxMppiSteps * kMppiColumns] = {};
  const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(batch.steps) * kMppiColumns;
  for (int block = 0; block < batch.samples; block += kMppiColumns) {
    float heaviest = 0.0F;
    for (int i = 0; i < kMppiColumns; ++i) {
      heaviest = weights[block + i] > heaviest ? weights[block + i] : heaviest;
    }
    if (heaviest == 0.0F) {
      continue;
    }
    const float* const controls = batch.controls[axis] + blockElementIndex(batch, block);
    for (int lane = 0; lane < kMppiColumns; lane += kLaneCount) {
      const Lanes weight = load(weights + block + lane);
      for (std::ptrdiff_t at = lane; at < size; at += kMppiColumns) {
        store(sums + at, load(sums + at) + weight * load(controls + at));
      }
    }
  }
  for (int step = 0; step < batch.steps; ++step) {
    sequence[step] = sumOfColumns(sums + static_cast<std::ptrdiff_t>(step) * kMppiColumns);
  }
}

}  // namespace
}  // namespace sim2d::nav2
