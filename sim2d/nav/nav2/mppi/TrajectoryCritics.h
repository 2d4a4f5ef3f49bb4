#pragma once

#include <cstddef>

#include "sim2d/nav/mppi/MppiLanes.h"
#include "sim2d/nav/nav2/mppi/TrajectoryKernel.h"
#include "sim2d/nav/nav2/mppi/TrajectoryRollout.h"

/// Critics that use velocities, positions and headings. Include once in the source file of each
/// instruction set.
namespace sim2d::nav2 {
namespace {

inline std::size_t stepOffset(int step) {
  return static_cast<std::size_t>(step) * kMppiColumns;
}

/// Adds (weight * raw)^power to the costs of the samples.
inline void addScore(const ScoreSink& sink, int sample, Lanes raw) {
  const Lanes weighted = fill(sink.weight) * raw;
  Lanes score = weighted;
  for (int i = 1; i < sink.power; ++i) {
    score = score * weighted;
  }
  store(sink.scores + sample, score);
  store(sink.costs + sample, load(sink.costs + sample) + score);
}

inline Lanes magnitudeOf(Lanes x, Lanes y) {
  return sqrt(x * x + y * y);
}

/// |angle| wrapped to [0, pi].
inline Lanes wrappedSize(Lanes angle) {
  const Lanes whole = fill(12582912.0F);
  const Lanes turns = (angle * fill(0.159154943F) + whole) - whole;
  return abs(angle - turns * fill(6.28318531F));
}

/// Heading of a vector, 0 at the origin: Abramowitz & Stegun 4.4.49, error 2e-8 before rounding.
inline Lanes headingOfLanes(Lanes y, Lanes x) {
  constexpr float kTan[9] = {1.0F,           -0.3333314528F, 0.1999355085F,
                             -0.1420889944F, 0.1065626393F,  -0.0752896400F,
                             0.0429096138F,  -0.0161657367F, 0.0028662257F};
  const Lanes width = abs(x);
  const Lanes height = abs(y);
  const Lanes ratio = min(width, height) / max(max(width, height), fill(1e-30F));
  const Lanes z = ratio * ratio;
  Lanes sum = fill(kTan[8]);
  for (int i = 7; i >= 0; --i) {
    sum = fill(kTan[i]) + z * sum;
  }
  const Lanes first = ratio * sum;
  const Lanes second = select(width < height, fill(1.57079633F) - first, first);
  const Lanes third = select(x < fill(0.0F), fill(3.14159265F) - second, second);
  return third | (y & fill(-0.0F));
}

/// Scores each register of samples by `rawAt(start)`.
template <class Raw>
inline void scoreEach(const TrajectoryBatch& batch, const ScoreSink& sink, const Raw& rawAt) {
  forEachRegister(batch,
                  [&](int sample, std::size_t start) { addScore(sink, sample, rawAt(start)); });
}

/// Sum of `valueAt(place)` over all steps.
template <class Value>
inline Lanes sumOverSteps(const TrajectoryBatch& batch, std::size_t start, const Value& valueAt) {
  Lanes sum = fill(0.0F);
  for (int step = 0; step < batch.steps; ++step) {
    sum = sum + valueAt(start + stepOffset(step));
  }
  return sum;
}

/// Scores by that sum times `factor`.
template <class Value>
inline void scoreSum(const TrajectoryBatch& batch, const ScoreSink& sink, float factor,
                     const Value& valueAt) {
  scoreEach(batch, sink,
            [&](std::size_t start) { return sumOverSteps(batch, start, valueAt) * fill(factor); });
}

/// Scores by the mean of `valueAt(place)` over all steps.
template <class Value>
inline void scoreMean(const TrajectoryBatch& batch, const ScoreSink& sink, const Value& valueAt) {
  const Lanes steps = fill(static_cast<float>(batch.steps));
  scoreEach(batch, sink,
            [&](std::size_t start) { return sumOverSteps(batch, start, valueAt) / steps; });
}

inline void scoreConstraint(const ConstraintProblem& problem, const TrajectoryBatch& batch,
                            const ScoreSink& sink) {
  using Model = ConstraintProblem::Model;
  scoreSum(batch, sink, problem.dt, [&](std::size_t at) {
    const Lanes vx = load(batch.speeds[0] + at);
    Lanes speed = vx;
    if (problem.model == Model::Planar) {
      const Lanes size = magnitudeOf(vx, load(batch.speeds[2] + at));
      speed = select(fill(0.0F) < vx, size, fill(0.0F) - size);
    }
    Lanes excess =
        positivePart(speed - fill(problem.high)) + positivePart(fill(problem.low) - speed);
    if (problem.model == Model::LinearAndLateral) {
      excess = excess + positivePart(abs(load(batch.speeds[2] + at)) - fill(problem.lateral));
    } else if (problem.model == Model::Ackermann) {
      const Lanes wz = max(abs(load(batch.speeds[1] + at)), fill(1e-6F));
      excess = excess + positivePart(fill(problem.turningRadius) - abs(vx) / wz);
    }
    return excess;
  });
}

inline void scoreForward(float dt, const TrajectoryBatch& batch, const ScoreSink& sink) {
  scoreSum(batch, sink, dt,
           [&](std::size_t at) { return positivePart(fill(0.0F) - load(batch.speeds[0] + at)); });
}

inline void scoreTwirling(const TrajectoryBatch& batch, const ScoreSink& sink) {
  scoreMean(batch, sink, [&](std::size_t at) { return abs(load(batch.speeds[1] + at)); });
}

inline void scoreDeadband(const DeadbandProblem& problem, const TrajectoryBatch& batch,
                          const ScoreSink& sink) {
  const int axes = problem.isHolonomic ? 3 : 2;
  scoreSum(batch, sink, problem.dt, [&](std::size_t at) {
    Lanes sum = fill(0.0F);
    for (int axis = 0; axis < axes; ++axis) {
      sum = sum + positivePart(fill(problem.deadband[axis]) - abs(load(batch.speeds[axis] + at)));
    }
    return sum;
  });
}

inline void scoreGoal(float x, float y, const TrajectoryBatch& batch, const ScoreSink& sink) {
  scoreMean(batch, sink, [&](std::size_t at) {
    return magnitudeOf(load(batch.x + at) - fill(x), load(batch.y + at) - fill(y));
  });
}

inline void scoreGoalAngle(float yaw, bool isSymmetric, const TrajectoryBatch& batch,
                           const ScoreSink& sink) {
  scoreMean(batch, sink, [&](std::size_t at) {
    const Lanes size = wrappedSize(fill(yaw) - load(batch.yaw + at));
    return isSymmetric ? min(size, abs(fill(3.14159265F) - size)) : size;
  });
}

inline void scoreFollow(float x, float y, const TrajectoryBatch& batch, const ScoreSink& sink) {
  scoreEach(batch, sink, [&](std::size_t start) {
    const std::size_t end = start + stepOffset(batch.steps - 1);
    return magnitudeOf(load(batch.x + end) - fill(x), load(batch.y + end) - fill(y));
  });
}

/// |angle| from a heading to the direction to the point, corrected by the mode.
inline Lanes angleToPoint(const AngleProblem& problem, const TrajectoryBatch& batch,
                          std::size_t at) {
  using Mode = AngleProblem::Mode;
  const Lanes pi = fill(3.14159265F);
  const Lanes quarter = fill(1.57079633F);
  const Lanes between =
      headingOfLanes(fill(problem.y) - load(batch.y + at), fill(problem.x) - load(batch.x + at));
  const Lanes size = wrappedSize(between - load(batch.yaw + at));
  if (problem.mode == Mode::Forward) {
    return size;
  }
  const Lanes measure =
      problem.mode == Mode::EitherEnd ? size : wrappedSize(between - fill(problem.yaw));
  return select(measure < quarter, size, abs(pi - size));
}

inline void scoreAngle(const AngleProblem& problem, const TrajectoryBatch& batch,
                       const ScoreSink& sink) {
  const auto angleAt = [&](std::size_t at) { return angleToPoint(problem, batch, at); };
  if (problem.isMean) {
    scoreMean(batch, sink, angleAt);
  } else {
    scoreEach(batch, sink,
              [&](std::size_t start) { return angleAt(start + stepOffset(batch.steps - 1)); });
  }
}

/// Of equally near points the first is used.
inline void nearestPathPoints(const PathPoints& path, float slack, const TrajectoryBatch& batch,
                              float* indices) {
  forEachRegister(batch, [&](int sample, std::size_t start) {
    const std::size_t end = start + stepOffset(batch.steps - 1);
    const Lanes x = load(batch.x + end);
    const Lanes y = load(batch.y + end);
    const Lanes reach = load(batch.length + sample) + fill(slack);
    Lanes best = fill(0.0F);
    Lanes least = fill(3.4e38F);
    for (int i = 0; i < path.count; ++i) {
      const Lanes dx = fill(path.x[i]) - x;
      const Lanes dy = fill(path.y[i]) - y;
      const Lanes distance2 = dx * dx + dy * dy;
      const LaneMask isBetter = (distance2 < least) & (fill(path.way[i]) <= reach);
      least = select(isBetter, distance2, least);
      best = select(isBetter, fill(static_cast<float>(i)), best);
    }
    store(indices + sample, best);
  });
}

/// Advances each sample's path index to a driven length, starting at the previous index.
inline Lanes advancedAlong(const PathPoints& path, Lanes way, Lanes& index) {
  const Lanes one = fill(1.0F);
  const Lanes last = fill(static_cast<float>(path.count - 1));
  for (;;) {
    const LaneMask isPassed =
        (index < last) & (Lanes::gather(path.way + 1, xsimd::to_int(index)) <= way);
    if (!xsimd::any(isPassed)) {
      break;
    }
    index = select(isPassed, index + one, index);
  }
  const Lanes before = Lanes::gather(path.way, xsimd::to_int(index));
  const Lanes after = Lanes::gather(path.way + 1, xsimd::to_int(index));
  index = select((way - before < after - way) | (index == last), index, index + one);
  return index;
}

inline Lanes alignmentOf(const AlignProblem& problem, const TrajectoryBatch& batch,
                         std::size_t start) {
  const PathPoints& path = problem.path;
  const Lanes none = fill(0.0F);
  Lanes beforeX = load(batch.x + start);
  Lanes beforeY = load(batch.y + start);
  Lanes way = none;
  Lanes index = none;
  Lanes sum = none;
  Lanes count = none;
  for (int step = problem.pointStep; step < batch.steps; step += problem.pointStep) {
    const std::size_t at = start + stepOffset(step);
    const Lanes x = load(batch.x + at);
    const Lanes y = load(batch.y + at);
    way = way + magnitudeOf(x - beforeX, y - beforeY);
    beforeX = x;
    beforeY = y;
    const LaneInts point = xsimd::to_int(advancedAlong(path, way, index));
    const Lanes dx = Lanes::gather(path.x, point) - x;
    const Lanes dy = Lanes::gather(path.y, point) - y;
    Lanes distance2 = dx * dx + dy * dy;
    if (problem.usesOrientations) {
      const Lanes turn = wrappedSize(load(batch.yaw + at) - Lanes::gather(path.yaw, point));
      distance2 = distance2 + turn * turn;
    }
    const Lanes valid = Lanes::gather(path.valid, point);
    sum = sum + valid * sqrt(distance2);
    count = count + valid;
  }
  return sum / max(count, fill(1.0F));
}

inline void scoreAlign(const AlignProblem& problem, const TrajectoryBatch& batch,
                       const ScoreSink& sink) {
  scoreEach(batch, sink, [&](std::size_t start) { return alignmentOf(problem, batch, start); });
}

}  // namespace
}  // namespace sim2d::nav2
