#include <QSignalSpy>
#include <QtTest>

#include "SmallScenario.h"
#include "editor/panels/runs/Playback.h"

using editor::TimelineBar;
using sim2d::Event;
using sim2d::EventKind;

/// The time line and the events on it, of a run that was recorded.
class TimelineTest : public QObject {
  Q_OBJECT

 private:
  static constexpr double kDt = 0.1;  // [s]
  editor::ScenarioDocument document_;
  editor::SimulationRunner runner_;
  editor::RunEvents events_{document_, runner_};
  TimelineBar bar_{document_, events_, runner_, editor::Theme::light()};

  /// 42.4 s, of which each has ten pixels.
  void open(const std::vector<std::pair<double, Event>>& happened) {
    sim2d::TraceHeader header;
    header.dt = kDt;
    auto recording = std::make_shared<sim2d::Recording>();
    recording->setHeader(header);
    sim2d::Frame frame;
    recording->addState(frame);
    frame.step = 424;
    frame.time = 42.4;
    recording->addState(frame);
    for (const auto& [time, event] : happened) {
      recording->addEvent(std::llround(time / kDt), event);
    }
    runner_.openRecorded(recording);
    bar_.resize(600, 44);
    QCOMPARE(bar_.xOf(11.0) - bar_.xOf(1.0), 100.0);
  }
  std::vector<int> counts() const {
    std::vector<int> all;
    for (const TimelineBar::Cluster& cluster : bar_.clusters()) {
      all.push_back(cluster.count);
    }
    return all;
  }

 private Q_SLOTS:
  void initTestCase() { document_.load(small::scenario()); }
  void cleanup() { runner_.reset(); }

  void marks_ofOneKindInOnePlace_areOneWithTheirNumber() {
    const Event goal{EventKind::Goal, 1, true, 0, false, "3"};
    const Event other{EventKind::Goal, 2, true, 0, false, "3"};
    open({{1.0, goal}, {1.1, other}, {1.2, goal}, {12.0, goal}, {20.0, goal}, {22.0, goal}});
    QCOMPARE(counts(), (std::vector<int>{3, 1, 1, 1}));
  }

  void marks_besideANumber_leaveItRoom() {
    const Event goal{EventKind::Goal, 1, true, 0, false, "3"};
    const Event other{EventKind::Goal, 2, true, 0, false, "3"};
    open({{1.0, goal}, {1.1, other}, {2.8, goal}, {12.0, goal}, {13.7, goal}});
    QCOMPARE(counts(), (std::vector<int>{3, 1, 1}));  // without a number there is room
  }

  void marks_ofSeveralKinds_showTheLoudest() {
    const Event goal{EventKind::Goal, 1, true, 0, false, "3"};
    const Event contact{EventKind::Contact, 1, true, 2, true, {}};
    open({{1.0, goal}, {1.1, contact}, {1.2, goal}});
    QCOMPARE(counts(), (std::vector<int>{1}));
    QVERIFY(bar_.clusters().front().mark == editor::EventMark::Cross);
  }

  /// Reaching the last goal is the arrival: one event, at one time. Others keep theirs.
  void arrival_atTheLastGoal_isOneEvent() {
    const Event reached{EventKind::Goal, 1, true, 0, false, "3"};
    const Event other{EventKind::Goal, 2, true, 0, false, "1"};
    const Event arrived{EventKind::Arrived, 1, true, 0, false, {}};
    const Event alone{EventKind::Arrived, 2, true, 0, false, {}};
    open({{1.0, reached}, {4.0, reached}, {4.0, other}, {4.0, arrived}, {5.0, alone}});
    QStringList texts;
    for (const editor::RunEvent& event : events_.events()) {
      texts << QStringLiteral("%1 %2").arg(event.time, 0, 'f', 1).arg(event.text);
    }
    QCOMPARE(texts, (QStringList{QStringLiteral("1.0 Ana reached Goal 3"),
                                 QStringLiteral("4.0 Ana has arrived at Goal 3"),
                                 QStringLiteral("4.0 Ben reached Goal 1"),
                                 QStringLiteral("5.0 Ben has arrived")}));
    QVERIFY(events_.events()[1].event.kind == EventKind::Arrived);
  }

  /// With a single goal that is repeated, HuNavSim reaches it anew in each step.
  void stay_atTheOnlyGoal_isOneEvent() {
    const Event goal{EventKind::Goal, 1, true, 0, false, "3"};
    const Event next{EventKind::Goal, 1, true, 0, false, "4"};
    const Event other{EventKind::Goal, 2, true, 0, false, "3"};
    std::vector<std::pair<double, Event>> happened;
    for (int step = 10; step <= 100; ++step) {
      happened.push_back({step * kDt, goal});
    }
    happened.insert(happened.begin() + 5, {1.4, other});
    happened.push_back({10.1, next});
    happened.push_back({10.2, goal});
    happened.push_back({20.0, goal});
    open(happened);
    QStringList texts;
    for (const editor::RunEvent& event : events_.events()) {
      texts << QStringLiteral("%1 %2").arg(event.time, 0, 'f', 1).arg(event.text);
    }
    QCOMPARE(texts, (QStringList{QStringLiteral("1.0 Ana reached Goal 3"),
                                 QStringLiteral("1.4 Ben reached Goal 3"),
                                 QStringLiteral("10.1 Ana reached Goal 4"),
                                 QStringLiteral("10.2 Ana reached Goal 3"),
                                 QStringLiteral("20.0 Ana reached Goal 3")}));
    QCOMPARE(runner_.recording()->events().size(), happened.size());  // the record has all
  }

  /// A longer compared run is reached by mouse and keys; the shown run stays at its last state.
  void comparedRun_longer_isReached() {
    open({});
    const auto click = [this](double time) {
      QTest::mouseClick(&bar_, Qt::LeftButton, {}, QPoint(qRound(bar_.xOf(time)), 17));
    };
    QSignalSpy chosen(&bar_, &TimelineBar::timeAfterEndChosen);
    bar_.setCompared({{0, 60.0, {}}});
    QCOMPARE(bar_.length(), 60.0);
    click(50.0);
    QCOMPARE(runner_.shownFrame()->time, 42.4);
    QCOMPARE(chosen.count(), 1);
    QVERIFY(std::abs(bar_.pointedTime() - 50.0) < 0.1);
    QTest::keyClick(&bar_, Qt::Key_Right);
    QVERIFY(std::abs(bar_.pointedTime() - 50.0 - kDt) < 0.1);
    click(70.0);
    QCOMPARE(bar_.pointedTime(), 60.0);
    QTest::keyClick(&bar_, Qt::Key_Home);
    QCOMPARE(bar_.pointedTime(), 0.0);
    click(60.0);
    bar_.setCompared({{0, 45.0, {}}});
    QCOMPARE(bar_.pointedTime(), 45.0);
    bar_.setCompared({});
    QCOMPARE(bar_.pointedTime(), 42.4);
    click(60.0);
    QCOMPARE(bar_.pointedTime(), 42.4);
  }

  void texts_ofGoals_nameThem() {
    open({{1.0, {EventKind::Goal, 1, true, 0, false, "3"}},
          {2.0, {EventKind::Goal, 1, true, 0, false, {}}}});
    QCOMPARE(events_.events().size(), std::size_t{2});
    QCOMPARE(events_.events()[0].text, QStringLiteral("Ana reached Goal 3"));
    QCOMPARE(events_.events()[1].text, QStringLiteral("Ana reached the goal"));
  }
};

QTEST_MAIN(TimelineTest)
#include "tst_Timeline.moc"
