#include <atomic>
#include <future>
#include <limits>
#include <numeric>

#include <QSignalSpy>
#include <QtTest>

#include "SmallScenario.h"
#include "editor/run/SimulationRunner.h"

using namespace editor;

namespace {

/// Everybody walks to their goals in order.
class Walking : public sim2d::HumanBehavior {
 public:
  void enter(int, const sim2d::WorldView&) override {}
  void decide(const sim2d::WorldView& view, sim2d::Intents& intents) override {
    for (int i = 0; i < view.humanCount(); ++i) {
      sim2d::Intent& intent = intents.of(i);
      const sim2d::HumanControl& control = intents.control(i);
      if (view.isPresent(i) && !control.goals.empty()) {
        intent.motion = sim2d::Motion::Walk;
        intent.target = control.goals.front();
        intent.targetIsGoal = true;
        intent.speed = view.constants(i).desiredSpeed;
      }
    }
  }
};

base::Result<std::unique_ptr<sim2d::World>> makeWorld() {
  sim2d::WorldSetup setup;
  setup.scenario = std::make_shared<const sim2d::Scenario>(small::scenario());
  setup.map = *small::room();
  setup.behavior = std::make_unique<Walking>();
  return sim2d::World::create(std::move(setup));
}

using ObserverFactory = std::vector<app::Session::Observer>;

RunRequest request(std::int64_t steps) {
  RunRequest result;
  result.makeWorld = makeWorld;
  result.rule = {steps, true};
  result.again = [steps] { return request(steps); };
  return result;
}

constexpr double kFast = std::numeric_limits<double>::infinity();

/// Runs of so many steps.
struct TestRunner : SimulationRunner {
  explicit TestRunner(std::int64_t steps, double speed = 1.0) {
    setRequest([steps] { return request(steps); });
    setSpeed(speed);
  }
};

}  // namespace

class SimulationRunnerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Were it to wait, this test would not end.
  void reset_whileTheWorldIsMade_doesNotWait() {
    std::promise<void> gate;
    const std::shared_future<void> opened = gate.get_future().share();
    SimulationRunner runner;
    runner.setRequest([opened] {
      RunRequest result = request(5);
      result.makeWorld = [opened] {
        opened.wait();
        return makeWorld();
      };
      return result;
    });
    QSignalSpy finished(&runner, &SimulationRunner::finished);
    runner.setSpeed(kFast);
    runner.play();
    runner.reset();
    QCOMPARE(runner.state(), SimulationRunner::State::Editing);
    runner.play();
    gate.set_value();
    QTRY_COMPARE(finished.count(), 1);  // the second run; nobody hears of the first
    QCOMPARE(runner.newestFrame()->step, std::int64_t{5});
  }

  /// The making is told that nobody waits, and what is left of it goes when it has ended.
  void reset_whileTheWorldIsMade_keepsNothing() {
    std::promise<void> gate;
    const std::shared_future<void> opened = gate.get_future().share();
    std::weak_ptr<int> memory;
    std::shared_ptr<base::StopFlag> left;
    SimulationRunner runner;
    runner.setRequest([&memory, &left, opened] {
      const auto held = std::make_shared<int>(1);
      memory = held;
      RunRequest result = request(5);
      left = result.left;
      result.makeWorld = [opened, held] {
        opened.wait();
        return makeWorld();
      };
      return result;
    });
    runner.play();
    left->check();
    runner.reset();
    QVERIFY_EXCEPTION_THROWN(left->check(), base::Stopped);
    QVERIFY(!memory.expired());
    gate.set_value();
    QTRY_VERIFY(memory.expired());
  }

  /// The last one too, and what is made again.
  void guests_seeEachStateOnceAndGoWithTheRun() {
    TestRunner runner(20, kFast);
    std::vector<std::int64_t> seen;
    std::weak_ptr<int> memory;
    runner.setObserverFactory(
        [&](app::Session& /*session*/, sim2d::World& /*world*/, const auto& /*made*/) {
          const auto held = std::make_shared<int>(1);
          memory = held;
          return ObserverFactory{
              {[&seen, held](const sim2d::Frame& frame) { seen.push_back(frame.step); }, {}}};
        });
    QSignalSpy finished(&runner, &SimulationRunner::finished);
    connect(&runner, &SimulationRunner::finished, this, [&] { QVERIFY(memory.expired()); });
    runner.play();
    QTRY_COMPARE(finished.count(), 1);
    std::vector<std::int64_t> expected(21);
    std::iota(expected.begin(), expected.end(), 0);
    QCOMPARE(seen, expected);
    seen.clear();
    runner.seek(15);
    runner.branchFromShown();
    QTRY_VERIFY(runner.newestFrame() != nullptr && runner.newestFrame()->step == 15);
    runner.setObserverFactory({});  // of the runs after this one
    runner.play();
    QTRY_COMPARE(finished.count(), 2);
    QCOMPARE(seen, expected);
  }

  /// In the step that comes next, also a single one.
  void guests_giveInputsJustBeforeTheStep() {
    TestRunner runner(40);
    std::atomic<bool> isWanted{false};
    runner.setObserverFactory(
        [&](app::Session& /*session*/, sim2d::World& world, const auto& /*made*/) {
          const int id = world.frame().humans.id.front();
          return ObserverFactory{{[](const sim2d::Frame& /*frame*/) {},
                                  [&isWanted, id](const sim2d::Frame& /*frame*/) {
                                    sim2d::Input push;
                                    push.kind = sim2d::InputKind::Push;
                                    push.id = id;
                                    push.velocity = {0.3, 0.2};
                                    return isWanted ? sim2d::StepInputs{push} : sim2d::StepInputs{};
                                  }}};
        });
    for (std::int64_t step = 1; step < 4; ++step) {
      runner.stepOnce();
      QTRY_VERIFY(runner.newestFrame() != nullptr && runner.newestFrame()->step == step);
      QCOMPARE(runner.recording()->inputs().size(), step == 3 ? std::size_t{1} : std::size_t{0});
      isWanted = step == 2;
    }
    QCOMPARE(runner.recording()->inputs()[0].first, std::int64_t{3});
  }

  /// Foxglove pauses; the window shows it.
  void guests_pauseAndSpeed_areFollowed() {
    TestRunner runner(400);
    std::atomic<app::Session*> session{nullptr};
    runner.setObserverFactory(
        [&](app::Session& its, sim2d::World& /*world*/, const auto& /*made*/) {
          return ObserverFactory{{[&](const sim2d::Frame& frame) {
                                    if (frame.step == 5) {
                                      its.setPaused(true);
                                      its.setSpeed(64.0);
                                      session = &its;
                                    }
                                  },
                                  {}}};
        });
    QSignalSpy finished(&runner, &SimulationRunner::finished);
    QSignalSpy ordered(&runner, &SimulationRunner::speedRequested);
    runner.setSpeed(kFast);
    runner.play();
    QTRY_COMPARE(runner.state(), SimulationRunner::State::Paused);
    QTRY_COMPARE(ordered.count(), 1);
    QCOMPARE(runner.speed(), 64.0);
    QTest::qWait(50);
    QCOMPARE(runner.newestFrame()->step, std::int64_t{5});
    runner.seek(2);  // a look back
    QVERIFY(runner.isLookingBack());
    session.load()->setPaused(false);
    QTRY_VERIFY(!runner.isLookingBack());
    QTRY_COMPARE(finished.count(), 1);
    QCOMPARE(runner.newestFrame()->step, runner.result()->steps);  // the robot arrives before 400
    QVERIFY(runner.newestFrame()->step > 100);
  }

  /// What was done to people is done again; then somebody may do something else.
  void goOnFromShown_repeatsAndWaits() {
    TestRunner runner(40, kFast);
    QSignalSpy finished(&runner, &SimulationRunner::finished);
    runner.stepOnce();
    QTRY_VERIFY(runner.newestFrame() != nullptr && runner.newestFrame()->step == 1);
    const int id = runner.newestFrame()->humans.id.front();
    runner.steer([id](const sim2d::Frame& frame) {
      sim2d::Input push;
      push.kind = sim2d::InputKind::Push;
      push.id = id;
      push.velocity = {0.3, 0.2};
      return frame.step % 3 == 0 ? sim2d::StepInputs{push} : sim2d::StepInputs{};
    });
    runner.play();
    QTRY_COMPARE(finished.count(), 1);
    QVERIFY(!runner.canBranchFromShown());  // the end is no past
    const editor::RecordingPtr first = runner.recording();
    QVERIFY(first->inputs().size() > 10);
    runner.seek(20);
    QVERIFY(runner.canBranchFromShown());
    runner.branchFromShown();
    QTRY_VERIFY(runner.newestFrame() != nullptr && runner.newestFrame()->step == 20);
    QTest::qWait(50);
    QCOMPARE(runner.newestFrame()->step, std::int64_t{20});
    QCOMPARE(runner.state(), SimulationRunner::State::Paused);
    QVERIFY(!runner.isFinished() && !runner.isLookingBack() && runner.recording() != first);
    const auto rows = [](const editor::RecordingPtr& recording, std::size_t index) {
      std::string text;
      sim2d::appendTrajectoryRows(text, *recording->frame(index));
      return text;
    };
    for (std::size_t index = 0; index <= 20; ++index) {
      QCOMPARE(rows(runner.recording(), index), rows(first, index));
    }
    runner.play();  // nobody pushes now
    QTRY_COMPARE(finished.count(), 2);
    QCOMPARE(runner.newestFrame()->step, std::int64_t{40});
    QVERIFY(rows(runner.recording(), 40) != rows(first, 40));
  }

  void play_workOnTheMapIsStopped_isOver() {
    SimulationRunner runner;
    runner.setRequest([] {
      RunRequest result = request(5);
      result.makeWorld = []() -> base::Result<std::unique_ptr<sim2d::World>> {
        throw base::Stopped();
      };
      return result;
    });
    QSignalSpy refused(&runner, &SimulationRunner::notStarted);
    runner.play();
    QTRY_COMPARE(runner.state(), SimulationRunner::State::Editing);
    QCOMPARE(refused.count(), 0);
  }

  void record_asFastAsPossible_equalsTheHeadlessRun() {
    auto world = makeWorld();
    QVERIFY(bool(world));
    sim2d::Recording recording;
    const sim2d::RunResult expected = sim2d::run(**world, {200, true}, recording);
    const sim2d::Trace headless = recording.trace((*world)->header());

    TestRunner runner(200, kFast);
    QSignalSpy finished(&runner, &SimulationRunner::finished);
    runner.play();
    QTest::qWait(20);
    runner.pause();
    runner.stepOnce();
    runner.play();
    QVERIFY(finished.wait(20000));
    QVERIFY(runner.isFinished());
    QCOMPARE(runner.state(), SimulationRunner::State::Paused);
    const sim2d::Trace trace = runner.recording()->trace();
    QVERIFY(sim2d::trajectoryCsv(trace) == sim2d::trajectoryCsv(headless));
    QVERIFY(sim2d::eventsCsv(trace) == sim2d::eventsCsv(headless));
    QVERIFY(sim2d::traceJson(trace.header) == sim2d::traceJson(headless.header));
    QVERIFY(runner.recording()->treesCsv() == recording.treesCsv());
    const auto result = finished.front().front().value<sim2d::RunResult>();
    QCOMPARE(result.steps, expected.steps);
    QVERIFY(result.reason == expected.reason);
    QCOMPARE(runner.recording()->size(), static_cast<std::size_t>(expected.steps) + 1);
  }

  /// A run that is over is played from its recording: nothing is lost, nothing computed twice.
  void play_afterTheEnd_playsTheSameRun() {
    SimulationRunner runner;
    int started = 0;
    runner.setRequest([&] {
      ++started;
      return request(40);
    });
    runner.setSpeed(kFast);
    runner.play();
    QTRY_VERIFY_WITH_TIMEOUT(runner.isFinished(), 20000);
    const RecordingPtr recording = runner.recording();
    runner.seek(10);
    QVERIFY(runner.isLookingBack());
    runner.setSpeed(4.0);
    std::vector<std::int64_t> seen;
    connect(&runner, &SimulationRunner::frameShown, this, [&](const FramePtr& frame) {
      if (frame != nullptr) {  // null: left
        seen.push_back(frame->step);
      }
    });
    runner.play();
    QCOMPARE(runner.state(), SimulationRunner::State::Running);
    QTRY_COMPARE_WITH_TIMEOUT(runner.state(), SimulationRunner::State::Paused, 20000);
    QCOMPARE(runner.shownFrame()->step, std::int64_t{40});
    QVERIFY(!runner.isLookingBack());
    QVERIFY(std::is_sorted(seen.begin(), seen.end()) && seen.front() >= 10);
    runner.play();  // at the end: from the beginning
    runner.pause();
    QVERIFY(runner.shownFrame()->step < 40);
    QVERIFY(runner.recording() == recording);
    QCOMPARE(started, 1);
    QVERIFY(runner.result()->reason == "duration");
    runner.reset();
    QVERIFY(!runner.result());
  }

  void play_whereTheLastStepIsNotRecorded_ends() {
    SimulationRunner runner;
    runner.setRequest([] {
      RunRequest sparse = request(43);
      sparse.recordEvery = 5;
      return sparse;
    });
    runner.setSpeed(kFast);
    runner.play();
    QTRY_VERIFY_WITH_TIMEOUT(runner.isFinished(), 20000);
    QCOMPARE(runner.recording()->stepOf(runner.recording()->size() - 1), std::int64_t{40});
    runner.seek(10);
    runner.play();
    QTRY_COMPARE_WITH_TIMEOUT(runner.state(), SimulationRunner::State::Paused, 20000);
    QCOMPARE(runner.shownFrame()->step, std::int64_t{43});
    QVERIFY(!runner.isLookingBack());
    runner.play();
    QCOMPARE(runner.state(), SimulationRunner::State::Running);
    QVERIFY(runner.shownFrame()->step < 43);
  }

  void setSpeed_afterTheEnd_keepsTheMeasuredOne() {
    TestRunner runner(3);
    runner.play();
    QTRY_VERIFY_WITH_TIMEOUT(runner.isFinished(), 20000);
    const double measured = runner.measuredSpeed();
    runner.setSpeed(16.0);
    QCOMPARE(runner.measuredSpeed(), measured);
  }

  void stepOnce_fromEditing_makesOneStep() {
    TestRunner runner(1000);
    runner.stepOnce();
    QCOMPARE(runner.state(), SimulationRunner::State::Paused);
    QTRY_VERIFY(runner.shownFrame() != nullptr && runner.shownFrame()->step == 1);
    runner.stepOnce();
    QTRY_COMPARE(runner.shownFrame()->step, std::int64_t{2});
    QTest::qWait(60);
    QCOMPARE(runner.newestFrame()->step, std::int64_t{2});
    runner.stepBack();
    QCOMPARE(runner.shownFrame()->step, std::int64_t{1});
    QVERIFY(runner.isLookingBack());
    runner.stepOnce();
    QCOMPARE(runner.shownFrame()->step, std::int64_t{2});
    QVERIFY(!runner.isLookingBack());
  }

  void play_atRealTime_keepsPace() {
    TestRunner runner(1000);
    runner.play();
    QTRY_VERIFY(runner.newestFrame() != nullptr);
    QElapsedTimer timer;
    timer.start();
    QTRY_VERIFY_WITH_TIMEOUT(runner.newestFrame()->time >= 0.5, 50000);  // however slow the machine
    runner.pause();
    const double wall = 0.001 * static_cast<double>(timer.elapsed());
    QTest::qWait(60);
    QVERIFY(runner.newestFrame()->time <= wall + 0.3);  // but never ahead of the clock
  }

  void seek_duringARun_pausesAndShowsThePast() {
    TestRunner runner(1000, 20.0);
    runner.play();
    QTRY_VERIFY(runner.newestFrame() != nullptr && runner.newestFrame()->step > 20);
    runner.seek(7);
    QCOMPARE(runner.state(), SimulationRunner::State::Paused);
    QCOMPARE(runner.shownFrame()->step, std::int64_t{7});
    runner.play();
    QVERIFY(!runner.isLookingBack());
    QCOMPARE(runner.state(), SimulationRunner::State::Running);
  }

  /// States are recorded, but none has come to the window yet.
  void seek_beforeTheFirstState_showsNothing() {
    TestRunner runner(1000);
    QSignalSpy shown(&runner, &SimulationRunner::frameShown);
    runner.play();
    while (runner.recording() == nullptr) {
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 10);
    }
    while (runner.recording()->size() < 2) {
      QThread::msleep(1);  // nothing is delivered meanwhile
    }
    if (runner.newestFrame() == nullptr) {
      runner.seek(0);
      QVERIFY(runner.shownFrame() == nullptr && shown.isEmpty());
    }
    QTRY_VERIFY(runner.newestFrame() != nullptr);
    runner.seek(0);
    QCOMPARE(runner.shownFrame()->step, std::int64_t{0});
  }

  void reset_duringARun_clearsAndLeavesTheRecording() {
    TestRunner runner(1000);
    runner.play();
    QTRY_VERIFY(runner.newestFrame() != nullptr && runner.newestFrame()->step > 0);
    const editor::RecordingPtr kept = runner.recording();
    runner.reset();
    QCOMPARE(runner.state(), SimulationRunner::State::Editing);
    QVERIFY(runner.shownFrame() == nullptr);
    QVERIFY(runner.recording() == nullptr);
    QVERIFY(kept->events()[kept->events().size() - 1].second.text == "interrupted");
    runner.play();
    QTRY_VERIFY(runner.shownFrame() != nullptr);
  }

  void openRecorded_playsScrubsAndIsLeft() {
    auto world = makeWorld();
    QVERIFY(bool(world));
    auto recording = std::make_shared<sim2d::Recording>();
    sim2d::run(**world, {100, false}, *recording);
    recording->setHeader((*world)->header());
    SimulationRunner runner;
    runner.openRecorded(recording);
    QVERIFY(runner.isRecorded() && runner.isFinished() && !runner.isLookingBack());
    QCOMPARE(runner.state(), SimulationRunner::State::Paused);
    QCOMPARE(runner.shownFrame()->step, std::int64_t{0});
    QCOMPARE(runner.newestFrame()->step, std::int64_t{100});
    runner.stepOnce();
    runner.stepOnce();
    runner.stepBack();
    QCOMPARE(runner.shownFrame()->step, std::int64_t{1});
    runner.setSpeed(2.0);
    runner.play();
    QTRY_VERIFY(runner.shownFrame()->step > 5);
    runner.pause();
    QCOMPARE(runner.state(), SimulationRunner::State::Paused);
    runner.seek(40);
    QVERIFY(runner.shownFrame()->humans == recording->frame(40)->humans);
    QVERIFY(!runner.isLookingBack());
    runner.setSpeed(kFast);
    runner.play();
    QTRY_COMPARE(runner.state(), SimulationRunner::State::Paused);  // at its end
    QCOMPARE(runner.shownFrame()->step, std::int64_t{100});
    runner.play();  // once more
    QVERIFY(runner.shownFrame()->step < 100);
    runner.reset();
    QVERIFY(!runner.isRecorded() && runner.recording() == nullptr);
    QCOMPARE(runner.state(), SimulationRunner::State::Editing);
  }

  void makeWorld_withErrors_isToldAndLeavesEditing() {
    SimulationRunner runner;
    runner.setRequest([] {
      RunRequest broken;
      broken.scenarios.now = std::make_shared<sim2d::Scenario>();
      broken.makeWorld = []() -> base::Result<std::unique_ptr<sim2d::World>> {
        return base::error("run.failed", {"no place for Ana"});
      };
      return broken;
    });
    QSignalSpy spy(&runner, &SimulationRunner::notStarted);
    runner.play();
    QVERIFY(spy.wait(5000));
    QCOMPARE(runner.state(), SimulationRunner::State::Editing);
    QVERIFY(runner.scenarios().now == nullptr);  // no run beside the edited scenario
    QVERIFY(spy.front().front().value<base::Diagnostics>().front().message == "no place for Ana");
  }
};

QTEST_MAIN(SimulationRunnerTest)
#include "tst_SimulationRunner.moc"
