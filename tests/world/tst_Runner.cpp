#include <algorithm>
#include <cmath>

#include <QtTest>

#include "sim2d/world/Runner.h"
#include "tests/support/TraceHash.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

Scenario crossing() {
  Scenario scenario;
  addRoom(scenario, Vec2(-6.0, -6.0), Vec2(6.0, 6.0));
  for (int i = 0; i < 8; ++i) {
    const double angle = i * base::kPi / 4.0;
    addGoal(scenario, i + 1, -4.0 * std::cos(angle), -4.0 * std::sin(angle));
    addPerson(scenario, i, Vec2(4.0 * std::cos(angle), 4.0 * std::sin(angle)), {i + 1}).groupId =
        i < 2 ? 3 : -1;
  }
  addDoor(scenario, Vec2(0.0, 5.0), Vec2(1.0, 5.0), true, {2.0});
  addRobot(scenario, Vec2(-5.0, -5.0), Vec2(5.0, 5.0));
  return scenario;
}

Trace traceOf(const Scenario& scenario, std::int64_t steps) {
  const auto world = make(scenario);
  Recording recording;
  run(*world, {steps, false}, recording);
  return recording.trace(world->header());
}

}  // namespace

class RunnerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void stopRuleOf_scenario_followsTheContract() {
    Scenario scenario;
    QCOMPARE(stopRuleOf(scenario).maximumSteps, std::int64_t{1200});
    QVERIFY(!stopRuleOf(scenario).stopOnArrival);
    addRobot(scenario, Vec2::Zero(), Vec2(1.0, 0.0));
    QCOMPARE(stopRuleOf(scenario).maximumSteps, std::int64_t{2400});
    QVERIFY(stopRuleOf(scenario).stopOnArrival);
    scenario.desktop.duration = 7.0;
    scenario.desktop.dt = 0.1;
    QCOMPARE(stopRuleOf(scenario).maximumSteps, std::int64_t{70});
    QVERIFY(!stopRuleOf(scenario).stopOnArrival);
  }

  void run_duration_recordsEveryFrameAndTheStop() {
    const Trace trace = traceOf(crossing(), 50);
    QCOMPARE(trace.frames.size(), std::size_t{51});
    QCOMPARE(trace.frames.back().step, std::int64_t{50});
    QVERIFY(trace.events.back().second.kind == EventKind::Stop);
    QVERIFY(trace.events.back().second.text == "duration");
    QCOMPARE(trace.events.back().first, std::int64_t{50});
  }

  void run_robotArrives_endsOneSecondLater() {
    Scenario scenario;
    addRobot(scenario, Vec2::Zero(), Vec2(2.0, 0.0));
    const auto world = make(scenario);
    Recording recording;
    const RunResult result = run(*world, stopRuleOf(scenario), recording);
    QVERIFY(result.status == RunStatus::Finished && result.reason == "arrived");
    QVERIFY(std::fabs(world->time() - *world->arrivedAt() - 1.0) < 1e-9);
    QCOMPARE(result.steps, world->stepIndex());
  }

  void run_interrupted_keepsWhatIsDone() {
    const auto world = make(crossing());
    Recording recording;
    const RunResult result =
        run(*world, {100, false}, recording, [](const Frame& frame) { return frame.step == 12; });
    QVERIFY(result.status == RunStatus::Interrupted);
    QCOMPARE(recording.trace(world->header()).frames.size(), std::size_t{13});
  }

  void run_diverged_failsWithTheReason() {
    const auto world = make(crossing(), [](const WorldView& view, Intents& intents) {
      intents.of(2).speed = view.step() > 9 ? std::nan("") : 1.0;
    });
    Recording recording;
    const RunResult result = run(*world, {100, false}, recording);
    QVERIFY(result.status == RunStatus::Failed);
    QVERIFY(result.reason.find("person2") != std::string::npos);
    const Trace trace = recording.trace(world->header());
    QCOMPARE(trace.frames.size(), std::size_t{10});
    QVERIFY(trace.events.back().second.text == result.reason);
  }

  void run_twice_givesEqualTraces() {
    const Trace first = traceOf(crossing(), 300);
    const Trace second = traceOf(crossing(), 300);
    QVERIFY(trajectoryCsv(first) == trajectoryCsv(second));
    QVERIFY(eventsCsv(first) == eventsCsv(second));
    QVERIFY(traceJson(first.header) == traceJson(second.header));
  }

  void run_peopleListedInAnotherOrder_givesAnEqualTrace() {
    Scenario shuffled = crossing();
    std::reverse(shuffled.humans.begin(), shuffled.humans.end());
    std::swap(shuffled.humans[1], shuffled.humans[4]);
    QVERIFY(hashOf(traceOf(crossing(), 300)) == hashOf(traceOf(shuffled, 300)));
  }

  void run_threads_giveEqualTraces_data() {
    QTest::addColumn<QString>("model");
    for (const std::string& model : builtinRegistries().models.names()) {
      QTest::newRow(model.c_str()) << QString::fromStdString(model);
    }
  }

  void run_threads_giveEqualTraces() {
    QFETCH(QString, model);
    Scenario scenario;
    scenario.desktop.model = model.toStdString();
    addGoal(scenario, 1, 40.0, 0.0);
    addGoal(scenario, 2, -40.0, 0.0);
    addWall(scenario, {Vec2(-30.0, 12.0), Vec2(30.0, 12.0)});
    for (int i = 0; i < 240; ++i) {
      const int row = i / 24;
      addPerson(scenario, i, Vec2(-24.0 + 2.0 * (i % 24), -10.0 + 2.0 * row), {i % 2 + 1});
    }
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 8}) {
      WorldSetup setup = setupOf(scenario);
      setup.threads = threads;
      auto world = make(std::move(setup));
      Recording recording;
      run(*world, {40, false}, recording);
      hashes.push_back(hashOf(recording.trace(world->header())));
    }
    QCOMPARE(hashes[1], hashes[0]);
    QCOMPARE(hashes[2], hashes[0]);
  }

  void run_asTheOriginal_passesThroughEachOther() {
    Scenario scenario;
    addGoal(scenario, 1, 8.0, 0.0);
    addGoal(scenario, 2, -8.0, 0.0);
    addPerson(scenario, 1, Vec2(-4.0, 0.0), {1});
    addPerson(scenario, 2, Vec2(4.0, 0.0), {2});
    WorldSetup setup = setupOf(scenario);
    setup.compatibility = *Compatibility::parse("hunav2");
    auto world = make(std::move(setup));
    double least = 1e9;
    advance(*world, 400, [&](const Frame& frame) {
      least = std::min(least, (positionOf(frame, 0) - positionOf(frame, 1)).norm());
    });
    QVERIFY(std::fabs(least - 0.0085229617) < 1e-3);  // by a program of its own
    QVERIFY(world->header().humans[0].model == "sfm-hunav2");
  }
};

QTEST_APPLESS_MAIN(RunnerTest)
#include "tst_Runner.moc"
