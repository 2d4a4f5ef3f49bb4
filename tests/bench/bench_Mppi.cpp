#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <QtTest>

#include "sim2d/nav/mppi/MppiPlanner.h"
#include "tests/bench/FastestOf.h"
#include "tests/nav/MppiHandMade.h"
#include "tests/nav/MppiReference.h"
#include "tests/nav/MppiScenes.h"

using namespace sim2d;

/// 2000 ways of 56 steps among 20 people: the kernel of each instruction set beside plain loops in
/// double precision, and a whole call of the planner.
class MppiBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void draw_2000Samples20People_data();
  void draw_2000Samples20People();
  void command_20People_data();
  void command_20People();
};

namespace {

constexpr int kSamples = 2000;
constexpr int kPeople = 20;
constexpr int kRounds = 15;

}  // namespace

void MppiBench::draw_2000Samples20People_data() {
  QTest::addColumn<int>("path");
  QTest::addColumn<bool>("isSocial");
  QTest::newRow("SSE2") << 0 << false;
  QTest::newRow("AVX2") << 1 << false;
  QTest::newRow("AVX-512") << 2 << false;
  QTest::newRow("SSE2, comfort") << 0 << true;
  QTest::newRow("AVX2, comfort") << 1 << true;
  QTest::newRow("AVX-512, comfort") << 2 << true;
}

void MppiBench::draw_2000Samples20People() {
  QFETCH(int, path);
  QFETCH(bool, isSocial);
  if (!isMppiSimdLevelSupported(static_cast<MppiSimdLevel>(path))) {
    QSKIP("not on this processor");
  }
  const mppitest::HandMade scene(kPeople, isSocial);
  mppitest::Columns columns(kSamples, scene.problem.steps);
  const MppiKernel kernel = mppiKernelFor(static_cast<MppiSimdLevel>(path));
  const double vector =
      fastestOf(kRounds, [&] { kernel.draw(scene.problem, columns.view(), 0, kSamples); });
  std::size_t count = 0;
  const double plain =
      fastestOf(2, [&] { count += reference::rollAll(scene.problem, 0, kSamples).size(); });
  QCOMPARE(count, static_cast<std::size_t>(2 * kSamples));
  qInfo("kernel %.3f ms, plain %.1f ms, ratio %.1f", vector, plain, plain / vector);
  QTest::setBenchmarkResult(vector, QTest::WalltimeMilliseconds);
}

void MppiBench::command_20People_data() {
  QTest::addColumn<bool>("isSocial");
  QTest::newRow("mppi") << false;
  QTest::newRow("social_mppi") << true;
}

void MppiBench::command_20People() {
  QFETCH(bool, isSocial);
  PlannerSetup setup;
  setup.body = mppitest::discRobot(Kinematics::Differential);
  setup.robotId = 0;
  std::optional<SocialMppiParameters> social;
  if (isSocial) {
    social = SocialMppiParameters{};
  }
  MppiPlanner planner(setup, {}, social);
  const mppitest::Scene scene = mppitest::SceneMaker(mppitest::Meeting::Crowd, 1).make();
  std::vector<mppitest::Human> people = scene.people;
  const mppitest::Scene more = mppitest::SceneMaker(mppitest::Meeting::Crowd, 2).make();
  people.insert(people.end(), more.people.begin(), more.people.end());
  QCOMPARE(static_cast<int>(people.size()), kPeople);
  int call = 0;
  const double time = fastestOf(kRounds, [&] {
    const auto command = planner.command(
        scene.world->observe(scene.pose, {0.5, 0.0, 0.0}, scene.goal, people, 0.05 * call));
    QVERIFY(static_cast<bool>(command));
    ++call;
  });
  qInfo("%.3f ms per call", time);
  QTest::setBenchmarkResult(time, QTest::WalltimeMilliseconds);
}

QTEST_APPLESS_MAIN(MppiBench)
#include "bench_Mppi.moc"
