#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/mppi/MppiOptimizer.h"
#include "tests/bench/FastestOf.h"
#include "tests/bench/Nav2PlainMppi.h"
#include "tests/nav/Nav2MppiReference.h"
#include "tests/nav/Nav2MppiScenes.h"

using namespace sim2d::nav2;
using sim2d::MppiSimdLevel;

/// A cycle of Nav2's MPPI, 2000 trajectories of 56 steps with the critics of the bringup, on one
/// thread: each instruction set beside plain loops in single precision (Nav2PlainMppi.h) and beside
/// the reference of the tests in double precision, which draws no noise.
class Nav2MppiBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void command_2000x56_data();
  void command_2000x56();
  void command_omni_data();
  void command_omni();
  void command_edgesOfTheFootprint();
};

namespace {

constexpr int kRounds = 25;

/// Every critic of the bringup that is asked on the way, and its new noise per call.
MppiConfiguration benchMppi(bool regenerates) {
  MppiConfiguration mppi = nav2test::stockMppi(Distro::Jazzy);
  mppi.settings.batchSize = 2000;
  mppi.settings.regeneratesNoises = regenerates;
  mppi.critics.pathAlign.offsetFromFurthest = 5;
  mppi.critics.pathAngle.maxAngleToFurthest = 0.0;
  return mppi;
}

Nav2PlainMppi plainOf(const MppiConfiguration& mppi, const nav2test::HandScene& scene,
                      const TrajectoryBuffer& columns) {
  Nav2PlainMppi plain(mppi, scene);
  for (int sample = 0; sample < columns.count(); ++sample) {
    for (int step = 0; step < columns.steps(); ++step) {
      const std::size_t to =
          static_cast<std::size_t>(sample) * static_cast<std::size_t>(columns.steps()) +
          static_cast<std::size_t>(step);
      plain.vxNoise[to] = columns.noise[0][columns.elementIndex(step, sample)];
      plain.wzNoise[to] = columns.noise[1][columns.elementIndex(step, sample)];
    }
  }
  return plain;
}

/// How many trajectories the two price otherwise: a place on a cell's edge may fall to either side.
int differences(const std::vector<float>& costs, const std::vector<float>& others) {
  int differ = 0;
  for (std::size_t i = 0; i < others.size(); ++i) {
    differ += std::fabs(costs[i] - others[i]) > 1e-4F * (1.0F + costs[i]) ? 1 : 0;
  }
  return differ;
}

}  // namespace

void Nav2MppiBench::command_2000x56_data() {
  QTest::addColumn<int>("path");
  QTest::addColumn<bool>("regenerates");
  const char* paths[] = {"SSE2", "AVX2", "AVX-512"};
  for (int path = 0; path < 3; ++path) {
    QTest::addRow("%s, kept noise", paths[path]) << path << false;
    QTest::addRow("%s, new noise", paths[path]) << path << true;
  }
}

void Nav2MppiBench::command_2000x56() {
  QFETCH(int, path);
  QFETCH(bool, regenerates);
  if (!sim2d::isMppiSimdLevelSupported(static_cast<MppiSimdLevel>(path))) {
    QSKIP("not on this processor");
  }
  const MppiConfiguration mppi = benchMppi(regenerates);
  const nav2test::HandScene scene = nav2test::curve();
  MppiOptimizer optimizer(mppi, {0.05, 1, 0, static_cast<MppiSimdLevel>(path)});
  QVERIFY(optimizer.command(scene.view()));
  Nav2PlainMppi plain = plainOf(mppi, scene, optimizer.trajectories());
  plain.cycle();
  const int differ = differences(optimizer.costs(), plain.costs);
  QVERIFY2(differ < 20, qPrintable(QString::number(differ)));
  const double vector = fastestOf(kRounds, [&] { QVERIFY(optimizer.command(scene.view())); });
  const double scalar = fastestOf(kRounds, [&] {
    if (regenerates) {
      plain.drawNoise();
    }
    plain.cycle();
  });
  nav2reference::Reference reference(mppi, 0.05);
  const auto& columns = optimizer.trajectories();
  const double precise = fastestOf(2, [&] {
    reference.cycle(scene, [&](int sample, int step, int axis) {
      return static_cast<double>(
          columns.noise[static_cast<std::size_t>(axis)][columns.elementIndex(step, sample)]);
    });
  });
  qInfo("%.3f ms; plain loops %.2f ms, ratio %.1f; the reference %.1f ms", vector, scalar,
        scalar / vector, precise);
  QTest::setBenchmarkResult(vector, QTest::WalltimeMilliseconds);
}

void Nav2MppiBench::command_omni_data() {
  QTest::addColumn<int>("path");
  QTest::newRow("SSE2") << 0;
  QTest::newRow("AVX2") << 1;
  QTest::newRow("AVX-512") << 2;
}

/// With a third axis of noise.
void Nav2MppiBench::command_omni() {
  QFETCH(int, path);
  if (!sim2d::isMppiSimdLevelSupported(static_cast<MppiSimdLevel>(path))) {
    QSKIP("not on this processor");
  }
  MppiConfiguration mppi = benchMppi(true);
  mppi.motion = MppiMotion::Omni;
  const nav2test::HandScene scene = nav2test::curve();
  MppiOptimizer optimizer(mppi, {0.05, 1, 0, static_cast<MppiSimdLevel>(path)});
  const double time = fastestOf(kRounds, [&] { QVERIFY(optimizer.command(scene.view())); });
  qInfo("%.3f ms", time);
  QTest::setBenchmarkResult(time, QTest::WalltimeMilliseconds);
}

/// CostCritic by the edges of the footprint, which are asked one pose at a time wherever the centre
/// is near something.
void Nav2MppiBench::command_edgesOfTheFootprint() {
  MppiConfiguration mppi = benchMppi(true);
  mppi.critics.cost.considersFootprint = true;
  const nav2test::HandScene scene = nav2test::curve();
  MppiOptimizer optimizer(mppi, {});
  const double time = fastestOf(kRounds, [&] { QVERIFY(optimizer.command(scene.view())); });
  qInfo("%.3f ms", time);
  QTest::setBenchmarkResult(time, QTest::WalltimeMilliseconds);
}

QTEST_APPLESS_MAIN(Nav2MppiBench)
#include "bench_Nav2Mppi.moc"
