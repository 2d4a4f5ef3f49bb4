#include <algorithm>
#include <cstddef>

#include <QElapsedTimer>
#include <QtTest>

#include "sim2d/nav/nav2/mppi/MppiOptimizer.h"
#include "tests/nav/Nav2MppiReference.h"
#include "tests/nav/Nav2MppiScenes.h"

using namespace sim2d::nav2;
using sim2d::MppiPath;

/// A cycle of Nav2's MPPI, 2000 trajectories of 56 steps with the critics of the bringup, on one
/// thread: each instruction set beside plain loops in double precision.
class Nav2MppiBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void command_2000x56_data();
  void command_2000x56();
  void command_edgesOfTheFootprint();
};

namespace {

constexpr int kRounds = 25;

template <typename Work>
double fastestOf(int rounds, const Work& work) {
  double best = 1e18;
  for (int round = 0; round < rounds; ++round) {
    QElapsedTimer timer;
    timer.start();
    work();
    best = std::min(best, static_cast<double>(timer.nsecsElapsed()) * 1e-6);
  }
  return best;
}

}  // namespace

void Nav2MppiBench::command_2000x56_data() {
  QTest::addColumn<int>("path");
  QTest::addColumn<int>("motion");
  QTest::addColumn<bool>("regenerates");
  const char* paths[] = {"SSE2", "AVX2", "AVX-512"};
  for (int path = 0; path < 3; ++path) {
    QTest::addRow("%s, kept noise", paths[path]) << path << 0 << false;
    QTest::addRow("%s, new noise", paths[path]) << path << 0 << true;
    QTest::addRow("%s, new noise, Omni", paths[path]) << path << 1 << true;
  }
}

void Nav2MppiBench::command_2000x56() {
  QFETCH(int, path);
  QFETCH(int, motion);
  QFETCH(bool, regenerates);
  if (!sim2d::hasMppiPath(static_cast<MppiPath>(path))) {
    QSKIP("not on this processor");
  }
  MppiConfiguration mppi = nav2test::stockMppi(Distro::Jazzy);
  mppi.motion = static_cast<MppiMotion>(motion);
  mppi.settings.batchSize = 2000;
  mppi.settings.regeneratesNoises = regenerates;
  mppi.critics.pathAlign.offsetFromFurthest = 5;
  mppi.critics.pathAngle.mostAngle = 0.0;  // both are asked
  const nav2test::HandScene scene = nav2test::curve();
  MppiOptimizer optimizer(mppi, {0.05, 1, 0, static_cast<MppiPath>(path)});
  const double vector = fastestOf(kRounds, [&] { QVERIFY(optimizer.command(scene.view())); });
  nav2reference::Reference reference(mppi, 0.05);
  const auto& columns = optimizer.trajectories();
  const double plain = fastestOf(3, [&] {
    reference.cycle(scene, [&](int sample, int step, int axis) {
      return static_cast<double>(
          columns.noise[static_cast<std::size_t>(axis)][columns.placeOf(step, sample)]);
    });
  });
  qInfo("%.3f ms, plain without drawing noise %.1f ms, ratio %.1f", vector, plain, plain / vector);
  QTest::setBenchmarkResult(vector, QTest::WalltimeMilliseconds);
}

/// CostCritic by the edges of the footprint, which are asked one pose at a time wherever the centre
/// is near something.
void Nav2MppiBench::command_edgesOfTheFootprint() {
  MppiConfiguration mppi = nav2test::stockMppi(Distro::Jazzy);
  mppi.settings.batchSize = 2000;
  mppi.settings.regeneratesNoises = true;
  mppi.critics.cost.considersFootprint = true;
  const nav2test::HandScene scene = nav2test::curve();
  MppiOptimizer optimizer(mppi, {});
  const double time = fastestOf(kRounds, [&] { QVERIFY(optimizer.command(scene.view())); });
  qInfo("%.3f ms", time);
  QTest::setBenchmarkResult(time, QTest::WalltimeMilliseconds);
}

QTEST_APPLESS_MAIN(Nav2MppiBench)
#include "bench_Nav2Mppi.moc"
