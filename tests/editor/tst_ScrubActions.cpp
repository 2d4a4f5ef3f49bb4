#include <limits>
#include <random>

#include <QSignalSpy>
#include <QtTest>

#include "SmallScenario.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/MapView.h"
#include "editor/panels/runs/Playback.h"
#include "editor/panels/runs/ScrubActions.h"

using namespace editor;
using sim2d::Event;
using sim2d::EventKind;

/// Looking for something in a run.
class ScrubActionsTest : public QObject {
  Q_OBJECT

 private:
  static constexpr double kDt = 0.1;  // [s]
  ScenarioDocument document_;
  SimulationRunner runner_;
  RunEvents events_{document_, runner_};
  MapScene scene_{document_, Theme::light()};
  ScrubActions actions_{runner_, events_, scene_};
  TimelineBar bar_{document_, events_, runner_, Theme::light()};

  /// 42.4 s of one person who goes 1 m/s along x; contacts at these times.
  void open(const std::vector<double>& contacts, int recordEvery = 1) {
    sim2d::TraceHeader header;
    header.dt = kDt;
    header.recordEvery = recordEvery;
    sim2d::TraceHuman human;
    human.id = 1;
    human.name = "Ana";
    header.humans = {human};
    auto recording = std::make_shared<sim2d::Recording>(recordEvery);
    recording->setHeader(header);
    for (int step = 0; step <= 424; step += recordEvery) {
      sim2d::Frame frame;
      frame.step = step;
      frame.time = kDt * step;
      frame.humans.add(1, {{frame.time, 0.0}, 0.0}, {1.0, 0.0}, 0.0, sim2d::kNoGoal);
      frame.humans.group = {-1};
      frame.humans.state = {0};
      recording->addState(frame);
    }
    for (const double time : contacts) {
      recording->addEvent(std::llround(time / kDt),
                          Event{EventKind::Contact, 1, true, 2, true, {}});
    }
    runner_.openRecorded(recording);
    bar_.resize(600, 44);
  }
  double shown() const { return runner_.shownFrame()->time; }
  void drag(double from, double to, Qt::KeyboardModifiers modifiers, int y) {
    const QPoint start(qRound(bar_.xOf(from)), y), end(qRound(bar_.xOf(to)), y);
    QTest::mousePress(&bar_, Qt::LeftButton, modifiers, start);
    QMouseEvent move(QEvent::MouseMove, end, bar_.mapToGlobal(end), Qt::NoButton, Qt::LeftButton,
                     modifiers);
    QCoreApplication::sendEvent(&bar_, &move);
    QTest::mouseRelease(&bar_, Qt::LeftButton, modifiers, end);
  }

 private Q_SLOTS:
  void initTestCase() { document_.load(small::scenario()); }
  void cleanup() { runner_.reset(); }

  void contacts_areGoneThrough() {
    open({3.0, 3.0, 10.0, 42.4});
    QVERIFY(!actions_.previousContact->isEnabled() && actions_.nextContact->isEnabled());
    for (const double time : {3.0, 10.0, 42.4}) {
      actions_.nextContact->trigger();
      QVERIFY(std::fabs(shown() - time) < 1e-9);
    }
    QVERIFY(!actions_.nextContact->isEnabled());
    actions_.previousContact->trigger();
    QVERIFY(std::fabs(shown() - 10.0) < 1e-9);
    runner_.seek(60);
    actions_.previousContact->trigger();
    QVERIFY(std::fabs(shown() - 3.0) < 1e-9);
    QVERIFY(!actions_.previousContact->isEnabled());
  }

  /// A contact between two recorded states shows the one before, and the next is another one.
  void contacts_betweenStates_areGoneThrough() {
    open({3.1, 3.2, 10.3}, 4);
    actions_.nextContact->trigger();
    QVERIFY(std::fabs(shown() - 2.8) < 1e-9);
    actions_.nextContact->trigger();
    QVERIFY(std::fabs(shown() - 3.2) < 1e-9);
    actions_.nextContact->trigger();
    QVERIFY(std::fabs(shown() - 10.0) < 1e-9);
    QVERIFY(!actions_.nextContact->isEnabled());
    actions_.previousContact->trigger();
    QVERIFY(std::fabs(shown() - 3.2) < 1e-9);
  }

  void loop_drawnWithShift_isPlayedAgainAndAgain() {
    open({});
    drag(10.0, 10.6, Qt::ShiftModifier, 17);
    QVERIFY(runner_.loop().has_value());
    QVERIFY(std::fabs(runner_.loop()->from - 10.0) < 0.1);
    QVERIFY(std::fabs(runner_.loop()->to - 10.6) < 0.1);
    QVERIFY(actions_.loop->isChecked());
    std::vector<double> times;
    connect(&runner_, &SimulationRunner::frameShown, this,
            [&](const FramePtr& frame) { times.push_back(frame != nullptr ? frame->time : -1.0); });
    runner_.setSpeed(4.0);
    runner_.play();
    int rounds = 0;
    QElapsedTimer clock;
    clock.start();
    while (rounds < 3 && clock.elapsed() < 20000) {
      QTest::qWait(20);
      rounds = 0;
      for (std::size_t k = 1; k < times.size(); ++k) {
        rounds += times[k] < times[k - 1] ? 1 : 0;
      }
    }
    QCOMPARE(runner_.state(), SimulationRunner::State::Running);
    runner_.pause();
    runner_.disconnect(this);
    QVERIFY(rounds >= 3);
    for (const double time : times) {
      QVERIFY2(time > 9.8 && time < 10.8, QByteArray::number(time));
    }
  }

  void loop_marksAreDragged() {
    open({});
    runner_.seek(200);
    actions_.loop->trigger();
    QVERIFY(std::fabs(runner_.loop()->from - 17.5) < 1e-9);
    QVERIFY(std::fabs(runner_.loop()->to - 22.5) < 1e-9);
    drag(17.5, 15.0, Qt::NoModifier, 28);
    QVERIFY(std::fabs(runner_.loop()->from - 15.0) < 0.1);
    QVERIFY(std::fabs(runner_.loop()->to - 22.5) < 1e-9);
    drag(22.5, 30.0, Qt::NoModifier, 28);
    QVERIFY(std::fabs(runner_.loop()->to - 30.0) < 0.1);
    QVERIFY(std::fabs(shown() - 20.0) < 1e-9);  // marks are not the slider
    drag(5.0, 6.0, Qt::NoModifier, 17);
    QVERIFY(std::fabs(shown() - 6.0) < 0.15);
    actions_.loop->trigger();
    QVERIFY(!runner_.loop());
    runner_.setLoop(SimulationRunner::LoopRange{1.0, 2.0});
    runner_.reset();
    QVERIFY(!runner_.loop() && !actions_.loop->isChecked());
  }

  void onionSkin_atEvenTimes() {
    open({});
    actions_.onionSkin->setChecked(true);
    runner_.seek(20);  // 2 s
    const auto& skins = actions_.onion().skins();
    std::map<int, double> places;
    for (const OnionLayer::Skin& skin : skins) {
      places[skin.place] = skin.frame->humans.x[0];
    }
    const std::map<int, double> expected = {{-2, 0.0}, {-1, 1.0}, {1, 3.0}, {2, 4.0}, {3, 5.0}};
    QCOMPARE(places.size(), expected.size());
    for (const auto& [place, x] : expected) {
      QVERIFY(std::fabs(places.at(place) - x) < 1e-9);
    }
    runner_.seekNewest();
    QCOMPARE(skins.size(), std::size_t{3});  // nothing comes after the end
    actions_.onionSkin->setChecked(false);
    QVERIFY(skins.empty());
  }

  void trails_ofAnotherLength_reachBack() {
    open({});
    const auto lengthAt = [this](double seconds) {
      for (QAction* each : actions_.trailLengths()) {
        if (each->text() == QStringLiteral("%1 s").arg(seconds)) {
          each->trigger();
        }
      }
      return scene_.options().trailSeconds;
    };
    runner_.seek(400);
    QCOMPARE(lengthAt(30), 30.0);
    Trails trails;
    trails.advance(nullptr, *runner_.shownFrame(), runner_.recording().get(), 30.0);
    const Trail& trail = trails.all().at(1);
    QVERIFY(std::fabs(trail.points.front().first - 10.0) < 0.25);
    trails.advance(nullptr, *runner_.shownFrame(), runner_.recording().get(), 3.0);
    QVERIFY(std::fabs(trails.all().at(1).points.front().first - 37.0) < 0.25);
    QCOMPARE(lengthAt(6), 6.0);
  }

  /// Whatever is jumped to is what was recorded: a run that goes on, and one of every third step.
  void seek_anyStep_showsExactlyTheRecordedState() {
    for (const int every : {1, 3}) {
      sim2d::Scenario scenario = small::scenario();
      scenario.desktop.duration = 6.0;
      scenario.desktop.recordEvery = every;
      ScenarioDocument document;
      document.load(std::move(scenario));
      document.setMap(small::room());
      SimulationRunner runner;
      runner.setRequest([&document] { return runRequestOf(document); });
      runner.setSpeed(std::numeric_limits<double>::infinity());
      std::map<std::int64_t, std::string> rows;  // of the world itself
      const RunRequest request = runRequestOf(document);
      const auto world = request.makeWorld();
      QVERIFY(bool(world));
      for (int step = 0; step <= 120; ++step) {
        sim2d::appendTrajectoryRows(rows[step], (*world)->frame());
        (*world)->step();
      }
      QSignalSpy finished(&runner, &SimulationRunner::finished);
      runner.play();
      QVERIFY(finished.wait(60000));
      std::mt19937 draw(7);
      for (int k = 0; k < 300; ++k) {
        const auto step = static_cast<std::int64_t>(draw() % 121U);
        runner.seek(step);
        const bool isEnd = step >= runner.newestFrame()->step;
        const std::int64_t expected = isEnd ? step : step / every * every;
        QCOMPARE(runner.shownFrame()->step, expected);
        std::string now;
        sim2d::appendTrajectoryRows(now, *runner.shownFrame());
        QCOMPARE(now, rows[expected]);
      }
    }
  }
};

QTEST_MAIN(ScrubActionsTest)
#include "tst_ScrubActions.moc"
