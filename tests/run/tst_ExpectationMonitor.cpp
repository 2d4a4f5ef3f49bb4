#include <QtTest>

#include "app/run/ExpectationMonitor.h"
#include "tests/support/Columns.h"

using namespace app;
using sim2d::Event;
using sim2d::EventKind;
using sim2d::Frame;

namespace {

/// Anna (1) walks along y = 0 at 1 m/s from x = 0 and stands from 4 s to 7 s at x = 4; Ben (2)
/// stands at (4, 2) and leaves at 6 s.
Frame frameAt(double time) {
  Frame frame;
  frame.time = time;
  const bool stands = time >= 4.0 && time < 7.0;
  const double x = time < 4.0 ? time : stands ? 4.0 : time - 3.0;
  frame.humans.add(1, {{x, 0.0}, 0.0}, {stands ? 0.0 : 1.0, 0.0}, 0.0, 1);
  if (time < 6.0) {
    frame.humans.add(2, {{4.0, 2.0}, 0.0}, {0.0, 0.0}, 0.0, 1);
  }
  return frame;
}

Event event(EventKind kind, int id, const char* text = "", int other = 0) {
  Event made;
  made.kind = kind;
  made.id = id;
  made.text = text;
  made.other = other;
  made.hasOther = other != 0;
  return made;
}

sim2d::Scenario scenarioWith(const std::string& expectation) {
  sim2d::Scenario scenario;
  for (const auto& [name, id] : {std::pair("anna", 1), std::pair("ben", 2)}) {
    sim2d::Human human;
    human.name = name;
    human.id = id;
    scenario.humans.push_back(human);
  }
  sim2d::GlobalGoal goal;
  goal.id = 1;
  goal.position = {10.0, 0.0};
  scenario.goals.push_back(goal);
  sim2d::Area area;
  area.name = "hall";
  area.points = {{3.0, -1.0}, {6.0, -1.0}, {6.0, 1.0}, {3.0, 1.0}};
  scenario.areas.push_back(area);
  sim2d::Door door;
  door.name = "gate";
  door.from = {4.5, 1.0};
  door.to = {4.5, 1.8};
  scenario.doors.push_back(door);
  scenario.desktop.card.expect = {expectation};
  return scenario;
}

/// 15 s in steps of 0.5 s with these events.
ExpectationOutcome outcomeOf(const std::string& expectation) {
  const sim2d::Scenario scenario = scenarioWith(expectation);
  ExpectationMonitor monitor(scenario);
  for (int step = 0; step <= 30; ++step) {
    Frame frame = frameAt(0.5 * step);
    if (step == 4) {
      frame.events = {event(EventKind::Say, 1, "hello Ben"),
                      event(EventKind::Heard, 2, "hello Ben", 1),
                      event(EventKind::Action, 1, "StopAndWaitTimerAction")};
    } else if (step == 12) {
      frame.events = {event(EventKind::Leave, 2), event(EventKind::Arrived, 2)};
    } else if (step == 20) {
      frame.events = {event(EventKind::Contact, 1, "0.30", 2),
                      event(EventKind::ActionEnd, 1, "StopAndWaitTimerAction SUCCESS")};
    } else if (step == 26) {
      frame.events = {event(EventKind::Goal, 1, "1"), event(EventKind::Arrived, 1)};
    }
    monitor.add(frame);
  }
  return monitor.outcomes().front();
}

}  // namespace

/// Expectations against states whose times and distances are known.
class ExpectationMonitorTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void expectation_inARun_holdsWithItsTime_data() {
    addColumns<QByteArray, double>({"text", "time"});  // time < 0: does not hold
    const auto row = [](const char* text, double time) {
      QTest::newRow(text) << QByteArray(text) << time;
    };
    row("anna reaches goal 1 before 15 s", 12.5);  // x = 9.5 is within 0.5 m
    row("anna reaches goal 1 before 12 s", -1.0);
    row("anna arrives before 13 s", 13.0);
    row("anna enters hall", 3.0);
    row("anna enters hall after 5 s", 5.0);
    row("ben leaves before 7 s", 6.0);
    row("anna leaves", -1.0);
    row("anna says \"hello\" before 3 s", 2.0);
    row("anna says \"good bye\"", -1.0);
    row("ben hears anna", 2.0);
    row("anna starts StopAndWaitTimerAction", 2.0);
    row("anna ends StopAndWaitTimerAction before 9 s", -1.0);
    row("anna ends StopAndWaitTimerAction before 10 s", 10.0);
    row("anna stands for 2 s", 6.0);
    row("anna stands for 4 s", -1.0);
    row("anna yields at the gate before 5 s", 4.5);  // the gate is 1.12 m away
    row("anna stands at hall for 1 s", 5.0);
    row("anna stands at goal 1", -1.0);
    row("anna comes within 2 m of ben", 4.0);
    row("anna comes within 1.9 m of ben", -1.0);
    row("anna comes within 1 m of goal 1 from 0 to 12 s", 12.0);
    row("anna touches ben", 10.0);
    row("ben touches anyone before 9 s", -1.0);
    row("2 people arrive before 14 s", 13.0);
    row("2 people arrive before 12 s", -1.0);
  }
  void expectation_inARun_holdsWithItsTime() {
    QFETCH(QByteArray, text);
    QFETCH(double, time);
    const ExpectationOutcome outcome = outcomeOf(text.toStdString());
    QCOMPARE(outcome.holds, time >= 0.0);
    QCOMPARE(outcome.time.value_or(-1.0), time);
  }

  void never_holdsIfItDoesNotHappen() {
    QVERIFY(outcomeOf("anna never touches ben before 9 s").holds);
    QVERIFY(!outcomeOf("anna never touches ben before 10 s").holds);
  }

  void horizon_isTheLastTimeThatMatters() {
    sim2d::Scenario scenario = scenarioWith("anna arrives before 13 s");
    scenario.desktop.card.expect.emplace_back("ben leaves before 20 s");
    QCOMPARE(ExpectationMonitor(scenario).horizon(), 20.0);
    scenario.desktop.card.expect.emplace_back("anna never touches ben");
    QVERIFY(std::isinf(ExpectationMonitor(scenario).horizon()));
  }
};

QTEST_APPLESS_MAIN(ExpectationMonitorTest)
#include "tst_ExpectationMonitor.moc"
