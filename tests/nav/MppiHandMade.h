#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "sim2d/nav/mppi/MppiKernel.h"

/// A problem for the kernel made by hand: a wall at y = 1.2 m, the goal at (4, 0.5), people on a
/// spiral who walk about.
namespace mppitest {

struct HandMade {
  HandMade(int count, bool isSocial) {
    problem.isSocial = isSocial;
    fillGrids();
    fillPeople(count);
    fillPlan();
    fillCosts();
    problem.zones = zones.data();
    problem.zoneCount = isSocial ? static_cast<int>(zones.size()) : 0;
    problem.discs = discs.data();
    problem.discCount = static_cast<int>(discs.size());
  }
  HandMade(const HandMade&) = delete;
  HandMade& operator=(const HandMade&) = delete;
  HandMade(HandMade&&) = delete;
  HandMade& operator=(HandMade&&) = delete;
  ~HandMade() = default;

  void fillGrids();
  void fillPeople(int count);
  void fillPlan();
  void fillCosts();

  static constexpr int kNodes = 160;
  sim2d::MppiProblem problem;
  std::vector<float> clearance, distance;
  std::vector<sim2d::MppiPerson> people;
  std::vector<int> firstPerson;
  std::vector<sim2d::MppiZone> zones = {{1.5F, -0.8F, 2.0F, 3.0F}};
  std::vector<sim2d::MppiDisc> discs = {{0.0F, 0.0F, 0.3F}};
  std::vector<float> mean[3], pull[3];
};

inline void HandMade::fillGrids() {
  for (int j = 0; j < kNodes; ++j) {
    for (int i = 0; i < kNodes; ++i) {
      const double x = -4.0 + 0.05 * i;
      const double y = -4.0 + 0.05 * j;
      clearance.push_back(static_cast<float>(1.2 - y));
      distance.push_back(static_cast<float>(std::hypot(x - 4.0, y - 0.5)));
    }
  }
  problem.clearance = {clearance.data(), kNodes, kNodes, -4.0F, -4.0F, 20.0F};
  problem.distance = {distance.data(), kNodes, kNodes, -4.0F, -4.0F, 20.0F};
}

inline void HandMade::fillPeople(int count) {
  for (int step = 0; step < problem.steps; ++step) {
    firstPerson.push_back(static_cast<int>(people.size()));
    for (int i = 0; i < count; ++i) {
      const double angle = 2.39996323 * i;
      const double distanceTo = 0.9 + 0.15 * i;
      const double vx = 0.9 * std::cos(1.7 * i);
      const double vy = 0.9 * std::sin(1.7 * i);
      const double time = 0.05 * (step + 1);
      sim2d::MppiPerson person;
      person.x = static_cast<float>(distanceTo * std::cos(angle) + vx * time);
      person.y = static_cast<float>(distanceTo * std::sin(angle) + vy * time);
      person.touch = 0.6F;
      person.far2 = 1.44F;
      person.perBand = 1.0F / (1.44F - 0.36F);
      person.vx = static_cast<float>(vx);
      person.vy = static_cast<float>(vy);
      person.hx = static_cast<float>(std::cos(1.7 * i));
      person.hy = static_cast<float>(std::sin(1.7 * i));
      person.front = 0.4F;
      person.side = 0.6F;
      person.rear = 0.8F;
      person.perStrip = 0.4F;
      person.walks = 1.0F;
      people.push_back(person);
    }
  }
  firstPerson.push_back(static_cast<int>(people.size()));
  problem.people = people.data();
  problem.firstPerson = firstPerson.data();
}

inline void HandMade::fillPlan() {
  for (int axis = 0; axis < 3; ++axis) {
    for (int step = 0; step < problem.steps; ++step) {
      mean[axis].push_back(axis == 0 ? 0.6F : 0.2F * static_cast<float>(std::sin(0.1 * step)));
      pull[axis].push_back(0.01F * static_cast<float>(std::cos(0.2 * step)));
    }
    problem.mean[axis] = mean[axis].data();
    problem.pull[axis] = pull[axis].data();
  }
}

inline void HandMade::fillCosts() {
  problem.start = {0.8F, 0.6F, 0.4F, 0.1F, 0.0F};
  problem.noise.key[0] = 42U;
  problem.noise.key[1] = 7U;
  problem.noise.robot = 3U;
  problem.noise.call = 5U;
  problem.noise.keep = 0.8F;
  problem.noise.fresh = 0.6F;
  problem.costs.end = 2.0F;
  problem.costs.heading = 3.0F;
  problem.costs.reverse = 3.0F;
  problem.costs.stop = 10.0F;
  problem.costs.wall = 4.0F;
  problem.costs.perWallRange = 3.0F;
  problem.costs.person = 4.0F;
  problem.costs.hit = 100.0F;
  problem.costs.changeLinear = 20.0F;
  problem.costs.changeAngular = 3.0F;
  problem.social.intimate = 6.0F;
  problem.social.personal = 4.0F;
  problem.social.space = 3.0F;
  problem.social.touchTime = 2.0F;
  problem.social.relativeSpeed = 1.0F;
  problem.social.strip = 3.0F;
  problem.social.legible = 1.0F;
}

/// The kernel's columns.
struct Columns {
  Columns(int samples, int steps) : count(samples) {
    for (std::vector<float>& column : controls) {
      column.assign(static_cast<std::size_t>(samples) * static_cast<std::size_t>(steps), 0.0F);
    }
    costs.assign(static_cast<std::size_t>(samples), 0.0F);
    hits = costs;
  }
  sim2d::MppiSamples view() {
    sim2d::MppiSamples samples;
    for (int axis = 0; axis < 3; ++axis) {
      samples.controls[axis] = controls[axis].data();
    }
    samples.stride = count;
    samples.costs = costs.data();
    samples.hits = hits.data();
    return samples;
  }
  int count;
  std::vector<float> controls[3], costs, hits;
};

}  // namespace mppitest
