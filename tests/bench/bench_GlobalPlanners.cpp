#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include <QElapsedTimer>
#include <QtTest>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/PathSmoother.h"
#include "tests/nav/CostmapSketch.h"

using namespace costs;
using namespace sim2d::nav2;

/// Nav2's global planners across 20 m x 20 m in cells of 5 cm, through doors, beside a textbook
/// Dijkstra with std::priority_queue through the same map.
class GlobalPlannersBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void plan_data();
  void plan();
  void smooth_data();
  void smooth();
};

namespace {

constexpr int kSide = 400;

/// Walls with doors and clutter between them.
Costmap building() {
  Costmap costmap(kSide, kSide, 0.05, Vec2::Zero());
  Numbers numbers(7);
  for (int wall = 80; wall < kSide; wall += 80) {
    const int door = static_cast<int>(numbers.between(30, kSide - 60));
    for (int along = 0; along < kSide; ++along) {
      if (along < door || along > door + 30) {
        costmap.set({wall, along}, 254);
      }
    }
  }
  for (int i = 0; i < 60; ++i) {
    const int column = static_cast<int>(numbers.between(20, kSide - 20));
    const int row = static_cast<int>(numbers.between(20, kSide - 20));
    for (int k = 0; k < 16; ++k) {
      costmap.set({column + k % 4, row + k / 4}, 254);
    }
  }
  inflate(costmap, 0.22, 0.55, 3.0);
  return costmap;
}

/// The least of so many runs [ms]: others that use the machine do not count.
double leastOf(int runs, const std::function<void()>& work) {
  double least = std::numeric_limits<double>::max();
  for (int i = 0; i < runs; ++i) {
    QElapsedTimer timer;
    timer.start();
    work();
    least = std::min(least, static_cast<double>(timer.nsecsElapsed()) * 1e-6);
  }
  return least;
}

double plainDijkstra(const Costmap& costmap, Cell from, Cell to) {
  const auto best = cheapest(costmap, from, 8, [&](Cell cell, double length) {
    const double cost = costmap.at(cell);
    return cost >= 253.0 ? std::numeric_limits<double>::infinity() : length * (1.0 + cost / 252.0);
  });
  return best[costmap.indexOf(to)];
}

}  // namespace

void GlobalPlannersBench::plan_data() {
  QTest::addColumn<QString>("plugin");
  QTest::addColumn<QString>("variant");
  QTest::newRow("NavFn, Dijkstra") << "nav2_navfn_planner::NavfnPlanner"
                                   << "";
  QTest::newRow("NavFn, A*") << "nav2_navfn_planner::NavfnPlanner"
                             << "astar";
  QTest::newRow("Theta*") << "nav2_theta_star_planner::ThetaStarPlanner"
                          << "";
  QTest::newRow("Smac 2D") << "nav2_smac_planner::SmacPlanner2D"
                           << "";
  QTest::newRow("Smac Hybrid, Dubins") << "nav2_smac_planner::SmacPlannerHybrid"
                                       << "";
  QTest::newRow("Smac Hybrid, Reeds-Shepp") << "nav2_smac_planner::SmacPlannerHybrid"
                                            << "both";
}

void GlobalPlannersBench::plan() {
  QFETCH(QString, plugin);
  QFETCH(QString, variant);
  auto parameters = *globalPlannerPlugin(plugin.toStdString(), Distro::Jazzy).parameters;
  if (auto* navfn = std::get_if<NavfnParameters>(&parameters)) {
    navfn->useAstar = !variant.isEmpty();
  } else if (auto* hybrid = std::get_if<SmacHybridParameters>(&parameters)) {
    hybrid->motionModelForSearch = variant.isEmpty() ? "DUBIN" : "REEDS_SHEPP";
  }
  const Costmap costmap = building();
  const Cell from{20, 200}, to{380, 200};
  const auto planner = makeGlobalPlanner(parameters, Distro::Jazzy);
  PlanResult result;
  const double first = leastOf(1, [&] {
    result =
        planner->plan({costmap, {costmap.cellToWorld(from), 0.5}, {costmap.cellToWorld(to), 0.0}});
  });
  const double later = leastOf(9, [&] {
    result =
        planner->plan({costmap, {costmap.cellToWorld(from), 0.5}, {costmap.cellToWorld(to), 0.0}});
  });
  double best = 0.0;
  const double plain = leastOf(5, [&] { best = plainDijkstra(costmap, from, to); });
  QVERIFY(result.error == PlanError::None && best < 1e6);
  qInfo(
      "%.2f ms (the first time %.2f), %d expanded, path %.2f m; plain Dijkstra %.2f ms, ratio %.1f",
      later, first, result.iterations, lengthOf(result.path), plain, plain / later);
  QTest::setBenchmarkResult(later, QTest::WalltimeMilliseconds);
}

void GlobalPlannersBench::smooth_data() {
  QTest::addColumn<QString>("plugin");
  QTest::newRow("simple") << "nav2_smoother::SimpleSmoother";
  QTest::newRow("Savitzky-Golay") << "nav2_smoother::SavitzkyGolaySmoother";
}

void GlobalPlannersBench::smooth() {
  QFETCH(QString, plugin);
  const Costmap costmap = building();
  const auto planner = makeGlobalPlanner(NavfnParameters(), Distro::Jazzy);
  const Path path = planner->plan({costmap, {{1.0, 10.0}, 0.0}, {{19.0, 10.0}, 0.0}}).path;
  const auto smoother = *pathSmootherPlugin(plugin.toStdString(), Distro::Jazzy).parameters;
  SmoothResult result;
  const double time =
      leastOf(9, [&] { result = smoothPath(smoother, Distro::Jazzy, path, costmap, 3.0); });
  QVERIFY(result.error == SmoothError::None);
  qInfo("%.3f ms for %zu poses", time, path.size());
  QTest::setBenchmarkResult(time, QTest::WalltimeMilliseconds);
}

QTEST_APPLESS_MAIN(GlobalPlannersBench)
#include "bench_GlobalPlanners.moc"
