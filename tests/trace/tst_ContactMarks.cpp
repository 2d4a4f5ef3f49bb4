#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <QtTest>

#include "sim2d/trace/ContactMarks.h"

using base::Vec2;
using sim2d::ContactMark;
using sim2d::Event;
using sim2d::EventKind;
using sim2d::Frame;
using Cause = ContactMark::Cause;

namespace {

/// A robot of 0.3 m at the origin and a person of 0.5 m at (0.8, 0) touch; another person stands
/// behind.
Frame stateAt(std::int64_t step, const Vec2& ofRobot, const Vec2& ofPerson) {
  Frame frame;
  frame.step = step;
  frame.time = 0.1 * double(step);
  frame.robots.add(-1, {{0.0, 0.0}, 0.0}, ofRobot, 0.0, sim2d::kNoGoal);
  frame.humans.add(4, {{0.8, 0.0}, 0.0}, ofPerson, 0.0, sim2d::kNoGoal);
  frame.humans.add(5, {{1.8, 0.0}, 0.0}, Vec2::Zero(), 0.0, sim2d::kNoGoal);
  frame.humans.group.assign(2, -1);
  frame.humans.state.assign(2, 0);
  return frame;
}

sim2d::TraceHeader header() {
  sim2d::TraceHeader header;
  header.dt = 0.1;
  header.robots.resize(1);
  header.robots[0].radius = 0.3;
  header.humans.resize(2);
  header.humans[0].id = 4;
  header.humans[1].id = 5;
  header.humans[0].radius = header.humans[1].radius = 0.5;
  return header;
}

Event contact(int id, std::optional<int> other, std::string text) {
  Event event;
  event.kind = EventKind::Contact;
  event.id = id;
  event.other = other.value_or(0);
  event.hasOther = other.has_value();
  event.text = std::move(text);
  return event;
}

}  // namespace

class ContactMarksTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void mark_ofTwo_isBetweenTheBodies() {
    const auto mark =
        sim2d::contactMark({2, contact(-1, 4, "0.5 robot front")}, stateAt(1, {0, 0}, {0, 0}),
                           stateAt(2, {0, 0}, {0, 0}), header());
    QVERIFY(mark.has_value());
    QVERIFY((mark->position - Vec2(0.3, 0.0)).norm() < 1e-12);  // on the robot's edge
    QVERIFY(std::abs(mark->time - 0.2) < 1e-12);
    QCOMPARE(*mark->other, 4);
  }

  void cause_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("robotSpeed");
    QTest::addColumn<double>("personSpeed");
    QTest::addColumn<int>("cause");
    QTest::newRow("told robot") << "0.5 robot front" << 0.0 << -1.0 << int(Cause::Robot);
    QTest::newRow("told person") << "0.5 person behind" << 1.0 << 0.0 << int(Cause::Person);
    QTest::newRow("told both") << "0.5 both left" << 1.0 << 0.0 << int(Cause::Both);
    QTest::newRow("robot is faster") << "0.5" << 0.6 << -0.4 << int(Cause::Robot);
    QTest::newRow("person is faster") << "0.5" << 0.2 << -0.4 << int(Cause::Person);
    QTest::newRow("person runs up from behind") << "0.5" << -0.2 << -0.4 << int(Cause::Person);
    QTest::newRow("equal") << "0.5" << 0.4 << -0.4 << int(Cause::Both);
  }
  void cause() {
    QFETCH(QString, text);
    QFETCH(double, robotSpeed);
    QFETCH(double, personSpeed);
    QFETCH(int, cause);
    const auto mark = sim2d::contactMark({2, contact(-1, 4, text.toStdString())},
                                         stateAt(1, {robotSpeed, 0.0}, {personSpeed, 0.0}),
                                         stateAt(2, {0, 0}, {0, 0}), header());
    QCOMPARE(int(mark->cause), cause);
  }

  void cause_wallsAndPeople_isWhoRan() {
    const Frame now = stateAt(2, {0, 0}, {0, 0});
    const auto wall = sim2d::contactMark({2, contact(-1, {}, "0.2 box1")}, now, now, header());
    QCOMPARE(int(wall->cause), int(Cause::Robot));
    QVERIFY(!wall->other && wall->position == Vec2(0.0, 0.0));
    const auto people = sim2d::contactMark({2, contact(4, 5, "0.2")}, now, now, header());
    QCOMPARE(int(people->cause), int(Cause::Person));
    QVERIFY((people->position - Vec2(1.3, 0.0)).norm() < 1e-12);
  }

  void mark_nobodyThere_isNone() {
    const Frame now = stateAt(2, {0, 0}, {0, 0});
    QVERIFY(!sim2d::contactMark({2, contact(9, 4, "0.2")}, now, now, header()));
    Event said = contact(4, 5, "hello");
    said.kind = EventKind::Say;
    QVERIFY(!sim2d::contactMark({2, said}, now, now, header()));
  }

  void marks_ofARecording_areThoseOfItsTrace() {
    sim2d::Recording recording;
    recording.setHeader(header());
    for (int step = 0; step < 4; ++step) {
      Frame frame = stateAt(step, {0.5, 0.0}, {-0.1 * step, 0.0});
      if (step == 2) {
        frame.events = {contact(-1, 4, "0.6")};
      }
      if (step == 3) {
        frame.events = {contact(4, 5, "0.3")};
      }
      recording.append(frame);
    }
    const auto marks = sim2d::contactMarks(recording);
    const auto again = sim2d::contactMarks(recording.trace());
    QCOMPARE(marks.size(), std::size_t{2});
    QCOMPARE(again.size(), std::size_t{2});
    for (std::size_t k = 0; k < 2; ++k) {
      QCOMPARE(int(marks[k].cause), int(again[k].cause));
      QVERIFY(marks[k].position == again[k].position && marks[k].step == again[k].step);
    }
    QCOMPARE(int(marks[0].cause), int(Cause::Robot));
    QCOMPARE(sim2d::contactMarks(recording, 1).size(), std::size_t{1});
    QVERIFY(sim2d::contactMarks(sim2d::Recording()).empty());
  }
};

QTEST_APPLESS_MAIN(ContactMarksTest)
#include "tst_ContactMarks.moc"
