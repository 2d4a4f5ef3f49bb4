#include <set>

#include <QtTest>

#include "tests/bt/ShippedScenario.h"

using namespace shipped;
using sim2d::Event;
using sim2d::EventKind;
using sim2d::Frame;

/// maps/corner_cafe, the first that people see: the robot comes through, nobody walks into it, and
/// who reacts to robots does.
class ShippedCafeTest : public QObject {
  Q_OBJECT

 private:
  std::vector<Frame> frames_;

 private Q_SLOTS:
  void initTestCase() {
    Loaded cafe = load("corner_cafe", "corner_cafe_agents");
    const std::unique_ptr<sim2d::World> world = makeWorld(cafe);
    QVERIFY2(world != nullptr, pendingDiagnostics(cafe.diagnostics).c_str());
    frames_ = framesOf(*world);
  }

  void robot_arrives_untouched() {
    double arrival = 0.0;
    for (const Frame& frame : frames_) {
      for (const Event& event : frame.events) {
        const bool isRobots = event.id < 0;
        QVERIFY2(!isRobots || event.kind != EventKind::Contact,
                 qPrintable(QStringLiteral("touches %1 at %2 s").arg(event.other).arg(frame.time)));
        arrival = isRobots && event.kind == EventKind::Arrived ? frame.time : arrival;
      }
    }
    QVERIFY2(arrival > 10.0 && arrival < 40.0, qPrintable(QString::number(arrival)));
  }

  void people_seldomTouchEachOther() {
    int contacts = 0;
    for (const Frame& frame : frames_) {
      contacts += static_cast<int>(
          std::count_if(frame.events.begin(), frame.events.end(),
                        [](const Event& event) { return event.kind == EventKind::Contact; }));
    }
    QVERIFY2(contacts <= 3, qPrintable(QString::number(contacts)));
  }

  void people_reactToTheRobot() {
    std::set<int> reacting;
    for (const Frame& frame : frames_) {
      for (std::size_t k = 0; k < frame.humans.size(); ++k) {
        if (frame.humans.state[k] != 0) {
          reacting.insert(frame.humans.id[k]);
        }
      }
    }
    // Chloe (curious), Emma (surprised), Farid (scared), Greta (threatening)
    QCOMPARE(reacting, (std::set<int>{3, 5, 6, 7}));
  }
};

QTEST_APPLESS_MAIN(ShippedCafeTest)
#include "tst_ShippedCafe.moc"
