#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim2d/base/Rng.h"
#include "sim2d/nav/mppi/MppiKernel.h"

/// MPPI as plain loops in double precision, straight from the equations: what the kernel must agree
/// with to rounding, and what it is measured against. It shares the kernel's input and no code.
namespace reference {

using Control = std::array<double, 3>;  // linear, angular, lateral

struct Sample {
  std::vector<Control> controls;
  double cost = 0.0;
  bool hits = false;
};

inline double bilinear(const sim2d::MppiGrid& grid, double x, double y) {
  const double fx = std::min(std::max((x - grid.x) * grid.perMetre, 0.0), grid.columns - 1.01);
  const double fy = std::min(std::max((y - grid.y) * grid.perMetre, 0.0), grid.rows - 1.01);
  const int i = static_cast<int>(fx);
  const int j = static_cast<int>(fy);
  const auto at = [&](int a, int b) {
    return static_cast<double>(grid.values[b * grid.columns + a]);
  };
  return (1.0 - fx + i) * (1.0 - fy + j) * at(i, j) + (fx - i) * (1.0 - fy + j) * at(i + 1, j) +
         (1.0 - fx + i) * (fy - j) * at(i, j + 1) + (fx - i) * (fy - j) * at(i + 1, j + 1);
}

inline double bounded(double value, double low, double high) {
  return std::max(low, std::min(high, value));
}

inline double positive(double value) {
  return std::max(value, 0.0);
}

inline double square(double value) {
  return value * value;
}

/// Standard normal numbers of one axis: Box and Muller on words of Philox.
inline double normal(const sim2d::MppiNoise& noise, int sample, int step, int axis) {
  const auto block = static_cast<std::uint32_t>(step / 2);
  const std::uint32_t series = axis == 2 ? 1U << 16U : 0U;
  const auto words = base::philox4x32(
      {static_cast<std::uint32_t>(sample), noise.robot, noise.call, (11U << 24U) | series | block},
      {noise.key[0], noise.key[1]});
  const std::size_t first = step % 2 == 0 ? 0 : 2;
  const double u = 1.0 - (words[first] >> 9U) / 8388608.0;
  const double turn = (words[first + 1] >> 9U) / 8388608.0 - 0.5;
  const double radius = std::sqrt(-2.0 * std::log(u));
  return radius * (axis == 1 ? std::sin(2.0 * M_PI * turn) : std::cos(2.0 * M_PI * turn));
}

/// Where a rollout is, and what it has cost.
struct Place {
  double x = 0.0, y = 0.0, heading = 0.0;
  Control motion{};
};

inline Control feasible(const sim2d::MppiDrive& drive, const Control& now, const Control& wanted) {
  Control next{};
  next[0] = bounded(wanted[0], std::max<double>(drive.lowLinear, now[0] - drive.linearStep),
                    std::min<double>(drive.highLinear, now[0] + drive.linearStep));
  next[1] = bounded(wanted[1], std::max<double>(-drive.highAngular, now[1] - drive.angularStep),
                    std::min<double>(drive.highAngular, now[1] + drive.angularStep));
  if (drive.isOmnidirectional) {
    next[2] = bounded(wanted[2], std::max<double>(-drive.highLateral, now[2] - drive.lateralStep),
                      std::min<double>(drive.highLateral, now[2] + drive.lateralStep));
  }
  if (drive.isAckermann) {
    const double most = std::fabs(next[0]) * drive.mostCurvature;
    next[1] = bounded(next[1], -most, most);
  }
  return next;
}

inline double costOfWay(const sim2d::MppiProblem& problem, const Place& at) {
  const sim2d::MppiCosts& costs = problem.costs;
  const double toGo = bilinear(problem.distance, at.x, at.y);
  const double h = 1e-4;
  const double gx =
      (bilinear(problem.distance, at.x + h, at.y) - bilinear(problem.distance, at.x - h, at.y)) /
      (2.0 * h);
  const double gy =
      (bilinear(problem.distance, at.x, at.y + h) - bilinear(problem.distance, at.x, at.y - h)) /
      (2.0 * h);
  const double steep = std::max(1.0, std::hypot(gx, gy));
  const double uphill = (std::cos(at.heading) * gx + std::sin(at.heading) * gy) / steep;
  const double speed2 = square(at.motion[0]) + square(at.motion[2]);
  return costs.goal * toGo + 0.5 * costs.heading * (1.0 + uphill) * std::min(1.0, 2.0 * toGo) +
         costs.reverse * positive(-at.motion[0]) +
         (toGo < costs.goalRadius ? costs.stop * speed2 : 0.0);
}

/// Walls and people for one disc; adds to `hits`.
inline double costOfNearness(const sim2d::MppiProblem& problem, const sim2d::MppiDisc& disc,
                             const Place& at, int step, double& hits) {
  const double c = std::cos(at.heading);
  const double s = std::sin(at.heading);
  const double x = at.x + c * disc.x - s * disc.y;
  const double y = at.y + s * disc.x + c * disc.y;
  const double gap = bilinear(problem.clearance, x, y) - disc.radius;
  double cost = problem.costs.wall * square(positive(1.0 - gap * problem.costs.perWallRange));
  if (gap < problem.costs.wallMargin) {
    hits += 1.0 + 10.0 * (problem.costs.wallMargin - gap);
  }
  for (int i = problem.firstPerson[step]; i < problem.firstPerson[step + 1]; ++i) {
    const sim2d::MppiPerson& person = problem.people[i];
    const double d2 = square(x - person.x) + square(y - person.y);
    const double near = positive((person.far2 - d2) * person.perBand);
    cost += problem.costs.person * square(near);
    if (near > 1.0) {
      hits += 10.0 * near - 9.0;
    }
  }
  return cost;
}

/// The terms of comfort (SocialMppiParameters) for one person.
inline double discomfort(const sim2d::MppiSocial& social, const sim2d::MppiPerson& person,
                         const Place& at, double early) {
  const double c = std::cos(at.heading);
  const double s = std::sin(at.heading);
  const double wx = c * at.motion[0] - s * at.motion[2] - person.vx;
  const double wy = s * at.motion[0] + c * at.motion[2] - person.vy;
  const double dx = at.x - person.x;
  const double dy = at.y - person.y;
  const double d = std::hypot(dx, dy);
  const double gap = d - person.touch;
  const double personal = positive(1.0 - gap * social.perPersonal);
  const double ahead = dx * person.hx + dy * person.hy;
  const double left = person.hx * dy - person.hy * dx;
  double sum = social.intimate * positive(1.0 - gap * social.perIntimate) +
               social.personal * square(personal);
  const double along = ahead > 0.0 ? person.front : person.rear;
  sum += social.space * std::exp2(-square(ahead) * along - square(left) * person.side);
  if (ahead > 0.0) {
    sum += social.strip * person.walks * positive(1.0 - ahead * person.perStrip) *
           positive(1.0 - std::fabs(left) * social.perStripWidth);
  }
  const double w = std::hypot(wx, wy);
  const double closing = -(dx * wx + dy * wy) / d;  // [m/s]
  if (closing > 0.0) {
    const double time = std::max(gap, 0.1) / closing;
    sum += social.touchTime * personal *
           square(std::min(2.0, positive(social.fromTouchTime / time - 1.0)));
    const double miss = std::fabs(dx * wy - dy * wx) / std::max(w, 0.2);
    sum += social.legible * person.walks * early * positive(1.0 - gap * social.perLegible) *
           std::min(1.0, positive(1.0 - (miss - person.touch) * social.perPass));
  }
  return person.comfort * (sum + social.relativeSpeed * square(w) * personal);
}

inline double costOfComfort(const sim2d::MppiProblem& problem, const Place& at, int step) {
  double sum = 0.0;
  for (int i = 0; i < problem.zoneCount; ++i) {
    const sim2d::MppiZone& zone = problem.zones[i];
    const double d2 = square(at.x - zone.x) + square(at.y - zone.y);
    sum += zone.weight * positive(1.0 - d2 * zone.perRadius2);
  }
  if (problem.isSocial && step % 2 == 0) {
    const double early = 2.0 - 2.0 * step / problem.steps;
    for (int i = problem.firstPerson[step]; i < problem.firstPerson[step + 1]; ++i) {
      sum += 2.0 * discomfort(problem.social, problem.people[i], at, early);
    }
  }
  return sum;
}

inline Sample roll(const sim2d::MppiProblem& problem, int number) {
  const double sigma[3] = {problem.noise.linear, problem.noise.angular, problem.noise.lateral};
  const int axes = problem.drive.isOmnidirectional ? 3 : 2;
  Place at;
  at.heading = std::atan2(problem.start.sine, problem.start.cosine);
  at.motion = {problem.start.linear, problem.start.angular, problem.start.lateral};
  Sample sample;
  sample.controls.reserve(static_cast<std::size_t>(problem.steps));
  double sum = 0.0;
  double hits = 0.0;
  double pulled = 0.0;
  double drift[3] = {};
  for (int step = 0; step < problem.steps; ++step) {
    Control wanted{};
    for (int axis = 0; axis < axes; ++axis) {
      const double fresh = normal(problem.noise, number, step, axis);
      drift[axis] =
          step == 0 ? fresh : problem.noise.keep * drift[axis] + problem.noise.fresh * fresh;
      wanted[static_cast<std::size_t>(axis)] = problem.mean[axis][step] + sigma[axis] * drift[axis];
      pulled += problem.pull[axis][step] * fresh;
    }
    const Control before = at.motion;
    at.motion = feasible(problem.drive, before, wanted);
    sample.controls.push_back(at.motion);
    sum += problem.costs.changeLinear * square(at.motion[0] - before[0]) +
           problem.costs.changeAngular * square(at.motion[1] - before[1]) +
           problem.costs.changeLateral * square(at.motion[2] - before[2]);
    const double middle = at.heading + 0.5 * problem.dt * at.motion[1];
    at.x += problem.dt * (at.motion[0] * std::cos(middle) - at.motion[2] * std::sin(middle));
    at.y += problem.dt * (at.motion[0] * std::sin(middle) + at.motion[2] * std::cos(middle));
    at.heading += problem.dt * at.motion[1];
    sum += costOfWay(problem, at);
    for (int i = 0; i < problem.discCount; ++i) {
      sum += costOfNearness(problem, problem.discs[i], at, step, hits);
    }
    sum += costOfComfort(problem, at, step);
  }
  sample.hits = hits > 0.0;
  sample.cost = sum / problem.steps + problem.costs.hit * hits / problem.steps +
                problem.costs.end * bilinear(problem.distance, at.x, at.y) + pulled;
  return sample;
}

/// Samples `first` up to before `last`.
inline std::vector<Sample> rollAll(const sim2d::MppiProblem& problem, int first, int last) {
  std::vector<Sample> samples;
  samples.reserve(static_cast<std::size_t>(last - first));
  for (int i = first; i < last; ++i) {
    samples.push_back(roll(problem, i));
  }
  return samples;
}

/// Mean of the controls with the weights exp(-(S - min S) / lambda) / sum.
inline std::vector<Control> meanOf(const std::vector<Sample>& samples, double lambda) {
  double least = samples.front().cost;
  for (const Sample& sample : samples) {
    least = std::min(least, sample.cost);
  }
  std::vector<Control> mean(samples.front().controls.size(), Control{});
  double sum = 0.0;
  for (const Sample& sample : samples) {
    const double weight = std::exp(-(sample.cost - least) / lambda);
    sum += weight;
    for (std::size_t step = 0; step < mean.size(); ++step) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        mean[step][axis] += weight * sample.controls[step][axis];
      }
    }
  }
  for (Control& control : mean) {
    for (double& value : control) {
      value /= sum;
    }
  }
  return mean;
}

}  // namespace reference
