#include <limits>

#include <QSignalSpy>
#include <QtTest>

#include "SmallScenario.h"
#include "editor/panels/MetricsFeed.h"
#include "editor/panels/runs/Playback.h"

using namespace editor;

namespace {

constexpr std::size_t kMega = std::size_t{1} << 20;

/// On open ground, two metres apart, each with two goals of other people's.
sim2d::Scenario crowd(int people, double seconds) {
  constexpr int kInRow = 20;
  sim2d::Scenario scenario = small::scenario();
  scenario.humans.clear();
  scenario.goals.clear();
  scenario.obstacles.clear();
  scenario.doors.clear();
  scenario.areas.clear();
  scenario.desktop.duration = seconds;
  for (int k = 0; k < people; ++k) {
    const int column = k % kInRow, row = k / kInRow;
    const sim2d::Vec2 at(2.0 * column, 2.0 * row);
    const std::string name = "P" + std::to_string(k + 1);
    scenario.goals.push_back(small::goal(1000 + k, k + 1, at + sim2d::Vec2(1.0, 0.7)));
    scenario.humans.push_back(
        small::person(k + 1, name.c_str(), at, 0.0, sim2d::BehaviorType::Regular,
                      {(k * 37 + 11) % people + 1, (k * 53 + 5) % people + 1}));
  }
  return scenario;
}

bool isSame(const sim2d::Frame& a, const sim2d::Frame& b) {
  return a.step == b.step && a.time == b.time && a.humans == b.humans && a.robots == b.robots &&
         a.forces == b.forces && a.robotPaths == b.robotPaths && a.doorOpen == b.doorOpen;
}

}  // namespace

/// Runs that do not fit into their memory, watched and looked back at.
class RunHistoryTest : public QObject {
  Q_OBJECT

 private:
  ScenarioDocument document_;

  void runToTheEnd(SimulationRunner& runner) {
    runner.setRequest([this] { return runRequestOf(document_); });
    runner.setSpeed(std::numeric_limits<double>::infinity());
    QSignalSpy finished(&runner, &SimulationRunner::finished);
    runner.play();
    QVERIFY(finished.wait(300000));
  }
  /// Of 30 people, of which some seconds fit into the memory, and nothing on the disk.
  void runWithoutDisk(SimulationRunner& runner) {
    const QTemporaryDir folder;
    document_.load(crowd(30, 60.0));
    runner.setHistory(kMega / 2, (folder.path() + QStringLiteral("/none")).toStdString());
    runToTheEnd(runner);
  }

 private Q_SLOTS:
  void seek_longRunOfACrowd_showsWhatWasShown() {
    constexpr std::size_t kMemory = 8 * kMega;
    document_.load(crowd(200, 120.0));
    SimulationRunner runner;
    std::map<std::int64_t, FramePtr> shown;
    std::size_t most = 0;
    connect(&runner, &SimulationRunner::frameShown, this, [&](const FramePtr& frame) {
      if (frame != nullptr && shown.size() < 300) {  // 25 kB each
        shown[frame->step] = frame;
      }
      most = std::max(most, runner.recording() ? runner.recording()->history().memory() : 0);
    });
    runner.setHistory(kMemory);
    runToTheEnd(runner);
    const RecordingPtr recording = runner.recording();
    QCOMPARE(recording->size(), std::size_t{2401});
    QVERIFY(shown.size() > 10);
    QVERIFY(recording->history().disk() > kMemory);
    const std::map<std::int64_t, FramePtr> live = shown;
    for (auto each = live.rbegin(); each != live.rend(); ++each) {  // from now back to the start
      runner.seek(each->first);
      QVERIFY2(isSame(*runner.shownFrame(), *each->second), QByteArray::number(int(each->first)));
    }
    runner.seek(0);
    QCOMPARE(runner.shownFrame()->step, std::int64_t{0});
    QVERIFY2(most > kMega && most <= kMemory, QByteArray::number(qulonglong(most)));
    QVERIFY(recording->history().memory() <= kMemory);
    QCOMPARE(runner.oldestTime(), 0.0);
  }

  void seek_diskTakesNothing_endsAtTheOldestStateKept() {
    SimulationRunner runner;
    QSignalSpy cut(&runner, &SimulationRunner::historyTruncated);
    runWithoutDisk(runner);
    QCOMPARE(cut.count(), 1);
    const auto problems = cut.front().front().value<base::Diagnostics>();
    QVERIFY(problems.front().code == "run.history-cut");
    const RecordingPtr recording = runner.recording();
    const std::size_t first = recording->first();
    QVERIFY(first > 0 && first + 1 < recording->size());
    QVERIFY(recording->history().memory() <= kMega / 2);
    QCOMPARE(runner.oldestTime(), recording->timeOf(first));
    runner.seek(0);
    QCOMPARE(runner.shownFrame()->step, recording->stepOf(first));
    QCOMPARE(runner.shownFrame()->humans.size(), std::size_t{30});
    runner.stepBack();
    QCOMPARE(runner.shownFrame()->step, recording->stepOf(first));
    runner.stepOnce();
    QCOMPARE(runner.shownFrame()->step, recording->stepOf(first + 1));
    runner.seekNewest();
    runner.play();  // again, from where it is kept
    QCOMPARE(runner.shownFrame()->step, recording->stepOf(first));
    runner.reset();
    QCOMPARE(runner.oldestTime(), 0.0);
  }

  /// The file is emptied behind the program's back.
  void seek_fileIsLost_isTold() {
    const QTemporaryDir folder;
    document_.load(crowd(30, 60.0));
    SimulationRunner runner;
    runner.setHistory(kMega / 2, folder.path().toStdString());
    runToTheEnd(runner);
    QVERIFY(runner.recording()->history().disk() > 0);
    int emptied = 0;
    const QDir open(QStringLiteral("/proc/self/fd"));
    for (const QFileInfo& each : open.entryInfoList(QDir::Files | QDir::System)) {
      const bool isIts = each.symLinkTarget().startsWith(folder.path());
      emptied += isIts && QFile(each.filePath()).resize(0) ? 1 : 0;
    }
    QCOMPARE(emptied, 1);
    QSignalSpy warned(&runner, &SimulationRunner::warned);
    const FramePtr before = runner.shownFrame();
    runner.seek(0);
    QCOMPARE(warned.count(), 1);
    const auto problems = warned.front().front().value<base::Diagnostics>();
    QCOMPARE(problems.front().code, std::string_view("run.history-unreadable"));
    QCOMPARE(runner.shownFrame(), before);
    runner.seek(runner.newestFrame()->step - 1);  // what is in memory is there
    QCOMPARE(runner.shownFrame()->humans.size(), std::size_t{30});
    QCOMPARE(warned.count(), 1);
  }

  void timeline_diskTakesNothing_beginsLater() {
    SimulationRunner runner;
    RunEvents events(document_, runner);
    TimelineBar bar(document_, events, runner, Theme::light());
    bar.resize(600, 44);
    runWithoutDisk(runner);
    const auto groove = [&bar](double time) {
      return bar.grab().toImage().pixelColor(qRound(bar.xOf(time)), 17);
    };
    runner.seek(0);
    const double oldest = runner.oldestTime();
    QVERIFY(groove(0.5 * (oldest + 60.0)) != groove(0.5 * oldest));
    runner.seekNewest();
    QTest::mouseClick(&bar, Qt::LeftButton, {}, QPoint(qRound(bar.xOf(0.0)), 17));
    QCOMPARE(runner.shownFrame()->time, oldest);
  }

  void metrics_ofStatesThatAreGone_haveNoValues() {
    SimulationRunner runner;
    MetricsFeed feed(document_, runner);
    QSignalSpy failed(&feed, &MetricsFeed::failed);
    runWithoutDisk(runner);
    runner.stepBack();  // from here on all would be measured anew, from states that are gone
    QTRY_VERIFY_WITH_TIMEOUT(feed.isCurrent(), 60000);
    QVERIFY(!feed.shown().empty());
    for (const metrics::MetricResult& result : feed.shown()) {
      QVERIFY2(!result.value.value, result.info.key.c_str());
    }
    for (const QList<QVariant>& told : failed) {  // when measuring was behind what was dropped
      QVERIFY(told.front().value<base::Diagnostics>().front().code == "run.metrics-cut");
    }
  }

  /// Who begins to measure when the beginning is gone is told.
  void metrics_begunTooLate_areCut() {
    SimulationRunner runner;
    runWithoutDisk(runner);
    MetricsFeed feed(document_, runner);
    QSignalSpy failed(&feed, &MetricsFeed::failed);
    runner.stepBack();  // the feed hears of the run
    QTRY_VERIFY_WITH_TIMEOUT(feed.isCurrent(), 60000);
    QCOMPARE(failed.count(), 1);
    const auto problems = failed.front().front().value<base::Diagnostics>();
    QVERIFY(problems.front().code == "run.metrics-cut");
    QVERIFY(feed.snapshot().isCut);
  }
};

QTEST_MAIN(RunHistoryTest)
#include "tst_RunHistory.moc"
