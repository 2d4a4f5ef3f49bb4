#include <limits>

#include <QSignalSpy>
#include <QtTest>

#include "SmallScenario.h"
#include "editor/run/SimulationRunner.h"

using namespace editor;

namespace {

/// All that the files tell of a run, from a state on.
std::string allOf(const RecordingPtr& recording, std::size_t from = 0) {
  std::string rows;
  for (std::size_t k = from; k < recording->size(); ++k) {
    sim2d::appendTrajectoryRows(rows, *recording->frame(k));
  }
  for (std::size_t k = 0; k < recording->events().size(); ++k) {
    const auto& [step, event] = recording->events()[k];
    sim2d::appendEventRow(rows, step, recording->header()->dt, event);
  }
  return rows + (from == 0 ? recording->treesCsv() : std::string());
}

}  // namespace

/// Runs that left another one.
class BranchesTest : public QObject {
  Q_OBJECT

 private:
  static constexpr std::int64_t kSteps = 80, kFork = 30;
  ScenarioDocument document_;
  std::unique_ptr<SimulationRunner> runner_;

  void runToTheEnd() {
    QSignalSpy finished(runner_.get(), &SimulationRunner::finished);
    runner_->play();
    QVERIFY(finished.wait(60000));
  }
  void fork(std::int64_t step, const app::RunSpec& changes = {}) {
    runner_->seek(step);
    QVERIFY(runner_->branchFromShown(changes));
    QTRY_VERIFY_WITH_TIMEOUT(
        runner_->newestFrame() != nullptr && runner_->newestFrame()->step == step, 60000);
    QCOMPARE(runner_->state(), SimulationRunner::State::Paused);
  }
  static app::RunSpec slower() {
    app::RunSpec changes;
    changes.set = {"robot1.max_vel=0.3"};
    return changes;
  }

 private Q_SLOTS:
  void init() {
    sim2d::Scenario scenario = small::scenario();
    scenario.desktop.duration = 4.0;  // 80 steps
    document_.load(std::move(scenario));
    document_.setMap(small::room());
    runner_ = std::make_unique<SimulationRunner>();
    runner_->setRequest([this] {
      app::RunSettings settings;
      settings.code = sim2d::ExternalCodePolicy::Refused;
      return runRequestOf(document_, settings);
    });
    runner_->setSpeed(std::numeric_limits<double>::infinity());
    runToTheEnd();
    QCOMPARE(runner_->newestFrame()->step, kSteps);
  }
  void cleanup() { runner_.reset(); }

  void branch_withNothingChanged_isTheRunByteForByte() {
    const RecordingPtr first = runner_->recording();
    fork(kFork);
    QVERIFY(runner_->recording() != first);
    runToTheEnd();
    QCOMPARE(allOf(runner_->recording()), allOf(first));
    QCOMPARE(runner_->branches().size(), std::size_t{2});
    const RunnerBranch& branch = runner_->branches()[1];
    QCOMPARE(branch.from, 0);
    QVERIFY(std::fabs(branch.branchTime - 1.5) < 1e-9);
    QVERIFY(branch.changed.isEmpty());
  }

  void branch_changed_isTheRunUpToThere() {
    const RecordingPtr first = runner_->recording();
    const std::string before = allOf(first);
    fork(kFork, slower());
    runToTheEnd();
    const RecordingPtr other = runner_->recording();
    for (std::size_t k = 0; k <= kFork; ++k) {
      QVERIFY(first->frame(k)->humans == other->frame(k)->humans);
      QVERIFY(first->frame(k)->robots == other->frame(k)->robots);
    }
    QVERIFY(!(first->frame(kSteps)->robots == other->frame(kSteps)->robots));
    QCOMPARE(runner_->branches()[1].changed, QStringLiteral("robot1.max_vel = 0.3"));
    QCOMPARE(allOf(first), before);  // the earlier one is not lost
    QCOMPARE(runner_->recordingOf(0), first);
  }

  void showBranch_atTheSameTime_andBack() {
    const RecordingPtr first = runner_->recording();
    fork(kFork, slower());
    runToTheEnd();
    const RecordingPtr other = runner_->recording();
    runner_->seek(50);
    runner_->showBranch(0);
    QCOMPARE(runner_->branch(), 0);
    QCOMPARE(runner_->recording(), first);
    QCOMPARE(runner_->shownFrame()->step, std::int64_t{50});
    QVERIFY(runner_->isLookingBack() && runner_->isFinished());
    QVERIFY(runner_->canBranchFromShown());
    runner_->showBranch(1);
    QCOMPARE(runner_->recording(), other);
    QCOMPARE(runner_->shownFrame()->step, std::int64_t{50});
  }

  /// One that was left on its way is made again to where it was, and goes on.
  void showBranch_unfinished_goesOn() {
    const std::string whole = allOf(runner_->recording());
    fork(kFork);
    QVERIFY(!runner_->isFinished());
    runner_->showBranch(0);
    QVERIFY(runner_->isFinished());
    runner_->showBranch(1);
    QTRY_VERIFY_WITH_TIMEOUT(
        runner_->newestFrame() != nullptr && runner_->newestFrame()->step == kFork, 60000);
    runToTheEnd();
    QCOMPARE(allOf(runner_->recording()), whole);
  }

  /// A branch of a branch keeps what was changed before.
  void branch_ofABranch_keepsItsChanges() {
    fork(kFork, slower());
    runToTheEnd();
    const RecordingPtr slow = runner_->recording();
    fork(50);
    runToTheEnd();
    QCOMPARE(allOf(runner_->recording()), allOf(slow));
    QCOMPARE(runner_->branches()[2].from, 1);
  }

  void branch_movedPerson_standsThere() {
    app::RunSpec changes;
    changes.moves = {"Ana 3 3 0"};
    fork(kFork, changes);
    runner_->stepOnce();
    QTRY_COMPARE(runner_->newestFrame()->step, kFork + 1);
    const sim2d::HumanColumns& humans = runner_->newestFrame()->humans;
    QCOMPARE(humans.id[0], 1);
    QVERIFY(std::hypot(humans.x[0] - 3.0, humans.y[0] - 3.0) < 0.15);
  }

  void branch_thatCannotBe_isToldAndNothingChanges() {
    QSignalSpy warned(runner_.get(), &SimulationRunner::warned);
    const RecordingPtr first = runner_->recording();
    runner_->seek(kFork);
    for (const char* set : {"robot1.radius=0.9", "robot1.planner=nobody", "what"}) {
      app::RunSpec changes;
      changes.set = {set};
      QVERIFY2(!runner_->branchFromShown(changes), set);
    }
    QCOMPARE(warned.count(), 3);
    QCOMPARE(runner_->recording(), first);
    QCOMPARE(runner_->branches().size(), std::size_t{1});
    QCOMPARE(runner_->shownFrame()->step, kFork);
  }

  void branches_tooMany_areRefused() {
    for (std::size_t k = 1; k < SimulationRunner::kMaxBranches; ++k) {
      runner_->showBranch(0);
      runner_->seek(kFork);
      QVERIFY(runner_->branchFromShown());
    }
    runner_->showBranch(0);
    runner_->seek(kFork);
    QVERIFY(!runner_->canBranchFromShown());
    runner_->removeBranch(3);
    QVERIFY(runner_->canBranchFromShown());
    runner_->removeBranch(0);  // it is shown
    QCOMPARE(runner_->branches().size(), SimulationRunner::kMaxBranches - 1);
    runner_->renameBranch(2, QStringLiteral("  Slow "));
    QCOMPARE(runner_->branches()[2].name, QStringLiteral("Slow"));
    runner_->reset();
    QVERIFY(runner_->branches().empty());
    QCOMPARE(runner_->branch(), -1);
  }

  void recordedRun_thatIsKnown_isForked() {
    const RecordingPtr first = runner_->recording();
    const auto again = runner_->again();
    SimulationRunner other;
    other.setSpeed(std::numeric_limits<double>::infinity());
    other.openRecorded(first);
    QVERIFY(!other.canBranchFromShown());
    other.openRecorded(first, again);
    other.seek(kFork);
    QSignalSpy warned(&other, &SimulationRunner::warned);
    QVERIFY(other.branchFromShown());
    QSignalSpy finished(&other, &SimulationRunner::finished);
    other.play();
    QVERIFY(finished.wait(60000));
    QCOMPARE(warned.count(), 0);
    QCOMPARE(allOf(other.recording()), allOf(first));
    other.showBranch(0);
    QVERIFY(other.isRecorded());
    QCOMPARE(other.recording(), first);
  }

  /// Another world than that of the record, as another program might make it.
  void recordedRun_madeAgainOtherwise_isTold() {
    SimulationRunner other;
    other.setSpeed(std::numeric_limits<double>::infinity());
    sim2d::Scenario scenario = document_.scenario();
    scenario.humans[0].initPose.position.x() += 0.25;
    document_.load(std::move(scenario));
    document_.setMap(small::room());
    app::RunSettings settings;
    settings.code = sim2d::ExternalCodePolicy::Refused;
    other.openRecorded(runner_->recording(),
                       [this, settings] { return runRequestOf(document_, settings); });
    other.seek(kFork);
    QSignalSpy warned(&other, &SimulationRunner::warned);
    QVERIFY(other.branchFromShown());
    QTRY_COMPARE(warned.count(), 1);
    const auto problems = warned.front().front().value<base::Diagnostics>();
    QVERIFY(problems.front().code == "again.branch-elsewhere");
  }
};

QTEST_MAIN(BranchesTest)
#include "tst_Branches.moc"
