#pragma once

#include <cstddef>

#include "sim2d/nav/mppi/MppiCosts.h"
#include "sim2d/nav/mppi/MppiKernel.h"
#include "sim2d/nav/mppi/MppiLanes.h"
#include "sim2d/nav/mppi/MppiNoise.h"
#include "sim2d/nav/nav2/mppi/TrajectoryCollisions.h"

/// Rollouts of one register of samples at a time: noise, feasible controls, trajectories, costs.
/// Include exactly once per instruction-set file.
namespace sim2d {
namespace {

/// White noise of unit deviation, one column of kLaneCount per step.
struct NoiseColumns {
  float fresh[3][kMaxMppiSteps * kLaneCount];
  float spare[kMaxMppiSteps * kLaneCount];
};

inline void drawNoise(const MppiProblem& problem, int sample, NoiseColumns& noise) {
  drawNormals(problem.noise, sample, 0, problem.steps, noise.fresh[0], noise.fresh[1]);
  if (problem.drive.isOmnidirectional) {
    drawNormals(problem.noise, sample, 1, problem.steps, noise.fresh[2], noise.spare);
  }
}

/// Trajectory of one register of samples, step by step.
class Rollout {
 public:
  explicit Rollout(const MppiProblem& problem) : problem_(problem) {
    const MppiStart& start = problem.start;
    at_ = {fill(0.0F),         fill(0.0F),          fill(start.cosine), fill(start.sine),
           fill(start.linear), fill(start.angular), fill(start.lateral)};
  }

  /// Applies a control, made feasible, for one step.
  void advance(Lanes linear, Lanes angular, Lanes lateral) {
    const MppiDrive& drive = problem_.drive;
    const Lanes before[3] = {at_.linear, at_.angular, at_.lateral};
    at_.linear = reached(linear, at_.linear, drive.linearStep, drive.lowLinear, drive.highLinear);
    at_.angular =
        reached(angular, at_.angular, drive.angularStep, -drive.highAngular, drive.highAngular);
    if (drive.isOmnidirectional) {
      at_.lateral =
          reached(lateral, at_.lateral, drive.lateralStep, -drive.highLateral, drive.highLateral);
    }
    if (drive.isAckermann) {
      const Lanes most = abs(at_.linear) * fill(drive.mostCurvature);
      at_.angular = clamped(at_.angular, fill(0.0F) - most, most);
    }
    addChanges(before);
    move();
  }

  /// Adds the cost of the pose at this step.
  void weigh(int step) {
    addPathCosts(problem_, at_, sums_);
    for (int i = 0; i < problem_.discCount; ++i) {
      const MppiDisc& disc = problem_.discs[i];
      const Lanes x = at_.x + at_.cosine * fill(disc.x) - at_.sine * fill(disc.y);
      const Lanes y = at_.y + at_.sine * fill(disc.x) + at_.cosine * fill(disc.y);
      addWallCosts(problem_, disc, x, y, sums_);
      addPeopleCosts(problem_, step, x, y, sums_);
    }
    if (problem_.zoneCount > 0) {
      addZoneCosts(problem_, at_, sums_);
    }
    if (problem_.isSocial && step % kComfortStride == 0) {
      addComfortCosts(problem_, step, at_, sums_);
    }
  }

  /// `controlCost`: control cost of the noise.
  void finish(Lanes controlCost, float* cost, float* hits) const {
    const Lanes perStep = fill(1.0F / static_cast<float>(problem_.steps));
    const MppiCosts& costs = problem_.costs;
    const Lanes share = sums_.hits * perStep;
    store(cost, sums_.cost * perStep + fill(costs.end) * sums_.toGo + fill(costs.hit) * share +
                    controlCost);
    store(hits, share);
  }

  const RolloutState& state() const { return at_; }

 private:
  static Lanes reached(Lanes wanted, Lanes now, float step, float low, float high) {
    return clamped(wanted, max(fill(low), now - fill(step)), min(fill(high), now + fill(step)));
  }

  void addChanges(const Lanes (&before)[3]) {
    const MppiCosts& costs = problem_.costs;
    const Lanes linear = at_.linear - before[0];
    const Lanes angular = at_.angular - before[1];
    const Lanes lateral = at_.lateral - before[2];
    sums_.cost = sums_.cost + fill(costs.changeLinear) * (linear * linear) +
                 fill(costs.changeAngular) * (angular * angular) +
                 fill(costs.changeLateral) * (lateral * lateral);
  }

  /// Half the rotation, the translation, the other half (error: third order in the rotation).
  void move() {
    const Lanes half = at_.angular * fill(0.5F * problem_.dt);
    const Lanes half2 = half * half;
    const Lanes one = fill(1.0F);
    const Lanes sine =
        half * (one - half2 * fill(1.0F / 6.0F) * (one - half2 * fill(1.0F / 20.0F)));
    const Lanes cosine =
        one - half2 * fill(0.5F) *
                  (one - half2 * fill(1.0F / 12.0F) * (one - half2 * fill(1.0F / 30.0F)));
    turn(cosine, sine);
    const Lanes dt = fill(problem_.dt);
    at_.x = at_.x + dt * (at_.linear * at_.cosine - at_.lateral * at_.sine);
    at_.y = at_.y + dt * (at_.linear * at_.sine + at_.lateral * at_.cosine);
    turn(cosine, sine);
  }

  void turn(Lanes cosine, Lanes sine) {
    const Lanes turned = at_.cosine * cosine - at_.sine * sine;
    at_.sine = at_.sine * cosine + at_.cosine * sine;
    at_.cosine = turned;
  }

  const MppiProblem& problem_;
  RolloutState at_;
  RolloutSums sums_;
};

inline void storeControls(const MppiSamples& samples, const RolloutState& at, int place,
                          bool isOmnidirectional) {
  store(samples.controls[0] + place, at.linear);
  store(samples.controls[1] + place, at.angular);
  if (isOmnidirectional) {
    store(samples.controls[2] + place, at.lateral);
  }
}

inline void drawRegister(const MppiProblem& problem, const MppiSamples& samples, int first,
                         NoiseColumns& noise) {
  drawNoise(problem, first, noise);
  Rollout rollout(problem);
  const float deviation[3] = {problem.noise.linear, problem.noise.angular, problem.noise.lateral};
  const int axes = problem.drive.isOmnidirectional ? 3 : 2;
  Lanes drift[3] = {fill(0.0F), fill(0.0F), fill(0.0F)};
  Lanes wanted[3] = {fill(0.0F), fill(0.0F), fill(0.0F)};
  Lanes controlCost = fill(0.0F);
  for (int step = 0; step < problem.steps; ++step) {
    const Lanes keep = fill(step == 0 ? 0.0F : problem.noise.keep);
    const Lanes share = fill(step == 0 ? 1.0F : problem.noise.fresh);
    for (int axis = 0; axis < axes; ++axis) {
      const Lanes fresh = load(noise.fresh[axis] + static_cast<std::ptrdiff_t>(step) * kLaneCount);
      drift[axis] = keep * drift[axis] + share * fresh;
      wanted[axis] = fill(problem.mean[axis][step]) + fill(deviation[axis]) * drift[axis];
      controlCost = controlCost + fill(problem.pull[axis][step]) * fresh;
    }
    rollout.advance(wanted[0], wanted[1], wanted[2]);
    storeControls(samples, rollout.state(), step * samples.stride + first, axes == 3);
    rollout.weigh(step);
  }
  rollout.finish(controlCost, samples.costs + first, samples.hits + first);
}

inline void weighRegister(const MppiProblem& problem, const MppiSamples& samples, int first) {
  Rollout rollout(problem);
  const bool isOmnidirectional = problem.drive.isOmnidirectional;
  for (int step = 0; step < problem.steps; ++step) {
    const int place = step * samples.stride + first;
    rollout.advance(load(samples.controls[0] + place), load(samples.controls[1] + place),
                    isOmnidirectional ? load(samples.controls[2] + place) : fill(0.0F));
    storeControls(samples, rollout.state(), place, isOmnidirectional);
    rollout.weigh(step);
  }
  rollout.finish(fill(0.0F), samples.costs + first, samples.hits + first);
}

inline void drawSamples(const MppiProblem& problem, const MppiSamples& samples, int first,
                        int last) {
  NoiseColumns noise;
  for (int sample = first; sample < last; sample += kLaneCount) {
    drawRegister(problem, samples, sample, noise);
  }
}

inline void weighSamples(const MppiProblem& problem, const MppiSamples& samples, int first,
                         int last) {
  for (int sample = first; sample < last; sample += kLaneCount) {
    weighRegister(problem, samples, sample);
  }
}

/// Accumulates in columns, then always adds them in the same order.
inline float weightedSum(const float* weights, const float* values, int count) {
  float columns[kMppiColumns];
  for (int lane = 0; lane < kMppiColumns; lane += kLaneCount) {
    Lanes sum = fill(0.0F);
    for (int i = lane; i < count; i += kMppiColumns) {
      sum = sum + load(weights + i) * load(values + i);
    }
    store(columns + lane, sum);
  }
  return sumOfColumns(columns);
}

}  // namespace

namespace nav2 {
namespace {

inline CompiledKernels compiledKernels() {
  return {{drawSamples, weighSamples, weightedSum},
          {drawTrajectoryNoise, rolloutTrajectories, nearestPathPoints, scoreConstraint, scoreCost,
           scoreObstacles, scoreGoal, scoreGoalAngle, scoreAlign, scoreFollow, scoreAngle,
           scoreForward, scoreTwirling, scoreDeadband, meanOfControls}};
}

}  // namespace
}  // namespace nav2
}  // namespace sim2d
