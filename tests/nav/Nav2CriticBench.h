#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/mppi/MppiCritics.h"
#include "tests/nav/Nav2MppiScenes.h"

/// One critic of Nav2's MPPI on trajectories made by hand.
namespace nav2test {

/// As Nav2's own tests have it: 1000 trajectories of 30 steps of 0.1 s.
struct CriticBench {
  CriticBench(const std::string& critic, Distro distro, int count = 1000, int steps = 30)
      : columns(count, steps) {
    mppi = stockMppi(distro);
    mppi.settings.critics = {critic};
    mppi.settings.modelDt = 0.1;
    mppi.settings.timeSteps = steps;
    mppi.settings.batchSize = count;
    std::fill(columns.length.begin(), columns.length.end(), 100.0F);
    scene.goAhead(10.0, 11);
  }

  static void fill(std::vector<float>& column, double value) {
    std::fill(column.begin(), column.end(), static_cast<float>(value));
  }
  void setSpeeds(double vx, double wz = 0.0, double vy = 0.0) {
    fill(columns.speeds[0], vx);
    fill(columns.speeds[1], wz);
    fill(columns.speeds[2], vy);
  }
  void setPoses(double x, double y, double yaw = 0.0) {
    fill(columns.x, x);
    fill(columns.y, y);
    fill(columns.yaw, yaw);
  }
  void setPose(int sample, int step, double x, double y, double yaw = 0.0) {
    const std::size_t place = columns.elementIndex(step, sample);
    columns.x[place] = static_cast<float>(x);
    columns.y[place] = static_cast<float>(y);
    columns.yaw[place] = static_cast<float>(yaw);
  }

  /// What each trajectory costs.
  std::vector<double> all() {
    MppiCritics critics(mppi, trajectoryKernelOf(sim2d::fastestMppiSimdLevel()));
    std::vector<float> costs(columns.length.size(), 0.0F);
    critics.begin(scene.view());
    critics.score(scene.view(), columns, costs);
    furthest = critics.furthest().value_or(-1);
    hasFailed = critics.hasFailed();
    wasEvaluated = critics.wasEvaluated(0);
    std::vector<double> result;
    for (int i = 0; i < columns.count(); ++i) {
      result.push_back(static_cast<double>(costs[static_cast<std::size_t>(i)]));
    }
    return result;
  }
  /// What all cost; they are the same. -1: they are not.
  double each() {
    const std::vector<double> costs = all();
    const bool isSame =
        std::all_of(costs.begin(), costs.end(), [&](double cost) { return cost == costs.front(); });
    return isSame ? costs.front() : -1.0;
  }

  MppiConfiguration mppi;
  HandScene scene;
  TrajectoryBuffer columns;
  int furthest = 0;
  bool hasFailed = false, wasEvaluated = false;
};

}  // namespace nav2test
